#include "basis/span_table.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

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

void expect_agreement(int degree, const std::vector<double> &knots, const std::vector<double> &params) {
    const SpanTable table(degree, knots);
    for (const double t : params) {
        for (const bool left : {false, true}) {
            ASSERT_EQ(table.find(t, left), span_by_definition(degree, knots, t, left))
                << t << (left ? " left" : "");
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

TEST(SpanTable, AgreesWithTheDefinitionForUnevenAndRepeatedKnots) {
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

TEST(SpanTable, SurvivesDomainsTooShortOrTooLongForAScale) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    expect_agreement(0, {0, tiny, 3 * tiny}, probes({0, tiny, 3 * tiny}));
    expect_agreement(0, {-8e307, 0, 1, 8e307}, probes({-8e307, 0, 1, 8e307}));
    expect_agreement(0, {1, 1 + 1e-15, 1e15}, probes({1, 1 + 1e-15, 1e15}));
}

TEST(SpanTable, ListsOnlySpansThatAreNotEmpty) {
    const std::vector<double> knots{0, 0, 0, 1, 1, 2, 2, 2};
    const SpanTable table(2, knots);
    EXPECT_EQ(table.size(), 2);
    EXPECT_TRUE(std::ranges::equal(table.indices(), std::vector<int64_t>{2, 4}));
    EXPECT_TRUE(std::ranges::equal(table.breaks(), std::vector<double>{0, 1, 2}));
}

} // namespace
