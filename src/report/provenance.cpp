#include "report/provenance.h"

#include <utility>

#include "io/input_file.h"
#include "io/sha256.h"
#include "movement/trend.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

Movement movementOf(const Datum& datum, const Baseline& baseline, const RunOptions& run) {
  try {
    return movementSince(baseline, datum, run.datum);
  } catch (const Error& error) {
    if (!run.all) throw;
    Movement none;
    none.baseline = baseline.epoch.name;
    none.message = error.what();
    return none;
  }
}

/// The rates of the judged figures since the baseline's survey.
LimitRates limitRatesSince(const Baseline& baseline, const Datum& datum, const RunOptions& run) {
  Epoch current = epochOf(datum, run.datum.method, "this survey");
  for (const auto& [key, words] : run.identity ? run.identity->about : Identity().about) {
    if (key == "survey_date") current.date = words;
  }
  const std::vector<Epoch> surveys = {baseline.epoch, current};
  requireInOrder(surveys);
  return limitRatesOf(surveys);
}

}  // namespace

std::vector<InputRecord> recordInputs(const Scan& scan, Checksum checksum, const std::function<bool()>& wanted) {
  std::vector<InputRecord> files;
  for (std::size_t i = 0; i < scan.paths().size(); ++i) {
    InputRecord file{scan.paths()[i], scan.sizeOf(i), checksum, {}};
    if (checksum == Checksum::Xxh3) file.hash = scan.hashOf(i, wanted);
    if (checksum == Checksum::Sha256) file.hash = sha256OfFile(file.path, wanted);
    files.push_back(std::move(file));
  }
  scan.requireUnchanged();
  return files;
}

RecordedDatum readRecordedLevelling(const RunOptions& run) {
  const InputFile file(run.levelling);
  RecordedDatum levelled{readLevelling(run.levelling, run.metresPerUnit(), run.diameter, run.datum), {}};
  levelled.file = {run.levelling, levelled.datum.stations.size(), run.checksumTaken(), {}};
  if (levelled.file.checksum == Checksum::Xxh3) levelled.file.hash = file.xxh3();
  if (levelled.file.checksum == Checksum::Sha256) levelled.file.hash = sha256OfFile(run.levelling);
  file.requireUnchanged();
  return levelled;
}

Provenance provenanceOf(std::vector<InputRecord> files, const std::string& units, const DatumOptions& options,
                        const Datum& datum) {
  Provenance provenance;
  provenance.files = std::move(files);
  provenance.units = units;
  provenance.invalid_points = datum.counts.invalid;
  provenance.left_out_points = datum.counts.left_out;
  provenance.far_points = datum.counts.far;
  provenance.options = options;
  return provenance;
}

Provenance provenanceOf(std::vector<InputRecord> files, const RunOptions& run, const std::optional<Baseline>& baseline,
                        const Datum& datum) {
  Provenance provenance = provenanceOf(std::move(files), run.units, run.datum, datum);
  provenance.up = run.up;
  provenance.reading = run.reading;
  provenance.reading.foreign = nullptr;  // what reads does not leave with the result
  provenance.baseline = run.baseline;
  provenance.movement_options = run.movement;
  if (run.identity) provenance.identity = *run.identity;
  if (!baseline || !datum.usable()) return provenance;
  provenance.movement = movementOf(datum, *baseline, run);
  if (provenance.movement->valid()) provenance.limit_rates = limitRatesSince(*baseline, datum, run);
  return provenance;
}

}  // namespace tank_datum
