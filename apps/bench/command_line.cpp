#include "command_line.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>

#include "core/units.h"
#include "parsed.h"
#include "tank_datum/version.h"

namespace tank_datum::bench {
namespace {

/// Refused before minutes of measuring, not after them.
std::string inAFolder(const std::string& path) {
  const auto folder = std::filesystem::absolute(path).parent_path();
  return std::filesystem::is_directory(folder) ? "" : folder.string() + " is no folder";
}

void addOptions(CLI::App& app, Command& command, double& angle_deg) {
  const auto positive = CLI::PositiveNumber;
  app.add_option("scan", command.scan, "PCD file")->required();
  app.add_option("--json", command.json, "file for the figures")->check(inAFolder);
  app.add_option("--k", command.options.normals.k, "neighbours of a point, itself included, of both chains")
      ->check(CLI::Range(3, 1000));
  app.add_option("--angle-deg", angle_deg, "theta of both chains")->check(CLI::Range(0.1, 89.9));
  app.add_option("--threads", command.options.threads, "threads; 0: all cores")->check(CLI::NonNegativeNumber);
  app.add_option("--search-points", command.options.crop.search_points, "the ring's points that both chains work on")
      ->check(CLI::Range(1000, 1'000'000'000));
  app.add_option("--repeats", command.repeats, "of the chains on the ring; the fastest counts")->check(positive);
  app.add_option("--stock-points", command.stock_points,
                 "the stock chain is run on the whole scan if it has at most so many points");
  const std::map<std::string, Checksum> checksums = {
      {"xxh3", Checksum::Xxh3}, {"sha256", Checksum::Sha256}, {"none", Checksum::None}};
  app.add_option("--checksum", command.checksum, "of the scan, by the command")
      ->transform(CLI::CheckedTransformer(checksums))
      ->default_str("xxh3");
  CLI::Option* scale = app.add_flag("--scale", command.scale,
                                    "make scans of 1, 10, 100 million points of this one, and run the command");
  app.add_option("--smallest", command.smallest, "scan that --scale makes [million points]")
      ->check(positive)
      ->needs(scale);
  app.add_option("--largest", command.largest, "scan that --scale makes [million points]; 1000 needs 12 GB of disk")
      ->check(positive)
      ->needs(scale);
  app.add_option("--folder", command.folder, "for the scans that --scale makes, each removed after its run")
      ->check(CLI::ExistingDirectory)
      ->needs(scale);
  app.set_version_flag("--version", std::string("tank_datum_bench ") + kVersion);
}

}  // namespace

bool parseCommandLine(int argc, char** argv, Command& command, int& status) {
  CLI::App app(
      "What the chain costs: PCL's own classes beside tank_datum, stage by stage, on the same points with the same k "
      "and theta, and whether both mark the same candidates.",
      "tank_datum_bench");
  app.option_defaults()->always_capture_default();
  command.folder = std::filesystem::temp_directory_path().string();
  double angle_deg = command.options.growing.angle / kDegree;
  addOptions(app, command, angle_deg);
  if (!parsed(app, argc, argv, status)) return false;
  command.options.growing.angle = angle_deg * kDegree;
  return true;
}

}  // namespace tank_datum::bench
