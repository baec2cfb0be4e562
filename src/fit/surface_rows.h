#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace tank_datum {

/// The rows of a robust fit of z = s0 + s1 a + s2 t + s3 t^2 [m], which is what either surface is near the foot: a is
/// the distance across the edge, t the arc along it. Column by column, for the same sums on every machine, whatever
/// the width of its vectors.
class SurfaceRows {
 public:
  /// Sums of the weighted normal equations.
  struct Equations {
    Eigen::Matrix4d matrix;
    Eigen::Vector4d right;
    double weight = 0;
  };

  void reserve(std::size_t rows);
  void add(double a, double t, double z);
  std::size_t size() const { return z_.size(); }

  /// To be called once, when all rows are in: all weights are 1.
  void close();

  Equations equations() const;

  /// Takes the residuals from a solution.
  /// @return their robust standard deviation about zero [m]
  double residualsFrom(const Eigen::Vector4d& solution);

  /// Tukey's weights of the residuals.
  void weigh(double noise);

  const std::vector<double>& a() const { return a_; }
  const std::vector<double>& t() const { return t_; }
  const std::vector<double>& residuals() const { return residuals_; }
  const std::vector<double>& weights() const { return weights_; }

 private:
  std::vector<double> a_, t_, z_, residuals_, weights_;
};

/// A robust fit of such rows.
struct SurfaceFit {
  Eigen::Vector4d solution;
  Eigen::Matrix4d normal, inverse;  ///< of the weighted equations
  double noise = 0;                 ///< standard deviation of the rows about it [m]
};

/// What is known of the unknowns beforehand, each about zero: 1 / variance, zero for nothing.
struct SurfacePrior {
  Eigen::Vector4d precision = Eigen::Vector4d::Zero();
  double noise = 0;  ///< that the rows are expected to have [m]
};

/// Tukey's; the rows keep the weights. Nothing where the equations are singular.
/// @param rows  closed
std::optional<SurfaceFit> fitRobustly(SurfaceRows& rows, const SurfacePrior& prior = {});

}  // namespace tank_datum
