// Products of splines: control points against their definition, knots against the continuity.
#include "property/products.h"

namespace product_test {

using namespace support;
using namespace support::products;
using reference::eps;
using reference::Fraction;
using reference::Rational;

namespace {

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

} // namespace

} // namespace product_test
