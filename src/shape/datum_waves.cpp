#include "shape/datum_waves.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/portable_math.h"
#include "fit/harmonics.h"

namespace tank_datum {
namespace {

std::vector<double> residualsOf(const WaveData& data, const PeriodicFit& fit) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < data.count(); ++i) residuals.push_back(data.z[i] - fit(data.azimuths[i]));
  return residuals;
}

void weigh(WaveData& data, double excess) {
  for (std::size_t i = 0; i < data.count(); ++i) {
    data.weights[i] = 1.0 / (data.sigmas[i] * data.sigmas[i] + excess * excess);
  }
}

/// The scatter on top of the standard errors that makes the weighted residuals as large as they should be [m].
double excessOf(const WaveData& data, const std::vector<double>& residuals, double freedom) {
  const auto misfit = [&](double excess) {
    double sum = 0;
    for (std::size_t i = 0; i < data.count(); ++i) {
      sum += residuals[i] * residuals[i] / (data.sigmas[i] * data.sigmas[i] + excess * excess);
    }
    return sum / freedom;
  };
  double low = 0, high = 0;
  for (const double r : residuals) high = std::max(high, std::abs(r) * std::sqrt(static_cast<double>(data.count())));
  if (misfit(0.0) <= 1.0 || misfit(high) > 1.0) return 0.0;
  for (int i = 0; i < 60; ++i) (misfit(0.5 * (low + high)) > 1.0 ? low : high) = 0.5 * (low + high);
  return high;
}

/// The variance that noise gives to a fitted wave, over what the weights promise: the mean power of the residuals in
/// the waves next above those fitted. Neighbours that share errors have more power there than among stations apart.
double noisePower(const WaveData& data, const std::vector<double>& residuals, int order) {
  constexpr int kBand = 20, kFewestWaves = 8;
  const int last = std::min(order + kBand, static_cast<int>(data.count()) / 3);
  double sum = 0;
  if (last - order < kFewestWaves) {  // too few stations for waves above
    for (std::size_t i = 0; i < data.count(); ++i) sum += data.weights[i] * residuals[i] * residuals[i];
    return sum / (static_cast<double>(data.count()) - 2.0 * order - 1.0);
  }
  for (int n = order + 1; n <= last; ++n) {
    std::complex<double> wave = 0.0;
    for (std::size_t i = 0; i < data.count(); ++i) {
      const auto [sine, cosine] = portable::sinCos(n * data.azimuths[i]);
      wave += std::sqrt(data.weights[i]) * residuals[i] * std::complex(cosine, sine);
    }
    sum += std::norm(wave) / static_cast<double>(data.count());
  }
  return sum / (last - order);
}

}  // namespace

WaveData waveData(const std::vector<Station>& stations, int order) {
  WaveData data;
  bool known = true;
  for (const Station& s : stations) {
    if (s.flag != StationFlag::Measured) continue;
    data.azimuths.push_back(s.azimuth);
    data.z.push_back(s.z);
    data.sigmas.push_back(s.sigma_z);
    known = known && s.sigma_z > 0.0;
  }
  data.weights.assign(data.count(), 1.0);
  if (!known) data.sigmas.clear();
  const double freedom = static_cast<double>(data.count()) - 2.0 * order - 1.0;
  if (data.sigmas.empty() || freedom < 1.0) return data;
  weigh(data, 0.0);
  for (int iteration = 0; iteration < 3; ++iteration) {
    const PeriodicFit fit = fitHarmonics(data.azimuths, data.z, data.weights, {order, false, 0.0});
    weigh(data, excessOf(data, residualsOf(data, fit), freedom));
  }
  return data;
}

bool tellsApart(const WaveData& data, int order) {
  constexpr double kDearest = 25.0;  // variance of a coefficient over that of stations all round
  double total = 0;
  for (const double w : data.weights) total += w;
  const PeriodicFit fit = fitHarmonics(data.azimuths, data.z, data.weights, {order, false, 0.0});
  return fit.covariance.diagonal().maxCoeff() < kDearest * 2.0 / total;
}

int highestOrder(const WaveData& data, int wanted, int least) {
  const auto count = static_cast<int>(data.count());
  for (int order = std::min(wanted, (count - 1) / 4); order > least; --order) {
    if (tellsApart(data, order)) return order;
  }
  return std::min(least, std::max(0, (count - 1) / 4));
}

double noiseFactor(const WaveData& data, const std::vector<double>& residuals, int order) {
  const double power = noisePower(data, residuals, order);
  return data.sigmas.empty() ? power : std::max(1.0, power);
}

PeriodicFit fitWaves(const WaveData& data, int order) {
  PeriodicFit fit = fitHarmonics(data.azimuths, data.z, data.weights, {order, false, 0.0});
  fit.covariance *= noiseFactor(data, residualsOf(data, fit), order);
  return fit;
}

double residualSum(const WaveData& data, const PeriodicFit& fit) {
  const std::vector<double> residuals = residualsOf(data, fit);
  double sum = 0;
  for (std::size_t i = 0; i < data.count(); ++i) sum += data.weights[i] * residuals[i] * residuals[i];
  return sum;
}

}  // namespace tank_datum
