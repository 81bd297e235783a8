// Warps and flattened regions against their formulas.
#include "property/deform_cases.h"

namespace warp_test {

using namespace support;
using namespace support::deform;

namespace {

// The B-spline over even knots at t, without rounding of the knots, and over its value in the middle.
long double bump(double lower, double upper, int degree, double t) {
    const long double n = degree + 1, x = (static_cast<long double>(t) - lower) /
                                          (static_cast<long double>(upper) - lower) * n;
    const auto cardinal = [degree](long double at) { // sum (-1)^j binomial(d + 1, j) (x - j)_+^d, d! apart
        long double sum = 0;
        for (int j = 0; j <= degree + 1; ++j) {
            const long double part = std::max<long double>(at - j, 0);
            sum += (j % 2 == 0 ? 1 : -1) * static_cast<long double>(binomial(degree + 1, j)) *
                   std::pow(part, degree);
        }
        return sum;
    };
    return x <= 0 || x >= n ? 0 : cardinal(x) / cardinal(n / 2);
}

TEST(Warp, adds_the_bump) {
    for_each_case(1510000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data =
            random_spline(random, calm_recipe(random, axes, axes == 1 ? 5 : 3, random.whole(1, 3)));
        const std::vector<double> range = any_range(random, data), direction = direction_of(random, data.dim);
        const int order = random.whole(0, 3);
        const double distance = random.between(-2, 2);
        const Handle g = create(data);
        nurbs *out = nullptr;
        const nurbs_status status =
            nurbs_warp(g.get(), range.data(), direction.data(), distance, order, &out);
        const Handle h(out);
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const SplineData after = read_back(h.get());
        for (int k = 0; k < axes; ++k) {
            ASSERT_EQ(after.periodic(k), data.periodic(k)) << where(seed, data);
        }
        long double length = 0;
        for (const double x : direction) {
            length = std::hypot(length, static_cast<long double>(x));
        }
        for (int n = 0; n < 6; ++n) {
            const std::vector<double> param = random_params(random, data, 1);
            bool knot = false; // where the limits of jumps differ
            long double height = distance;
            for (int k = 0; k < axes; ++k) {
                const auto at = static_cast<size_t>(k);
                height *= bump(range[2 * at], range[2 * at + 1], order + 1, param[at]);
                knot = knot ||
                       std::count(data.knots[at].begin(), data.knots[at].end(), param[at]) > data.degrees[at];
            }
            const Point step = step_between(g.get(), h.get(), param);
            // The products and sums of degrees up to p + order + 1 on each axis, knots rounded relative to
            // spans of at least 1 / 64 of the domain's size.
            const long double bound = 1 << 14,
                              unit = eps * (extent(data) + std::fabs(distance)) * (data.rational() ? 25 : 1);
            for (size_t c = 0; c < step.size() && !knot; ++c) {
                ASSERT_LE(std::fabs(as_long_double(step[c]) - height * direction[c] / length), bound * unit)
                    << where(seed, data) << hex(range) << " at " << hex(param);
            }
        }
    });
}

// The derivatives of the difference at the ends of the range vanish up to the order, and outside there is
// none.
TEST(Warp, keeps_derivatives_at_the_ends) {
    for_each_case(1520000, 150, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 5, 2);
        recipe.weights = Weights::none;
        const SplineData data = random_spline(random, recipe);
        const std::vector<double> range = any_range(random, data), direction = {0, 1};
        const int order = random.whole(0, 4);
        const Handle g = create(data);
        nurbs *out = nullptr;
        require_ok(nurbs_warp(g.get(), range.data(), direction.data(), 1, order, &out));
        const Handle h(out);
        const SplineData after = read_back(h.get());
        for (const int end : {0, 1}) {
            const double t = range[static_cast<size_t>(end)];
            const reference::Sides left{end == 1};
            const auto a = reference::exact_derivatives(data, order, &t, left),
                       b = reference::exact_derivatives(after, order, &t, left);
            for (int k = 0; k <= order; ++k) {
                const auto at = static_cast<size_t>(k);
                for (size_t c = 0; c < 2; ++c) {
                    const Rational gap = Rational(a[at][c].numerator, a[at][c].denominator) -
                                         Rational(b[at][c].numerator, b[at][c].denominator);
                    const long double spans =
                        std::pow(static_cast<long double>(64 * 32) / (data.upper(0) - data.lower(0)), k);
                    ASSERT_LE(std::fabs(as_long_double(gap)), 64 * eps * spans * 1024 * (extent(data) + 1))
                        << where(seed, data) << hex(range) << " derivative " << k;
                }
            }
        }
    });
}

TEST(Flatten, makes_the_middle_flat_and_keeps_the_outside) {
    for_each_case(1530000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data =
            random_spline(random, calm_recipe(random, axes, axes == 1 ? 5 : 3, random.whole(2, 3)));
        std::vector<double> range = any_range(random, data);
        const std::vector<double> point = direction_of(random, data.dim),
                                  normal = direction_of(random, data.dim);
        const Handle g = create(data);
        double moved = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_flatten(g.get(), range.data(), point.data(), normal.data(), nullptr, &moved, &out));
        const Handle h(out);
        const SplineData after = read_back(h.get());
        const long double rounding = 4096 * eps * (extent(data) + 4) * (data.rational() ? 25 : 1);
        for (int n = 0; n < 6; ++n) {
            std::vector<double> param = random_params(random, data, 1);
            bool outside = false;
            for (int k = 0; k < axes; ++k) {
                const auto at = static_cast<size_t>(k);
                outside = outside || param[at] < range[2 * at] || param[at] > range[2 * at + 1];
            }
            const long double gap = length(step_between(g.get(), h.get(), param));
            ASSERT_LE(gap, outside ? rounding : moved + rounding)
                << where(seed, data) << hex(range) << hex(param);
            for (size_t k = 0; k < param.size(); ++k) {
                param[k] = (range[2 * k] + range[2 * k + 1]) / 2;
            }
            const Point middle = point_at(after, param);
            long double height = 0, size = 0;
            for (size_t c = 0; c < middle.size(); ++c) {
                height += as_long_double(Rational(middle[c] - exact(point[c]))) * normal[c];
                size = std::hypot(size, static_cast<long double>(normal[c]));
            }
            ASSERT_LE(std::fabs(height) / size, rounding) << where(seed, data) << hex(range);
        }
    });
}

} // namespace

} // namespace warp_test
