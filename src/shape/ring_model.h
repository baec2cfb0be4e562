#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shape/local_shapes.h"
#include "shape/ring_data.h"
#include "shape/ring_likelihood.h"

namespace tank_datum {

/// What the errors of the stations are, beside the shared ones that the survey knows of.
struct RingNoise {
  double scale = 1.0;          ///< own errors over sigmas, at least 1 where sigmas are given
  double repeatability = 1.0;  ///< of all errors that the stations show, over sigmas; above or below 1
  double neighbours = 0.0;     ///< standard deviation of an error that neighbours share [m]
  double length = 0.0;         ///< arc over which they do [rad]
  double freedom = 0.0;        ///< degrees of freedom behind the scale; 0: it was given
  double about_plane = 1.0;    ///< what the stations depart from a plane by, over sigmas
  bool is_overstated = false;  ///< whether sigmas are given that even this is far below
};

/// The datum along the ring: z = mean + tilt + waves + local shapes, with errors; the waves are sums of a_n cos nt +
/// b_n sin nt up to order(). Mean and tilt are free. The waves have normal priors whose standard deviation falls with a
/// power of n; its size, its power, and size and length of an error that neighbours share (Matern 3/2) are those of
/// largest restricted marginal likelihood (Patterson and Thompson, Biometrika 58, 1971). A single wave that stands
/// above that gets a wider prior of its own (automatic relevance). So what stations tell of the waves is taken from
/// them, and what a gap hides is as uncertain as the waves seen make it. A settlement of one place is no error that all
/// share: local shapes are added while the likelihood gains more than chance gives the best of all places.
class RingModel {
 public:
  explicit RingModel(const RingData& data);

  int order() const { return order_; }
  const RingData& data() const { return data_; }
  const RingNoise& noise() const { return noise_; }

  /// Local settlements and rises, one a place: the datum in their middle above the mean of it at their ends, and its
  /// standard error [m].
  struct Local {
    LocalShape shape;
    double height, sigma;
  };
  std::vector<Local> locals() const;

  /// The datum, given the survey, and its covariance: coefficients 1, a1, b1, a2, ... up to order(), and those of the
  /// local shapes less their waves up to order().
  Eigen::VectorXd coefficients() const;
  Eigen::MatrixXd covariance() const;
  /// The same of those waves only that stand out of their errors, and of the local shapes.
  Eigen::VectorXd standing() const;
  /// Values that coefficients give at azimuths: [azimuths x coefficients].
  Eigen::MatrixXd rowsAt(const Eigen::VectorXd& azimuths) const;

  /// Variance of what an error that neighbours share adds to each wave of a survey [m^2].
  const Eigen::VectorXd& neighbourVariances() const { return errors_; }

  /// Surveys that could have been: each column a datum as likely as this survey leaves it, what the same survey of
  /// that datum would measure, and what this model would make of it.
  struct Simulated {
    Eigen::MatrixXd truth;     ///< [coefficients x draws]
    Eigen::MatrixXd estimate;  ///< [coefficients x draws]
    Eigen::MatrixXd survey;    ///< [stations x draws] elevations [m]
  };
  Simulated simulate(int draws, std::uint64_t seed) const;

  /// Whether there are so many stations that they show their errors beside each other: more than 64.
  bool dense() const;

  /// Matrix product without Eigen's own threads, so that results do not depend on their number.
  static Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

 private:
  Eigen::Index waveCount() const { return 2 * order_ + 1; }
  Eigen::Index datumCount() const { return waveCount() + static_cast<Eigen::Index>(shapes_.size()); }
  void takeOutPlane();
  void compareWithSigmas();
  std::vector<LocalShape> standingShapes();
  void setUp(const std::vector<LocalShape>& shapes);
  double estimatePriors(double scale2);
  struct Left {
    Eigen::VectorXd residuals;  ///< over their sigmas
    double freedom;             ///< stations less what of the unknowns they tell apart
  };
  Left leftOf(Eigen::Index used) const;
  double robustScale2() const;
  double ownScale2();
  double differencesScale() const;
  void factorPrecision();
  void solve();
  Eigen::VectorXd datumShares() const;
  Eigen::MatrixXd solvedCovariance() const;
  Eigen::MatrixXd withWavesOfShapes(Eigen::MatrixXd solved) const;

  RingData data_;
  RingNoise noise_;
  int order_ = 0;
  Eigen::Vector3d plane_ = Eigen::Vector3d::Zero();  ///< mean and tilt taken from z before it is solved for [m]
  Eigen::Matrix3d plane_precision_;                  ///< of what the datum's differ from those [1/m^2]
  std::vector<LocalShape> shapes_;
  Eigen::MatrixXd design_;                 ///< [stations x (waves, local shapes, shared errors)]
  Eigen::MatrixXd normal_;                 ///< design' D^-1 design, D of sigmas^2
  Eigen::VectorXd rhs_;                    ///< design' D^-1 z
  double squares_ = 0.0;                   ///< z' D^-1 z
  Eigen::VectorXd waves_, errors_;         ///< prior variances of each wave: of the datum, of neighbours' errors [m^2]
  Eigen::LLT<Eigen::MatrixXd> posterior_;  ///< of the precision of all unknowns
  Eigen::VectorXd solution_;               ///< waves of the survey, local shapes over their scales, shared errors
};

}  // namespace tank_datum
