// Polylines in place of curves: no sample and no rational point is farther than the bound, both ways; and laws of scales,
// knots, reversal and tolerances.
#include "dense_samples.h"
#include "exact_points.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace mesh_curve_test {

using namespace support;

namespace {

using Vec = std::vector<double>;
using Precise = std::vector<long double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Rule {
    double chord = infinity, angle = 0, longest = 0;
};

struct Polyline {
    Vec params, points;
    double bound = -1;
    int32_t reached = -1;

    [[nodiscard]] size_t segments() const { return params.size() - 1; }
};

Polyline polyline(const nurbs *g, int32_t dim, Rule rule) {
    Polyline line;
    int64_t count = -1;
    const auto ask = [&] {
        require_ok(nurbs_mesh_curve(g, rule.chord, rule.angle, rule.longest, std::max<int64_t>(count, 0),
                                    line.params.data(), line.points.data(), &line.bound, &line.reached,
                                    &count));
    };
    ask();
    line.params.resize(static_cast<size_t>(count));
    line.points.resize(static_cast<size_t>(count * dim));
    ask();
    EXPECT_TRUE(std::is_sorted(line.params.begin(), line.params.end()));
    return line;
}
Polyline polyline(const SplineData &data, Rule rule) {
    return polyline(create(data).get(), data.dim, rule);
}

// A segment of a polyline with what is known of its part of the curve.
struct Side {
    const double *a, *b;
    size_t dim;

    // The distance of a point.
    [[nodiscard]] long double distance(const Precise &x) const {
        long double along = 0, square = 0, sum = 0;
        for (size_t c = 0; c < dim; ++c) {
            const long double d = static_cast<long double>(b[c]) - a[c];
            along += (x[c] - a[c]) * d;
            square += d * d;
        }
        const long double share = square > 0 ? std::clamp(along / square, 0.0L, 1.0L) : 0;
        for (size_t c = 0; c < dim; ++c) {
            const long double off = x[c] - (a[c] + share * (static_cast<long double>(b[c]) - a[c]));
            sum += off * off;
        }
        return std::sqrt(sum);
    }
    [[nodiscard]] Precise point(long double share) const {
        Precise x(dim);
        for (size_t c = 0; c < dim; ++c) {
            x[c] = a[c] + share * (static_cast<long double>(b[c]) - a[c]);
        }
        return x;
    }
};

long double apart(const Precise &x, const Precise &y) {
    long double sum = 0;
    for (size_t c = 0; c < x.size(); ++c) {
        sum += (x[c] - y[c]) * (x[c] - y[c]);
    }
    return std::sqrt(sum);
}

std::vector<Precise> samples(const SplineData &data, double from, double to, int count) {
    std::vector<Precise> points;
    for (int j = 0; j <= count; ++j) {
        const double t = j == count ? to : from + (to - from) * (static_cast<double>(j) / count);
        points.push_back(long_point(data, &t, {t == to, false, false}));
    }
    return points;
}

// The largest distance that samples show, of the part from the segment and the other way.
long double sampled(const std::vector<Precise> &part, const Side &side) {
    long double most = 0, gap = 0;
    for (size_t j = 0; j < part.size(); ++j) {
        most = std::max(most, side.distance(part[j]));
        gap = j > 0 ? std::max(gap, apart(part[j], part[j - 1])) : 0;
    }
    for (int k = 1; k < 8; ++k) {
        const Precise x = side.point(k / 8.0L);
        long double nearest = apart(x, part[0]);
        for (const Precise &y : part) {
            nearest = std::min(nearest, apart(x, y));
        }
        most = std::max(most, nearest - gap);
    }
    return most;
}

// Returns the largest distance that samples show.
long double expect_proven(const SplineData &data, const Polyline &line, int per_segment, uint64_t seed) {
    long double most = 0;
    const auto dim = static_cast<size_t>(data.dim);
    const long double room = sampling_error(data);
    EXPECT_EQ(line.params.front(), data.lower(0)) << seed;
    EXPECT_EQ(line.params.back(), data.upper(0)) << seed;
    for (size_t i = 0; i < line.segments(); ++i) {
        if (line.params[i] == line.params[i + 1]) {
            continue; // a jump
        }
        const Side side{&line.points[i * dim], &line.points[(i + 1) * dim], dim};
        const auto part = samples(data, line.params[i], line.params[i + 1], per_segment);
        const long double found = sampled(part, side);
        most = std::max(most, found - room);
        EXPECT_LE(found, line.bound + room)
            << "from " << hex(line.params[i]) << " to " << hex(line.params[i + 1]) << where(seed, data);
    }
    return most;
}

// Vertices are points as evaluation returns them, the first of a periodic curve at its end, too.
void expect_evaluated(const nurbs *g, const SplineData &data, const Polyline &line, uint64_t seed) {
    const Vec right = eval(g, line.params), left = eval(g, line.params, NURBS_LEFT);
    const auto dim = static_cast<size_t>(data.dim);
    for (size_t i = 0; i < line.params.size(); ++i) {
        const bool before = i + 1 < line.params.size() && line.params[i] == line.params[i + 1];
        const bool seam = data.periodic(0) && i + 1 == line.params.size();
        const double *expected = seam ? right.data() : (before ? left : right).data() + i * dim;
        EXPECT_TRUE(std::equal(expected, expected + dim, &line.points[i * dim])) << i << where(seed, data);
    }
}

// Of a curve; 1 if it has none.
double size_of(const SplineData &data) {
    const double size = extent(data);
    return size > 0 ? size : 1;
}

SplineData random_curve(Random &random, int max_degree) {
    return random_spline(random, random_recipe(random, 1, max_degree));
}

} // namespace

TEST(MeshCurve, nothing_is_farther_than_the_bound) {
    WorstRatios tight("longest distance of samples");
    int64_t reached = 0;
    for_each_case(8100, 2000, [&](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 9);
        const Handle g = create(data);
        Rule rule{size_of(data) * random.magnitude(1e-4, 1)};
        rule.angle = random.chance(30) ? random.between(0.05, 3) : 0;
        rule.longest = random.chance(30) ? size_of(data) * random.between(0.05, 1) : 0;
        const Polyline line = polyline(g.get(), data.dim, rule);
        reached += line.reached;
        if (line.reached == 1) {
            EXPECT_LE(line.bound, rule.chord) << where(seed, data);
        }
        expect_evaluated(g.get(), data, line, seed);
        tight.add(expect_proven(data, line, 12, seed) / line.bound);
    });
    EXPECT_GE(reached, of_whole_run(1800));
}

// Ten thousand samples of each of a few curves.
TEST(MeshCurve, many_samples) {
    for_each_case(8200, 10, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 5);
        recipe.dim = 3;
        const SplineData data = random_spline(random, recipe);
        const Polyline line = polyline(data, {size_of(data) * 0.02});
        expect_proven(data, line, std::max(8, 10000 / static_cast<int>(line.segments())), seed);
    });
}

// A rational point of the curve and the square of its distance from the line, with no rounding at all.
TEST(MeshCurve, rational_points) {
    for_each_case(8300, 60, [](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 5);
        const Polyline line = polyline(data, {size_of(data) * random.magnitude(1e-3, 1e-1)});
        if (!std::isfinite(line.bound)) {
            return;
        }
        const reference::Rational bound = exact(line.bound);
        const auto dim = static_cast<size_t>(data.dim);
        for (int k = 0; k < 6; ++k) {
            const size_t i = random.bits() % line.segments();
            const double t = line.params[i] / 2 + line.params[i + 1] / 2;
            if (!(t > line.params[i] && t < line.params[i + 1])) {
                continue;
            }
            const Point x = point_at(data, {t});
            reference::Rational along = 0, square = 0, length = 0;
            for (size_t c = 0; c < dim; ++c) {
                const reference::Rational a = exact(line.points[i * dim + c]),
                                          d = exact(line.points[(i + 1) * dim + c]) - a;
                along += (x[c] - a) * d;
                length += d * d;
                square += (x[c] - a) * (x[c] - a);
            }
            if (along > 0 && along < length) {
                square -= along * along / length;
            } else if (along >= length && length > 0) {
                square += length - 2 * along;
            }
            EXPECT_LE(square, bound * bound) << hex(t) << where(seed, data);
        }
    });
}

// Powers of two in the unit of length and in that of parameters change nothing else.
TEST(MeshCurve, scales) {
    for_each_case(8400, 60, [](Random &random, uint64_t seed) {
        const SplineData data = random_curve(random, 7);
        Rule rule{size_of(data) * random.magnitude(1e-3, 1e-1), random.chance(50) ? 0.3 : 0};
        const Polyline line = polyline(data, rule);
        for (const double size : {0x1p-40, 0x1p40}) {
            const Polyline other = polyline(scaled(data, size), {rule.chord * size, rule.angle, 0});
            EXPECT_TRUE(same_bits(other.params, line.params)) << where(seed, data);
            EXPECT_EQ(other.reached, line.reached) << where(seed, data);
            EXPECT_NEAR(other.bound, line.bound * size, 1e-15 * other.bound) << where(seed, data);
        }
        const Polyline slow = polyline(scaled(data, 1, 0x1p20), rule);
        ASSERT_EQ(slow.params.size(), line.params.size()) << where(seed, data);
        for (size_t i = 0; i < line.params.size(); ++i) {
            EXPECT_EQ(slow.params[i], line.params[i] * 0x1p20) << where(seed, data);
        }
    });
}

// Backwards, with more knots, and in a mirror, a curve needs about as many segments.
TEST(MeshCurve, same_curve) {
    for_each_case(8500, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 5);
        recipe.axes[0].spacing = Spacing::integers;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.dim = 3;
        const SplineData data = random_spline(random, recipe);
        if (data.degrees[0] == 0) {
            return;
        }
        const Handle g = create(data);
        const Rule rule{size_of(data) * 1e-4};
        const auto count = static_cast<double>(polyline(g.get(), 3, rule).segments());
        const Handle back =
            made([&](nurbs **out) { return nurbs_reverse(g.get(), 0, NURBS_KEEP_DOMAIN, out); });
        const Handle fine = made([&](nurbs **out) { return nurbs_refine_uniform(g.get(), 0, 3, out); });
        const double point[] = {1, 2, 3}, normal[] = {1, -2, 0.5};
        const Handle mirrored = made([&](nurbs **out) { return nurbs_mirror(g.get(), point, normal, out); });
        for (const nurbs *other : {back.get(), fine.get(), mirrored.get()}) {
            const auto again = static_cast<double>(polyline(other, 3, rule).segments());
            EXPECT_NEAR(again, count, 4 + 0.1 * count) << where(seed, data);
        }
    });
}

// A quarter of the tolerance takes twice as many segments of a smooth curve.
TEST(MeshCurve, tolerances) {
    for_each_case(8600, 40, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 5);
        recipe.axes[0] = {random.whole(2, 5), KnotForm::clamped, Spacing::integers, Placement::origin, 1};
        recipe.weights = Weights::none;
        recipe.dim = random.whole(2, 4);
        const SplineData data = random_spline(random, recipe);
        double chord = 1e-5 * size_of(data);
        const auto coarse = static_cast<double>(polyline(data, {chord}).segments());
        const auto fine = static_cast<double>(polyline(data, {chord / 4}).segments());
        EXPECT_GE(fine, 1.85 * coarse - 2) << where(seed, data);
        EXPECT_LE(fine, 2.15 * coarse + 2) << where(seed, data);
    });
}

// Corners are vertices whatever the tolerance: a curve of degree 1 is its own polyline.
TEST(MeshCurve, corners) {
    for_each_case(8700, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 1);
        recipe.axes[0] = {1, KnotForm::clamped, Spacing::full, Placement::origin, random.whole(2, 9)};
        recipe.weights = Weights::none;
        recipe.dim = 3;
        const SplineData data = random_spline(random, recipe);
        const Polyline line = polyline(data, {1e6 * size_of(data)});
        const auto knots = data.knots[0];
        for (size_t i = 2; i + 2 < knots.size(); ++i) {
            EXPECT_TRUE(std::binary_search(line.params.begin(), line.params.end(), knots[i]))
                << where(seed, data);
        }
        EXPECT_EQ(line.reached, 1) << where(seed, data);
    });
}

} // namespace mesh_curve_test
