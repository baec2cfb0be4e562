#include "report/verdict_lines.h"

#include <algorithm>

#include "limits/checks.h"
#include "report/check_text.h"
#include "report/summary_line.h"

namespace tank_datum {
namespace {

/// A value with its limit as people say it.
std::string figures(const Check& check, const Display& display) {
  return checkFigureWithInterval(check, display, "en") + ", limit " + checkFigure(check.limit, check, display);
}

}  // namespace

std::string checkLines(const std::vector<Check>& checks, const Display& display) {
  if (checks.empty()) return {};
  int counts[5] = {};
  const auto is_second = [](const Check& c) { return c.role == "second opinion"; };
  std::vector<const Check*> failed, undecided;
  for (const Check& c : checks) {
    ++counts[static_cast<int>(c.verdict)];
    if (c.verdict == Verdict::Fail) failed.push_back(&c);
    if (c.verdict == Verdict::Undecided && !is_second(c)) undecided.push_back(&c);
  }
  const auto graver = [&](const Check* a, const Check* b) {
    if (is_second(*a) != is_second(*b)) return is_second(*b);
    return a->value / a->limit > b->value / b->limit;
  };
  std::stable_sort(failed.begin(), failed.end(), graver);
  std::stable_sort(undecided.begin(), undecided.end(), graver);
  if (undecided.size() > 1) undecided.resize(1);
  std::string lines = line(
      "checks", "%d pass, %d fail, %d undecided, %d not evaluated, %d not applicable (screening, no code evaluation)",
      counts[0], counts[1], counts[2], counts[4], counts[3]);
  for (const Check* c : failed.empty() ? undecided : failed) {
    const char* role = is_second(*c) ? " (a second opinion)" : "";
    lines +=
        line(nameOf(c->verdict), "%s %s: %s%s", c->code.c_str(), c->name.c_str(), figures(*c, display).c_str(), role);
  }
  return lines;
}

std::string verdictLine(const Analysis& analysis) {
  if (!analysis.valid()) return {};
  const Headline& h = analysis.headline;
  if (h.governing.empty()) return line("verdict", "%s: no rule could be judged", h.word.c_str());
  if (h.word == "INCOMPLETE")
    return line("verdict", "%s: %s%s", h.word.c_str(), h.governing.c_str(), h.meaning.c_str());
  return line("verdict", "%s: %s, %s%s", h.word.c_str(), h.governing.c_str(), shareOfLimit(h).c_str(),
              h.meaning.c_str());
}

}  // namespace tank_datum
