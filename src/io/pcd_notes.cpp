#include "io/pcd_notes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/io_error.h"
#include "io/text_number.h"

namespace tank_datum {
namespace {

constexpr std::string_view kMark = "tank_datum: ";

/// The shortest text without an exponent that reads back as the same double.
std::string text(double value) {
  char buffer[1100];  // the smallest double has 1074 digits behind the point
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr);
}

std::string text(const double* xyz) { return text(xyz[0]) + " " + text(xyz[1]) + " " + text(xyz[2]); }

/// Reads the words of a note one after the other.
class NoteReader {
 public:
  NoteReader(std::string_view note, const std::string& path) : note_(note), rest_(note), path_(path) {}

  /// Up to the next blank.
  std::string_view word() {
    const std::size_t begin = std::min(rest_.find_first_not_of(' '), rest_.size());
    const std::size_t end = std::min(rest_.find(' ', begin), rest_.size());
    const std::string_view found = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return found;
  }

  double number() {
    const std::string_view found = word();
    double value = 0.0;
    const char* const end = found.data() + found.size();
    if (found.empty() || parseNumber(found.data(), end, value) != end || !std::isfinite(value)) refuse("numbers");
    return value;
  }

  std::uint32_t label() {
    const std::string_view found = word();
    std::uint32_t value = 0;
    const auto [end, code] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (code != std::errc() || end != found.data() + found.size()) refuse("the number of a setup");
    return value;
  }

  std::string rest() {
    const std::size_t begin = rest_.find_first_not_of(' ');
    if (begin == rest_.npos) refuse("a name");
    return std::string(rest_.substr(begin));
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    throw fileError("header comment", path_, "\"" + echo(note_) + "\"", expected);
  }

 private:
  std::string_view note_, rest_;
  const std::string& path_;
};

void readNote(NoteReader note, PcdNotes& notes) {
  const std::string_view what = note.word();
  if (what == "origin") {
    for (double& coordinate : notes.origin) coordinate = note.number();
  } else if (what == "step") {
    notes.step = note.number();
    if (!(notes.step > 0.0)) note.refuse("a number > 0");
  } else if (what == "setup") {
    ScanBlocks::Setup& setup = notes.setups[note.label()];
    const std::string_view which = note.word();
    if (which == "is") {
      setup.name = note.rest();
    } else if (which == "at") {
      const double x = note.number(), y = note.number(), z = note.number();
      setup.viewpoint = Eigen::Vector3d(x, y, z);
    } else {
      note.refuse("setup N is NAME, or setup N at X Y Z");
    }
  } else {
    note.refuse("origin, step or setup");
  }
}

}  // namespace

std::vector<std::string> PcdNotes::lines() const {
  std::vector<std::string> all;
  const std::string mark(kMark);
  if (origin != std::array<double, 3>{}) all.push_back(mark + "origin " + text(origin.data()));
  if (step > 0.0) all.push_back(mark + "step " + text(step));
  for (const auto& [label, setup] : setups) {
    const std::string which = mark + "setup " + std::to_string(label);
    if (!setup.name.empty()) all.push_back(which + " is " + setup.name);
    if (setup.viewpoint) all.push_back(which + " at " + text(setup.viewpoint->data()));
  }
  return all;
}

PcdNotes readPcdNotes(const std::vector<std::string_view>& comments, const std::string& path) {
  PcdNotes notes;
  for (std::string_view comment : comments) {
    comment.remove_prefix(std::min(comment.find_first_not_of(' '), comment.size()));
    while (!comment.empty() && comment.back() == '\r') comment.remove_suffix(1);
    if (comment.substr(0, kMark.size()) != kMark) continue;
    readNote(NoteReader(comment.substr(kMark.size()), path), notes);
  }
  for (auto& [label, setup] : notes.setups) {
    if (setup.name.empty()) setup.name = std::to_string(label);
  }
  return notes;
}

}  // namespace tank_datum
