// Reversal, transposition, other domains, and the homogeneous form: what must come back bit for bit does, and
// the shape follows.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace forms_test {

using namespace support;
using reference::eps;

namespace {

Handle reverse(const nurbs *g, int axis, uint32_t flags = 0) {
    return made([&](nurbs **out) { return nurbs_reverse(g, axis, flags, out); });
}

Handle transpose(const nurbs *g, const std::vector<int32_t> &permutation) {
    return made([&](nurbs **out) { return nurbs_transpose(g, permutation.data(), out); });
}

void expect_same(const SplineData &want, const SplineData &got, const std::string &place) {
    ASSERT_EQ(got.degrees, want.degrees) << place;
    ASSERT_EQ(got.counts, want.counts) << place;
    ASSERT_EQ(got.flags, want.flags) << place;
    ASSERT_TRUE(same_bits(got.all_knots(), want.all_knots())) << place;
    ASSERT_TRUE(same_bits(got.points, want.points)) << place;
    ASSERT_TRUE(same_bits(got.weights, want.weights)) << place;
}

TEST(Reverse, twice_gives_every_bit_back) {
    for_each_case(110000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 5));
        const int axis = random.whole(0, data.axes() - 1);
        const auto once = reverse(create(data).get(), axis);
        Handle again;
        ASSERT_EQ(try_create(read_back(once.get()), again), NURBS_OK) << last_error() << where(seed, data);
        expect_same(data, read_back(reverse(once.get(), axis).get()), where(seed, data));
    });
}

// At t of the one and -t of the other, from opposite sides, each within its own promise.
TEST(Reverse, the_shape_is_that_of_the_negated_parameter) {
    for_each_case(111000, 999, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, data.axes() - 1);
        const auto g = create(data);
        auto params = random_params(random, data, 8);
        const auto before = eval(g.get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        for (size_t i = static_cast<size_t>(axis); i < params.size(); i += static_cast<size_t>(data.axes())) {
            params[i] = -params[i];
        }
        const auto after = eval(reverse(g.get(), axis).get(), params, NURBS_ON_AXIS(axis, NURBS_LEFT));
        const long double bound = 2 * (data.rational() ? 4 : 1) * reference::c_of(data) * eps;
        for (size_t i = 0; i < before.size(); ++i) {
            ASSERT_LE(std::fabs(static_cast<long double>(before[i]) - after[i]),
                      bound * hulls[i / static_cast<size_t>(data.dim)])
                << where(seed, data) << " axis " << axis << " value " << i;
        }
    });
}

// The domain has its bits, knots inside are mirrored to within 2 eps, and periodic axes are accepted again.
TEST(Reverse, can_keep_the_domain) {
    for_each_case(112000, 999, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 5));
        const int axis = random.whole(0, data.axes() - 1);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_reverse(create(data).get(), axis, NURBS_KEEP_DOMAIN, &out);
        const Handle reversed(out);
        if (status == NURBS_ERROR_KNOTS_MERGE) {
            return; // spans of a few units of rounding
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const auto got = read_back(reversed.get());
        const auto k = static_cast<size_t>(axis);
        const double lower = data.lower(axis);
        const double upper = data.upper(axis);
        ASSERT_TRUE(same_bits(got.lower(axis), lower)) << where(seed, data);
        ASSERT_TRUE(same_bits(got.upper(axis), upper)) << where(seed, data);
        const double size = std::max({std::fabs(lower), std::fabs(upper), upper - lower});
        const auto &t = data.knots[k];
        for (int64_t i = data.degrees[k]; i <= data.counts[k]; ++i) {
            const long double mirrored =
                static_cast<long double>(lower) +
                (static_cast<long double>(upper) - t[t.size() - 1 - static_cast<size_t>(i)]);
            ASSERT_LE(std::fabs(got.knots[k][static_cast<size_t>(i)] - mirrored), 2 * eps * size)
                << where(seed, data);
        }
        Handle again;
        ASSERT_EQ(try_create(got, again), NURBS_OK) << last_error() << where(seed, data);
    });
}

TEST(Transpose, the_inverse_order_gives_every_bit_back) {
    for_each_case(113000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 3));
        std::vector<int32_t> order(static_cast<size_t>(data.axes()));
        std::iota(order.begin(), order.end(), 0);
        for (size_t i = order.size(); i-- > 1;) {
            std::swap(order[i], order[static_cast<size_t>(random.whole(0, static_cast<int>(i)))]);
        }
        std::vector<int32_t> inverse(order.size());
        for (size_t k = 0; k < order.size(); ++k) {
            inverse[static_cast<size_t>(order[k])] = static_cast<int32_t>(k);
        }
        const auto g = create(data);
        const auto turned = transpose(g.get(), order);
        expect_same(data, read_back(transpose(turned.get(), inverse).get()), where(seed, data));
        // Another order of the axes is another order of the sums.
        const auto params = random_params(random, data, 1);
        std::vector<double> moved;
        for (const int32_t k : order) {
            moved.push_back(params[static_cast<size_t>(k)]);
        }
        const auto before = eval(g.get(), params);
        const auto after = eval(turned.get(), moved);
        const long double bound =
            2 * reference::c_of(data) * reference::weight_factor(data, params.data()) * eps;
        for (size_t i = 0; i < before.size(); ++i) {
            ASSERT_LE(std::fabs(static_cast<long double>(before[i]) - after[i]),
                      bound * hull_sizes(g.get(), params)[0])
                << where(seed, data);
        }
    });
}

// Ends exact, knots inside to 2 eps, control points untouched; and what is refused merges indeed.
TEST(Reparametrize, maps_the_knots_and_nothing_else) {
    for_each_case(114000, 999, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 5));
        const int axis = random.whole(0, data.axes() - 1);
        const auto k = static_cast<size_t>(axis);
        const double lower = random.chance(30) ? 0 : random.between(-1, 1) * random.magnitude(1e-9, 1e9);
        const double upper = random.chance(30) ? lower + 1 : lower + random.magnitude(1e-6, 1e9);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_reparametrize(create(data).get(), axis, lower, upper, &out);
        const Handle mapped(out);
        const auto &t = data.knots[k];
        const long double a = data.lower(axis);
        const long double factor = (static_cast<long double>(upper) - lower) / (data.upper(axis) - a);
        const double size = std::max({std::fabs(lower), std::fabs(upper), upper - lower});
        if (status == NURBS_ERROR_KNOTS_MERGE) {
            long double shortest = t.back() - t.front();
            for (size_t i = 1; i < t.size(); ++i) {
                shortest = t[i] > t[i - 1] ? std::min<long double>(shortest, t[i] - t[i - 1]) : shortest;
            }
            const double outside = std::max(std::fabs(t.front()), std::fabs(t.back()));
            ASSERT_LE(shortest * factor, 8 * eps * (size + outside * factor)) << where(seed, data);
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        auto got = read_back(mapped.get());
        ASSERT_TRUE(same_bits(got.lower(axis), lower)) << where(seed, data);
        ASSERT_TRUE(same_bits(got.upper(axis), upper)) << where(seed, data);
        for (auto i = static_cast<size_t>(data.degrees[k]); i <= static_cast<size_t>(data.counts[k]); ++i) {
            ASSERT_LE(std::fabs(got.knots[k][i] - (lower + (t[i] - a) * factor)), 2 * eps * size)
                << where(seed, data) << " knot " << i;
        }
        Handle again;
        ASSERT_EQ(try_create(got, again), NURBS_OK) << last_error() << where(seed, data);
        got.knots[k] = t;
        expect_same(data, got, where(seed, data));
    });
}

// Points of the homogeneous spline are (w C, w), so that their quotient is C.
TEST(Homogeneous, there_and_back) {
    for_each_case(115000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 3));
        const auto g = create(data);
        const auto lifted = made([&](nurbs **out) { return nurbs_to_homogeneous(g.get(), out); });
        const auto flat = read_back(lifted.get());
        ASSERT_EQ(flat.dim, data.dim + 1) << where(seed, data);
        ASSERT_FALSE(flat.rational()) << where(seed, data);
        ASSERT_TRUE(same_bits(flat.points, homogeneous_points(g.get()))) << where(seed, data);
        const auto back = made([&](nurbs **out) { return nurbs_from_homogeneous(lifted.get(), out); });
        ASSERT_TRUE(same_bits(homogeneous_points(back.get()), homogeneous_points(g.get())))
            << where(seed, data);
        const auto rational =
            read_back(made([&](nurbs **out) { return nurbs_make_rational(g.get(), out); }).get());
        ASSERT_TRUE(same_bits(rational.points, data.points)) << where(seed, data);
        ASSERT_TRUE(same_bits(rational.weights, data.rational()
                                                    ? data.weights
                                                    : std::vector<double>(rational.weights.size(), 1.0)))
            << where(seed, data);
    });
}

} // namespace

} // namespace forms_test
