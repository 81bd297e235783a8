// SPDX-License-Identifier: MIT
// Pairs of surfaces whose common curves are known, for all libraries.
//
// With a bicubic patch P(u, v) and a wave W(u), P + W e_z and P + level e_z meet where W(u) = level, as bicubic splines with knots of
// their own in one domain: the second one over the part of it in which there are three waves. So there are six curves, which are
// P(u, v) + level e_z with six values of u.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string_view>
#include <vector>

namespace bench::meets {

using Point = std::array<double, 3>;

inline constexpr int degree = 3;

// Clamped and even; the last index of points varies fastest.
struct Net {
    std::array<int, 2> counts;
    std::array<std::vector<double>, 2> knots;
    std::vector<Point> points;
};

inline std::vector<double> even_knots(int count, double lower, double upper) {
    std::vector<double> knots;
    for (int i = -degree; i <= count; ++i) {
        knots.push_back(lower +
                        (upper - lower) * std::clamp(static_cast<double>(i) / (count - degree), 0.0, 1.0));
    }
    return knots;
}

// The blossom of a cubic with four Bezier points.
inline Point blossom(std::array<Point, 4> points, const double *arguments) {
    for (size_t r = 0; r < 3; ++r) {
        for (size_t i = 0; i + r < 3; ++i) {
            for (size_t c = 0; c < 3; ++c) {
                points[i][c] += arguments[r] * (points[i + 1][c] - points[i][c]);
            }
        }
    }
    return points[0];
}

// P at three equal arguments each, and its control points at three successive knots.
inline Point patch(const double *u, const double *v) {
    constexpr std::array<double, 16> heights{0,    0.1, -0.1, 0.05, 0.1,  0.3, 0.2, -0.1,
                                             -0.1, 0.2, 0.1,  0.1,  0.05, 0,   0.2, 0.1};
    constexpr std::array<double, 4> along{0, 0.28, 0.7, 1}, across{0, 0.4, 0.65, 1};
    std::array<Point, 4> column{};
    for (size_t i = 0; i < 4; ++i) {
        std::array<Point, 4> row{};
        for (size_t j = 0; j < 4; ++j) {
            row[j] = {along[i] + 0.05 * across[j], across[j] - 0.1 * along[i] * along[i], heights[4 * i + j]};
        }
        column[i] = blossom(row, v);
    }
    return blossom(column, u);
}

// rise: of the control points by their first index.
template <class Rise>
Net surface(std::array<int, 2> counts, double lower, double upper, Rise &&rise) {
    Net net{counts, {even_knots(counts[0], lower, upper), even_knots(counts[1], 0, 1)}, {}};
    for (int i = 0; i < counts[0]; ++i) {
        for (int j = 0; j < counts[1]; ++j) {
            Point at =
                patch(&net.knots[0][static_cast<size_t>(i + 1)], &net.knots[1][static_cast<size_t>(j + 1)]);
            at[2] += rise(static_cast<size_t>(i));
            net.points.push_back(at);
        }
    }
    return net;
}

// Five waves of six spans each.
inline constexpr int waves = 5, spans = 30;
inline double control_value(size_t i) {
    return 0.2 * std::sin(2 * std::numbers::pi * waves * (static_cast<double>(i) - 1) / spans);
}
// W inside, where knots are even: a uniform cubic spline.
inline double wave(double x) {
    const double at = x * spans;
    const auto span = static_cast<size_t>(std::min(std::floor(at), spans - 1.0));
    const double t = at - static_cast<double>(span), s = 1 - t;
    const std::array<double, 4> basis{s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                                      (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6};
    double sum = 0;
    for (size_t i = 0; i < 4; ++i) {
        sum += basis[i] * control_value(span + i);
    }
    return sum;
}

struct Pair {
    Net a, b;
    double level = 0;
    std::vector<double> places; // u of the common curves
};

// Where W is level between two places, of which it is above that at one.
inline double place_between(double below, double above, double level) {
    for (int i = 0; i < 100; ++i) {
        const double middle = (below + above) / 2;
        (wave(middle) < level ? below : above) = middle;
    }
    return below;
}

// "six": far from the crests. "near": a little below them, so that surfaces cross at an angle of some five degrees, and two curves
// are side by side.
inline Pair pair_of(std::string_view name) {
    const double crest = 0.25 / waves, period = 1.0 / waves;
    Pair pair;
    if (name == "six") {
        pair.level = 0.05;
    } else if (name == "near") {
        pair.level = wave(crest + period) - 3e-5;
    } else {
        std::fprintf(stderr, "there is no such pair\n");
        std::exit(77);
    }
    pair.a = surface({spans + degree, 20}, 0, 1, control_value);
    pair.b = surface({17, 23}, period, 1 - period, [&](size_t) { return pair.level; });
    for (int i = 1; i + 1 < waves; ++i) {
        const double top = crest + i * period;
        for (const double side : {-1.0, 1.0}) {
            pair.places.push_back(place_between(top + side * period / 4, top, pair.level));
        }
    }
    return pair;
}

inline Point point_of_curve(const Pair &pair, double u, double v) {
    const std::array<double, 3> us{u, u, u}, vs{v, v, v};
    Point at = patch(us.data(), vs.data());
    at[2] += pair.level;
    return at;
}
inline double distance(const Point &x, const Point &y) {
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

// How far a point is from the curve at u: to where it comes nearest, by halves of halves around the best of 64 places.
inline double distance_from(const Pair &pair, double u, const Point &at) {
    const auto far = [&](double v) { return distance(point_of_curve(pair, u, std::clamp(v, 0.0, 1.0)), at); };
    double best = 0, step = 1.0 / 64;
    for (int i = 0; i <= 64; ++i) {
        best = far(i / 64.0) < far(best) ? i / 64.0 : best;
    }
    for (; step > 1e-12; step /= 2) {
        best = far(best - step) < far(best) ? best - step : far(best + step) < far(best) ? best + step : best;
    }
    return far(best);
}
// From the nearest one.
inline double distance_from(const Pair &pair, const Point &at) {
    double least = HUGE_VAL;
    for (const double u : pair.places) {
        least = std::min(least, distance_from(pair, u, at));
    }
    return least;
}

inline double true_length(const Pair &pair) {
    constexpr int samples = 1000;
    double sum = 0;
    for (const double u : pair.places) {
        for (int i = 0; i < samples; ++i) {
            sum += distance(point_of_curve(pair, u, static_cast<double>(i) / samples),
                            point_of_curve(pair, u, static_cast<double>(i + 1) / samples));
        }
    }
    return sum;
}

} // namespace bench::meets
