// Knot generators and Greville abscissae, each by the law that defines it.
#include "reference/exact_basis.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace knots_test {

using namespace support;
using reference::eps;
using reference::Rational;

namespace {

// A curve of dimension 1 over a knot vector.
SplineData over(int degree, const std::vector<double> &knots, uint32_t flags = 0) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    return {{degree}, {count}, {knots}, 1, std::vector<double>(static_cast<size_t>(count), 1), {}, flags};
}

std::vector<double> greville(const SplineData &data) {
    std::vector<double> abscissae(static_cast<size_t>(data.counts[0]));
    require_ok(nurbs_greville(create(data).get(), 0, data.counts[0], abscissae.data()));
    return abscissae;
}

double largest(const std::vector<double> &values) {
    double size = 0;
    for (const double x : values) {
        size = std::max(size, std::fabs(x));
    }
    return size;
}

// |value - want| <= units * eps * size.
void expect_near(double value, const Rational &want, long double units, double size,
                 const std::string &place) {
    ASSERT_LE(reference::error_ratio(value, reference::fraction(want), units * eps * size), 1)
        << place << ": " << hex(value);
}

// p additions and a division round at most p + 1 times.
TEST(Greville, abscissae_are_means_of_inner_knots) {
    for_each_case(60000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {random_axis(random, random.whole(0, 15))};
        const auto data = random_spline(random, recipe);
        const int p = data.degrees[0];
        const auto &t = data.knots[0];
        const auto abscissae = greville(data);
        for (size_t i = 0; i < abscissae.size(); ++i) {
            const size_t from = p == 0 ? i : i + 1;
            const size_t n = p == 0 ? 2 : static_cast<size_t>(p);
            Rational sum = 0;
            for (size_t j = from; j < from + n; ++j) {
                sum += reference::exact(t[j]);
            }
            const double size = std::max(std::fabs(t[from]), std::fabs(t[from + n - 1]));
            expect_near(abscissae[i], sum / static_cast<int>(n), (p + 1) / 2.0L, size, where(seed, data));
            ASSERT_TRUE(t[from] <= abscissae[i] && abscissae[i] <= t[from + n - 1]) << where(seed, data);
        }
    });
}

// sum x_i N_i(t) = t. The abscissae carry their own rounding on top of the evaluation's.
TEST(Greville, linear_precision) {
    for_each_case(61000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {random_axis(random, random.whole(1, 15))};
        recipe.axes[0].form = random.chance(50) ? KnotForm::clamped : KnotForm::unclamped;
        auto data = random_spline(random, recipe);
        data.dim = 1;
        data.points = greville(data);
        const auto g = create(data);
        const auto params = random_params(random, data, 20);
        const auto points = eval(g.get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        const long double c = reference::c_of(data) + (data.degrees[0] + 1) / 2.0L;
        for (size_t i = 0; i < params.size(); ++i) {
            ASSERT_LE(std::fabs(static_cast<long double>(points[i]) - params[i]), c * eps * hulls[i])
                << where(seed, data) << "at " << hex(params[i]);
        }
    });
}

struct Span {
    int degree;
    int64_t count;
    double a;
    double b;
};

Span random_span(Random &random) {
    const int degree = random.whole(0, 15);
    const double a = random.between(-1, 1) * random.magnitude(1e-9, 1e9);
    return {degree, degree + random.whole(1, 20), a, a + std::fabs(a) * random.magnitude(1e-3, 1e3)};
}

TEST(Generators, uniform_knots) {
    for_each_case(62000, 200, [](Random &random, uint64_t seed) {
        const Span s = random_span(random);
        std::vector<double> knots(static_cast<size_t>(s.count + s.degree + 1));
        require_ok(nurbs_knots_uniform(s.degree, s.count, s.a, s.b, static_cast<int64_t>(knots.size()),
                                       knots.data()));
        ASSERT_EQ(knots[static_cast<size_t>(s.degree)], s.a) << "seed " << seed;
        ASSERT_EQ(knots[static_cast<size_t>(s.count)], s.b) << "seed " << seed;
        const Rational step = (reference::exact(s.b) - reference::exact(s.a)) / (s.count - s.degree);
        for (size_t i = 0; i < knots.size(); ++i) {
            const Rational want = reference::exact(s.a) + (static_cast<int64_t>(i) - s.degree) * step;
            expect_near(knots[i], want, 2, largest(knots), "seed " + std::to_string(seed));
        }
        Handle g;
        auto data = over(s.degree, knots, NURBS_PERIODIC);
        ASSERT_EQ(try_create(data, g), NURBS_OK) << where(seed, data) << last_error();
    });
}

TEST(Generators, open_uniform_knots) {
    for_each_case(63000, 200, [](Random &random, uint64_t seed) {
        const Span s = random_span(random);
        std::vector<double> knots(static_cast<size_t>(s.count + s.degree + 1));
        require_ok(nurbs_knots_open_uniform(s.degree, s.count, s.a, s.b, static_cast<int64_t>(knots.size()),
                                            knots.data()));
        const Rational step = (reference::exact(s.b) - reference::exact(s.a)) / (s.count - s.degree);
        for (int64_t i = 0; i < static_cast<int64_t>(knots.size()); ++i) {
            const double knot = knots[static_cast<size_t>(i)];
            if (i <= s.degree || i >= s.count) {
                ASSERT_EQ(knot, i <= s.degree ? s.a : s.b) << "seed " << seed;
            } else {
                expect_near(knot, reference::exact(s.a) + (i - s.degree) * step, 2, largest(knots),
                            "seed " + std::to_string(seed));
            }
        }
        ASSERT_NO_THROW(create(over(s.degree, knots))) << "seed " << seed;
    });
}

TEST(Generators, bezier_knots) {
    for_each_case(64000, 100, [](Random &random, uint64_t) {
        const int degree = random.whole(0, 15);
        const int pieces = random.whole(1, 8);
        std::vector<double> breaks = {random.between(-1, 1)};
        for (int i = 0; i < pieces; ++i) {
            breaks.push_back(breaks.back() + random.magnitude(1e-6, 1));
        }
        std::vector<double> want(static_cast<size_t>(degree) + 1, breaks.front());
        for (int i = 1; i < pieces; ++i) {
            want.insert(want.end(), static_cast<size_t>(std::max(degree, 1)), breaks[static_cast<size_t>(i)]);
        }
        want.insert(want.end(), static_cast<size_t>(degree) + 1, breaks.back());
        std::vector<double> knots(want.size());
        require_ok(nurbs_knots_bezier(degree, pieces, breaks.data(), static_cast<int64_t>(knots.size()),
                                      knots.data()));
        ASSERT_EQ(knots, want);
        require_ok(
            nurbs_knots_bezier(degree, pieces, nullptr, static_cast<int64_t>(knots.size()), knots.data()));
        for (size_t i = 0; i < knots.size(); ++i) {
            const auto piece = std::lower_bound(breaks.begin(), breaks.end(), want[i]) - breaks.begin();
            ASSERT_EQ(knots[i], static_cast<double>(piece) / pieces);
        }
    });
}

TEST(Generators, averaged_knots) {
    for_each_case(65000, 200, [](Random &random, uint64_t seed) {
        const int p = random.whole(0, 15);
        const int64_t count = p + random.whole(1, 20);
        std::vector<double> s;
        for (int64_t i = 0; i < count + (count == 1 ? 1 : 0); ++i) {
            s.push_back((s.empty() ? 1e3 * random.between(-1, 1) : s.back()) + random.magnitude(1e-6, 1));
        }
        if (count == 1) {
            return; // one parameter has no interval
        }
        std::vector<double> knots(static_cast<size_t>(count + p + 1));
        require_ok(
            nurbs_knots_averaged(p, count, s.data(), static_cast<int64_t>(knots.size()), knots.data()));
        const std::string place =
            "seed " + std::to_string(seed) + " degree " + std::to_string(p) + " " + hex(s);
        for (int64_t i = 0; i < static_cast<int64_t>(knots.size()); ++i) {
            const double knot = knots[static_cast<size_t>(i)];
            if (i <= p || i >= count) {
                ASSERT_EQ(knot, i <= p ? s.front() : s.back()) << place;
                continue;
            }
            // Degree 0 takes the midpoints of neighbours: the mean of two.
            const int64_t from = p == 0 ? i - 1 : i - p;
            const int64_t n = p == 0 ? 2 : p;
            Rational sum = 0;
            for (int64_t j = from; j < from + n; ++j) {
                sum += reference::exact(s[static_cast<size_t>(j)]);
            }
            expect_near(knot, sum / n, (p + 1) / 2.0L + 0.5L, largest(s), place);
        }
        ASSERT_TRUE(std::is_sorted(knots.begin(), knots.end())) << place;
    });
}

TEST(Generators, periodic_knots) {
    for_each_case(66000, 300, [](Random &random, uint64_t seed) {
        const int p = random.whole(0, 9);
        const int n = random.whole(2, 7);
        std::vector<double> breaks = {random.chance(50) ? 0 : random.between(-9, 9)};
        std::vector<int32_t> multiplicities;
        for (int i = 0; i < n; ++i) {
            multiplicities.push_back(p == 0 || random.chance(60) ? 1 : random.whole(1, p + 1));
            if (i > 0) {
                breaks.push_back(breaks.back() + random.magnitude(1e-6, 1));
            }
        }
        multiplicities.back() = multiplicities.front();
        int64_t distinct = 0;
        for (int i = 0; i + 1 < n; ++i) {
            distinct += multiplicities[static_cast<size_t>(i)];
        }
        std::vector<double> knots(static_cast<size_t>(distinct + 2 * p + 1));
        require_ok(nurbs_knots_periodic(p, n, breaks.data(), multiplicities.data(),
                                        static_cast<int64_t>(knots.size()), knots.data()));
        const auto data = over(p, knots, NURBS_PERIODIC);
        Handle g;
        ASSERT_EQ(try_create(data, g), NURBS_OK) << where(seed, data) << last_error();
        ASSERT_EQ(data.lower(0), breaks.front()) << where(seed, data);
        ASSERT_EQ(data.upper(0), breaks.back()) << where(seed, data);
        for (int i = 1; i + 1 < n; ++i) {
            const auto place = static_cast<size_t>(i);
            ASSERT_EQ(std::count(knots.begin(), knots.end(), breaks[place]), multiplicities[place])
                << where(seed, data);
        }
    });
}

} // namespace

} // namespace knots_test
