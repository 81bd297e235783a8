// All minima of the distance on surfaces: against the critical points, and those at edges and corners.
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

using namespace support;

namespace {

struct Minima {
    std::vector<double> params, distances;
    int32_t status = 0;
};

Minima minima(const nurbs *g, const std::vector<double> &x, double tolerance) {
    int64_t count = 0;
    require_ok(
        nurbs_closest_all(g, x.data(), nullptr, tolerance, 0, 0, nullptr, nullptr, &count, nullptr));
    const auto n = static_cast<size_t>(count);
    Minima found{std::vector<double>(2 * n), std::vector<double>(n), 0};
    require_ok(nurbs_closest_all(g, x.data(), nullptr, tolerance, 0, count, found.params.data(),
                                 found.distances.data(), &count, &found.status));
    return found;
}

// A net over the unit square with hills, of 1 to 3 spans along each axis.
SplineData hills(Random &random, bool weighted) {
    SplineData data{{random.whole(1, 4), random.whole(1, 4)}, {}, {}, 3, {}, {}, 0};
    for (const int32_t p : data.degrees) {
        const int spans = random.whole(1, 3);
        std::vector<double> knots(static_cast<size_t>(p) + 1, 0.0);
        for (int i = 1; i < spans; ++i) {
            knots.push_back(i);
        }
        knots.insert(knots.end(), static_cast<size_t>(p) + 1, spans);
        data.counts.push_back(p + spans);
        data.knots.push_back(knots);
    }
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        for (int64_t j = 0; j < data.counts[1]; ++j) {
            data.points.insert(data.points.end(),
                               {static_cast<double>(i) / static_cast<double>(data.counts[0] - 1),
                                static_cast<double>(j) / static_cast<double>(data.counts[1] - 1),
                                random.between(-1, 1)});
            if (weighted) {
                data.weights.push_back(random.between(0.5, 2));
            }
        }
    }
    return data;
}

TEST(PatchMinima, those_that_are_isolated_are_certified) {
    int asked = 0, certified = 0, several = 0, budget = 0;
    for (uint64_t seed = 2500000; seed < 2500300; ++seed) {
        Random random(seed);
        const SplineData data = hills(random, random.chance(40));
        const Handle g = create(data);
        const std::vector<double> x{random.between(-1, 2), random.between(-1, 2), random.between(-3, 3)};
        for (const double tolerance : {1e-6, 1e-2, 0.3, 3.0}) {
            const Minima found = minima(g.get(), x, tolerance);
            ++asked;
            several += found.distances.size() > 1 ? 1 : 0;
            certified += (found.status & NURBS_CLOSEST_CERTIFIED) != 0 ? 1 : 0;
            budget += (found.status & NURBS_CLOSEST_BUDGET) != 0 ? 1 : 0;
            if ((found.status & NURBS_CLOSEST_CERTIFIED) == 0) std::printf("seed %lu tol %g: %zu status %d deg %d %d spans %d %d w %d\n", (unsigned long)seed, tolerance, found.distances.size(), found.status, data.degrees[0], data.degrees[1], (int)data.counts[0]-data.degrees[0], (int)data.counts[1]-data.degrees[1], !data.weights.empty());
        }
    }
    std::printf("%d of %d certified, %d with several, %d budget\n", certified, asked, several, budget);
    EXPECT_GE(certified, asked);
}

} // namespace
