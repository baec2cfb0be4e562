#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/edge/edge_points.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/search/normals.h"
#include "tank_datum/setups/setups.h"
#include "tank_datum/shape/analysis.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"
#include "tank_datum/trust/tank_tests.h"

namespace TANK_DATUM_API tank_datum {

/// What a station's z is.
enum class Method {
  Refined,  ///< the intersection of two fitted surfaces
  Paper,    ///< the paper's B-spline through edge points, which straddle the crease: millimetres too high
};

/// The name used at the command line and in files: "refined", "paper".
const char* nameOf(Method method);

/// Every option of the chain, stage by stage.
struct DatumOptions {
  Method method = Method::Refined;
  LocateOptions locate;
  CropOptions crop;
  NormalOptions normals;
  GrowingOptions growing;
  CentreFilterOptions centre_filter;
  SplineOptions spline;
  SetupOptions setups;
  RefineOptions refine;
  StationOptions stations;
  AnalysisOptions analysis;
  ShellOptions shell;
  std::optional<Circle> tank;  ///< the tank's circle in the scan's frame [m], when it need not be searched
  bool accept = false;         ///< a doubtful tank is taken for one
  bool level = false;          ///< turn the scan so that the shell stands upright
  int pick = 1;                ///< which of the tanks found, best first, counted from 1
  int threads = 0;             ///< 0: all cores; the result does not depend on it
};

/// The first refused option, or nothing.
std::optional<Refusal> firstError(const DatumOptions& options);

enum class Status {
  NotRun,
  Ok,            ///< every station measured or interpolated
  Partial,       ///< some stations missing
  NoTank,        ///< no vertical cylinder in the scan
  NoCrease,      ///< a shell, but no foundation surface meeting it
  TooFewPoints,  ///< fewer points than the neighbours asked for
  FitFailed,     ///< edge points that no closed curve can be fitted to
  Doubtful,      ///< a datum of something like a tank, that fails a test of whether it is one
};

/// The name used in files: "ok", "partial", "no_tank", ...
const char* nameOf(Status status);

/// What was looked at where no datum was found: to see why, and what may help.
struct Sighting {
  Circle circle;                    ///< the circle tried, relative to the scan's origin [m]; not valid without any
  double foot = kUnknown;           ///< mean height of the shell's foot, relative to the origin [m]
  Points points;                    ///< a thinned sample of the scan, near the circle if there is one [m]
  std::vector<std::string> advice;  ///< three things to try
};

/// The datum of one tank. Lengths in metres relative to `origin`; usable() says whether there is one.
struct Datum {
  Status status = Status::NotRun;
  std::string message;                               ///< why there is none, what is missing, what to mind
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< add it for the scan's own frame
  double coordinate_step = 0;                        ///< between coordinates that the scan's files can hold [m]
  ScanCounts counts;
  bool levelled = false;  ///< stations typed in, not found in a scan: only they and what they mean are known
  Tank tank;
  Points edge_points;  ///< in order round the tank
  Circle circle;       ///< about whose centre the stations stand
  ClosedSpline curve;  ///< the paper's
  Refined refined;     ///< not valid with Method::Paper
  std::vector<Station> stations;
  SetupAgreement agreement;      ///< of the scanner's setups
  StationCovariance covariance;  ///< of their z; empty: each station by itself, sigma_z
  Level level;
  Tilt tilt;
  Antipodal antipodal;
  Analysis analysis;
  double asked_height = kUnknown;  ///< of the shell, as it was given for the checks [m]
  ShellSurvey shell;
  std::vector<TankTest> tests;     ///< of whether it is a tank
  ShellLean lean;                  ///< of the shell near its foot
  double foot_density = kUnknown;  ///< points a degree beside the foot, on the foundation's side
  Sighting sighting;               ///< of a datum that is not usable

  bool usable() const { return status == Status::Ok || status == Status::Partial; }
  /// Whether there are stations to look at: of a usable datum, or of a doubtful one.
  bool hasStations() const { return usable() || status == Status::Doubtful; }
};

/// What a caller may hang into the chain; each may be empty. What one of them throws ends the chain.
struct Callbacks {
  std::function<void(const char* name)> stage;                ///< told the name of each stage as it begins
  std::function<void(const std::vector<Tank>& tanks)> tanks;  ///< told what was found, before the long rest
  /// Gives the ring's points for the search their neighbours and normals, which are compared with each other alone;
  /// empty: estimateNormals.
  std::function<Normals(const Points& points, const NormalOptions& options, int threads)> normals;
  /// Told the scan that the chain begins anew on, turned upright (options.level): the points that follow are its.
  std::function<void(const Scan& scan)> turned = {};
};

/// The tanks of a scan, best first; or the one that options.tank gives.
/// @throws Error  a refused option, a file that cannot be read
std::vector<Tank> findTanks(const Scan& scan, const DatumOptions& options, const Callbacks& callbacks = {});

/// The datum of one of a scan's tanks: crop, setups, normals, region growing, centre filter, spline, refine,
/// deformation, shell, checks. What the data lack is said by its status.
/// @param tank  one that findTanks gave; Tank() for a scan without one, which gives the reason
/// @throws Error  a refused option, a file that cannot be read
Datum extractDatum(const Tank& tank, const Scan& scan, const DatumOptions& options, const Callbacks& callbacks = {});

/// The same for the tank that options.pick counts among those found, levelled if options.level asks for it.
Datum extractDatum(const Scan& scan, const DatumOptions& options, const Callbacks& callbacks = {});

/// The datum of stations whose elevations a levelling survey gives, described and judged as that of a scan: about the
/// centre (0, 0).
/// @throws Error (Option) a refused option; elevations further apart than a tenth of the diameter
Datum datumOfLevelling(std::vector<Station> stations, double diameter, const DatumOptions& options);

/// Reads a table of such stations, columns azimuth_deg, elevation and, where known, sigma.
/// @param diameter  of the tank [m]
/// @throws Error  the file cannot be read, or is refused
Datum readLevelling(const std::string& path, double metres_per_unit, double diameter, const DatumOptions& options);

/// What in a result looks like a mistake of units or of what was typed in; they stand in its notes too.
std::vector<std::string> warningsOf(const Datum& datum);

}  // namespace tank_datum
