#include "shape/ring_data.h"

#include "stations/station_covariance.h"

namespace tank_datum {

RingData ringData(const std::vector<Station>& stations, double radius, const StationCovariance& covariance) {
  constexpr double kUsualWave = 1.0 / 4000.0;  // of a foundation, over the radius
  RingData data;
  data.usual_wave = kUsualWave * radius;
  const StationCovariance given = covariance.empty() ? independentCovariance(stations) : covariance;
  std::vector<Eigen::Index> measured;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (stations[i].flag == StationFlag::Measured) measured.push_back(static_cast<Eigen::Index>(i));
  }
  const auto count = static_cast<Eigen::Index>(measured.size());
  data.azimuths.resize(count), data.directions.resize(count), data.z.resize(count), data.sigmas.resize(count);
  data.shared.resize(given.factors.rows(), count);
  data.sigmas_known = count > 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index i = measured[static_cast<std::size_t>(k)];
    const Station& s = stations[static_cast<std::size_t>(i)];
    data.azimuths[k] = s.azimuth, data.directions[k] = s.direction, data.z[k] = s.z,
    data.sigmas[k] = given.independent[i];
    if (given.factors.rows() > 0) data.shared.col(k) = given.factors.col(i);
    data.sigmas_known = data.sigmas_known && given.independent[i] > 0.0;
  }
  return data;
}

}  // namespace tank_datum
