#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// Points relative to Scan::origin() [m].
using Points = std::vector<Eigen::Vector3d>;

/// What one pass over a scan met.
struct ScanCounts {
  std::uint64_t points = 0;    ///< rows in the files
  std::uint64_t invalid = 0;   ///< rows dropped because x, y or z is not finite, or is a beam of PTX without return
  std::uint64_t left_out = 0;  ///< rows dropped that LAS marks as withheld, or whose class or setup is not asked for

  /// Rows looked at that cannot be of the tank that was measured: at zero of the scan's own frame, as beams without a
  /// return are often written, or more than 100 of its radii away.
  std::uint64_t far = 0;

  std::uint64_t kept() const { return points - invalid - left_out; }

  ScanCounts& operator+=(const ScanCounts& other) {
    points += other.points;
    invalid += other.invalid;
    left_out += other.left_out;
    far += other.far;
    return *this;
  }
};

/// Which setup of a scanner points come from: the file, and what the file's field of labels says.
struct SetupKey {
  std::uint32_t source = 0;  ///< number of the file, from 0
  std::uint32_t label = 0;   ///< 0 in a file without labels

  static constexpr std::uint32_t kUnlabelled = 0xffffffffU;  ///< what the field says is no number from 0 on
  bool operator==(const SetupKey& other) const { return source == other.source && label == other.label; }
};

/// Points that somebody else reads, block by block, in as many passes as the stages need. All blocks of a pass are
/// asked for by one thread of the library's, one ahead of the one that is looked at.
struct ScanBlocks {
  struct Block {
    Points points;                      ///< in their own frame [m]
    std::uint32_t setup = 0;            ///< of all of them, unless each has its own
    std::vector<std::uint32_t> setups;  ///< of each of them; empty: all are of `setup`
    std::uint64_t invalid = 0;          ///< rows beside them that hold no point
    std::uint64_t left_out = 0;         ///< rows beside them that are not wanted
    /// May be set to what fills the members above later, while the next block is read: with all of the block, or with
    /// some rows at a time, such as fit into a cache; true: it has more, and is asked again when these were looked at.
    /// It is called in the thread that looks at the points, and has to keep what it needs; what replaces the block
    /// replaces it too.
    std::function<bool(Block& block)> finish;
  };
  /// Replaces the block by the next one, of any size; false, and what it holds does not matter, behind the last.
  using Next = std::function<bool(Block& block)>;

  struct Setup {
    std::string name;                          ///< empty: its points are those of the file itself
    std::optional<Eigen::Vector3d> viewpoint;  ///< where the scanner stood, in the points' frame [m]
  };

  std::function<Next()> start;   ///< begins a pass over the same blocks
  std::uint64_t size = 0;        ///< rows in all of them; 0: not known
  double coordinate_step = 0.0;  ///< between neighbouring coordinates that were stored [m]; 0: below what matters
  bool tells_setups = false;     ///< Block::setup means something
  std::map<std::uint32_t, Setup> setups;  ///< what is known of them; one that is not here is called by its number

  /// Begins a pass over the blocks of some setups; rows of the others are told as left out. May be set where `setups`
  /// has them all; where it is not set all are read.
  std::function<Next(const std::vector<std::uint32_t>& wanted)> start_some;

  /// Parts of the scan that a pass can leave unread, such as chunks of a compressed file; 0: it cannot.
  std::uint64_t parts = 0;
  /// Begins a pass over every n-th part; rows of the others are told as left out. Set where `parts` is.
  std::function<Next(std::uint64_t n)> start_every;
};

/// A file of a format that is recognised, and read by somebody else.
struct ForeignScan {
  std::string path;
  std::string format;            ///< "E57" or "LAZ", which COPC is too
  double metres_per_unit = 1.0;  ///< of what the file holds
  std::vector<int> las_classes;  ///< as ScanOptions has them
};

/// By which hash of their bytes files are known again.
enum class Checksum { None, Xxh3, Sha256 };

/// "none", "xxh3", "sha256"
const char* nameOf(Checksum checksum);

/// How files are read.
struct ScanOptions {
  std::vector<int> las_classes;     ///< classification codes of the points of LAS files that are wanted; empty: all
  std::vector<std::string> setups;  ///< names of the setups that are wanted, see Scan::setupName; empty: all
  std::function<ScanBlocks(const ForeignScan& scan)> foreign;  ///< reads such files; not set: they are refused
  bool hash = false;  ///< take the files' XXH3-128 from what is read of them, for Scan::hashOf
};

/// How rows in memory hold their coordinates.
struct RowNumbers {
  bool single = false;           ///< in 4-byte floats
  double metres_per_unit = 1.0;  ///< of these; rows are asked for in metres
};

/// A laser scan as a stream of blocks: files of any size, or points in memory, seen the same way by the stages.
///
/// Coordinates are read in double and reduced by a local origin before anybody sees them, so that float32 work on
/// them keeps micrometres at 4e6 m. Several files are scan stations of one tank in one frame: one stream.
class Scan {
 public:
  /// Receives the next block of finite points, relative to origin().
  using Visitor = std::function<void(const Points& block)>;

  /// The i-th row of points somebody else holds, in their own frame [m].
  using Row = std::function<Eigen::Vector3d(std::uint64_t i)>;

  /// Opens files of the formats known: PCD, LAS, PLY, PTS, PTX and text of columns. Which a file is tells its content,
  /// not its name. Headers are read and checked here, data in forEachBlock.
  /// @param metres_per_unit  scale of the stored coordinates (0.001 for mm)
  /// @throws Error (File) naming the file, the value met and what was expected
  static Scan open(const std::vector<std::string>& paths, double metres_per_unit = 1.0,
                   const ScanOptions& options = {});

  /// Points in memory, in their own frame [m]; not finite ones are dropped and counted like those of a file.
  static Scan fromPoints(const Points& points);

  /// The same without a copy: points of any kind in memory, asked for row by row in every pass.
  static Scan fromRows(std::uint64_t rows, Row row, RowNumbers numbers = {});

  /// Points that somebody else reads, block by block. Size 0 has them counted in a pass of its own.
  static Scan fromBlocks(ScanBlocks blocks);

  /// The same scan in a frame turned about the zero of its own, as when another of its axes looks up. Coordinates in
  /// the results are the turned frame's.
  Scan turned(const Eigen::Matrix3d& rotation) const;

  /// The same scan turned about a point of its own frame, as when it was not level.
  Scan turnedAbout(const Eigen::Vector3d& point, const Eigen::Matrix3d& rotation) const;

  /// The same scan with another local origin: at zero, coordinates are those of its own frame to the last bit.
  Scan relativeTo(const Eigen::Vector3d& origin) const;

  /// Visits every finite point once, in file order. May be called again for another pass.
  /// @throws Error (File) when the data are shorter or other than the header says, or the file changes meanwhile
  ScanCounts forEachBlock(const Visitor& visit) const;

  /// The same, told which file or array a block is of and the labels of its points; none: all are 0.
  using LabelledVisitor =
      std::function<void(const Points& block, std::uint32_t source, const std::vector<std::uint32_t>& labels)>;
  ScanCounts forEachLabelled(const LabelledVisitor& visit) const;

  /// Local origin in the scan's own frame [m]; add it to go back. It is the first finite point, no stray and not at
  /// zero, so that the same tank has the same local coordinates, and so the same datum, wherever its frame lies.
  const Eigen::Vector3d& origin() const { return origin_; }

  /// Appends to `chosen` what it wants of the points of a block, the block-th of the scan.
  using Chooser = std::function<void(std::uint64_t block, const Points& points, Points& chosen)>;

  /// Visits, in file order, what is chosen of each block. Blocks of a binary file are read, decoded and chosen from in
  /// several threads at once; visit is called from the caller's, while others choose from the blocks that follow.
  /// @param threads  0 means all cores; which blocks there are does not depend on it
  /// @param n        choose is given about every n-th row only, and these alone are decoded where the format allows;
  ///                 odd, lest it keeps step with rows of even lengths
  /// @return of all rows
  /// @throws as forEachBlock
  ScanCounts forEachChosen(const Chooser& choose, int threads, const Visitor& visit, std::uint64_t n = 1) const;

  /// The same, told of what is chosen the setup it comes from. Points of one block that come from several setups are
  /// chosen from and visited setup by setup.
  using SetupVisitor = std::function<void(const Points& chosen, SetupKey setup)>;
  ScanCounts forEachChosen(const Chooser& choose, int threads, const SetupVisitor& visit, std::uint64_t n = 1) const;

  /// Whether the scan may hold several setups: several files, or points with labels (a field `setup`, `scan_id` or
  /// `point_source_id`; the scans of a PTX file, the blocks of a PTS file).
  bool tellsSetups() const;

  /// The setups that there are, file by file in rising order of labels. Files that do not list them are read once more.
  std::vector<SetupKey> setups() const;

  /// The file's name without its ending, the label, or both where both are needed: "file:label".
  std::string setupName(SetupKey setup) const;
  /// The label alone; empty in a file without labels, and for points that bear none.
  std::string setupLabel(SetupKey setup) const;

  /// Where the scanner stood, as the file says (PCD VIEWPOINT, PTX position), relative to origin() [m]; nothing when it
  /// does not.
  std::optional<Eigen::Vector3d> setupOrigin(SetupKey setup) const;

  /// Of about every n-th row the point, if it is finite, in file order. Where ScanBlocks can leave parts unread, as
  /// many rows of some hundred parts, spread over the scan.
  /// @param n,threads  as for forEachChosen
  /// @throws as forEachBlock
  Points everyNth(std::uint64_t n, int threads = 0) const;

  /// Told during forEachChosen and everyNth, from the caller's thread, how many of the size() rows have been read.
  using Progress = std::function<void(std::uint64_t rows)>;
  void setProgress(Progress progress) { progress_ = std::move(progress); }

  /// Rows announced by the headers.
  std::uint64_t size() const;
  std::uint64_t sizeOf(std::size_t file) const;

  /// XXH3-128 of the bytes of one of paths(), in hexadecimal digits as `xxhsum -H2` prints it. What passes have not
  /// read of the file is read now: all of it without ScanOptions::hash, or when somebody else reads the format.
  /// @param wanted  asked before each megabyte; false: an empty text is returned at once
  /// @throws Error (File) when the file cannot be read
  std::string hashOf(std::size_t file, const std::function<bool()>& wanted = {}) const;

  /// Passes see to this by themselves: no file has been written to, replaced or removed since it was opened.
  /// @throws Error (File) naming the one that has
  void requireUnchanged() const;

  /// Step between neighbouring coordinates that the files can hold at the origin [m]: 0.25 for 4-byte floats near 4e6
  /// m. Zero for points in memory that are doubles.
  double coordinateStep() const;

  /// Empty for points in memory.
  const std::vector<std::string>& paths() const { return paths_; }

  class Source;  ///< one file or one array, see scan.cpp

 private:
  /// forEachChosen of all rows, or everyNth of some parts of them.
  ScanCounts choose(const Chooser& choose, int threads, const SetupVisitor& visit, std::uint64_t n,
                    bool of_parts) const;
  void pickSetups(const std::vector<std::string>& names);

  std::vector<std::shared_ptr<const Source>> sources_;
  std::vector<std::string> paths_;
  struct File;
  std::vector<std::shared_ptr<const File>> files_;  ///< of paths_, open
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d stored_origin_ = Eigen::Vector3d::Zero();  ///< the same point in the frame of the files
  std::optional<Eigen::Matrix3d> rotation_;                  ///< from their frame to the scan's
  Progress progress_;
};

}  // namespace tank_datum
