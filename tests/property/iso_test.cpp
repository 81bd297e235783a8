// The iso-curve of a surface is the surface on that line; likewise the iso-surfaces of a volume.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>
#include <gtest/gtest.h>

namespace iso_test {

using namespace support;
using reference::eps;

namespace {

// Parameters of the whole, with the fixed one put back.
std::vector<double> with_fixed(const std::vector<double> &rest, int axis, double fixed) {
    auto param = rest;
    param.insert(param.begin() + axis, fixed);
    return param;
}

TEST(Iso, keeps_the_other_axes) {
    for_each_case(110000, 600, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(2, 3), 4));
        const int axis = random.whole(0, data.axes() - 1);
        const auto k = static_cast<size_t>(axis);
        const double fixed = random_param(random, data.knots[k], data.degrees[k]);
        const auto got = read_back(iso(create(data).get(), axis, fixed).get());
        ASSERT_EQ(got.axes(), data.axes() - 1) << where(seed, data);
        ASSERT_EQ(got.rational(), data.rational()) << where(seed, data);
        for (int other = 0, place = 0; other < data.axes(); ++other) {
            if (other != axis) {
                ASSERT_EQ(got.degrees[static_cast<size_t>(place)], data.degrees[static_cast<size_t>(other)]);
                ASSERT_TRUE(
                    same_bits(got.knots[static_cast<size_t>(place)], data.knots[static_cast<size_t>(other)]));
                ASSERT_EQ(got.periodic(place), data.periodic(other)) << where(seed, data);
                ++place;
            }
        }
    });
}

// The contraction is the same, in two steps with a rounded record between. With weights in [0.2, 5] the
// rounding of the records counts up to 25 times in numerator and denominator.
TEST(Iso, agrees_with_the_exact_surface_or_volume) {
    for_each_case(111000, 1000, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(2, 3), 4);
        recipe.weights = random.chance(60) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, data.axes() - 1);
        const auto k = static_cast<size_t>(axis);
        const double fixed = random_param(random, data.knots[k], data.degrees[k]);
        const bool left = random.chance(30);
        reference::Sides sides{};
        sides[k] = left;
        const auto line = iso(create(data).get(), axis, fixed, left ? NURBS_LEFT : 0U);
        const auto params = random_params(random, read_back(line.get()), 5);
        const auto points = eval(line.get(), params);
        const size_t rest = data.degrees.size() - 1;
        const auto dim = static_cast<size_t>(data.dim);
        for (size_t i = 0; i < points.size() / dim; ++i) {
            const auto from = params.begin() + static_cast<std::ptrdiff_t>(i * rest);
            const auto param = with_fixed({from, from + static_cast<std::ptrdiff_t>(rest)}, axis, fixed);
            const auto want = reference::exact_point(data, param.data(), sides);
            const double hull = reference::exact_hull(data, param.data(), sides);
            const long double c = reference::c_of(data) * (data.rational() ? 50 : 1);
            for (size_t d = 0; d < dim; ++d) {
                ASSERT_LE(reference::error_ratio(points[i * dim + d], want[d], c * eps * hull), 1)
                    << where(seed, data) << "axis " << axis << " at " << hex(param);
            }
        }
    });
}

TEST(Iso, at_clamped_ends_the_layer_itself) {
    for_each_case(112000, 400, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, 5);
        recipe.axes[0].form = KnotForm::clamped;
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const auto got = read_back(iso(create(data).get(), 0, data.lower(0)).get());
        const auto size = static_cast<std::ptrdiff_t>(got.points.size());
        ASSERT_TRUE(same_bits(got.points, {data.points.begin(), data.points.begin() + size}))
            << where(seed, data);
    });
}

} // namespace

} // namespace iso_test
