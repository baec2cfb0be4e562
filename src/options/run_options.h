#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

struct Identity;

/// All that a run can be asked for: the options of the library, and those of reading and writing. option_table.cpp
/// says what each is called, means and may be.
struct RunOptions {
  DatumOptions datum;
  MovementOptions movement;
  std::string units = "m";                   ///< of the input
  std::string up = "z";                      ///< the axis of the scan's frame that is vertical
  ScanOptions reading;                       ///< of files
  std::string baseline;                      ///< datum.json or folder of an earlier survey, or empty
  std::string setup_origins;                 ///< file of datum.setups.origins, or empty
  std::string about;                         ///< file of what the report says of the tank, or empty
  std::vector<std::string> marks;            ///< "name=azimuth" in degrees
  double north = kUnknown;                   ///< where it is, counter-clockwise from +x [degrees]
  int survey_points = 0;                     ///< numbered from north; 0: none
  std::string display_units = "mm";          ///< of what people read
  std::string language = "en";               ///< of the report
  std::shared_ptr<const Identity> identity;  ///< what these six say, readIdentity() reads it
  Checksum checksum = Checksum::Xxh3;        ///< of the files that go in
  bool no_checksum = false;                  ///< the same as none

  // of the command alone
  std::string output;          ///< folder for the results
  std::string levelling;       ///< file of stations typed in, in place of scans
  double diameter = kUnknown;  ///< of their tank [m]
  std::string timings;         ///< file for the seconds of each stage, or empty
  std::string json;            ///< file for datum.json besides, "-" standard output, or empty
  bool all = false;            ///< every tank, each in a folder of its own
  bool no_report = false;      ///< no report.html
  bool quiet = false;
  std::string config;  ///< file of options that was read, or empty
  bool print_config = false, print_limits = false, print_options = false;

  double metresPerUnit() const;
  Checksum checksumTaken() const { return no_checksum ? Checksum::None : checksum; }
};

/// Reads the files that options name: origins of setups, limits.
/// @throws Error  as readSetupOrigins and readLimits
void readFilesOf(RunOptions& run);

/// The first refused option; nothing when all are fine.
std::optional<Refusal> firstError(const RunOptions& run);

}  // namespace tank_datum
