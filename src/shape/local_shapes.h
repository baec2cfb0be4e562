#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace tank_datum {

/// A settlement or a rise of a part of the ring: half a cosine wave from its centre down to nothing on both sides.
struct LocalShape {
  double centre = 0.0;      ///< azimuth [rad]
  double half_width = 0.0;  ///< [rad]
  double scale = 1.0;       ///< standard deviation of its height before the stations are seen [m]
  bool detail = false;      ///< of the one before it, whose form is not quite a cosine's

  /// A shape of height 1.
  double at(double azimuth) const;
  /// Coefficients 1, cos t, sin t, cos 2t, ... of a shape of height 1.
  Eigen::VectorXd waves(int order) const;
  /// Whether the middle of one of the two lies in the other.
  bool isWithin(const LocalShape& other) const;
  /// The shape from where the first of the two begins to where the last ends.
  LocalShape joinedWith(const LocalShape& other) const;
};

/// A shape that is looked for, with the stations that it reaches and its values there.
struct CandidateShape {
  LocalShape shape;
  std::vector<Eigen::Index> stations;
  std::vector<double> values;
};

/// Where local shapes are looked for: from a single station's to one of 60 degrees, overlapping.
/// @param azimuths    of the stations [rad], in any order and turn
/// @param directions  of the same; places are chosen by them, so that the way stations are counted moves none
std::vector<CandidateShape> candidateShapes(const Eigen::VectorXd& azimuths, const Eigen::VectorXd& directions);

/// A shape with narrower ones inside it, which let its form depart from the cosine by a tenth of its height.
std::vector<LocalShape> withDetails(const LocalShape& shape, double spacing);

/// What a model without a local shape leaves of the stations.
struct RingResiduals {
  const Eigen::VectorXd& weights;                ///< 1 / (scale sigma)^2 [1/m^2]
  const Eigen::VectorXd& residuals;              ///< [m]
  const Eigen::MatrixXd& design;                 ///< [stations x unknowns]
  const Eigen::LLT<Eigen::MatrixXd>& precision;  ///< of the unknowns, priors included
};

/// The candidate that explains most of the residuals, with three times its likeliest height as its scale; nothing when
/// none explains more than a fitted number does by chance.
std::optional<LocalShape> likeliestShape(const RingResiduals& left, const std::vector<CandidateShape>& candidates);

}  // namespace tank_datum
