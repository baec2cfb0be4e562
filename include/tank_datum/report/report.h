#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace TANK_DATUM_API tank_datum {

/// A scan file as the results name it.
struct InputRecord {
  std::string path;
  std::uint64_t points = 0;  ///< rows, whatever is left out of them
  Checksum checksum = Checksum::None;
  std::string hash;  ///< by that checksum, in hexadecimal digits; empty: not taken
};

/// A place at the shell that readers know.
struct ReferenceMark {
  std::string name;
  double azimuth = kUnknown;  ///< as stations are counted [rad]
};

/// What the user says of the tank and its survey, for the readers of the results.
struct Identity {
  std::vector<std::pair<std::string, std::string>> about;  ///< key and words, "tank", "site", ...; see outputs.md
  std::string logo;                                        ///< an image as a data URI, or empty
  std::vector<ReferenceMark> marks;
  double north = kUnknown;           ///< direction of north, counter-clockwise from +x [rad]
  int survey_points = 0;             ///< numbered clockwise from north, or from +y where north is not known; 0: none
  std::string display_units = "mm";  ///< of lengths for readers: "mm", "in", "ft"; files hold metres
  std::string language = "en";       ///< of the report and of what it shares with the summary
};

/// Where a datum comes from, for the record.
struct Provenance {
  std::vector<InputRecord> files;
  std::string units = "m";
  std::string up = "z";  ///< the axis of the scan's frame that is vertical
  std::uint64_t invalid_points = 0;
  std::uint64_t left_out_points = 0;  ///< withheld, or not of reading.las_classes or reading.setups
  std::uint64_t far_points = 0;       ///< of those looked at, see ScanCounts
  ScanOptions reading;                ///< how the files were read
  DatumOptions options;
  std::string baseline;  ///< the earlier survey compared with, or empty
  MovementOptions movement_options;
  std::optional<Movement> movement;  ///< since the baseline
  LimitRates limit_rates;            ///< of the judged figures since then
  Identity identity;
};

/// The hashes and rows of a scan's files. XXH3 takes what the passes so far have read, with ScanOptions::hash, and
/// reads the rest; SHA-256 reads all of the files once more and takes longer than the extraction, beside which this can
/// run in a thread of its own.
/// @param wanted  asked now and then; false: it returns soon, the rest of the hashes empty
/// @throws Error (File) naming the file that cannot be read
std::vector<InputRecord> recordInputs(const Scan& scan, Checksum checksum = Checksum::Xxh3,
                                      const std::function<bool()>& wanted = {});

/// The record of a datum read from files.
/// @param units  of the files, "m", "mm" or "ft"
Provenance provenanceOf(std::vector<InputRecord> files, const std::string& units, const DatumOptions& options,
                        const Datum& datum);

/// stations.csv: the header line, then one row per station; unknown values are empty. Metres, degrees.
std::string stationsCsv(const Datum& datum);

/// datum.json: two-space indented, unknown values null. Metres, degrees.
std::string datumJson(const Datum& datum, const Provenance& provenance);

/// The summary for a terminal: some 15 lines, lengths in the provenance's units for readers.
/// @param blocks  whether to draw the elevations in UTF-8 block characters
std::string summary(const Datum& datum, const Provenance& provenance, bool blocks = false);
std::string summary(const Datum& datum);

/// Writes datum.json, stations.csv, shell.csv and, of a usable datum, datum_points.pcd and datum_curve.pcd into a
/// folder.
/// @throws Error (File) naming the path
void writeResults(const std::string& folder, const Datum& datum, const Provenance& provenance);

/// report.html: everything datum.json and stations.csv say, to look at; of refined results with sections, what each
/// station was fitted to.
std::string reportPage(const Datum& datum, const Provenance& provenance);

/// Writes report.html into a folder.
/// @throws Error (File) naming the path
void writeReportPage(const std::string& folder, const std::string& page);

/// A tank of several in one scan, and where its results are.
struct IndexEntry {
  const Datum& datum;
  const Provenance& provenance;
  std::string page;  ///< relative to the index: "tank_1/report.html", or its datum.json
};

/// index.html: the tanks of a scan with their verdicts, on a plan and in a table that leads to each one's page.
std::string indexPage(const std::vector<IndexEntry>& tanks);

/// Writes index.html into a folder.
/// @throws Error (File) naming the path
void writeIndexPage(const std::string& folder, const std::string& page);

}  // namespace tank_datum
