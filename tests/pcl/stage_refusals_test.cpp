// Single stages and the filter: what they refuse by name, and what a filter tells while it runs.
#include <gtest/gtest.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "support/pcl_clouds.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"
#include "tank_datum/pcl/datum_filter.h"
#include "tank_datum/pcl/pcl_stages.h"

namespace tank_datum::stage_refusals_test {

using pcl_clouds::tankCloud;
using pcl_clouds::toTheEdge;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

const Cloud::ConstPtr& tank() {
  static const Cloud::ConstPtr cloud = tankCloud<pcl::PointXYZ>();
  return cloud;
}

TEST(StageRefusals, NeighboursMustBeThreeOrMore) {
  Tree tree;
  tree.setInputCloud(tank());
  for (const int k : {0, -5, 2}) {
    NormalOptions options;
    options.k = k;
    const std::string expected = "options: k, " + std::to_string(k) + ", expected >= 3";
    EXPECT_EQ(refusalOf(Error::Kind::Option, [&] { estimateNormals(*tank(), options); }), expected);
    EXPECT_EQ(refusalOf(Error::Kind::Option, [&] { estimateNormals(*tank(), tree, options); }), expected);
    options.search = SearchEngine::Buckets;
    EXPECT_EQ(refusalOf(Error::Kind::Option, [&] { estimateNormals(*tank(), options); }), expected);
  }
  for (const int k : {0, -5}) {
    const std::string expected = "normals: k, " + std::to_string(k) + ", expected ";
    EXPECT_EQ(refusalOf(Error::Kind::Option, [&] { findNeighbours(tree, *tank(), {0, 1}, k); }), expected + ">= 1");
    EXPECT_NE(refusalOf(Error::Kind::Option, [&] { fitNormals(pointsOf(*tank()), {}, k); }).find(expected),
              std::string::npos);
  }
  EXPECT_NE(refusalOf(Error::Kind::Option,
                      [&] {
                        fitNormals(pointsOf(*tank()), {1, 2, 3}, 3);
                      })
                .find("as many as points"),
            std::string::npos);
}

TEST(StageRefusals, EveryStageNamesItsOption) {
  const Normals normals = estimateNormals(*tank(), NormalOptions());
  GrowingOptions growing;
  growing.angle = 2.0;
  EXPECT_NE(refusalOf(Error::Kind::Option, [&] { growCandidates(normals, growing); }).find("options: angle_deg, 114"),
            std::string::npos);
  CentreFilterOptions centre;
  centre.tolerance = -0.1;
  EXPECT_EQ(refusalOf(Error::Kind::Option, [&] { filterByCentre(*tank(), {}, std::nullopt, centre); }),
            "options: centre_tolerance, -0.1, expected >= 0 m");
  LocateOptions locate;
  locate.min_radius = 0.0;
  EXPECT_EQ(refusalOf(Error::Kind::Option, [&] { locateTanks<pcl::PointXYZ>(tank(), locate); }),
            "options: min_radius, 0, expected > 0 m");
  StationOptions stations;
  stations.count = 7;
  EXPECT_EQ(
      refusalOf(Error::Kind::Option, [&] { refineStations<pcl::PointXYZ>(tank(), Tank(), RefineOptions(), stations); }),
      "options: stations, 7, expected 8 to 36000");
  CropOptions crop;
  crop.fit_points = 10;
  EXPECT_EQ(refusalOf(Error::Kind::Option,
                      [&] { refineStations<pcl::PointXYZ>(tank(), Tank(), RefineOptions(), StationOptions(), crop); }),
            "options: fit_points, 10, expected >= 1000");
}

TEST(StageRefusals, CurvatureIsThatOfPcl) {
  NormalOptions options;
  options.k = 12;
  const Normals normals = estimateNormals(*tank(), options);
  const auto cloud = toPcl(normals, *tank());
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(tank());
  estimation.setSearchMethod(std::make_shared<Tree>());
  estimation.setKSearch(options.k);
  pcl::PointCloud<pcl::Normal> expected;
  estimation.compute(expected);
  ASSERT_EQ(cloud.size(), expected.size());
  float largest = 0.0F;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud[i].curvature, expected[i].curvature, 2e-3) << i;  // sums in float there
    largest = std::max(largest, cloud[i].curvature);
  }
  EXPECT_GT(largest, 0.1F);  // at the crease
  EXPECT_TRUE(std::isnan(toPcl(normals)[0].curvature));
  EXPECT_NE(refusalOf(Error::Kind::Option, [&] { toPcl(normals, Points(3)); }).find("normals: points, 3"),
            std::string::npos);
}

TEST(StageRefusals, CurvatureOfKnownPoints) {
  // a cross in the plane, and two points above and below its centre: variances 2, 2 and 0.5 of 4.5
  const Points points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 0.5}, {0, 0, -0.5}};
  Neighbours all;
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i < 6; ++i) all.push_back(i);
  }
  EXPECT_NEAR(toPcl(fitNormals(points, all, 6), points)[0].curvature, 0.5 / 4.5, 1e-6);
}

/// A search that answers otherwise than it should.
struct WrongTree : Tree {
  enum class Fault { OtherCloud, Same } fault = Fault::OtherCloud;

  int nearestKSearch(const pcl::PointXYZ& point, int k, pcl::Indices& found,
                     std::vector<float>& distances) const override {
    const int met = Tree::nearestKSearch(point, k, found, distances);
    for (auto& i : found) i = fault == Fault::Same ? found.front() : i + 1'000'000;
    return met;
  }
};

TEST(StageRefusals, ASearchThatCannotBeUsedIsSaid) {
  const auto tree = std::make_shared<WrongTree>();
  tree->setInputCloud(tank());
  DatumFilter<pcl::PointXYZ> filter;
  filter.setOptions(toTheEdge());
  filter.setInputCloud(tank());
  filter.setSearchMethod(tree);
  pcl::Indices edge;
  const std::string other = refusalOf(Error::Kind::Option, [&] { filter.filter(edge); });
  EXPECT_NE(other.find("by the search method, point 10"), std::string::npos) << other;
  EXPECT_NE(other.find("is the search over another cloud?"), std::string::npos) << other;
  tree->fault = WrongTree::Fault::Same;
  const std::string same = refusalOf(Error::Kind::Option, [&] { filter.filter(edge); });
  EXPECT_NE(same.find(" twice, expected points of the cloud"), std::string::npos) << same;
  EXPECT_EQ(filter.getDatum().status, Status::NotRun);
}

TEST(StageRefusals, ConstantNormalsAreSaid) {
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (const auto& p : *tank()) {
    pcl::PointNormal point;
    point.getVector3fMap() = p.getVector3fMap();
    point.getNormalVector3fMap() = Eigen::Vector3f::UnitZ();
    cloud->push_back(point);
  }
  DatumFilter<pcl::PointNormal> filter;
  filter.setOptions(toTheEdge());
  filter.setInputCloud(cloud);
  filter.setUseCloudNormals(true);
  pcl::Indices edge;
  filter.filter(edge);
  EXPECT_TRUE(edge.empty());
  EXPECT_NE(filter.getDatum().message.find("no paper's curve: all normals are the same"), std::string::npos)
      << filter.getDatum().message;
  DatumOptions flat = toTheEdge();
  flat.growing.angle = 1.57;  // no crease is as sharp
  filter.setUseCloudNormals(false);
  filter.setOptions(flat);
  filter.filter(edge);
  EXPECT_EQ(filter.getDatum().message.find("all normals"), std::string::npos) << filter.getDatum().message;
}

TEST(StageRefusals, NoStageLooksForWhatTheCloudDoesNotHave) {
  const auto refused = [](const auto& work) { return refusalOf(Error::Kind::Option, work); };
  const auto last = static_cast<std::int32_t>(tank()->size()) - 1;
  for (const std::int32_t bad : {-1, last + 1}) {
    const std::string expected = ", expected one of the cloud's " + std::to_string(tank()->size()) + " points";
    EXPECT_EQ(refused([&] {
                filterByCentre(*tank(), {last, bad}, std::nullopt, {});
              }),
              "pcl: candidate, " + std::to_string(bad) + expected);
    EXPECT_EQ(refused([&] { scanOf<pcl::PointXYZ>(tank(), std::make_shared<pcl::Indices>(pcl::Indices{bad})); }),
              "pcl: index, " + std::to_string(bad) + expected);
  }
  EXPECT_EQ(refused([] { locateTanks<pcl::PointXYZ>(nullptr, {}); }), "pcl: cloud, none, expected a cloud");
  EXPECT_EQ(refused([] { refineStations<pcl::PointXYZ>(tank(), Tank(), {}, {}); }),
            "refine: tank, without circle or foot, expected one that locateTanks gave");
}

TEST(StageRefusals, AFilterTellsHowFarItIs) {
  DatumFilter<pcl::PointXYZ> filter;
  filter.setOptions(toTheEdge());
  filter.setInputCloud(tank());
  std::vector<std::string> stages;
  std::uint64_t most = 0;
  filter.setProgress([&](const char* stage, std::uint64_t points, std::uint64_t of) {
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
    EXPECT_EQ(of, tank()->size());
    most = std::max(most, points);
  });
  pcl::Indices edge, silent;
  filter.filter(edge);
  EXPECT_EQ(most, tank()->size());
  const std::set<std::string> told(stages.begin(), stages.end());
  EXPECT_TRUE(told.count("locate") && told.count("normals") && told.count("refine")) << stages.size();
  filter.setProgress({});
  filter.filter(silent);
  EXPECT_EQ(edge, silent);
  EXPECT_GT(edge.size(), 1000U);
}

TEST(StageRefusals, AFilterCanBeCancelled) {
  DatumFilter<pcl::PointXYZ> filter;
  filter.setOptions(toTheEdge());
  filter.setInputCloud(tank());
  pcl::Indices edge;
  filter.filter(edge);
  ASSERT_TRUE(filter.getDatum().usable());
  for (const std::string at : {"locate", "crop", "refine"}) {
    filter.setProgress([&](const char* stage, std::uint64_t, std::uint64_t) {
      if (stage == at) throw std::runtime_error("enough");
    });
    EXPECT_THROW(filter.filter(edge), std::runtime_error);
    EXPECT_TRUE(edge.empty());
    EXPECT_EQ(filter.getDatum().status, Status::NotRun);
  }
}

}  // namespace tank_datum::stage_refusals_test
