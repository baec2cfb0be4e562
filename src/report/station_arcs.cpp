#include "report/station_arcs.h"

#include <algorithm>

#include "core/plain_text.h"
#include "core/ring_runs.h"
#include "core/units.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

struct Arc {
  double from, to;  ///< azimuths of its first and last station [deg]
  std::size_t stations;
};

std::vector<Arc> arcsOf(const std::vector<char>& is, const std::vector<Station>& stations) {
  if (std::find(is.begin(), is.end(), 0) == is.end()) return {{0.0, 360.0, is.size()}};
  std::vector<Arc> arcs;
  for (const RingRun& run : runsRound(is)) {
    arcs.push_back({toDegrees(stations[run.first % is.size()].azimuth),
                    toDegrees(stations[run.last % is.size()].azimuth), run.last - run.first + 1});
  }
  return arcs;
}

template <typename Predicate>
std::vector<char> where(const std::vector<Station>& stations, const Predicate& is) {
  std::vector<char> marks;
  for (const Station& s : stations) marks.push_back(is(s) ? 1 : 0);
  return marks;
}

}  // namespace

Json arcsJson(const std::vector<char>& is, const std::vector<Station>& stations) {
  Json list = Json::array();
  if (is.empty()) return list;
  for (const Arc& arc : arcsOf(is, stations)) list.push_back({arc.from, arc.to});
  return list;
}

std::vector<char> withReason(const std::vector<Station>& stations, Unmeasured reason) {
  return where(stations, [reason](const Station& s) { return s.reason == reason; });
}

std::vector<char> inDoubt(const std::vector<Station>& stations) { return where(stations, isInDoubt); }

std::vector<char> maybeHeaved(const std::vector<Station>& stations) { return where(stations, mayBeHeaved); }

std::string arcsText(const std::vector<char>& is, const std::vector<Station>& stations, std::size_t shortest) {
  constexpr std::size_t kShown = 5;  // arcs
  if (is.empty()) return {};
  std::vector<Arc> arcs = arcsOf(is, stations);
  arcs.erase(std::remove_if(arcs.begin(), arcs.end(), [&](const Arc& arc) { return arc.stations < shortest; }),
             arcs.end());
  std::stable_sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) { return a.stations > b.stations; });
  const std::size_t more = arcs.size() - std::min(arcs.size(), kShown);
  arcs.resize(arcs.size() - more);
  std::sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) { return a.from < b.from; });
  std::string text;
  for (const Arc& arc : arcs) {
    char part[60];
    snprintfPlain(part, sizeof part, "%s%.0f to %.0f", text.empty() ? "" : ", ", arc.from, arc.to);
    text += part;
  }
  if (!text.empty()) text += " deg";
  return more == 0 ? text : text + " and " + std::to_string(more) + " shorter arcs";
}

}  // namespace tank_datum
