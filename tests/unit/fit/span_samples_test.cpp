// Splines come back from their samples.
#include "fit/fit_image.h"
#include "fit/span_samples.h"
#include "unit/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace span_samples_test {

namespace {

using nrb::SplinePtr;
using nrb::fit::LocalNodes;

constexpr double eps = std::numeric_limits<double>::epsilon();

TEST(LocalNodes, hold_the_ends_and_lie_between_their_checks) {
    EXPECT_EQ(LocalNodes(0).nodes(), std::vector<double>{0.5});
    for (int degree = 1; degree <= 31; ++degree) {
        const LocalNodes nodes(degree);
        const std::vector<double> &all = nodes.with_checks();
        ASSERT_EQ(nodes.nodes().size(), static_cast<size_t>(degree) + 1);
        ASSERT_EQ(all.size(), 2 * static_cast<size_t>(degree) + 1);
        EXPECT_EQ(nodes.nodes().front(), 0);
        EXPECT_EQ(nodes.nodes().back(), 1);
        EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), std::less_equal<>()));
        for (size_t i = 0; i < nodes.nodes().size(); ++i) {
            EXPECT_EQ(all[2 * i], nodes.nodes()[i]);
        }
    }
}

std::vector<double> back(const SplinePtr &spline) {
    std::vector<LocalNodes> nodes;
    nrb::fit::Places places;
    for (int k = 0; k < spline->axes(); ++k) {
        nodes.emplace_back(spline->axis(k).degree());
        places[static_cast<size_t>(k)] = nodes.back().nodes();
    }
    const auto copy = [](std::span<const double> values) {
        return std::vector<double>(values.begin(), values.end());
    };
    const SplinePtr samples = nrb::fit::sampled(*spline, places);
    return copy(nrb::fit::control_points(*spline, nodes, copy(samples->points()), spline->dim())->points());
}

// The three forms of knots, a jump, and a surface. The condition of the system is at most about 2^p p.
TEST(ControlPoints, of_samples_are_those_of_the_spline) {
    const SplinePtr splines[] = {
        shapes::curve(3, {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}, 1, {1, -2, 3, 0, 5, 6, -7}),
        shapes::curve(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, 1, {1, 4, 2, -3, 0, 5}), // a jump
        shapes::curve(2, {0, 1, 2, 3, 4, 5, 6, 7}, 1, {1, -3, 2, 5, 4}),
        shapes::curve(2, {-2, -1, 0, 1, 2, 3, 4, 5}, 2, {0, 0, 4, 0, 0, 4, 0, 0, 4, 0}, true),
        nrb::make_spline({shapes::bezier_axis(2), shapes::bezier_axis(1)}, 1, nrb::Form::polynomial,
                         {1, 2, -3, 4, 5, -6})};
    for (const SplinePtr &spline : splines) {
        const std::vector<double> points = back(spline);
        ASSERT_EQ(points.size(), spline->points().size());
        for (size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(points[i], spline->points()[i], 256 * eps * 7);
        }
    }
}

// An affine map keeps the control points of a rational curve, moved by the map.
TEST(FitImage, of_an_affine_map_is_exact) {
    const SplinePtr arc = shapes::bezier(2, {0, 0, 1, 2, 2, 0}, {1, 3, 1});
    const nrb::fit::PointMap map = [](const std::vector<double> &points, std::vector<double> &images) {
        for (size_t i = 0; i < points.size(); i += 2) {
            images[i] = 2 * points[i] + points[i + 1] + 1;
            images[i + 1] = points[i + 1] - points[i];
        }
    };
    const nrb::fit::FittedImage image = nrb::fit::fit_image(arc, map, 1e-9);
    ASSERT_EQ(image.spline->points().size(), arc->points().size());
    const std::vector<double> expected = {1, 0, 5, 1, 5, -2};
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(image.spline->points()[i], expected[i], 64 * eps * 5);
    }
    EXPECT_EQ(shapes::vector_of(image.spline->weights()), shapes::vector_of(arc->weights()));
    EXPECT_FALSE(image.proven); // nobody has judged it
    EXPECT_LE(image.deviation, 1e-12);
}

} // namespace

} // namespace span_samples_test
