// Roots of scalar curves and meets with implicit sets: as many as exact arithmetic finds, where it finds them.
#include "exact_roots.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace roots_test {

using namespace support;

namespace {

using Vec = std::vector<double>;

struct Hits {
    Vec params, ranges;
    std::vector<int32_t> kinds;
    int32_t complete = -1;

    [[nodiscard]] int64_t count(int32_t kind) const { return std::count(kinds.begin(), kinds.end(), kind); }
};

template <class Call>
Hits listed(const Call &call) {
    Hits hits;
    int64_t count = -1;
    require_ok(call(int64_t{0}, hits, &count));
    const auto n = static_cast<size_t>(count);
    hits.params.resize(n);
    hits.kinds.resize(n);
    hits.ranges.resize(2 * n);
    require_ok(call(count, hits, &count));
    EXPECT_TRUE(std::is_sorted(hits.params.begin(), hits.params.end()));
    EXPECT_EQ(hits.complete, hits.count(NURBS_HIT_UNDECIDED) == 0 ? 1 : 0);
    return hits;
}

Hits roots_of(const nurbs *g, double value, double tolerance) {
    return listed([&](int64_t cap, Hits &h, int64_t *count) {
        return nurbs_roots(g, value, tolerance, cap, h.params.data(), h.kinds.data(), h.ranges.data(), count,
                           &h.complete);
    });
}
Hits level_of(const nurbs *g, int32_t degree, const Vec &coefficients, double tolerance) {
    return listed([&](int64_t cap, Hits &h, int64_t *count) {
        return nurbs_curve_level(g, degree, coefficients.data(), tolerance, cap, h.params.data(),
                                 h.kinds.data(), h.ranges.data(), count, &h.complete);
    });
}

std::vector<double> breaks_of(const SplineData &data) {
    Vec breaks;
    for (const double knot : data.knots[0]) {
        if (knot >= data.lower(0) && knot <= data.upper(0) && (breaks.empty() || knot > breaks.back())) {
            breaks.push_back(knot);
        }
    }
    return breaks;
}

// A polynomial that is positive where f of the piece exceeds the value, and so on.
using Numerator = std::function<Polynomial(const std::vector<Polynomial> &)>;

struct Expected {
    int64_t roots = 0, jumps = 0, stretches = 0;
};

// Of what lies at a knot, the sides count together; the seam of a periodic curve is one more knot.
Expected expected(const SplineData &data, const Numerator &numerator) {
    const Vec breaks = breaks_of(data);
    std::vector<ExactRoots> pieces;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        pieces.push_back(exact_roots(numerator(piece(data, breaks[i], breaks[i + 1]))));
    }
    Expected sum;
    bool in_stretch = data.periodic(0) && pieces.back().nothing;
    const bool began = in_stretch;
    for (size_t i = 0; i < pieces.size(); ++i) {
        const ExactRoots &now = pieces[i];
        const bool has_before = i > 0 || data.periodic(0);
        const ExactRoots &before = pieces[i > 0 ? i - 1 : pieces.size() - 1];
        if (now.nothing) {
            sum.stretches += in_stretch ? 0 : 1;
            in_stretch = true;
            continue;
        }
        if (!in_stretch) {
            const bool zero = now.at_start || (has_before && before.at_end);
            sum.roots += zero ? 1 : 0;
            sum.jumps += !zero && has_before && before.before_end == -now.after_start ? 1 : 0;
        }
        in_stretch = false;
        sum.roots += now.inside;
        const bool last = i + 1 == pieces.size() && !data.periodic(0);
        sum.roots += last && now.at_end ? 1 : 0;
    }
    if (began && std::all_of(pieces.begin(), pieces.end(), [](const ExactRoots &p) { return p.nothing; })) {
        sum.stretches = 1;
    }
    return sum;
}

// The sign of a scalar curve minus a value.
int exact_sign(const SplineData &data, double at, double value) {
    return (reference::defined_point(data, &at)[0] - reference::exact(value)).sign();
}

SplineData scalar_case(Random &random) {
    Recipe recipe = random_recipe(random, 1, 9);
    recipe.dim = 1;
    recipe.short_numbers = random.chance(50);
    return random_spline(random, recipe);
}

Polynomial minus_value(const std::vector<Polynomial> &components, double value) {
    const reference::Rational exact = reference::exact(value);
    Polynomial result = components[0];
    for (Integer &x : result) {
        x *= denominator(exact);
    }
    add(result, components[1], -numerator(exact));
    return result;
}

} // namespace

// Values that are taken often, or are control points, so that many roots lie at knots and ends.
TEST(Roots, are_as_many_as_in_exact_arithmetic) {
    int64_t complete = 0, all = 0, found = 0;
    for_each_case(2600000, 1000, [&](Random &random, uint64_t seed) {
        const SplineData data = scalar_case(random);
        const Handle g = create(data);
        const auto i = static_cast<size_t>(random.whole(0, static_cast<int>(data.point_count()) - 1));
        const double value = random.chance(30)   ? data.points[i]
                             : random.chance(50) ? 0
                                                 : data.points[i] * random.between(0.5, 1);
        const Hits hits = roots_of(g.get(), value, 0);
        ++all;
        for (size_t k = 0; k < hits.params.size(); ++k) {
            ASSERT_LE(hits.ranges[2 * k], hits.ranges[2 * k + 1]) << where(seed, data);
        }
        if (hits.complete != 1) {
            return;
        }
        ++complete;
        const Expected wanted = expected(
            data, [&](const std::vector<Polynomial> &components) { return minus_value(components, value); });
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING) + hits.count(NURBS_HIT_TANGENT), wanted.roots)
            << value << where(seed, data);
        ASSERT_EQ(hits.count(NURBS_HIT_JUMP), wanted.jumps) << value << where(seed, data);
        ASSERT_EQ(hits.count(NURBS_HIT_OVERLAP), wanted.stretches) << value << where(seed, data);
        found += wanted.roots;
    });
    std::cout << "complete " << complete << " of " << all << ", " << found << " roots\n";
    EXPECT_GE(complete, of_whole_run(990));
    EXPECT_GE(found, of_whole_run(500));
}

// The sign is another one at both ends of the range of a crossing inside, in exact arithmetic.
TEST(Roots, lie_in_their_ranges) {
    int64_t inside = 0;
    for_each_case(2610000, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = scalar_case(random);
        const Handle g = create(data);
        const double value = data.points.front() * random.between(0, 1);
        const Hits hits = roots_of(g.get(), value, 0);
        const Vec breaks = breaks_of(data);
        for (size_t k = 0; k < hits.params.size(); ++k) {
            const double from = hits.ranges[2 * k], to = hits.ranges[2 * k + 1];
            const auto knot = std::lower_bound(breaks.begin(), breaks.end(), from);
            if (hits.kinds[k] != NURBS_HIT_CROSSING || (knot != breaks.end() && *knot <= to)) {
                continue;
            }
            ++inside;
            ASSERT_EQ(exact_sign(data, from, value), -exact_sign(data, to, value))
                << value << where(seed, data);
        }
    });
    EXPECT_GE(inside, of_whole_run(120));
}

// With a tolerance there is a hit in every range in which the curve is as near, and every contact and overlap is as near.
TEST(Roots, with_a_tolerance_are_where_the_curve_is_near) {
    for_each_case(2620000, 1000, [&](Random &random, uint64_t seed) {
        const SplineData data = scalar_case(random);
        const Handle g = create(data);
        double size = 0;
        for (const double x : data.points) {
            size = std::max(size, std::abs(x));
        }
        const double value = size * random.between(-1, 1), tolerance = size * random.magnitude(1e-12, 0.3);
        const Hits hits = roots_of(g.get(), value, tolerance);
        const double lower = data.lower(0), upper = data.upper(0);
        constexpr int n = 200;
        Vec places, distances(n + 1);
        for (int i = 0; i <= n; ++i) {
            places.push_back(std::clamp(lower + (upper - lower) * i / n, lower, upper));
        }
        require_ok(nurbs_eval(g.get(), n + 1, places.data(), 0, 0, distances.data(), 0, 0, 0));
        const auto near = [&](size_t i, double share) {
            return std::abs(distances[i] - value) <= tolerance * share - 1e-11 * size;
        };
        for (size_t i = 0; i < places.size(); ++i) {
            size_t from = i, to = i;
            for (; from > 0 && near(from, 1); --from) {
            }
            for (; to < n && near(to, 1); ++to) {
            }
            bool found = !near(i, 1);
            for (size_t k = 0; k < hits.params.size(); ++k) {
                found = found || (hits.ranges[2 * k] <= places[to] && places[from] <= hits.ranges[2 * k + 1]);
            }
            ASSERT_TRUE(found || data.periodic(0)) << places[i] << where(seed, data);
        }
        for (size_t k = 0; k < hits.params.size(); ++k) {
            if (hits.kinds[k] == NURBS_HIT_CONTACT || hits.kinds[k] == NURBS_HIT_OVERLAP) {
                const double at = std::clamp(hits.params[k], lower, upper);
                double before = 0, after = 0;
                require_ok(nurbs_eval(g.get(), 1, &at, 0, 0, &before, 0, 0, NURBS_LEFT));
                require_ok(nurbs_eval(g.get(), 1, &at, 0, 0, &after, 0, 0, 0));
                ASSERT_LE(std::min(std::abs(before - value), std::abs(after - value)),
                          tolerance * 1.001 + 1e-11 * size)
                    << hits.kinds[k] << ' ' << where(seed, data);
            }
        }
    });
}

// Lines, conics and quadrics through known places of known curves; the same hits with more knots and a higher degree.
TEST(CurveLevel, finds_meets_of_circles_at_any_scale) {
    for_each_case(2630000, 300, [](Random &random, uint64_t seed) {
        const double radius = random.magnitude(1e-6, 1e6), turn = random.between(0, 6),
                     offset = random.between(-1.5, 1.5);
        nurbs *out = nullptr;
        require_ok(nurbs_curve_circle(2, nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, &out));
        const Handle circle(out);
        const double a = std::cos(turn), b = std::sin(turn);
        const Hits line = level_of(circle.get(), 1, {a, b, -offset * radius}, 0);
        if (std::abs(std::abs(offset) - 1) > 1e-9) {
            ASSERT_EQ(line.complete, 1) << seed;
            ASSERT_EQ(line.count(NURBS_HIT_CROSSING), std::abs(offset) < 1 ? 2 : 0) << offset << ' ' << seed;
        }
        // (x - m)^2 + y^2 = r^2 with m = offset radius and r = radius: two meets
        const double m = offset * radius;
        const Hits other = level_of(circle.get(), 2, {1, 0, -2 * m, 1, 0, m * m - radius * radius}, 0);
        if (std::abs(offset) > 1e-3) {
            ASSERT_EQ(other.count(NURBS_HIT_CROSSING), 2) << offset << ' ' << seed;
            for (const double at : other.params) {
                double x[2];
                require_ok(nurbs_eval(circle.get(), 1, &at, 0, 0, x, 0, 0, 0));
                ASSERT_NEAR(x[0], m / 2, 1e-12 * radius) << seed;
            }
        }
        nurbs *raised = nullptr;
        const int32_t by = random.whole(1, 3);
        require_ok(nurbs_elevate(circle.get(), 0, by, &raised));
        const Handle high(raised);
        const Hits again = level_of(high.get(), 2, {1, 0, -2 * m, 1, 0, m * m - radius * radius}, 0);
        if (std::abs(offset) > 1e-3) {
            ASSERT_EQ(again.count(NURBS_HIT_CROSSING), 2) << seed;
        }
    });
}

// Forms of random degrees along random curves, against exact arithmetic.
TEST(CurveLevel, finds_as_many_meets_as_exact_arithmetic) {
    int64_t complete = 0;
    for_each_case(2640000, 400, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 4);
        recipe.dim = random.whole(1, 3);
        recipe.short_numbers = true;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const int degree = random.whole(1, 3);
        double size = 0;
        for (const double x : data.points) {
            size = std::max(size, std::abs(x));
        }
        const auto dim = static_cast<size_t>(data.dim);
        std::vector<std::vector<size_t>> monomials; // of x_0 to x_dim, in lexicographic order
        std::vector<size_t> factors(static_cast<size_t>(degree), 0);
        while (true) {
            monomials.push_back(factors);
            size_t last = factors.size();
            while (last > 0 && factors[last - 1] == dim) {
                --last;
            }
            if (last == 0) {
                break;
            }
            const size_t next = factors[last - 1] + 1;
            std::fill(factors.begin() + static_cast<int64_t>(last) - 1, factors.end(), next);
        }
        Vec coefficients;
        for (const auto &monomial : monomials) {
            const auto ones = static_cast<double>(std::count(monomial.begin(), monomial.end(), dim));
            coefficients.push_back(
                std::ldexp(random.whole(-8, 8), std::ilogb(size == 0 ? 1 : size) * static_cast<int>(ones)));
        }
        if (std::all_of(coefficients.begin(), coefficients.end() - 1, [](double c) { return c == 0; })) {
            coefficients[0] = 1;
        }
        const Hits hits = level_of(g.get(), degree, coefficients, 0);
        if (hits.complete != 1) {
            return;
        }
        ++complete;
        const Expected wanted = expected(data, [&](const std::vector<Polynomial> &components) {
            Polynomial sum(components[0].size() * static_cast<size_t>(degree) - static_cast<size_t>(degree) +
                           1);
            for (size_t i = 0; i < monomials.size(); ++i) {
                Polynomial term{1};
                for (const size_t factor : monomials[i]) {
                    term = product(term, components[factor]);
                }
                const reference::Rational c = reference::exact(std::ldexp(coefficients[i], 1000));
                add(sum, term, numerator(c));
            }
            return sum;
        });
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING) + hits.count(NURBS_HIT_TANGENT), wanted.roots)
            << degree << where(seed, data);
        ASSERT_EQ(hits.count(NURBS_HIT_JUMP), wanted.jumps) << degree << where(seed, data);
    });
    EXPECT_GE(complete, of_whole_run(300));
}

} // namespace roots_test
