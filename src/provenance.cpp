#include <utility>

#include "tank_datum/report.h"
#include "tank_datum/sha256.h"

namespace tank_datum {

std::vector<InputRecord> recordInputs(const std::vector<std::string>& paths, const std::function<bool()>& wanted) {
  std::vector<InputRecord> files;
  for (const std::string& path : paths) files.push_back({path, sha256OfFile(path, wanted), Scan::open({path}).size()});
  return files;
}

Provenance provenanceOf(std::vector<InputRecord> files, const std::string& units, const DatumOptions& options,
                        const Datum& datum) {
  Provenance provenance;
  provenance.files = std::move(files);
  provenance.units = units;
  provenance.invalid_points = datum.counts.invalid;
  provenance.options = options;
  return provenance;
}

}  // namespace tank_datum
