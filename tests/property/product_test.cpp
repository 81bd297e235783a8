// Products and sums of splines: control points against their definition, the functions against each other at points,
// laws of calculus.
#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "same_shape.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

using namespace support;
using reference::eps;
using reference::Fraction;
using reference::Rational;

namespace {

using Point = std::vector<Rational>;

Handle product(const nurbs *a, const nurbs *b, uint32_t flags = 0) {
    nurbs *out = nullptr;
    require_ok(nurbs_product(a, b, flags, &out));
    return Handle(out);
}

Handle sum(const nurbs *a, double alpha, const nurbs *b, double beta) {
    nurbs *out = nullptr;
    require_ok(nurbs_sum(a, alpha, b, beta, &out));
    return Handle(out);
}

Handle derivative(const nurbs *g, int axis) {
    nurbs *out = nullptr;
    require_ok(nurbs_derivative(g, axis, 1, &out));
    return Handle(out);
}

long double size_of(const Rational &x) {
    return std::fabs(reference::quotient(numerator(x), denominator(x)));
}

// Knots inside [lower, upper], some of them out of `others`; sorted, at most degree + 1 equal.
std::vector<double> inner_knots(Random &random, int degree, double lower, double upper,
                                const std::vector<double> &others) {
    std::vector<double> knots;
    for (int i = random.whole(0, 3); i > 0; --i) {
        const double other = others[random.bits() % others.size()];
        const double fresh = lower + (upper - lower) * random.whole(1, 63) / 64;
        const double knot = random.chance(60) ? other : fresh;
        if (lower < knot && knot < upper && std::find(knots.begin(), knots.end(), knot) == knots.end()) {
            knots.insert(knots.end(),
                         random.chance(60) ? 1U : random.bits() % static_cast<size_t>(degree + 1) + 1, knot);
        }
    }
    std::sort(knots.begin(), knots.end());
    return knots;
}

// `degree` knots beyond an end of the domain: at it, beyond, or some of each.
std::vector<double> beyond(Random &random, int degree, double end, double step) {
    std::vector<double> knots;
    const bool clamped = random.chance(40);
    for (int i = 0; i < degree; ++i) {
        end += clamped || random.chance(30) ? 0 : step * random.whole(1, 8) / 8;
        knots.push_back(end);
    }
    return knots;
}

void set_axis(SplineData &data, int degree, std::vector<double> knots) {
    data.degrees.push_back(degree);
    data.counts.push_back(static_cast<int64_t>(knots.size()) - degree - 1);
    data.knots.push_back(std::move(knots));
}

void wrap(SplineData &data, std::vector<double> &values, int width) {
    for (int axis = 0; axis < data.axes(); ++axis) {
        const Layers layers(data, axis);
        const int64_t distinct = layers.count - data.degrees[static_cast<size_t>(axis)];
        for (int64_t o = 0; data.periodic(axis) && o < layers.outer; ++o) {
            for (int64_t l = distinct; l < layers.count; ++l) {
                for (int64_t i = 0; i < layers.inner * width; ++i) {
                    const auto at = [&](int64_t layer) {
                        return static_cast<size_t>((o * layers.count + layer) * layers.inner * width + i);
                    };
                    values[at(l)] = values[at(l - distinct)];
                }
            }
        }
    }
}

// A spline over the domains of another one, sharing some of its knots, periodic where that is (or nowhere).
SplineData partner(Random &random, const SplineData &other, int max_degree, int dim, bool rational,
                   bool periodic) {
    SplineData data;
    data.dim = dim;
    for (int k = 0; k < other.axes(); ++k) {
        const double lower = other.lower(k), upper = other.upper(k), length = upper - lower;
        const int p = random.whole(0, max_degree);
        const std::vector<double> inner =
            inner_knots(random, p, lower, upper, other.knots[static_cast<size_t>(k)]);
        std::vector<double> knots;
        if (periodic && other.periodic(k)) {
            std::vector<double> one(static_cast<size_t>(random.whole(1, p + 1)), lower);
            one.insert(one.end(), inner.begin(), inner.end());
            const auto m = std::ssize(one);
            const int64_t start = random.whole(
                0, std::min<int>(p, static_cast<int>(std::count(one.begin(), one.end(), lower)) - 1));
            for (int64_t i = start - p; i <= start + m + p;
                 ++i) { // knot `start` is the last before the domain
                const int64_t turn = i >= 0 ? i / m : -((m - 1 - i) / m);
                knots.push_back(one[static_cast<size_t>(i - turn * m)] + static_cast<double>(turn) * length);
            }
            data.flags |= NURBS_ON_AXIS(k, NURBS_PERIODIC);
        } else {
            knots = beyond(random, p, lower, -length / 8);
            std::reverse(knots.begin(), knots.end());
            knots.push_back(lower);
            knots.insert(knots.end(), inner.begin(), inner.end());
            knots.push_back(upper);
            const auto behind = beyond(random, p, upper, length / 8);
            knots.insert(knots.end(), behind.begin(), behind.end());
        }
        set_axis(data, p, std::move(knots));
    }
    for (int64_t i = 0; i < data.point_count() * dim; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    for (int64_t i = 0; rational && i < data.point_count(); ++i) {
        data.weights.push_back(random.between(0.2, 5));
    }
    wrap(data, data.points, dim);
    if (rational) {
        wrap(data, data.weights, 1);
    }
    return data;
}

// Recipes whose periodic axes repeat exactly.
Recipe exact_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = random.whole(1, 4);
        if (axis.form == KnotForm::periodic) {
            axis.spacing = random.chance(50) ? Spacing::few_bits : Spacing::integers;
            axis.placement = Placement::origin;
        }
    }
    return recipe;
}

struct Pair {
    SplineData a;
    SplineData b;
};

Pair random_pair(Random &random, int axes, int degree_a, int degree_b, int dim_b, bool same_dim) {
    Pair pair;
    pair.a = random_spline(random, exact_recipe(random, axes, degree_a));
    pair.b = partner(random, pair.a, degree_b, same_dim ? pair.a.dim : dim_b, random.chance(40),
                     random.chance(80));
    return pair;
}

int degree_sum(const SplineData &data) {
    int total = 0;
    for (const int32_t p : data.degrees) {
        total += p + 1;
    }
    return total;
}

// (w x, ..., w) at a parameter, exactly; w = 1 where there are no weights.
Point exact_record(const nurbs *g, const std::vector<double> &param, const reference::Sides &left) {
    Point point;
    for (const Fraction &x : reference::exact_point(homogeneous(g), param.data(), left)) {
        point.push_back(Rational(x.numerator, x.denominator));
    }
    return point;
}

reference::Sides random_sides(Random &random, const SplineData &data, const std::vector<double> &param) {
    reference::Sides left{};
    for (int k = 0; k < data.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        left[at] = param[at] == data.upper(k) || (param[at] != data.lower(k) && random.chance(30));
    }
    return left;
}

// The sides of a parameter that is a knot of only one of the splines do not matter to the other.
std::vector<double> random_place(Random &random, const Pair &pair) {
    return random_params(random, random.chance(50) ? pair.a : pair.b, 1);
}

// The largest magnitude of a component among the active control points.
long double hull_of(const nurbs *g, const std::vector<double> &param, const reference::Sides &left, int c) {
    SplineData data = homogeneous(g);
    SplineData one = data;
    one.dim = 1;
    one.points.clear();
    for (int64_t i = 0; i < data.point_count(); ++i) {
        one.points.push_back(data.coordinate(i, c));
    }
    return reference::exact_hull(one, param.data(), left);
}

std::string places(uint64_t seed, const Pair &pair) {
    return where(seed, pair.a) + where(seed, pair.b);
}

void expect_same_domains(const SplineData &got, const Pair &pair, const std::string &place) {
    for (int k = 0; k < pair.a.axes(); ++k) {
        ASSERT_EQ(got.lower(k), pair.a.lower(k)) << place;
        ASSERT_EQ(got.upper(k), pair.a.upper(k)) << place;
        ASSERT_EQ(got.periodic(k), pair.a.periodic(k) && pair.b.periodic(k)) << place;
    }
}

TEST(Product, components_are_exact_to_the_bound) {
    WorstErrors worst("products by degree of axis 0, unit eps * hull * hull");
    for_each_case(710000, 900, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        const int highest = axes == 1 ? 9 : axes == 2 ? 3 : 2;
        const Pair pair = random_pair(random, axes, highest, highest, 1, random.chance(50));
        const auto a = create(pair.a), b = create(pair.b);
        const auto made = product(a.get(), b.get());
        const auto got = read_back(made.get());
        expect_same_domains(got, pair, places(seed, pair));
        for (size_t k = 0; k < pair.a.degrees.size(); ++k) {
            ASSERT_EQ(got.degrees[k], pair.a.degrees[k] + pair.b.degrees[k]);
        }
        const long double bound = 2 * axes + (got.rational() ? 1 : 0);
        for (int n = 0; n < 3; ++n) {
            const auto param = random_place(random, pair);
            const auto left = random_sides(random, pair.a, param);
            const Point f = exact_record(a.get(), param, left), g = exact_record(b.get(), param, left),
                        h = exact_record(made.get(), param, left);
            for (int c = 0; c <= pair.a.dim; ++c) {
                const int of_b = c == pair.a.dim ? pair.b.dim : pair.b.dim == 1 ? 0 : c;
                const auto at = static_cast<size_t>(c);
                const long double unit =
                    eps * hull_of(a.get(), param, left, c) * hull_of(b.get(), param, left, of_b);
                const long double error = size_of(h[at] - f[at] * g[static_cast<size_t>(of_b)]);
                if (error != 0) {
                    worst.add(got.degrees[0], error / unit / bound, error / unit);
                    ASSERT_LE(error, bound * unit) << places(seed, pair) << hex(param);
                }
            }
        }
    });
}

// Every choice of p of the p + q knots, one after the other.
template <class Body>
void for_each_subset(int total, int chosen, Body &&body) {
    for (unsigned bits = 0; bits < 1U << total; ++bits) {
        if (__builtin_popcount(bits) == chosen) {
            body(bits);
        }
    }
}

// A non-empty span of the domain inside the support [low, high] of a new control point.
int64_t span_inside(const std::vector<double> &knots, int degree, double low, double high) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    for (int64_t s = degree; s < count; ++s) {
        const double from = knots[static_cast<size_t>(s)], to = knots[static_cast<size_t>(s) + 1];
        if (from < to && from < high && low < to) {
            return s;
        }
    }
    return -1;
}

Point polar(const SplineData &data, int64_t span, const std::vector<double> &args) {
    std::vector<Point> active;
    for (int64_t i = span - data.degrees[0]; i <= span; ++i) {
        active.push_back({reference::exact(data.coordinate(i, 0))});
    }
    return reference::defined_blossom(data.knots[0], data.degrees[0], span, active, args);
}

TEST(Product, control_points_are_means_over_all_choices) {
    WorstErrors worst("control points of products by degree, unit eps * max * max");
    for_each_case(720000, 250, [&](Random &random, uint64_t seed) {
        Recipe recipe = exact_recipe(random, 1, 4);
        recipe.weights = Weights::none;
        recipe.dim = 1;
        Pair pair;
        pair.a = random_spline(random, recipe);
        pair.b = partner(random, pair.a, 4, 1, false, false);
        const auto got = read_back(product(create(pair.a).get(), create(pair.b).get()).get());
        const int p = pair.a.degrees[0], q = pair.b.degrees[0], r = p + q;
        for (int64_t j = 0; j < got.counts[0]; ++j) {
            const double low = std::max(got.knots[0][static_cast<size_t>(j)], got.lower(0));
            const double high = std::min(got.knots[0][static_cast<size_t>(j + r + 1)], got.upper(0));
            if (low >= high) {
                continue; // seen nowhere in the domain
            }
            const int64_t s = span_inside(pair.a.knots[0], p, low, high);
            const int64_t t = span_inside(pair.b.knots[0], q, low, high);
            Rational mean = 0;
            int choices = 0;
            for_each_subset(r, p, [&](unsigned bits) {
                std::vector<double> own, rest;
                for (int i = 0; i < r; ++i) {
                    ((bits >> i & 1U) != 0 ? own : rest)
                        .push_back(got.knots[0][static_cast<size_t>(j + 1 + i)]);
                }
                mean += polar(pair.a, s, own)[0] * polar(pair.b, t, rest)[0];
                ++choices;
            });
            mean /= choices;
            const auto largest = [](const SplineData &data) {
                long double size = 0;
                for (const double x : data.points) {
                    size = std::max<long double>(size, std::fabs(x));
                }
                return size;
            };
            const long double unit = eps * largest(pair.a) * largest(pair.b);
            const long double error =
                reference::error_ratio(got.coordinate(j, 0), reference::fraction(mean), unit);
            worst.add(r, error / 2, error);
            ASSERT_LE(error, 2) << places(seed, pair) << " layer " << j;
        }
    });
}

// Knots of the product are those of the factors, as often as the continuity asks for.
TEST(Product, keeps_the_continuity) {
    for_each_case(730000, 1000, [](Random &random, uint64_t seed) {
        const Pair pair = random_pair(random, 1, 9, 9, 1, false);
        const auto got = read_back(product(create(pair.a).get(), create(pair.b).get()).get());
        const auto copies = [](const SplineData &data, double knot) {
            return static_cast<int>(std::count(data.knots[0].begin(), data.knots[0].end(), knot));
        };
        for (const double knot : got.knots[0]) {
            const int m = copies(pair.a, knot), n = copies(pair.b, knot);
            if (got.lower(0) < knot && knot < got.upper(0)) {
                ASSERT_EQ(copies(got, knot),
                          std::max(m > 0 ? pair.b.degrees[0] + m : 0, n > 0 ? pair.a.degrees[0] + n : 0))
                    << places(seed, pair) << hex(knot);
            }
        }
        Handle again;
        ASSERT_EQ(try_create(got, again), NURBS_OK) << last_error() << places(seed, pair);
    });
}

// The result is one that nurbs_create() accepts as periodic, whatever the rounding of the knots.
TEST(Product, periodic_axes_stay_periodic) {
    int cases = 0, refused = 0;
    for_each_case(735000, 600, [&](Random &random, uint64_t seed) {
        ++cases;
        Recipe recipe = random_recipe(random, 1, 6);
        recipe.axes[0].form = KnotForm::periodic;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_product(g.get(), g.get(), 0, &out);
        const Handle made(out);
        if (status == NURBS_ERROR_PERIODIC_KNOTS) {
            ++refused; // knots that rounding makes equal in one period and not in another
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const auto got = read_back(made.get());
        ASSERT_EQ(got.flags, data.flags) << where(seed, data);
        Handle again;
        ASSERT_EQ(try_create(got, again), NURBS_OK) << last_error() << where(seed, data);
    });
    std::printf("%d of %d refused\n", refused, cases);
    ASSERT_LE(refused, cases / 50);
}

// One times a spline is the spline with its degree raised: the same knots, and control points to rounding.
TEST(Product, with_one_is_elevation) {
    for_each_case(740000, 400, [](Random &random, uint64_t seed) {
        Recipe recipe = exact_recipe(random, 1, 6);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const int q = random.whole(1, 3);
        SplineData one;
        one.dim = 1;
        std::vector<double> knots(static_cast<size_t>(q) + 1, data.lower(0));
        knots.insert(knots.end(), static_cast<size_t>(q) + 1, data.upper(0));
        set_axis(one, q, knots);
        one.points.assign(static_cast<size_t>(q) + 1, 1.0);
        const auto g = create(data);
        const auto got = read_back(product(g.get(), create(one).get()).get());
        const auto want = read_back(elevate(g.get(), 0, q).get());
        double hull = 0;
        for (const double x : data.points) {
            hull = std::max(hull, std::fabs(x));
        }
        const bool clamped = data.knots[0].front() == data.lower(0) && data.knots[0].back() == data.upper(0);
        if (clamped && !data.periodic(0)) {
            ASSERT_TRUE(same_bits(got.all_knots(), want.all_knots())) << where(seed, data);
            for (size_t i = 0; i < want.points.size(); ++i) {
                ASSERT_LE(std::fabs(got.points[i] - want.points[i]),
                          (4 * (data.degrees[0] + q + 2) + 2 * q) * eps * hull)
                    << where(seed, data);
            }
        }
    });
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
        const int highest = axes == 1 ? 9 : axes == 2 ? 3 : 2;
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
