// Models of the squared distance: between those to the tangent and to the foot.
#include "fit/cloud/squared_distance.h"

#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace squared_distance_test {

using namespace nrb;
using fit::SquaredDistance;

namespace {

// At the vertex of the parabola y = x^2 / 4, with the parameter x / 3: the radius is 2.
constexpr double parabola[] = {0, 0, 3, 0, 0, 4.5};

std::vector<double> weights(const double *derivatives, int axes, int dim, std::vector<double> r,
                            std::array<bool, max_axes> stays = {}) {
    SquaredDistance model(axes, dim);
    model.set(derivatives, stays, r.data());
    return model.matrix();
}

void expect_near(const std::vector<double> &found, const std::vector<double> &wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(found[i], wanted[i], 1e-15) << i;
    }
}

TEST(SquaredDistance, is_that_to_the_tangent_on_the_hollow_side) {
    expect_near(weights(parabola, 1, 2, {0, 1}), {0, 0, 1});
    expect_near(weights(parabola, 1, 2, {0, 0}), {0, 0, 1});
}

TEST(SquaredDistance, comes_to_that_to_the_foot_on_the_outer_side) {
    expect_near(weights(parabola, 1, 2, {0, -2}), {0.5, 0, 1});
    expect_near(weights(parabola, 1, 2, {0, -6}), {0.75, 0, 1});
}

TEST(SquaredDistance, is_that_to_the_foot_where_it_stays) {
    expect_near(weights(parabola, 1, 2, {0, 1}, {true}), {1, 0, 1});
    constexpr double point[] = {7, 8, 0, 0, 0, 0}; // a curve without a tangent
    expect_near(weights(point, 1, 2, {0, 1}), {1, 0, 1});
}

// z = -(x^2 / 4 + y^2 / 8) over skew parameters x = u + v, y = v: radii 2 and 4 on the lower side, seen from above.
TEST(SquaredDistance, has_the_principal_curvatures_of_a_surface) {
    constexpr double cap[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, -0.5, 0, 0, -0.5, 0, 0, -0.75};
    expect_near(weights(cap, 2, 3, {0, 0, 2}), {0.5, 0, 1.0 / 3, 0, 0, 1});
    expect_near(weights(cap, 2, 3, {0, 0, -1}), {0, 0, 0, 0, 0, 1});
    expect_near(weights(cap, 2, 3, {0, 0, -1}, {false, true}), {0, 0, 1, 0, 0, 1});
}

TEST(SquaredDistance, pulls_by_what_it_weighs) {
    SquaredDistance model(1, 2);
    constexpr double r[] = {0.5, -2};
    model.set(parabola, {}, r);
    EXPECT_NEAR(model.force()[0], 0.25, 1e-15);
    EXPECT_EQ(model.force()[1], -2);
}

} // namespace

} // namespace squared_distance_test
