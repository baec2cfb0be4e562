#pragma once

#include <cstddef>
#include <vector>

namespace tank_datum {

/// Members first ... end - 1 of a round, counted on beyond its last.
struct Window {
  std::size_t first = 0, end = 0;
};

/// One window of this width about each direction [rad]; the directions ascend.
std::vector<Window> windowsOver(const std::vector<double>& directions, double width);

/// Weighted means over windows of values round a tank.
class WindowMeans {
 public:
  /// @param weights  one per value; those of weight 0 do not count
  WindowMeans(std::vector<Window> windows, std::vector<double> weights);

  /// One mean per window, 0 where nothing counts, of one value per weight.
  void of(const float* values, float* means);

 private:
  template <typename Term>
  void sumUp(Term term);

  std::vector<Window> windows_;
  std::vector<double> weights_, sums_, per_weight_;
};

}  // namespace tank_datum
