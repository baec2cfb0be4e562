#include "tank_datum/report.h"
#include "tank_datum/sha256.h"

namespace tank_datum {

Provenance provenanceOf(const std::vector<std::string>& paths, const std::string& units, const DatumOptions& options,
                        const Datum& datum) {
  Provenance provenance;
  for (const std::string& path : paths) {
    provenance.files.push_back({path, sha256OfFile(path), Scan::open({path}).size()});
  }
  provenance.units = units;
  provenance.invalid_points = datum.counts.invalid;
  provenance.options = options;
  return provenance;
}

}  // namespace tank_datum
