#include "chains.h"

#include <pcl/features/normal_3d_omp.h>
#include <pcl/io/pcd_io.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "background_records.h"
#include "core/parallel.h"
#include "tank_datum/core/error.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

std::vector<std::int32_t> markByAngle(const Cloud& cloud, const pcl::search::KdTree<pcl::PointXYZ>& tree,
                                      const pcl::PointCloud<pcl::Normal>& normals, const DatumOptions& options) {
  const float limit = static_cast<float>(std::cos(options.growing.angle));
  std::vector<char> marked(cloud.size(), 0);
  pcl::Indices found;
  std::vector<float> squared_distances;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    tree.nearestKSearch(cloud[i], options.normals.k, found, squared_distances);
    for (const auto j : found) {
      const auto other = static_cast<std::size_t>(j);
      if (std::abs(normals[i].getNormalVector3fMap().dot(normals[other].getNormalVector3fMap())) < limit) {
        marked[other] = 1;
      }
    }
  }
  std::vector<std::int32_t> candidates;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i]) candidates.push_back(static_cast<std::int32_t>(i));
  }
  return candidates;
}

void runStockSteps(const Cloud::Ptr& cloud, const DatumOptions& options, StageMeter& meter, ChainRun& run) {
  run.points = cloud->size();
  meter.begin("kd-tree");
  const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  tree->setInputCloud(cloud);
  meter.begin("normals");
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(static_cast<unsigned>(threadCount(options.threads)));
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(options.normals.k);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  meter.begin("angles");
  run.candidates = markByAngle(*cloud, *tree, normals, options);
  meter.end();
  run.stages = meter.stages();
}

}  // namespace

ChainRun runStock(const Points& points, const DatumOptions& options) {
  ChainRun run{"stock PCL", points.size(), {}, {}};
  const auto cloud = std::make_shared<Cloud>();
  for (const auto& p : points) {
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  }
  StageMeter meter;
  runStockSteps(cloud, options, meter, run);
  return run;
}

ChainRun runStock(const std::string& path, const DatumOptions& options) {
  ChainRun run{"stock PCL", 0, {}, {}};
  StageMeter meter;
  meter.begin("load");
  const auto cloud = std::make_shared<Cloud>();
  if (pcl::io::loadPCDFile(path, *cloud) < 0) {
    throw Error(Error::Kind::File, "bench", path, "not read by PCL", "a PCD file");
  }
  runStockSteps(cloud, options, meter, run);
  return run;
}

ChainRun runOwn(const Points& points, SearchEngine engine, DatumOptions options) {
  options.normals.search = engine;
  ChainRun run{std::string("own, ") + nameOf(engine), points.size(), {}, {}};
  StageMeter meter;
  meter.begin("tree, neighbours, normals");
  const Normals normals = estimateNormals(points, options.normals, options.threads);
  meter.begin("region_growing");
  run.candidates = growCandidates(normals, options.growing, options.threads);
  meter.end();
  run.stages = meter.stages();
  return run;
}

ChainRun runCommand(const std::vector<std::string>& paths, const DatumOptions& options, Checksum checksum,
                    Datum& datum) {
  ChainRun run{"tank_datum", 0, {}, {}};
  StageMeter meter;
  meter.begin("open");
  ScanOptions reading;
  reading.hash = checksum == Checksum::Xxh3;
  const Scan scan = Scan::open(paths, 1.0, reading);
  BackgroundRecords records(scan, checksum, options.threads);
  datum = extractDatum(scan, options, {[&meter](const char* stage) { meter.begin(stage); }, {}, {}});
  meter.begin("hash");
  records.take();
  meter.end();
  run.points = scan.size();
  run.stages = meter.stages();
  return run;
}

Agreement agreementOf(const ChainRun& first, const ChainRun& second) {
  std::vector<std::int32_t> shared;
  std::set_intersection(first.candidates.begin(), first.candidates.end(), second.candidates.begin(),
                        second.candidates.end(), std::back_inserter(shared));
  return {shared.size(), first.candidates.size() - shared.size(), second.candidates.size() - shared.size()};
}

}  // namespace tank_datum::bench
