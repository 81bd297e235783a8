// Nearest and farthest points of splines whose weights have both signs, which may go to infinity: against
// dense samples. Rounding counts by the smallest weight there.
#include "property/made_shapes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace closest_signed_test {

using namespace support;

namespace {

// A homogeneous spline over whole knots: records (w x, w) with weights between -0.3 and 1.5.
struct Signed {
    SplineData data; // the points x
    Handle g;
    double size = 0; // of the points
};

// Of a spline of one dimension more: its last coordinate becomes the weight, so that the copies of periodic
// axes stay copies.
Signed signed_spline(Random &random, int axes, int dim, double shift = 0) {
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 5 : axes == 2 ? 3 : 2);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = random.whole(1, axes == 1 ? 5 : 2);
        axis.spacing = Spacing::integers;
        axis.placement = Placement::origin;
    }
    recipe.dim = dim + 1;
    recipe.weights = Weights::none;
    SplineData records = random_spline(random, recipe);
    Signed made{records, {}, 0};
    made.data.dim = dim;
    made.data.points.clear();
    const double most = extent(records);
    for (size_t i = 0; i < records.points.size(); i += static_cast<size_t>(dim) + 1) {
        double &w = records.points[i + static_cast<size_t>(dim)];
        w = 0.6 + 0.9 * w / most;
        for (size_t c = i; c < i + static_cast<size_t>(dim); ++c) {
            made.data.points.push_back(records.points[c] + shift);
            records.points[c] = w * made.data.points.back();
        }
    }
    made.size = extent(made.data);
    const Handle holder = create(records);
    made.g = support::made([&](nurbs **out) { return nurbs_from_homogeneous(holder.get(), out); });
    return made;
}

struct Sampled {
    double least = INFINITY, most = 0;
};

// Over a grid; what is not finite lies at a pole.
Sampled sampled(const Signed &shape, const std::vector<double> &x) {
    std::vector<std::vector<double>> places;
    const int per_axis = shape.data.axes() == 1 ? 4000 : shape.data.axes() == 2 ? 120 : 30;
    for (int k = 0; k < shape.data.axes(); ++k) {
        places.emplace_back();
        for (int i = 0; i <= per_axis; ++i) {
            places.back().push_back(
                std::lerp(shape.data.lower(k), shape.data.upper(k), i / double(per_axis)));
        }
    }
    Sampled found;
    const std::vector<double> points = eval_grid(shape.g.get(), places);
    for (size_t i = 0; i < points.size(); i += x.size()) {
        double square = 0;
        for (size_t c = 0; c < x.size(); ++c) {
            square += (points[i + c] - x[c]) * (points[i + c] - x[c]);
        }
        if (std::isfinite(square)) {
            found.least = std::min(found.least, std::sqrt(square));
            found.most = std::max(found.most, std::sqrt(square));
        }
    }
    return found;
}

TEST(ClosestSigned, what_is_certified_is_beaten_by_no_sample) {
    int certified = 0, far_certified = 0;
    for_each_case(2195000, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const Signed shape = signed_spline(random, axes, random.whole(axes, 3));
        std::vector<double> x;
        for (int c = 0; c < shape.data.dim; ++c) {
            x.push_back(shape.size * random.between(-1.5, 1.5));
        }
        const Sampled samples = sampled(shape, x);
        std::vector<double> param(static_cast<size_t>(shape.data.axes())), foot(x.size());
        for (const bool farthest : {false, true}) {
            double distance = -1;
            int32_t status = 0;
            const auto function = farthest ? nurbs_farthest_points : nurbs_closest_points;
            require_ok(function(shape.g.get(), 1, x.data(), 0, 0, nullptr, 0, 0, param.data(), 0, 0,
                                foot.data(), 0, 0, &distance, 0, &status, 0));
            const bool proven = (status & NURBS_CLOSEST_CERTIFIED) != 0;
            (farthest ? far_certified : certified) += proven ? 1 : 0;
            const double rounding = 1e-12 * (shape.size + samples.least);
            if (proven && !farthest) {
                ASSERT_LE(distance, samples.least + rounding) << where(seed, shape.data) << hex(x);
            } else if (proven) {
                ASSERT_GE(distance, samples.most * (1 - 1e-9)) << where(seed, shape.data) << hex(x);
            }
            if (std::isfinite(distance)) {
                double square = 0;
                for (size_t c = 0; c < x.size(); ++c) {
                    square += (foot[c] - x[c]) * (foot[c] - x[c]);
                }
                // near the weight 0 a foot far away is off by the square of its distance
                ASSERT_NEAR(std::sqrt(square), distance,
                            1e-12 * (shape.size + distance) * (1 + distance / shape.size))
                    << where(seed, shape.data) << hex(x);
            }
        }
    });
    std::printf("%d nearest and %d farthest points certified of 300\n", certified, far_certified);
    EXPECT_GT(certified, support::of_whole_run(100));
}

std::vector<double> random_points(Random &random, const Signed &shape, int count) {
    std::vector<double> params;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < shape.data.axes(); ++k) {
            params.push_back(random.between(shape.data.lower(k), shape.data.upper(k)));
        }
    }
    return eval(shape.g.get(), params);
}

TEST(DistanceSigned, no_sample_is_nearer) {
    int certified = 0;
    for_each_case(2196000, 100, [&](Random &random, uint64_t seed) {
        const Signed a = signed_spline(random, random.whole(1, 2), 3),
                     b = signed_spline(random, random.whole(1, 2), 3, 2 * a.size);
        const double size = a.size + b.size, tolerance = 1e-6 * size;
        double least = -1, most = -1;
        int32_t status = 0;
        require_ok(
            nurbs_distance(a.g.get(), b.g.get(), tolerance, 20000, &least, &most, nullptr, nullptr, &status));
        const std::string place = where(seed, a.data) + where(seed, b.data);
        ASSERT_LE(least, most) << place;
        if ((status & NURBS_CLOSEST_CERTIFIED) != 0) {
            ++certified;
            ASSERT_LE(most - least, tolerance + 1e-9 * size) << place;
        }
        const std::vector<double> x = random_points(random, a, 100);
        std::vector<double> distances(x.size() / 3);
        require_ok(nurbs_closest_points(b.g.get(), std::ssize(distances), x.data(), 0, 0, nullptr, 0, 2000,
                                        nullptr, 0, 0, nullptr, 0, 0, distances.data(), 0, nullptr, 0));
        for (size_t i = 0; i < distances.size(); ++i) {
            ASSERT_FALSE(distances[i] < least - 1e-12 * (size + std::fabs(x[3 * i]))) << place;
        }
    });
    std::printf("%d of 100 certified\n", certified);
    EXPECT_GT(certified, support::of_whole_run(30));
}

} // namespace

} // namespace closest_signed_test
