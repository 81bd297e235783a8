#include "basis/span_table.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace span_table_test {

namespace {

using nrb::SpanTable;

// The definition: the last non-empty span of the domain that starts at or before t (before t when `left`).
int64_t span_by_definition(int degree, const std::vector<double> &knots, double t, bool left) {
    const auto last = static_cast<int64_t>(knots.size()) - degree - 1;
    int64_t found = -1;
    for (int64_t s = degree; s < last; ++s) {
        const double start = knots[static_cast<size_t>(s)];
        if (start < knots[static_cast<size_t>(s) + 1] && (found < 0 || (left ? start < t : start <= t))) {
            found = s;
        }
    }
    return found;
}

// With the table and without it, by index and by number.
void expect_agreement(int degree, const std::vector<double> &knots, const std::vector<double> &params) {
    const SpanTable table(degree, knots);
    for (const double t : params) {
        for (const bool left : {false, true}) {
            const int64_t span = span_by_definition(degree, knots, t, left);
            ASSERT_EQ(table.find(t, left), span) << t << (left ? " left" : "");
            ASSERT_EQ(nrb::find_span(degree, knots, t, left), span) << t << (left ? " left" : "");
            ASSERT_EQ(table.indices()[static_cast<size_t>(table.number(t, left))], span) << t;
        }
        if (t >= table.breaks().front() && t <= table.breaks().back()) {
            ASSERT_EQ(table.finder().number_inside(t), table.number(t, false)) << t;
        }
    }
}

std::vector<double> probes(const std::vector<double> &knots) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> params{-infinity, infinity};
    for (size_t i = 0; i < knots.size(); ++i) {
        params.insert(params.end(),
                      {knots[i], std::nextafter(knots[i], -infinity), std::nextafter(knots[i], infinity)});
        params.push_back(i == 0 ? knots[0] - 1 : std::midpoint(knots[i - 1], knots[i]));
    }
    return params;
}

TEST(SpanTable, agrees_with_the_definition_for_uneven_and_repeated_knots) {
    std::mt19937_64 random(20240611);
    for (int round = 0; round < 300; ++round) {
        const int degree = static_cast<int>(random() % 6);
        const double ratio = std::pow(10.0, static_cast<double>(random() % 17));
        std::vector<double> knots{
            std::ldexp(static_cast<double>(random() % 100), static_cast<int>(random() % 20) - 10)};
        const size_t count = 2 * static_cast<size_t>(degree) + 2 + random() % 60;
        while (knots.size() < count) {
            const double step =
                random() % 4 == 0 ? 0 : std::pow(ratio, -static_cast<double>(random() % 100) / 100);
            knots.push_back(knots.back() + step);
        }
        const auto first = static_cast<size_t>(degree);
        if (knots[first] == knots[count - first - 1]) { // an empty domain: lift its end
            std::fill(knots.end() - degree - 1, knots.end(),
                      std::max(knots.back(), std::nextafter(knots[first], 1e300)));
        }
        expect_agreement(degree, knots, probes(knots));
    }
}

// Knots that repeat, follow at one unit of rounding, at a tiny fraction of the domain, or at a distance:
// every order of these steps, at the ends too, where the knots outside the domain may or may not repeat.
TEST(SpanTable, agrees_with_the_definition_for_every_order_of_steps) {
    const auto step = [](double t, size_t kind) {
        return kind == 0 ? t : kind == 1 ? std::nextafter(t, 1e300) : kind == 2 ? t + 1e-9 : t + 1;
    };
    for (int degree = 0; degree <= 2; ++degree) {
        for (size_t pattern = 0; pattern < 4096; ++pattern) { // 6 steps of 4 kinds
            std::vector<double> knots{-1.5};
            for (size_t rest = pattern; knots.size() < 7; rest /= 4) {
                knots.push_back(step(knots.back(), rest % 4));
            }
            if (knots[static_cast<size_t>(degree)] < knots[knots.size() - static_cast<size_t>(degree) - 1]) {
                expect_agreement(degree, knots, probes(knots));
            }
        }
    }
}

// Breaks that crowd together share buckets, where a search decides.
TEST(SpanTable, agrees_with_the_definition_where_breaks_crowd) {
    for (const double ratio : {0.5, 0.9, 0.99}) {
        std::vector<double> knots{1};
        for (int i = 1; i < 200; ++i) {
            knots.push_back(knots.back() * ratio);
        }
        std::reverse(knots.begin(), knots.end());
        expect_agreement(3, knots, probes(knots));
        std::vector<double> mirrored;
        for (auto knot = knots.rbegin(); knot != knots.rend(); ++knot) {
            mirrored.push_back(2 - *knot);
        }
        mirrored.erase(std::unique(mirrored.begin(), mirrored.end()), mirrored.end());
        expect_agreement(2, mirrored, probes(mirrored));
    }
}

TEST(SpanTable, survives_domains_too_short_or_too_long_for_a_scale) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    expect_agreement(0, {0, tiny, 3 * tiny}, probes({0, tiny, 3 * tiny}));
    expect_agreement(0, {-8e307, 0, 1, 8e307}, probes({-8e307, 0, 1, 8e307}));
    expect_agreement(0, {1, 1 + 1e-15, 1e15}, probes({1, 1 + 1e-15, 1e15}));
}

TEST(SpanTable, lists_only_spans_that_are_not_empty) {
    const std::vector<double> knots{0, 0, 0, 1, 1, 2, 2, 2};
    const SpanTable table(2, knots);
    EXPECT_EQ(table.size(), 2);
    EXPECT_TRUE(std::ranges::equal(table.indices(), std::vector<int64_t>{2, 4}));
    EXPECT_TRUE(std::ranges::equal(table.breaks(), std::vector<double>{0, 1, 2}));
}

} // namespace

} // namespace span_table_test
