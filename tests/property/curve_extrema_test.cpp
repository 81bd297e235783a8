// SPDX-License-Identifier: MIT
// Extrema of scalar curves: as many as exact arithmetic finds.
#include "exact_roots.h"
#include "extrema.h"
#include "support/cases.h"

#include <cmath>
#include <iostream>

namespace curve_extrema_test {

using namespace support;

namespace {

// Of scaled coefficients, those of the derivative.
Polynomial slope(const Polynomial &a) {
    const auto n = static_cast<int64_t>(a.size()) - 1;
    Polynomial result;
    for (int64_t j = 0; j < n; ++j) {
        const auto at = static_cast<size_t>(j);
        result.push_back(a[at + 1] * (j + 1) - a[at] * (n - j));
    }
    return result;
}

struct ExactPiece {
    ExactRoots slope;
    Integer start, start_weight, end, end_weight; // values at the ends
};

ExactPiece exact_piece(const SplineData &data, double from, double to) {
    const std::vector<Polynomial> f = piece(data, from, to);
    ExactPiece result{{}, f[0].front(), f[1].front(), f[0].back(), f[1].back()};
    if (f[0].size() == 1) {
        result.slope.nothing = true;
        return result;
    }
    Polynomial numerator = product(slope(f[0]), f[1]);
    add(numerator, product(f[0], slope(f[1])), -1);
    result.slope = exact_roots(numerator);
    return result;
}

struct Expected {
    int64_t minima = 0, maxima = 0, saddles = 0;
    bool simple = true; // no stretches, no double roots: what the counts are about

    // level: the derivative vanishes from one side at least.
    void add(int before, int after, bool level = false) {
        saddles += level && before == after ? 1 : 0;
        minima += before < 0 && after > 0 ? 1 : 0;
        maxima += before > 0 && after < 0 ? 1 : 0;
    }
    void add_inside(const ExactRoots &roots) {
        const int signs = roots.inside % 2 == 0 ? 1 : -1;
        simple = simple && !roots.nothing && roots.before_end == signs * roots.after_start;
        for (int i = 0, sign = roots.after_start; i < roots.inside; ++i, sign = -sign) {
            add(sign, -sign);
        }
    }
    // jumps: not where periodic knots are rounded.
    void add_joint(const ExactPiece &left, const ExactPiece &right, bool jumps) {
        const int wall = jumps ? sign_of(right.start * left.end_weight - left.end * right.start_weight) : 0;
        const int before = left.slope.before_end, after = right.slope.after_start;
        if (wall == 0) {
            return add(before, after, left.slope.at_end || right.slope.at_start);
        }
        add(before, wall, left.slope.at_end);
        add(wall, after, right.slope.at_start);
    }
};

Expected expected(const SplineData &data) {
    std::vector<double> breaks;
    for (const double knot : data.knots[0]) {
        if (knot >= data.lower(0) && knot <= data.upper(0) && (breaks.empty() || knot > breaks.back())) {
            breaks.push_back(knot);
        }
    }
    std::vector<ExactPiece> pieces;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        pieces.push_back(exact_piece(data, breaks[i], breaks[i + 1]));
    }
    Expected sum;
    for (size_t i = 0; i < pieces.size(); ++i) {
        sum.add_inside(pieces[i].slope);
        if (i > 0) {
            sum.add_joint(pieces[i - 1], pieces[i], true);
        }
    }
    if (data.periodic(0)) {
        const std::vector<double> &knots = data.knots[0];
        sum.add_joint(pieces.back(), pieces.front(),
                      std::ranges::count(knots, data.lower(0)) > data.degrees[0]);
    } else {
        sum.add(-pieces.front().slope.after_start, pieces.front().slope.after_start);
        sum.add(pieces.back().slope.before_end, -pieces.back().slope.before_end);
    }
    return sum;
}

SplineData scalar_case(Random &random) {
    Recipe recipe = random_recipe(random, 1, 6);
    recipe.dim = 1;
    recipe.short_numbers = random.chance(50);
    SplineData data = random_spline(random, recipe);
    if (random.chance(30)) { // control points of few heights
        const double size = extent(data);
        for (double &x : data.points) {
            x = size > 0 ? std::round(2 * x / size) : 0;
        }
    }
    return data;
}

} // namespace

TEST(CurveExtrema, are_as_many_as_in_exact_arithmetic) {
    int64_t complete = 0, all = 0, compared = 0, found = 0, saddles = 0;
    for_each_case(2700000, 1000, [&](Random &random, uint64_t seed) {
        const SplineData data = scalar_case(random);
        const Extrema extrema = extrema_of(create(data).get());
        ++all;
        complete += extrema.complete;
        const Expected wanted = expected(data);
        if (extrema.complete == 0 || !wanted.simple) {
            return;
        }
        ++compared;
        ASSERT_EQ(extrema.count(NURBS_EXTREMUM_MINIMUM), wanted.minima) << where(seed, data);
        ASSERT_EQ(extrema.count(NURBS_EXTREMUM_MAXIMUM), wanted.maxima) << where(seed, data);
        ASSERT_EQ(extrema.count(NURBS_EXTREMUM_SADDLE), wanted.saddles) << where(seed, data);
        saddles += wanted.saddles;
        found += wanted.minima + wanted.maxima;
    });
    std::cout << "complete " << complete << " of " << all << ", compared " << compared << ", " << found
              << " extrema, " << saddles << " saddles\n";
    EXPECT_GE(complete, of_whole_run(950));
    EXPECT_GE(compared, of_whole_run(680));
    EXPECT_GE(found, of_whole_run(2500));
    EXPECT_GE(saddles, of_whole_run(3));
}

TEST(CurveExtrema, of_the_other_sign_are_those_of_the_curve_turned_over) {
    for_each_case(2710000, 500, [&](Random &random, uint64_t seed) {
        SplineData data = scalar_case(random);
        const Extrema before = extrema_of(create(data).get());
        for (double &x : data.points) {
            x = -x;
        }
        const Extrema after = extrema_of(create(data).get());
        ASSERT_EQ(before.list.size(), after.list.size()) << where(seed, data);
        ASSERT_EQ(before.count(NURBS_EXTREMUM_MINIMUM), after.count(NURBS_EXTREMUM_MAXIMUM))
            << where(seed, data);
        ASSERT_EQ(before.count(NURBS_EXTREMUM_SADDLE), after.count(NURBS_EXTREMUM_SADDLE))
            << where(seed, data);
        for (size_t i = 0; i < before.list.size(); ++i) {
            ASSERT_EQ(before.list[i].at, after.list[i].at) << where(seed, data);
        }
    });
}

// A step of degree 0, a plateau between slopes, and one with a jump beside it.
TEST(CurveExtrema, know_plateaus) {
    const SplineData steps{{0}, {4}, {{0, 1, 2, 3, 4}}, 1, {0, 1, 1, -2}, {}, 0};
    const Extrema of_steps = extrema_of(create(steps).get());
    ASSERT_EQ(of_steps.list.size(), 3U);
    EXPECT_EQ(of_steps.complete, 1);
    EXPECT_EQ(of_steps.list[0].kinds, NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_MINIMUM);
    EXPECT_EQ(of_steps.list[1].kinds, NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_MAXIMUM);
    EXPECT_EQ(of_steps.list[1].range, (std::vector<double>{1, 3}));
    EXPECT_EQ(of_steps.list[2].kinds, NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_MINIMUM);
    const SplineData terrace{{2}, {7}, {{0, 0, 0, 1, 2, 3, 4, 5, 5, 5}}, 1, {0, 1, 1, 1, 1, 2, 3}, {}, 0};
    const Extrema of_terrace = extrema_of(create(terrace).get());
    ASSERT_EQ(of_terrace.list.size(), 3U);
    EXPECT_EQ(of_terrace.list[1].kinds, NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_SADDLE);
    EXPECT_EQ(of_terrace.list[1].range, (std::vector<double>{1, 3}));
    const SplineData level{{3}, {6}, {{0, 0, 0, 0, 1, 2, 3, 3, 3, 3}}, 1, std::vector<double>(6, 0.1), {}, 0};
    const Extrema of_level = extrema_of(create(level).get());
    ASSERT_EQ(of_level.list.size(), 1U);
    EXPECT_EQ(of_level.list[0].kinds, NURBS_EXTREMUM_PLATEAU);
}

// Signs that were not looked for at the limit of work; found by fuzzing.
TEST(CurveExtrema, of_which_there_may_be_more_at_the_limit_of_work_are_undecided) {
    SplineData data{{28}, {29}, {{}}, 1, {}, {}, 0};
    data.points = {0.9,  8,    -2,  -0.9, 0,    0.06, 198,  0,  0.5, 0.3, 5, 0.5,  -0.7, 180658, 4,
                   -0.3, 0.05, 0.7, 230,  -0.6, 0,    -0.1, -1, -2,  0,   0, -0.8, 6,    -114};
    data.knots[0].assign(29, 0);
    data.knots[0].insert(data.knots[0].end(), 29, 1);
    const Handle g = create(data);
    const Extrema all = extrema_of(g.get());
    ASSERT_EQ(all.complete, 1);
    int undecided = 0;
    for (int64_t work = 1; work < 1 << 20; work *= 2) {
        const Extrema some = extrema_of(g.get(), work);
        undecided += 1 - some.complete;
        EXPECT_TRUE(some.complete == 0 || some.list.size() == all.list.size()) << work;
    }
    EXPECT_GT(undecided, 0);
}

TEST(CurveExtrema, at_the_limit_of_work_claim_nothing_false) {
    for_each_case(2720000, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = scalar_case(random);
        const Handle g = create(data);
        const Extrema all = extrema_of(g.get());
        for (const int64_t work : {1, 1000, 10000, 100000}) {
            const Extrema some = extrema_of(g.get(), work);
            if (some.complete == 1 && all.complete == 1) {
                ASSERT_EQ(some.list.size(), all.list.size()) << work << where(seed, data);
            }
        }
    });
}

} // namespace curve_extrema_test
