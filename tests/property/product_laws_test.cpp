// Products and sums of splines: laws of calculus and of vectors, at points.
#include "property/products.h"

namespace product_laws_test {

using namespace support;
using namespace support::products;
using reference::eps;
using reference::Fraction;
using reference::Rational;

namespace {

Handle derivative(const nurbs *g, int axis) {
    nurbs *out = nullptr;
    require_ok(nurbs_derivative(g, axis, 1, &out));
    return Handle(out);
}

// (f g)' = f' g + f g', evaluated at points.
TEST(Product, obeys_the_rule_of_leibniz) {
    for_each_case(750000, 400, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = exact_recipe(random, axes, 4);
        recipe.weights = Weights::none;
        Pair pair;
        pair.a = random_spline(random, recipe);
        pair.b = partner(random, pair.a, 4, 1, false, true);
        const int axis = random.whole(0, axes - 1);
        const auto a = create(pair.a), b = create(pair.b);
        const auto whole = derivative(product(a.get(), b.get()).get(), axis);
        const auto first = product(derivative(a.get(), axis).get(), b.get());
        const auto second = product(a.get(), derivative(b.get(), axis).get());
        const auto parts = sum(first.get(), 1, second.get(), 1);
        // Differences of control points that are off by a few eps of the largest, over the shortest length.
        const auto made = read_back(whole.get());
        const auto k = static_cast<size_t>(axis);
        double shortest = made.upper(axis) - made.lower(axis);
        for (const SplineData *data : {&pair.a, &pair.b}) {
            for (const double s : pair.a.knots[k]) {
                for (const double t : data->knots[k]) {
                    shortest = s < t   ? std::min(shortest, t - s)
                               : t < s ? std::min(shortest, s - t)
                                       : shortest;
                }
            }
        }
        double size = 0;
        for (const double x : pair.a.points) {
            size = std::max(size, std::fabs(x));
        }
        const int r = pair.a.degrees[k] + pair.b.degrees[k];
        const long double bound =
            eps * size * (r + 1) * 2 / shortest * 16 * (degree_sum(pair.a) + degree_sum(pair.b));
        for (int n = 0; n < 3; ++n) {
            const auto param = random_place(random, pair);
            const auto left = random_sides(random, pair.a, param);
            const Point x = exact_record(whole.get(), param, left),
                        y = exact_record(parts.get(), param, left);
            for (size_t c = 0; c < x.size(); ++c) {
                ASSERT_LE(size_of(x[c] - y[c]), bound) << places(seed, pair) << hex(param);
            }
        }
    });
}

TEST(Product, dot_and_cross_products_are_those_of_the_points) {
    for_each_case(760000, 400, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = exact_recipe(random, axes, 4);
        recipe.dim = 3;
        Pair pair;
        pair.a = random_spline(random, recipe);
        pair.b = partner(random, pair.a, 4, 3, random.chance(50), true);
        const auto a = create(pair.a), b = create(pair.b);
        const auto dot = product(a.get(), b.get(), NURBS_PRODUCT_DOT);
        const auto cross = product(a.get(), b.get(), NURBS_PRODUCT_CROSS);
        const auto param = random_place(random, pair);
        const auto left = random_sides(random, pair.a, param);
        const Point f = exact_record(a.get(), param, left), g = exact_record(b.get(), param, left);
        const Point d = exact_record(dot.get(), param, left), x = exact_record(cross.get(), param, left);
        long double unit = 0;
        for (int c = 0; c < 3; ++c) {
            for (int e = 0; e < 3; ++e) {
                unit = std::max(unit, hull_of(a.get(), param, left, c) * hull_of(b.get(), param, left, e));
            }
        }
        const long double bound = (4 * (degree_sum(pair.a) + degree_sum(pair.b)) + 3) * eps * unit;
        ASSERT_LE(size_of(d[0] - (f[0] * g[0] + f[1] * g[1] + f[2] * g[2])), 3 * bound) << places(seed, pair);
        for (size_t c = 0; c < 3; ++c) {
            const size_t i = (c + 1) % 3, j = (c + 2) % 3;
            ASSERT_LE(size_of(x[c] - (f[i] * g[j] - f[j] * g[i])), 2 * bound) << places(seed, pair);
        }
    });
}

TEST(Sum, is_the_sum_at_every_point) {
    WorstErrors worst("sums by degree of axis 0, unit eps * hulls");
    for_each_case(770000, 900, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        const int highest = axes == 1 ? random.chance(20) ? 15 : 9 : axes == 2 ? 3 : 2;
        Pair pair = random_pair(random, axes, highest, highest, 1, true);
        const bool same_weights = random.chance(20); // a spline and itself, raised in degree
        const auto a = create(pair.a);
        const auto b = same_weights ? sum(a.get(), 1, a.get(), -0.75) : create(pair.b);
        const double alpha = random.between(-2, 2), beta = random.between(-2, 2);
        const auto made = sum(a.get(), alpha, b.get(), beta);
        const auto got = read_back(made.get());
        const auto other = read_back(b.get());
        const bool over_product = got.rational() && !same_weights;
        for (int k = 0; k < axes; ++k) {
            const auto at = static_cast<size_t>(k);
            ASSERT_EQ(got.lower(k), pair.a.lower(k));
            ASSERT_EQ(got.upper(k), pair.a.upper(k));
            ASSERT_EQ(got.periodic(k), pair.a.periodic(k) && other.periodic(k));
            const int p = pair.a.degrees[at], q = other.degrees[at];
            ASSERT_TRUE(got.degrees[at] == (over_product ? p + q : std::max(p, q)) ||
                        (over_product && got.degrees[at] == std::max(p, q)))
                << places(seed, pair);
        }
        const auto param = random_place(random, pair);
        const auto left = random_sides(random, pair.a, param);
        const Point f = exact_record(a.get(), param, left), g = exact_record(b.get(), param, left),
                    h = exact_record(made.get(), param, left);
        const Rational w = f.back(), v = g.back(), u = h.back();
        const long double bound = 2 * axes + 1;
        for (int c = 0; c < pair.a.dim; ++c) {
            const auto at = static_cast<size_t>(c);
            // The value is compared: N / u against (alpha F / w + beta G / v), over u as it came out.
            const Rational error =
                h[at] - u * (reference::exact(alpha) * f[at] / w + reference::exact(beta) * g[at] / v);
            const int last = pair.a.dim;
            const long double hull_w = hull_of(a.get(), param, left, last),
                              hull_v = hull_of(b.get(), param, left, last);
            const long double own = std::fabs(alpha) * hull_of(a.get(), param, left, c);
            const long double others = std::fabs(beta) * hull_of(b.get(), param, left, c);
            const long double value =
                size_of(reference::exact(alpha) * f[at] / w) + size_of(reference::exact(beta) * g[at] / v);
            const long double unit = same_weights || !got.rational()
                                         ? own + others + value * hull_w
                                         : own * hull_v + others * hull_w + value * hull_w * hull_v;
            if (error != 0) {
                worst.add(got.degrees[0], size_of(error) / (eps * unit * bound),
                          size_of(error) / (eps * unit));
                ASSERT_LE(size_of(error), bound * eps * unit) << places(seed, pair) << hex(param);
            }
        }
    });
}

} // namespace

} // namespace product_laws_test
