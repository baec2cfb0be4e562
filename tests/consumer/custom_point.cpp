// The filter for a point type of the user's own, which the library is not compiled for: nothing but the package is
// linked. Exits with 0 when it finds the tank that the scan holds: custom_point SCAN RADIUS
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>
#include <tank_datum/io/scan.h>
#include <tank_datum/pcl/datum_filter.h>

#include <cmath>
#include <iostream>
#include <string>
#include <tank_datum/pcl/impl/datum_filter.hpp>

struct EIGEN_ALIGN16 TimedPoint {
  PCL_ADD_POINT4D;
  double time;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(TimedPoint, (float, x, x)(float, y, y)(float, z, z)(double, time, time))

int main(int, char** argv) {
  auto cloud = std::make_shared<pcl::PointCloud<TimedPoint>>();
  const auto scan = tank_datum::Scan::open({argv[1]});
  scan.forEachBlock([&](const tank_datum::Points& block) {
    for (const Eigen::Vector3d& p : block) {
      TimedPoint point;
      point.getVector3fMap() = (p + scan.origin()).cast<float>();
      point.time = static_cast<double>(cloud->size());
      cloud->push_back(point);
    }
  });
  tank_datum::DatumFilter<TimedPoint> filter;
  filter.setInputCloud(cloud);
  pcl::PointCloud<TimedPoint> edge;
  filter.filter(edge);
  const tank_datum::Datum& datum = filter.getDatum();
  std::cout << nameOf(datum.status) << ", R " << datum.circle.radius << " m, " << edge.size() << " edge points\n";
  return datum.usable() && std::abs(datum.circle.radius - std::stod(argv[2])) < 0.01 && edge.size() > 1000 ? 0 : 1;
}
