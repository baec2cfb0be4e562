#include "report/provenance.h"

#include <utility>

#include "io/sha256.h"

namespace tank_datum {

std::vector<InputRecord> recordInputs(const std::vector<std::string>& paths, const std::function<bool()>& wanted,
                                      ScanOptions reading) {
  reading.setups.clear();  // the names may be those of other files; the rows of all setups count
  std::vector<InputRecord> files;
  for (const std::string& path : paths) {
    files.push_back({path, sha256OfFile(path, wanted), Scan::open({path}, 1.0, reading).size()});
  }
  return files;
}

InputRecord recordOfLevelling(const std::string& path, const Datum& datum) {
  return {path, sha256OfFile(path), datum.stations.size()};
}

Provenance provenanceOf(std::vector<InputRecord> files, const std::string& units, const DatumOptions& options,
                        const Datum& datum) {
  Provenance provenance;
  provenance.files = std::move(files);
  provenance.units = units;
  provenance.invalid_points = datum.counts.invalid;
  provenance.left_out_points = datum.counts.left_out;
  provenance.options = options;
  return provenance;
}

}  // namespace tank_datum
