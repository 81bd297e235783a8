// Ruled surfaces and volumes against their defining formulas, without rounding.
#include "exact_points.h"
#include "reference/exact_basis.h"

namespace ruled_test {

using namespace support;

namespace {

// The homogeneous point of a curve, by the sum over all of its control points.
Point homogeneous_at(const SplineData &data, double t) {
    const auto basis = reference::exact_basis(data.knots[0], data.degrees[0], t, 0);
    Point point(static_cast<size_t>(data.dim) + 1);
    for (int j = 0; j <= data.degrees[0]; ++j) {
        const int64_t i = basis.span - data.degrees[0] + j;
        const Rational share =
            exact(data.weight(i)) * Rational(basis.numerators[0][static_cast<size_t>(j)], basis.denominator);
        for (int c = 0; c < data.dim; ++c) {
            point[static_cast<size_t>(c)] += share * exact(data.coordinate(i, c));
        }
        point.back() += share;
    }
    return point;
}

SplineData even_curve(Random &random, int dim) {
    Recipe recipe;
    recipe.axes.push_back(random_axis(random, random.whole(0, 9)));
    recipe.axes.back().spacing = random.chance(50) ? Spacing::integers : Spacing::few_bits;
    recipe.axes.back().placement = support::Placement::origin;
    recipe.axes.back().spans = random.whole(1, 3);
    recipe.weights = random.chance(70) ? Weights::moderate : Weights::none;
    recipe.dim = dim;
    return random_spline(random, recipe);
}

double weight_ratio(const SplineData &data) {
    const auto [least, most] = std::minmax_element(data.weights.begin(), data.weights.end());
    return data.rational() ? *most / *least : 1;
}

SplineData over_domain(const SplineData &data, double lower, double upper) {
    nurbs *out = nullptr;
    require_ok(nurbs_reparametrize(create(data).get(), 0, lower, upper, &out));
    return read_back(Handle(out).get());
}

SplineData ruled(const SplineData &a, const SplineData &b, uint32_t flags) {
    nurbs *out = nullptr;
    require_ok(nurbs_ruled(create(a).get(), create(b).get(), flags, &out));
    return read_back(Handle(out).get());
}

// (1 - v) A + v B, divided by the weight.
Point between(const Point &a, const Point &b, const Rational &v) {
    Point point(a.size() - 1);
    const Rational w = (1 - v) * a.back() + v * b.back();
    for (size_t c = 0; c < point.size(); ++c) {
        point[c] = ((1 - v) * a[c] + v * b[c]) / w;
    }
    return point;
}

Point divided(Point point) {
    for (Rational &x : point) {
        x /= Rational(point.back());
    }
    return point;
}

// Each step of raising a degree, and each of the new knots that a control point counts, at most its degree,
// gives 2 eps in homogeneous space, weights apart one more; the products with the other denominator 4 (p + q
// + 1). Division by weights that are at least 1 / ratio of the largest multiplies by 2 ratio, as numerator
// and denominator err.
TEST(Ruled, surfaces) {
    WorstRatios standard("ruled"), cartesian("ruled, Cartesian");
    for_each_case(717000, 80, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(1, 3);
        const auto a = even_curve(random, dim), given = even_curve(random, dim);
        const auto b = over_domain(given, a.lower(0), a.upper(0));
        const double u = random_params(random, a, 1)[0],
                     v = random.chance(30) ? random.whole(0, 1) : random.unit();
        const Point at_a = homogeneous_at(a, u), at_b = homogeneous_at(b, u);
        const int p = a.degrees[0], q = b.degrees[0];
        const long double size = std::max(extent(a), extent(b)),
                          steps = 2 * (std::abs(p - q) + std::max(p, q)) + 1,
                          ratios = weight_ratio(a) * weight_ratio(b);
        const long double error = ratio(point_at(ruled(a, given, 0), {u, v}), between(at_a, at_b, exact(v)),
                                        steps * 2 * ratios * eps * size);
        standard.add(error);
        ASSERT_LE(error, 1) << where(seed, a) << describe(given);
        const Point straight = between(divided(at_a), divided(at_b), exact(v));
        const long double more = ratio(point_at(ruled(a, given, NURBS_RULED_CARTESIAN), {u, v}), straight,
                                       std::max(steps, 4.0L * (p + q + 1)) * 2 * ratios * eps * size);
        cartesian.add(more);
        ASSERT_LE(more, 1) << where(seed, a) << describe(given);
    });
}

// Curves that share their knots and degree are the first and last layer bit for bit.
TEST(Ruled, surfaces_hold_compatible_curves) {
    for_each_case(718000, 50, [](Random &random, uint64_t seed) {
        const auto a = even_curve(random, 3);
        const auto b = scaled(a, -2);
        for (const uint32_t flags : {0U, NURBS_RULED_CARTESIAN}) {
            const auto got = ruled(a, b, flags);
            ASSERT_EQ(got.flags, a.flags);
            ASSERT_TRUE(same_bits(got.knots[0], a.knots[0])) << where(seed, a);
            for (size_t i = 0; i < a.points.size(); ++i) {
                const size_t at = i / 3 * 6 + i % 3;
                ASSERT_TRUE(same_bits(got.points[at], a.points[i]) &&
                            same_bits(got.points[at + 3], b.points[i]))
                    << where(seed, a);
            }
        }
    });
}

// Volumes between surfaces.
TEST(Ruled, volumes) {
    for_each_case(719000, 40, [](Random &random, uint64_t seed) {
        Recipe recipe;
        for (int k = 0; k < 2; ++k) {
            recipe.axes.push_back({random.whole(1, 3), KnotForm::clamped, Spacing::integers,
                                   support::Placement::origin, random.whole(1, 3)});
        }
        const auto a = random_spline(random, recipe);
        recipe.axes[0].degree = random.whole(1, 3);
        auto b = random_spline(random, recipe);
        nurbs *out = nullptr;
        require_ok(nurbs_reparametrize(create(b).get(), 0, a.lower(0), a.upper(0), &out));
        const Handle first(out);
        require_ok(nurbs_reparametrize(first.get(), 1, a.lower(1), a.upper(1), &out));
        const auto mapped = read_back(Handle(out).get());
        const auto got = ruled(a, b, 0);
        const auto params = random_params(random, a, 1);
        const double v = random.unit();
        Point want = point_at(a, params);
        const Point other = point_at(mapped, params);
        for (size_t c = 0; c < want.size(); ++c) {
            want[c] += exact(v) * (other[c] - want[c]);
        }
        const long double size = std::max(extent(a), extent(b));
        ASSERT_LE(ratio(point_at(got, joined(params, {v})), want, 2 * 10 * eps * size), 1) << where(seed, a);
    });
}

} // namespace

} // namespace ruled_test
