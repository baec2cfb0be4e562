// A program that knows the installed package only: the chain on a file, its stages on a cloud, the filter, and what the
// library throws. Exits with 0 when each gives the tank that the scan holds: consumer SCAN RADIUS
#include <pcl/search/kdtree.h>
#include <tank_datum/core/error.h>
#include <tank_datum/edge/find_edge_points.h>
#include <tank_datum/pcl/datum_filter.h>
#include <tank_datum/pcl/pcl_stages.h>
#include <tank_datum/report/report.h>
#include <tank_datum/version.h>

#include <cmath>
#include <iostream>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

int failures = 0;

void check(bool ok, const std::string& what) {
  std::cout << (ok ? "ok      " : "FAILED  ") << what << '\n';
  failures += ok ? 0 : 1;
}

Cloud::Ptr readCloud(const std::string& path) {
  auto cloud = std::make_shared<Cloud>();
  const auto scan = tank_datum::Scan::open({path});
  scan.forEachBlock([&](const tank_datum::Points& block) {
    for (const Eigen::Vector3d& p : block) {
      const Eigen::Vector3f at = (p + scan.origin()).cast<float>();
      cloud->push_back({at.x(), at.y(), at.z()});
    }
  });
  return cloud;
}

void checkStages(const Cloud::Ptr& cloud, double radius) {
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const auto normals = tank_datum::estimateNormals(*cloud, tree, tank_datum::NormalOptions());
  const auto candidates = tank_datum::growCandidates(normals, tank_datum::GrowingOptions());
  check(!candidates.empty(), "region growing finds candidates");
  const auto tanks = tank_datum::locateTanks<pcl::PointXYZ>(cloud, tank_datum::LocateOptions());
  check(tanks.size() == 1 && std::abs(tanks[0].circle.radius - radius) < 0.05, "locate finds the tank");
  if (tanks.empty()) return;
  const auto edge = tank_datum::filterByCentre(*cloud, candidates, tanks[0].circle, tank_datum::CentreFilterOptions());
  check(std::abs(edge.circle.radius - radius) < 0.05, "the centre filter finds its circle");
  const auto foot = tank_datum::refineStations<pcl::PointXYZ>(cloud, tanks[0], tank_datum::RefineOptions(),
                                                              tank_datum::StationOptions());
  check(std::abs(foot.refined.circle.radius - radius) < 0.002, "refine finds its radius");
  check(foot.stations.size() == 360, "and has its stations");
}

void checkFilter(const Cloud::Ptr& cloud) {
  tank_datum::DatumFilter<pcl::PointXYZ> filter(true);
  filter.setInputCloud(cloud);
  Cloud edge;
  filter.filter(edge);
  check(filter.getDatum().usable() && !edge.empty(), "the filter gives the datum's edge points");
  check(edge.size() + filter.getRemovedIndices()->size() == cloud->size(), "the filter tells what it removed");
}

void checkErrors(const std::string& path) {
  try {
    tank_datum::DatumOptions options;
    options.normals.k = 1;
    tank_datum::extractDatum(tank_datum::Scan::open({path}), options);
    check(false, "a refused option is thrown");
  } catch (const tank_datum::Error& error) {
    check(error.kind() == tank_datum::Error::Kind::Option, std::string("thrown: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string path = argv[1];
  const double radius = std::stod(argv[2]);
  std::cout << "tank_datum " << tank_datum::kVersion << '\n';
  const auto datum = tank_datum::extractDatum(tank_datum::Scan::open({path}), tank_datum::DatumOptions());
  check(datum.usable() && std::abs(datum.circle.radius - radius) < 0.002, "extractDatum finds the radius");
  const auto cloud = readCloud(path);
  checkStages(cloud, radius);
  checkFilter(cloud);
  checkErrors(path);
  return failures == 0 ? 0 : 1;
}
