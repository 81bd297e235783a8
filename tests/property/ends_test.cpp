// Where one basis function is 1 on every axis the stored control point comes back bit for bit.
#include "reference/exact_basis.h"
#include "reference/exact_spline.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace ends_test {

using namespace support;

namespace {

std::vector<double> stored_point(const SplineData &data, int64_t i) {
    const auto from = data.points.begin() + i * data.dim;
    return {from, from + data.dim};
}

// All corners of a spline that is clamped everywhere.
void check_corners(const SplineData &data, uint64_t seed) {
    const auto g = create(data);
    for (int corner = 0; corner < (1 << data.axes()); ++corner) {
        std::vector<double> param;
        int64_t place = 0;
        for (int k = 0; k < data.axes(); ++k) {
            const bool end = ((corner >> k) & 1) != 0;
            param.push_back(end ? data.upper(k) : data.lower(k));
            place = place * data.counts[static_cast<size_t>(k)] +
                    (end ? data.counts[static_cast<size_t>(k)] - 1 : 0);
        }
        ASSERT_TRUE(same_bits(eval(g.get(), param), stored_point(data, place))) << where(seed, data);
        auto derivs = eval_derivs(g.get(), 2, param);
        derivs.resize(static_cast<size_t>(data.dim));
        ASSERT_TRUE(same_bits(derivs, stored_point(data, place))) << where(seed, data);
    }
}

Recipe clamped_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.form = KnotForm::clamped;
    }
    return recipe;
}

TEST(Ends, corners_of_clamped_curves) {
    for_each_case(20000, 999, [](Random &random, uint64_t seed) {
        check_corners(random_spline(random, clamped_recipe(random, 1, random.chance(20) ? 31 : 9)), seed);
    });
}

TEST(Ends, corners_of_clamped_surfaces_and_volumes) {
    for_each_case(21000, 800, [](Random &random, uint64_t seed) {
        check_corners(random_spline(random, clamped_recipe(random, 2, 5)), seed);
        check_corners(random_spline(random, clamped_recipe(random, 3, 2)), seed);
    });
}

// A knot of multiplicity >= p inside, or degree 0: one function is 1 there on its side.
TEST(Ends, interior_knots_of_full_multiplicity) {
    for_each_case(22000, 1000, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, 1, 6));
        const auto g = create(data);
        for (const bool left : {false, true}) {
            for (const double t : data.knots[0]) {
                if (t < data.lower(0) || t > data.upper(0)) {
                    continue;
                }
                const auto basis = reference::exact_basis(data.knots[0], data.degrees[0], t, 0, left);
                const auto one =
                    std::find(basis.numerators[0].begin(), basis.numerators[0].end(), basis.denominator);
                if (one == basis.numerators[0].end()) {
                    continue;
                }
                const int64_t place = basis.span - data.degrees[0] + (one - basis.numerators[0].begin());
                ASSERT_TRUE(same_bits(eval(g.get(), {t}, left ? NURBS_LEFT : 0U), stored_point(data, place)))
                    << where(seed, data) << "at " << hex(t) << (left ? " from the left" : "");
            }
        }
    });
}

TEST(Ends, the_sign_of_zero_is_kept) {
    const SplineData data = {{2}, {3}, {{0, 0, 0, 1, 1, 1}}, 2, {-0.0, 1, 3, 4, 0.0, -0.0}, {2, 3, 5}, 0};
    const auto g = create(data);
    EXPECT_TRUE(same_bits(eval(g.get(), {0}), {-0.0, 1}));
    EXPECT_TRUE(same_bits(eval(g.get(), {1}), {0.0, -0.0}));
}

} // namespace

} // namespace ends_test
