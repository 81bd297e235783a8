// Graphs z = f(x, y) and z = g(x, y) of small integers: how many curves they have in common is how many those of f - g = 0 are,
// which is counted without rounding. Exchanges and maps by integers, projective ones too, change nothing, not even a bit of the points.
#include "reference/zero_count.h"
#include "surface_pairs.h"

namespace surface_graphs_test {

using namespace surface_crossings;
using reference::Integer;

namespace {

constexpr double tolerance = 1e-5;
constexpr size_t points = 16;
using Heights = std::array<int, points>; // of 4 x 4 Bezier points

Heights random_heights(Random &random, int most) {
    Heights heights{};
    for (int &z : heights) {
        z = random.whole(-most, most);
    }
    return heights;
}

// Below a plane inside, and mostly above it all around.
Heights random_bowl(Random &random) {
    Heights heights{};
    for (size_t i = 0; i < points; ++i) {
        const bool inside = i / 4 % 3 != 0 && i % 4 % 3 != 0;
        heights[i] = inside ? random.whole(-60, 10) : random.whole(-1, 20);
    }
    return heights;
}

// Over the square from (first, first) on, with sides of 3 steps.
SplineData graph(const Heights &heights, int first, int step) {
    SplineData data{{3, 3}, {4, 4}, {{0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}}, 3, {}, {}, 0};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            data.points.insert(data.points.end(),
                               {static_cast<double>(first + i * step), static_cast<double>(first + j * step),
                                static_cast<double>(heights[static_cast<size_t>(4 * i + j)])});
        }
    }
    return data;
}

// Of the middle third of a cubic, times 27: values of the blossom at thirds.
std::array<Integer, 4> middle_third(const std::array<Integer, 4> &whole) {
    std::array<Integer, 4> part;
    for (size_t upper = 0; upper < 4; ++upper) {
        std::array<Integer, 4> c = whole;
        for (size_t r = 0; r < 3; ++r) {
            const int t = r < upper ? 2 : 1;
            for (size_t i = 0; i + r < 3; ++i) {
                c[i] = (3 - t) * c[i] + t * c[i + 1];
            }
        }
        part[upper] = c[0];
    }
    return part;
}
std::vector<Integer> middle_ninth(const Heights &heights) {
    std::vector<Integer> result(points);
    for (size_t j = 0; j < 4; ++j) {
        const auto column = middle_third({heights[j], heights[4 + j], heights[8 + j], heights[12 + j]});
        for (size_t i = 0; i < 4; ++i) {
            result[4 * i + j] = column[i];
        }
    }
    for (size_t i = 0; i < 4; ++i) {
        const auto row =
            middle_third({result[4 * i], result[4 * i + 1], result[4 * i + 2], result[4 * i + 3]});
        std::copy(row.begin(), row.end(), result.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    return result;
}

// Over [0, 3]^2 f alone ends: g goes on.
reference::ZeroCount zeros_of_difference(const Heights &f, const Heights &g) {
    std::vector<Integer> difference = middle_ninth(g);
    for (size_t i = 0; i < points; ++i) {
        difference[i] = 729 * Integer(f[i]) - difference[i];
    }
    return reference::count_zeros(difference, {4, 4});
}

Handle mapped(const nurbs *g, const std::array<double, 16> &matrix) {
    return made([&](nurbs **out) { return nurbs_transform_projective(g, 3, matrix.data(), out); });
}
constexpr std::array<double, 16> affine{2, 1, 0, 5, 0, 3, 1, -4, 1, 0, 2, 7, 0, 0, 0, 1},
    projective{4, 1, 0, 3, 0, 5, 1, -2, 1, 0, 3, 1, 1, 1, 0, 16};

struct Compared {
    int64_t pairs = 0, in_doubt = 0, incomplete = 0, touching = 0, open = 0, closed = 0;
};
void compare_exactly(const nurbs *a, const nurbs *b, const reference::ZeroCount &count, Compared &compared) {
    const Crossing crossing = crossing_of(a, b, tolerance);
    if (!crossing.found.complete || crossing.found.count(NURBS_NODE_TOUCH) > 0) {
        ++(crossing.found.complete ? compared.touching : compared.incomplete);
        return;
    }
    ++compared.pairs;
    compared.open += count.open;
    compared.closed += count.closed;
    EXPECT_EQ(crossing.open_ways, count.open);
    EXPECT_EQ(crossing.closed_ways, count.closed);
}

TEST(SurfaceGraphsSizes, CurvesAreThoseOfExactZeros) {
    Random random(0x5d11);
    Compared compared;
    const int64_t cases = scaled(100);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const bool bowl = random.chance(50);
        const Heights f = bowl ? random_bowl(random) : random_heights(random, 20),
                      g = random_heights(random, bowl ? 3 : 20);
        const reference::ZeroCount exact = zeros_of_difference(f, g);
        if (!exact.doubt.empty()) {
            ++compared.in_doubt;
            continue;
        }
        const SplineData data_a = graph(f, 0, 1), data_b = graph(g, -3, 3);
        const reference::PairCount other = reference::count_curves(data_a, data_b);
        if (other.certain()) { // one oracle against the other
            EXPECT_EQ(other.open(), exact.open);
            EXPECT_EQ(other.closed(), exact.closed);
        }
        const Handle a = create(data_a), b = create(data_b);
        compare_exactly(a.get(), b.get(), exact, compared);
        compare_exactly(b.get(), a.get(), exact, compared);
        for (const auto &matrix : {affine, projective}) {
            compare_exactly(mapped(a.get(), matrix).get(), mapped(b.get(), matrix).get(), exact, compared);
        }
    }
    std::printf("%lld compared: %lld open, %lld closed; %lld in doubt, %lld incomplete, %lld touch\n",
                static_cast<long long>(compared.pairs), static_cast<long long>(compared.open),
                static_cast<long long>(compared.closed), static_cast<long long>(compared.in_doubt),
                static_cast<long long>(compared.incomplete), static_cast<long long>(compared.touching));
    EXPECT_GE(compared.pairs, 4 * cases * 95 / 100);
    EXPECT_GE(compared.open, 2 * cases);
    EXPECT_GE(compared.closed, cases / 5);
}

} // namespace

} // namespace surface_graphs_test
