#include "options/run_options.h"

#include "core/length_units.h"
#include "setups/agreement.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/shape/analysis.h"

namespace tank_datum {

double RunOptions::metresPerUnit() const { return kUnits.at(units); }

void readFilesOf(RunOptions& run) {
  if (!run.setup_origins.empty()) {
    run.datum.setups.origins = readSetupOrigins(run.setup_origins, run.metresPerUnit());
  }
  AnalysisOptions& analysis = run.datum.analysis;
  if (!analysis.limits_file.empty()) analysis.limits = readLimits(analysis.limits_file);
}

}  // namespace tank_datum
