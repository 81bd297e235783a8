// SPDX-License-Identifier: MIT
// The number of values that moments need.
#include "measure/moment_integrand.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace {

using namespace nrb;
using measure::MomentOrder;

// The content, dim coordinates and the dim (dim + 1) / 2 entries of a symmetric matrix. From dimension 46341
// on, twice the last number exceeds 32 bits; at 65536 its lower bits would pass for a small size.
TEST(MomentIntegrand, CountsItsValuesInAnyDimension) {
    for (const int dim : {1, 2, 3, 46340, 46341, 65536, 1000000}) {
        const int64_t n = dim;
        EXPECT_EQ(measure::MomentIntegrand(1, dim, MomentOrder::content).values(), 1);
        EXPECT_EQ(measure::MomentIntegrand(1, dim, MomentOrder::centroid).values(), 1 + n);
        EXPECT_EQ(measure::MomentIntegrand(1, dim, MomentOrder::inertia).values(), 1 + n + n * (n + 1) / 2);
    }
}

} // namespace
