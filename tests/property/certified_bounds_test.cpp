// Bounds of lossy operations on curves against the true distance, by exact arithmetic. With homogeneous
// points A, w and B, v of both curves the distance is at most d where
//
//     d^2 (w v)^2 - |A v - B w|^2 >= 0,
//
// a polynomial on each common span. Its Bernstein coefficients are integers here, after a common factor, and
// halving the span until all of them are >= 0 proves it; a value < 0 at an end disproves it. No rounding
// comes in.
#include "property/exact_polynomials.h"
#include "property/same_shape.h"

namespace certified_bounds_test {

using namespace support;
using reference::Integer;
using reference::Rational;

namespace {

bool at_most_on(const std::vector<Polynomial> &f, const std::vector<Polynomial> &g, const Rational &square) {
    const Polynomial &w = f.back(), &v = g.back();
    const Polynomial both = product(w, v);
    Polynomial rest = product(both, both);
    std::transform(rest.begin(), rest.end(), rest.begin(),
                   [&](const Integer &x) { return x * numerator(square); });
    for (size_t c = 0; c + 1 < f.size(); ++c) {
        Polynomial difference = product(f[c], v);
        add(difference, product(g[c], w), -1);
        add(rest, product(difference, difference), -denominator(square));
    }
    return nonnegative(rest);
}

// Whether |f(t) - g(t)| <= bound on the whole domain.
bool at_most(const SplineData &f, const SplineData &g, double bound) {
    std::vector<double> breaks = f.knots[0];
    breaks.insert(breaks.end(), g.knots[0].begin(), g.knots[0].end());
    std::erase_if(breaks, [&](double t) { return t < f.lower(0) || t > f.upper(0); });
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    const Rational square = reference::exact(bound) * reference::exact(bound);
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        if (!at_most_on(piece(f, breaks[i], breaks[i + 1]), piece(g, breaks[i], breaks[i + 1]), square)) {
            return false;
        }
    }
    return true;
}

SplineData random_curve(Random &random) {
    Recipe recipe = random_recipe(random, 1, 5);
    recipe.axes[0].spans = random.whole(2, 6);
    recipe.dim = random.whole(1, 3);
    if (recipe.weights == Weights::some_zero) {
        recipe.weights = Weights::extreme;
    }
    return random_spline(random, recipe);
}

struct Lossy {
    Handle spline;
    double bound = 0;
};

// One of the lossy operations.
Lossy made(Random &random, const nurbs *g, const SplineData &data) {
    nurbs *out = nullptr;
    double bound = 0;
    const double tolerance = extent(data) * random.magnitude(1e-3, 10);
    nurbs_status status = NURBS_OK;
    switch (random.whole(0, 3)) {
    case 0: {
        const double knot = data.knots[0][random.bits() % data.knots[0].size()];
        const bool inner = data.lower(0) < knot && knot < data.upper(0);
        int32_t times = 0;
        status = inner ? nurbs_remove_knot(g, 0, knot, 1, INFINITY, &times, &bound, &out)
                       : nurbs_reduce_knots(g, 0, tolerance, &bound, &out);
        break;
    }
    case 1:
        status = nurbs_reduce_knots(g, 0, tolerance, &bound, &out);
        break;
    case 2:
        status = nurbs_reduce_degree(g, 0, std::min(1, data.degrees[0]), &bound, &out);
        break;
    default:
        status = nurbs_simplify(g, tolerance, &bound, &out);
    }
    if (status != NURBS_ERROR_WEIGHT_SIGN) {
        require_ok(status);
    }
    return {Handle(out), bound};
}

TEST(CertifiedBounds, of_lossy_operations_hold_in_exact_arithmetic) {
    int compared = 0, moved = 0;
    for_each_case(990000, 1200, [&](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random);
        const auto g = create(data);
        const Lossy result = made(random, g.get(), data);
        if (result.spline && std::isfinite(result.bound)) {
            ASSERT_TRUE(at_most(data, read_back(result.spline.get()), result.bound))
                << where(seed, data) << " bound " << hex(result.bound);
            ++compared;
            moved += result.bound > 0 ? 1 : 0;
        }
    });
    std::printf("%d compared, %d with a bound above 0\n", compared, moved);
    EXPECT_GE(moved, compared / 4);
}

// Both ends of the enclosure of a distance: the upper one holds, the lower one, a little enlarged inwards,
// does not.
TEST(CertifiedBounds, of_distances_enclose_them) {
    for_each_case(991000, 150, [&](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random);
        SplineData other = data;
        for (double &x : other.points) {
            x += data.periodic(0) ? 0.125 : random.between(-0.125, 0.125);
        }
        double at_least = 0, at_most_this = 0;
        require_ok(nurbs_deviation(create(data).get(), create(other).get(), &at_least, &at_most_this));
        ASSERT_TRUE(at_most(data, other, at_most_this)) << where(seed, data);
        if (at_least > 0) {
            ASSERT_FALSE(at_most(data, other, at_least * (1 - 1e-9))) << where(seed, data);
        }
    });
}

} // namespace

} // namespace certified_bounds_test
