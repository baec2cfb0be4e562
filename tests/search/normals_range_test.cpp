#include <gtest/gtest.h>

#include <cmath>

#include "tank_datum/core/error.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum::normals_range_test {

/// Both engines square coordinates in float32: what is infinite there ended the process.
TEST(Normals, OfPointsFurtherApartThanFloatsBearAreRefused) {
  for (const SearchEngine engine : {SearchEngine::Flann, SearchEngine::Buckets}) {
    NormalOptions options;
    options.k = 4;
    options.search = engine;
    const auto of = [&](double far) {
      return estimateNormals({{0, 0, 0}, {far, 0, 0}, {0, far, 0}, {far, far, 0}}, options);
    };
    for (const auto& n : of(1e9).normals) EXPECT_NEAR(std::abs(n.z()), 1.0, 1e-6);
    for (const double far : {1.001e9, 1e39, -1e300, static_cast<double>(NAN)}) {
      try {
        of(far);
        ADD_FAILURE() << far;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Option);
        EXPECT_EQ(error.refused().name, "row 1 of points");
      }
    }
  }
}

}  // namespace tank_datum::normals_range_test
