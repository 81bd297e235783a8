// SPDX-License-Identifier: MIT
// Polylines of curves: what is proven of each segment against samples, few segments, and where vertices must be.
#include "mesh/polyline/polyline.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"
#include "unit/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace polyline_test {

using namespace nrb;
using mesh::Polyline;
using mesh::polyline_of;
using mesh::PolylineRule;
using shapes::bezier;
using shapes::curve;

namespace {

// The distance of x from the segment from a to b, and of the nearest point of that the share on it.
double distance_from(const double *x, const double *a, const double *b, int dim) {
    double along = 0, square = 0;
    for (int c = 0; c < dim; ++c) {
        along += (x[c] - a[c]) * (b[c] - a[c]);
        square += (b[c] - a[c]) * (b[c] - a[c]);
    }
    const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    return norm_of(dim, [&](int c) { return x[c] - a[c] - share * (b[c] - a[c]); });
}

// Points of the curve at equal steps from a parameter to another, the ends as their limits from inside.
std::vector<double> samples(const Spline &curve, double from, double to, int count) {
    std::vector<double> points;
    for (int i = 0; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        const double t = i == count ? to : from + share * (to - from);
        const std::vector<double> x = eval::curve_point(curve, t, i == count);
        points.insert(points.end(), x.begin(), x.end());
    }
    return points;
}

// The largest distance of samples of a part from its segment, and of samples of the segment from the part.
double sampled_hausdorff(const std::vector<double> &part, const double *a, const double *b, int dim) {
    const auto n = static_cast<size_t>(dim);
    double most = 0, gap = 0;
    for (size_t i = 0; i < part.size(); i += n) {
        most = std::max(most, distance_from(&part[i], a, b, dim));
        gap = i > 0 ? std::max(gap, distance(&part[i], &part[i - n], dim)) : 0;
    }
    for (int k = 0; k <= 16; ++k) {
        std::vector<double> x(n);
        for (size_t c = 0; c < n; ++c) {
            x[c] = a[c] + k / 16.0 * (b[c] - a[c]);
        }
        double nearest = infinity;
        for (size_t i = 0; i < part.size(); i += n) {
            nearest = std::min(nearest, distance(x.data(), &part[i], dim));
        }
        most = std::max(most, nearest - gap);
    }
    return most;
}

// What holds of every polyline.
void expect_proven(const Spline &curve, const Polyline &line, int count = 64) {
    const auto n = static_cast<size_t>(curve.dim());
    ASSERT_EQ(line.points.size(), line.params.size() * n);
    ASSERT_EQ(line.bounds.size() + 1, line.params.size());
    EXPECT_EQ(line.params.front(), curve.axis(0).domain().lower);
    EXPECT_EQ(line.params.back(), curve.axis(0).domain().upper);
    for (size_t i = 0; i + 1 < line.params.size(); ++i) {
        const double from = line.params[i], to = line.params[i + 1];
        ASSERT_LE(from, to);
        if (from == to) {
            EXPECT_EQ(line.bounds[i], 0) << "a jump";
            continue;
        }
        const std::vector<double> part = samples(curve, from, to, count);
        const double rounding =
            8 * eps * (norm(part.data(), curve.dim()) + norm(&line.points[i * n], curve.dim()));
        EXPECT_LE(sampled_hausdorff(part, &line.points[i * n], &line.points[(i + 1) * n], curve.dim()),
                  line.bounds[i] + rounding)
            << "segment " << i << " from " << from << " to " << to;
    }
}

// How many segments the sampled optimum has: each as long as samples allow.
int64_t fewest(const Spline &curve, double chord, int64_t count = 400000) {
    const Interval domain = curve.axis(0).domain();
    const std::vector<double> x = samples(curve, domain.lower, domain.upper, static_cast<int>(count));
    const int dim = curve.dim();
    const auto fits = [&](int64_t i, int64_t j) {
        for (int64_t k = i + 1; k < j; k += std::max<int64_t>(1, (j - i) / 64)) {
            if (distance_from(&x[static_cast<size_t>(k * dim)], &x[static_cast<size_t>(i * dim)],
                              &x[static_cast<size_t>(j * dim)], dim) > chord) {
                return false;
            }
        }
        return true;
    };
    int64_t segments = 0;
    for (int64_t at = 0, step = 64; at < count; ++segments) {
        while (at + step < count && fits(at, at + step)) {
            step *= 2;
        }
        int64_t good = 1, bad = std::min(step, count - at) + 1;
        while (bad - good > 1) {
            const int64_t middle = (good + bad) / 2;
            (fits(at, at + middle) ? good : bad) = middle;
        }
        at += good;
        step = std::max<int64_t>(good / 2, 1);
    }
    return segments;
}

// A cubic through a curve over [0, 1] given by position and derivative: C1, with simple pieces of equal length.
SplinePtr along(int dim, int64_t spans, const std::function<void(double, double *, double *)> &jet) {
    std::vector<double> points, knots(4, 0.0);
    std::vector<double> x(static_cast<size_t>(dim)), v(x);
    for (int64_t i = 0; i <= spans; ++i) {
        const double h = 1.0 / static_cast<double>(spans);
        jet(static_cast<double>(i) * h, x.data(), v.data());
        for (const double side : {-1.0, 1.0}) {
            if ((i == 0 && side < 0) || (i == spans && side > 0)) {
                points.insert(points.end(), x.begin(), x.end());
                continue;
            }
            for (int c = 0; c < dim; ++c) {
                points.push_back(x[static_cast<size_t>(c)] + side * h / 3 * v[static_cast<size_t>(c)]);
            }
        }
        if (i > 0) {
            knots.insert(knots.end(), i < spans ? 2 : 4, static_cast<double>(i) * h);
        }
    }
    return curve(3, knots, dim, points);
}

SplinePtr helix(int64_t spans = 97, double turns = 10) {
    const double w = 2 * std::numbers::pi * turns;
    return along(3, spans, [w, turns](double t, double *x, double *v) {
        x[0] = 5 * std::cos(w * t), x[1] = 5 * std::sin(w * t), x[2] = turns * t;
        v[0] = -5 * w * std::sin(w * t), v[1] = 5 * w * std::cos(w * t), v[2] = turns;
    });
}

SplinePtr spiral() {
    return along(2, 60, [](double t, double *x, double *v) {
        const double r = std::exp(3 * t), w = 20;
        x[0] = r * std::cos(w * t), x[1] = r * std::sin(w * t);
        v[0] = 3 * x[0] - w * x[1], v[1] = 3 * x[1] + w * x[0];
    });
}

SplinePtr circle() {
    const double r = std::sqrt(0.5);
    return make_spline({make_knot_vector(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4})}, 2, Form::rational,
                       {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0},
                       {1, r, 1, r, 1, r, 1, r, 1});
}

int64_t segments(const Polyline &line) {
    return std::ssize(line.bounds);
}

} // namespace

TEST(Polyline, FewSegments) {
    for (const SplinePtr &given : {helix(), spiral(), circle()}) {
        for (const double chord : {1e-1, 1e-2, 1e-3, 1e-4}) {
            const Polyline line = polyline_of(*given, {.chord = chord});
            EXPECT_TRUE(line.reached);
            expect_proven(*given, line);
            EXPECT_LE(*std::ranges::max_element(line.bounds), chord);
            const int64_t best = fewest(*given, chord);
            EXPECT_LE(segments(line), std::max(best + 1, best * 104 / 100));
        }
    }
}

TEST(Polyline, StraightAcrossPieces) {
    const SplinePtr slight = along(2, 20000, [](double t, double *x, double *v) {
        x[0] = t, x[1] = 1e-3 * t * t;
        v[0] = 1, v[1] = 2e-3 * t;
    });
    const Polyline line = polyline_of(*slight, {.chord = 1e-5});
    EXPECT_TRUE(line.reached);
    EXPECT_LE(segments(line), 6);
    expect_proven(*slight, line, 20000);
    EXPECT_EQ(segments(polyline_of(*slight, {.chord = 1e-3})), 1);
}

TEST(Polyline, JumpsAndKinks) {
    // A jump from (1, 1) to (2, 0), and a kink at (3, 0).
    const SplinePtr broken =
        curve(2, {0, 0, 0, 1, 1, 1, 2, 2, 3, 3, 3}, 2, {0, 0, 0.5, 1, 1, 1, 2, 0, 2.5, 0, 3, 0, 3, 1, 3, 2});
    const Polyline line = polyline_of(*broken, {.chord = 1});
    EXPECT_EQ(line.params, (std::vector<double>{0, 1, 1, 2, 3}));
    EXPECT_EQ(line.points, (std::vector<double>{0, 0, 1, 1, 2, 0, 3, 0, 3, 2}));
    EXPECT_TRUE(line.reached);
    expect_proven(*broken, line);
    expect_proven(*broken, polyline_of(*broken, {.chord = 1e-3}));
    // The same knots without a jump and without a kink.
    const SplinePtr whole = curve(2, {0, 0, 0, 1, 1, 1, 2, 2, 3, 3, 3}, 2,
                                  {0, 0, 0.5, 0, 1, 0, 1, 0, 1.5, 0, 2, 0, 2.5, 0, 3, 0});
    EXPECT_EQ(polyline_of(*whole, {.chord = 1e-9}).params, (std::vector<double>{0, 3}));
}

// Limits that differ by rounding are no jump, but a vertex, so that nothing is left out in between.
TEST(Polyline, LimitsThatDifferByRounding) {
    const double near = std::nextafter(1.0, 2.0);
    const SplinePtr torn = curve(1, {0, 0, 1, 1, 2, 2}, 2, {0, 0, 1, 0, near, 0, 2, 0});
    EXPECT_EQ(polyline_of(*torn, {.chord = 1}).params, (std::vector<double>{0, 1, 2}));
    const SplinePtr whole = curve(1, {0, 0, 1, 1, 2, 2}, 2, {0, 0, 1, 0, 1, 0, 2, 0});
    EXPECT_EQ(polyline_of(*whole, {.chord = 1}).params, (std::vector<double>{0, 2}));
}

// The end of a periodic curve that jumps at its seam is its start all the same.
TEST(Polyline, JumpAtTheSeam) {
    const SplinePtr steps = curve(0, {0, 1, 2}, 1, {3, 5}, true);
    const Polyline line = polyline_of(*steps, {.chord = 1}, std::vector<double>{0, 2});
    EXPECT_EQ(line.params, (std::vector<double>{0, 1, 1, 2, 2}));
    EXPECT_EQ(line.points, (std::vector<double>{3, 3, 5, 5, 3}));
}

TEST(Polyline, DegreeZero) {
    const SplinePtr steps = curve(0, {0, 1, 2, 4}, 2, {0, 0, 1, 0, 1, 5});
    const Polyline line = polyline_of(*steps, {.chord = 1e-12});
    EXPECT_EQ(line.params, (std::vector<double>{0, 1, 1, 2, 2, 4}));
    EXPECT_EQ(line.points, (std::vector<double>{0, 0, 0, 0, 1, 0, 1, 0, 1, 5, 1, 5}));
    EXPECT_TRUE(line.reached);
}

TEST(Polyline, ClosedCurvesStayOpen) {
    for (const double chord : {infinity, 3.0, 1e-2}) {
        const Polyline line = polyline_of(*circle(), {.chord = chord});
        EXPECT_GE(segments(line), 3);
        EXPECT_TRUE(line.reached);
        expect_proven(*circle(), line);
    }
    const SplinePtr round =
        curve(3, {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7}, 2, {0, 0, 3, 0, 3, 3, 0, 3, 0, 0, 3, 0, 3, 3}, true);
    for (const double chord : {10.0, 1e-2, 1e-4}) {
        const Polyline line = polyline_of(*round, {.chord = chord});
        const size_t n = line.points.size();
        EXPECT_GE(segments(line), 3);
        EXPECT_EQ(line.points[0], line.points[n - 2]);
        EXPECT_EQ(line.points[1], line.points[n - 1]);
        expect_proven(*round, line);
    }
}

TEST(Polyline, FixedParameters) {
    const std::vector<double> fixed{0, 0.25, 0.3, 0.30000001, 1};
    const Polyline line = polyline_of(*helix(), {.chord = 1e-2}, fixed);
    for (const double t : fixed) {
        EXPECT_TRUE(std::ranges::binary_search(line.params, t)) << t;
    }
    EXPECT_TRUE(line.reached);
    expect_proven(*helix(), line);
}

// Segments of a circle turn by 2 pi / n, and are 2 sin(pi / n) long.
TEST(Polyline, AnglesAndLengths) {
    for (const int n : {7, 20, 100}) {
        const double angle = 2 * std::numbers::pi / n;
        const Polyline turned = polyline_of(*circle(), {.chord = infinity, .angle = angle});
        EXPECT_TRUE(turned.reached);
        EXPECT_GE(segments(turned), n);
        EXPECT_LE(segments(turned), n + 1 + n / 25);
        const double longest = 2 * std::sin(std::numbers::pi / n);
        const Polyline even = polyline_of(*circle(), {.chord = infinity, .longest = longest});
        EXPECT_TRUE(even.reached);
        EXPECT_GE(segments(even), n);
        EXPECT_LE(segments(even), n + 2 + n / 25); // three parts, each begun anew
        for (size_t i = 2; i < even.points.size(); i += 2) {
            EXPECT_LE(distance(&even.points[i], &even.points[i - 2], 2), longest);
        }
        expect_proven(*circle(), even);
    }
}

// (t^2, t^3) turns back at a point: no segment over it has a bounded angle, but few are made in vain.
TEST(Polyline, Cusp) {
    const SplinePtr cusp = bezier(2, {1, -1, -1, 1, -1, -1, 1, 1});
    const Polyline line = polyline_of(*cusp, {.chord = 1e-3, .angle = 0.1});
    EXPECT_FALSE(line.reached);
    EXPECT_LE(segments(line), 120);
    expect_proven(*cusp, line);
    EXPECT_TRUE(polyline_of(*cusp, {.chord = 1e-6}).reached);
}

TEST(Polyline, OneDimension) {
    const SplinePtr rising = bezier(1, {0, 1, 3, 4});
    EXPECT_EQ(segments(polyline_of(*rising, {.chord = 1e-9})), 1);
    const SplinePtr hill = bezier(1, {0, 2, 1});
    const Polyline line = polyline_of(*hill, {.chord = 1e-6});
    EXPECT_TRUE(line.reached);
    EXPECT_LE(segments(line), 6);
    expect_proven(*hill, line);
}

TEST(Polyline, WildWeights) {
    const SplinePtr wild = bezier(3, {0, 0, 0, 1, 2, 0, 2, -1, 1, 3, 0, 0}, {1, 1e12, 1e-9, 1});
    const Polyline line = polyline_of(*wild, {.chord = 1e-4});
    EXPECT_TRUE(line.reached);
    EXPECT_LE(segments(line), 200);
    expect_proven(*wild, line);
    const SplinePtr zero = bezier(2, {0, 0, 9, 9, 1, 1}, {1, 0, 1});
    const Polyline straight = polyline_of(*zero, {.chord = 1e-9});
    EXPECT_TRUE(straight.reached);
    EXPECT_EQ(segments(straight), 1);
}

// The weight passes through 0: nothing is proven there, and the search ends.
TEST(Polyline, NegativeWeights) {
    const SplinePtr pole =
        make_spline({shapes::bezier_axis(2)}, 2, Form::homogeneous, {0, 0, 1, 1, 0, -1, 2, 1, 1});
    const Polyline line = polyline_of(*pole, {.chord = 1e-3});
    EXPECT_FALSE(line.reached);
    EXPECT_LE(segments(line), 1000);
    const SplinePtr below =
        make_spline({shapes::bezier_axis(2)}, 2, Form::homogeneous, {0, 0, -1, -1, 0, -1, -2, -1, -1});
    const Polyline proven = polyline_of(*below, {.chord = 1e-3});
    EXPECT_TRUE(proven.reached);
    expect_proven(*below, proven);
    // Positive, though a coefficient is not.
    const SplinePtr dip =
        make_spline({shapes::bezier_axis(2)}, 2, Form::homogeneous, {0, 0, 1, 0.1, 0.1, -0.5, 2, 1, 1});
    const Polyline dipped = polyline_of(*dip, {.chord = 1e-3});
    EXPECT_TRUE(dipped.reached);
    expect_proven(*dip, dipped);
}

TEST(Polyline, ScaleFree) {
    const SplinePtr one = spiral();
    const Polyline line = polyline_of(*one, {.chord = 1e-2, .angle = 0.2, .longest = 1});
    for (const int exponent : {-500, -40, 40, 500}) {
        std::vector<double> points = shapes::vector_of(one->points());
        for (double &x : points) {
            x = std::ldexp(x, exponent);
        }
        const SplinePtr other = make_spline({one->knot_vectors()}, 2, Form::polynomial, points);
        const Polyline scaled = polyline_of(
            *other, {.chord = std::ldexp(1e-2, exponent), .angle = 0.2, .longest = std::ldexp(1, exponent)});
        EXPECT_EQ(scaled.params, line.params);
        EXPECT_EQ(scaled.reached, line.reached);
    }
}

// What rounding hides is not divided further.
TEST(Polyline, ToleranceBelowRounding) {
    const SplinePtr far = bezier(2, {1e9, 1e9, 1e9 + 1, 1e9 + 1, 1e9 + 2, 1e9});
    const Polyline line = polyline_of(*far, {.chord = 1e-12});
    EXPECT_FALSE(line.reached);
    EXPECT_LE(segments(line), 5000);
    expect_proven(*far, line);
}

TEST(Polyline, LimitOfWork) {
    const Watch watch({.work = 200000});
    const SplinePtr given = helix();
    const Polyline line = polyline_of(*given, {.chord = 1e-6});
    EXPECT_FALSE(line.reached);
    EXPECT_TRUE(work_ended());
    expect_proven(*given, line);
}

TEST(Polyline, Points) {
    const SplinePtr point = bezier(2, {1, 2, 1, 2, 1, 2});
    const Polyline line = polyline_of(*point, {.chord = 1e-9});
    EXPECT_TRUE(line.reached);
    expect_proven(*point, line);
}

} // namespace polyline_test
