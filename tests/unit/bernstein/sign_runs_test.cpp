// SPDX-License-Identifier: MIT
// Signs of polynomials with known zeros, and what is not claimed where rounding hides them.
#include "bernstein/sign_runs.h"

#include "support/cases.h"
#include "support/generators.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sign_runs_test {

namespace {

using nrb::RoundedPolynomial;
using nrb::side_by_side;
using nrb::SignRun;

RoundedPolynomial polynomial(std::vector<double> values, std::vector<double> errors = {}) {
    RoundedPolynomial f;
    f.shape.degrees = {0, 0, static_cast<int>(values.size()) - 1};
    errors.resize(values.size(), 0.0);
    f.values = std::move(values);
    f.errors = std::move(errors);
    return f;
}

// x - zero, as rounded as doubles are.
RoundedPolynomial factor(double zero) {
    return polynomial({-zero, 1 - zero}, {1e-16, 1e-16});
}

RoundedPolynomial with_zeros(const std::vector<double> &zeros) {
    RoundedPolynomial f = polynomial({1});
    for (const double zero : zeros) {
        f = f * factor(zero);
    }
    return f;
}

// Hidden runs.
std::vector<SignRun> hidden(const nrb::SignRuns &signs) {
    std::vector<SignRun> result;
    std::copy_if(signs.runs.begin(), signs.runs.end(), std::back_inserter(result),
                 [](const SignRun &run) { return run.sign == 0 && !run.simple; });
    return result;
}

int sign_at(const nrb::SignRuns &signs, double x) {
    const auto run = std::find_if(signs.runs.begin(), signs.runs.end(),
                                  [x](const SignRun &r) { return r.from <= x && x <= r.to; });
    return run == signs.runs.end() ? 2 : run->sign;
}

} // namespace

TEST(SignRuns, finds_zeros_that_are_apart) {
    support::for_each_case(9300, 200, [](support::Random &random, uint64_t seed) {
        std::vector<double> zeros;
        for (int n = random.whole(0, 6); n > 0; --n) {
            const double zero = random.between(0.01, 0.99);
            if (std::all_of(zeros.begin(), zeros.end(),
                            [&](double x) { return std::fabs(x - zero) > 0.02; })) {
                zeros.push_back(zero);
            }
        }
        std::sort(zeros.begin(), zeros.end());
        const nrb::SignRuns signs = nrb::sign_runs(with_zeros(zeros));
        EXPECT_TRUE(hidden(signs).empty() && !signs.doubtful) << seed;
        std::vector<double> found;
        for (const SignRun &run : signs.runs) {
            if (run.simple) {
                found.push_back(run.from);
            }
        }
        ASSERT_EQ(found.size(), zeros.size()) << seed;
        for (size_t i = 0; i < zeros.size(); ++i) {
            EXPECT_NEAR(found[i], zeros[i], 1e-9) << seed;
        }
        double place = 0;
        for (const SignRun &run : signs.runs) { // nothing is left out
            EXPECT_EQ(run.from, place);
            place = run.to;
        }
        EXPECT_EQ(place, 1);
        for (int i = 0; i <= 100; ++i) {
            const double x = i / 100.0;
            double exact = 1;
            for (const double zero : zeros) {
                exact *= x - zero;
            }
            if (std::fabs(exact) > 1e-9) {
                EXPECT_EQ(sign_at(signs, x), exact > 0 ? 1 : -1) << x << " " << seed;
            }
        }
    });
}

TEST(SignRuns, claims_nothing_of_double_zeros) {
    const nrb::SignRuns signs = nrb::sign_runs(with_zeros({0.3, 0.3}));
    ASSERT_EQ(hidden(signs).size(), 1U);
    EXPECT_NEAR(hidden(signs)[0].from, 0.3, 1e-6);
    EXPECT_NEAR(hidden(signs)[0].to, 0.3, 1e-6);
    EXPECT_EQ(sign_at(signs, 0.1), 1);
    EXPECT_EQ(sign_at(signs, 0.9), 1);
}

// A triple one changes the sign, at the place that is given.
TEST(SignRuns, estimates_what_is_hidden) {
    const nrb::SignRuns signs = nrb::sign_runs(with_zeros({0.3, 0.3, 0.3}));
    ASSERT_EQ(hidden(signs).size(), 1U);
    EXPECT_NEAR(hidden(signs)[0].zero, 0.3, 1e-4);
    EXPECT_EQ(sign_at(signs, 0.1), -1);
    EXPECT_EQ(sign_at(signs, 0.9), 1);
}

// (1, c, 1) has no zero for c > -1, one that is double for c = -1 and two below it.
TEST(SignRuns, counts_what_errors_may_hide) {
    EXPECT_TRUE(hidden(nrb::sign_runs(polynomial({1, 0, 1}, {0, 0.5, 0}))).empty());
    EXPECT_FALSE(hidden(nrb::sign_runs(polynomial({1, 0, 1}, {0, 1.5, 0}))).empty());
    const nrb::SignRuns one = nrb::sign_runs(polynomial({1, 0, -1}, {0, 5, 0})); // one zero whatever it is
    EXPECT_TRUE(hidden(one).empty());
    EXPECT_EQ(std::count_if(one.runs.begin(), one.runs.end(), [](const SignRun &r) { return r.simple; }), 1);
}

TEST(SignRuns, divides_zeros_at_ends_out) {
    const nrb::SignRuns signs = nrb::sign_runs(with_zeros({0, 0, 1, 0.5}));
    EXPECT_EQ(signs.zeros_at_start, 2);
    EXPECT_EQ(signs.zeros_at_end, 1);
    EXPECT_FALSE(signs.doubtful);
    EXPECT_EQ(sign_at(signs, 0.25), 1);
    EXPECT_EQ(sign_at(signs, 0.75), -1);
    EXPECT_TRUE(nrb::sign_runs(polynomial({1e-3, 1}, {1e-2, 0})).doubtful);
    EXPECT_TRUE(nrb::sign_runs(polynomial({1e-3, 1e-4}, {1e-2, 1e-2})).nothing);
}

TEST(ZeroPlaces, of_vectors) {
    support::for_each_case(9400, 200, [](support::Random &random, uint64_t seed) {
        const double zero = random.between(0.01, 0.99), far = random.between(0.01, 0.99);
        const RoundedPolynomial base = factor(zero) * factor(1.5 + random.unit());
        const RoundedPolynomial x = scaled(base, random.magnitude(1e-6, 1e6)),
                                y = scaled(base, -random.magnitude(1e-6, 1e6));
        const auto found = nrb::zero_places(side_by_side({x, y}));
        ASSERT_EQ(found.size(), 1U) << seed;
        EXPECT_TRUE(found[0].certain) << seed;
        EXPECT_NEAR(found[0].from, zero, 1e-13) << seed;
        if (std::fabs(far - zero) > 1e-9) {
            EXPECT_TRUE(nrb::zero_places(side_by_side({x, factor(far) * factor(2)})).empty()) << seed;
        }
    });
    const auto ends = nrb::zero_places(side_by_side({with_zeros({0, 1}), with_zeros({0, 1})}));
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_TRUE(ends[0].certain && ends[0].to == 0 && ends[1].certain && ends[1].from == 1);
    const auto flat = nrb::zero_places(side_by_side({with_zeros({0.3, 0.3}), with_zeros({0.3, 0.3})}));
    ASSERT_EQ(flat.size(), 1U);
    EXPECT_FALSE(flat[0].certain);
    // the zero of the first is known to 1e-10, so that of the second may be the same
    const RoundedPolynomial rough = polynomial({-0.3, 0.7}, {1e-10, 1e-10});
    EXPECT_EQ(nrb::zero_places(side_by_side({rough, factor(0.3 + 5e-11)})).size(), 1U);
    EXPECT_TRUE(nrb::zero_places(side_by_side({rough, factor(0.3 + 1e-9)})).empty());
    // nearer to the end than numbers below 1 are to 1, without being there
    const RoundedPolynomial late = polynomial({-1, 0x1p-60});
    for (const RoundedPolynomial &other : {scaled(late, 2), polynomial({0, 0})}) {
        const auto last = nrb::zero_places(side_by_side({late, other}));
        ASSERT_EQ(last.size(), 1U);
        EXPECT_TRUE(last[0].certain && last[0].from == 1);
    }
    const auto nothing = nrb::zero_places(side_by_side({polynomial({0, 0}), polynomial({0, 0})}));
    ASSERT_EQ(nothing.size(), 1U);
    EXPECT_TRUE(!nothing[0].certain && nothing[0].from == 0 && nothing[0].to == 1);
}

} // namespace sign_runs_test
