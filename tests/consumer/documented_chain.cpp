// The chain that src/doc/pcl.md shows, compiled from its text and run: documented_chain SCAN RADIUS
#include <cmath>
#include <iostream>
#include <string>

#include "documented_block.inc"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  auto cloud = std::make_shared<Cloud>();
  const auto scan = tank_datum::Scan::open({argv[1]});
  scan.forEachBlock([&](const tank_datum::Points& block) {
    for (const Eigen::Vector3d& p : block) {
      const Eigen::Vector3f at = (p + scan.origin()).cast<float>();
      cloud->push_back({at.x(), at.y(), at.z()});
    }
  });
  tank_datum::Datum datum;
  const Cloud::Ptr edge = runChain(cloud, datum);
  std::cout << cloud->size() << " points in, " << edge->size() << " edge points out, radius " << datum.circle.radius
            << " m, range " << 1000.0 * datum.level.range() << " mm\n";
  const bool good = datum.usable() && edge->size() == datum.edge_points.size() && !edge->empty() &&
                    std::abs(datum.circle.radius - std::stod(argv[2])) < 0.003;
  return good ? 0 : 1;
}
