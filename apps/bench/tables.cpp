#include "tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace tank_datum::bench {
namespace {

using Json = nlohmann::ordered_json;

template <typename... Values>
std::string line(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double perSecond(std::uint64_t points, const StageCost& cost) { return static_cast<double>(points) / cost.seconds; }
double megabytes(std::uint64_t bytes) { return 1e-6 * static_cast<double>(bytes); }

std::string tableOf(const std::vector<ChainRun>& runs, const char* title) {
  if (runs.empty()) return {};
  std::string text =
      line("%s, %llu points\n%-36s %10s %10s %10s %12s\n", title, static_cast<unsigned long long>(runs.front().points),
           "stage", "seconds", "cpu s", "peak MB", "M points/s");
  for (const ChainRun& run : runs) {
    std::vector<StageCost> rows = run.stages;
    rows.push_back(totalOf(run.stages));
    text += run.name + "\n";
    for (const StageCost& row : rows) {
      text += line("  %-34s %10.3f %10.3f %10.0f %12.2f\n", row.name.c_str(), row.seconds, row.cpu_seconds,
                   megabytes(row.peak_memory), 1e-6 * perSecond(run.points, row));
    }
  }
  const StageCost first = totalOf(runs.front().stages);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const StageCost other = totalOf(runs[i].stages);
    text += line("%s over %s: %.2f times (cpu %.2f)\n", runs.front().name.c_str(), runs[i].name.c_str(),
                 first.seconds / other.seconds, first.cpu_seconds / other.cpu_seconds);
  }
  return text;
}

std::string candidatesOf(const std::vector<ChainRun>& ring) {
  std::string text;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Agreement agreement = agreementOf(ring.front(), ring[i]);
    text += line("candidates of %s and %s: %zu both, %zu and %zu one alone: %s\n", ring.front().name.c_str(),
                 ring[i].name.c_str(), agreement.both, agreement.only_first, agreement.only_second,
                 agreement.same() ? "the same" : "NOT the same");
  }
  return text;
}

std::string growthTable(const std::vector<GrowthRun>& growth) {
  if (growth.empty()) return {};
  std::string text = line("%14s %10s %10s %10s %12s %12s %14s\n", "points", "seconds", "cpu s", "peak MB", "M points/s",
                          "over reading", "sigmas apart");
  for (const GrowthRun& run : growth) {
    const StageCost total = totalOf(run.chain.stages);
    text +=
        line("%14llu %10.2f %10.2f %10.0f %12.2f %12.1f %14.2f\n", static_cast<unsigned long long>(run.chain.points),
             total.seconds, total.cpu_seconds, megabytes(total.peak_memory), 1e-6 * perSecond(run.chain.points, total),
             total.seconds / run.read_seconds, largestInSigmas(growth.back().datum, run.datum));
  }
  return text +
         "over reading: the time over that of reading the same file, cached; sigmas apart: the largest difference "
         "of an elevation from the last row's, over its standard error\n";
}

double gigabytes(double bytes) { return 1e-9 * bytes; }

/// A number in a column; where it is not known, a dash.
std::string cell(double value, int width, int decimals) {
  return std::isnan(value) ? line("%*s", width, "-") : line("%*.*f", width, decimals, value);
}

std::string stageTable(const StageRuns& runs) {
  const MemorySpeed& memory = runs.memory;
  std::string text = line("memory, one and two threads: read %.1f and %.1f GB/s, copy %.1f and %.1f GB/s\n",
                          gigabytes(memory.read.one), gigabytes(memory.read.two), gigabytes(memory.copy.one),
                          gigabytes(memory.copy.two));
  text += line("%-16s %10s %10s %8s %8s %10s %10s %10s %10s %8s\n", "stage", "points", "bytes each", "ms", "ms, 2",
               "ns each", "ns each, 2", "% memory", "% mem., 2", "1 over 2");
  for (const StageLimit& stage : runs.stages) {
    const StageSpeed &one = stage.one, &two = stage.two;
    text += line("%-16s", stage.name.c_str()) +
            cell(stage.work.points > 0 ? static_cast<double>(stage.work.points) : kUnknown, 11, 0) +
            cell(stage.work.bytes_per_point, 11, 1) + cell(1e3 * one.seconds, 9, 1) + cell(1e3 * two.seconds, 9, 1) +
            cell(one.ns_per_point, 11, 1) + cell(two.ns_per_point, 11, 1) + cell(100.0 * one.bandwidth_share, 11, 2) +
            cell(100.0 * two.bandwidth_share, 11, 2) + cell(stage.ratio, 9, 2) + "\n";
  }
  return text +
         "points: of the stage; bytes each: what it has to read and to write once; % memory: these bytes a second, "
         "over what "
         "as many threads move at most\n";
}

Json speedJson(const StageSpeed& speed) {
  return {{"seconds", speed.seconds}, {"ns_per_point", speed.ns_per_point}, {"bandwidth_share", speed.bandwidth_share}};
}

Json stagesJson(const std::vector<StageLimit>& stages) {
  Json list = Json::array();
  for (const StageLimit& stage : stages) {
    list.push_back({{"stage", stage.name},
                    {"points", stage.work.points},
                    {"bytes_per_point", stage.work.bytes_per_point},
                    {"one_thread", speedJson(stage.one)},
                    {"two_threads", speedJson(stage.two)},
                    {"ratio", stage.ratio}});
  }
  return list;
}

Json speedsJson(const MemorySpeeds& speeds) { return {{"one_thread", speeds.one}, {"two_threads", speeds.two}}; }

Json costJson(const StageCost& cost) {
  return {{"seconds", cost.seconds}, {"cpu_seconds", cost.cpu_seconds}, {"peak_memory_bytes", cost.peak_memory}};
}

Json runJson(const ChainRun& run) {
  Json stages = Json::object();
  for (const StageCost& stage : run.stages) stages[stage.name] = costJson(stage);
  const StageCost total = totalOf(run.stages);
  return {{"chain", run.name},
          {"points", run.points},
          {"stages", stages},
          {"total", costJson(total)},
          {"points_per_second", perSecond(run.points, total)}};
}

Json runsJson(const std::vector<ChainRun>& runs) {
  Json list = Json::array();
  for (const ChainRun& run : runs) {
    Json json = runJson(run);
    const StageCost first = totalOf(runs.front().stages), own = totalOf(run.stages);
    json["ratio"] = first.seconds / own.seconds;
    json["cpu_ratio"] = first.cpu_seconds / own.cpu_seconds;
    list.push_back(json);
  }
  return list;
}

}  // namespace

bool sameCandidates(const Figures& figures) {
  return std::all_of(figures.ring.begin(), figures.ring.end(),
                     [&](const ChainRun& run) { return agreementOf(figures.ring.front(), run).same(); });
}

std::string tablesOf(const Figures& figures) {
  return tableOf(figures.ring, "the ring's chain") + candidatesOf(figures.ring) + "\n" +
         tableOf(figures.whole, "the whole scan") + "\n" + stageTable(figures.stages) + "\n" +
         growthTable(figures.growth);
}

std::string jsonOf(const Figures& figures) {
  Json json = {{"ring", runsJson(figures.ring)},
               {"same_candidates", sameCandidates(figures)},
               {"whole", runsJson(figures.whole)},
               {"growth", Json::array()},
               {"stages", stagesJson(figures.stages.stages)},
               {"memory_bytes_per_second",
                {{"read", speedsJson(figures.stages.memory.read)}, {"copy", speedsJson(figures.stages.memory.copy)}}}};
  for (std::size_t i = 0; i < figures.ring.size(); ++i) {
    const Agreement agreement = agreementOf(figures.ring.front(), figures.ring[i]);
    json["ring"][i]["candidates"] = figures.ring[i].candidates.size();
    json["ring"][i]["candidates_not_both"] = agreement.only_first + agreement.only_second;
  }
  for (const GrowthRun& run : figures.growth) {
    Json row = runJson(run.chain);
    row["bytes"] = run.bytes;
    row["read_seconds"] = run.read_seconds;
    row["measured"] = run.datum.level.measured;
    row["largest_difference_in_sigmas"] = largestInSigmas(figures.growth.back().datum, run.datum);
    json["growth"].push_back(row);
  }
  return json.dump(2) + "\n";
}

}  // namespace tank_datum::bench
