// SPDX-License-Identifier: MIT
// What is meshed, for all libraries: a bicubic rational patch, quadrics, and a polygon that trims.
#pragma once

#include "bench/meshes/mesh.h"

#include <numbers>
#include <random>
#include <string_view>

namespace bench::meshes {

// One count of control points along both axes; the last one of them varies fastest.
struct Net {
    int degree = 3;
    int count = 20;
    std::vector<double> u_knots, v_knots;
    std::vector<Point> points;
    std::vector<double> weights;
};

// Numbers from 0 to 1 that are the same everywhere; the distributions of the standard library are not.
class Numbers {
public:
    explicit Numbers(uint64_t seed) : engine_(seed) {}
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }

private:
    std::mt19937_64 engine_;
};

// Clamped on [0, 1]; spans differ by a factor of up to 4.
inline std::vector<double> uneven_knots(Numbers &numbers, int degree, int count) {
    std::vector<double> inner{0};
    for (int i = degree; i < count; ++i) {
        inner.push_back(inner.back() + numbers.between(0.5, 2));
    }
    std::vector<double> knots(static_cast<size_t>(degree), 0.0);
    for (const double t : inner) {
        knots.push_back(t / inner.back());
    }
    knots.insert(knots.end(), static_cast<size_t>(degree), 1.0);
    return knots;
}

// Of side 1, with 20 x 20 control points, heights of up to 0.03 and weights from 0.5 to 2.
inline Net patch() {
    Numbers numbers(20240229);
    Net net;
    net.u_knots = uneven_knots(numbers, net.degree, net.count);
    net.v_knots = uneven_knots(numbers, net.degree, net.count);
    for (int i = 0; i < net.count; ++i) {
        for (int j = 0; j < net.count; ++j) {
            const auto off = [&] { return numbers.between(-0.2, 0.2); };
            const double u = i + off(), v = j + off();
            net.points.push_back({u / (net.count - 1), v / (net.count - 1), numbers.between(-0.03, 0.03)});
            net.weights.push_back(numbers.between(0.5, 2));
        }
    }
    return net;
}

inline Net plane() {
    return {1,
            2,
            {0, 0, 1, 1},
            {0, 0, 1, 1},
            {Point{0, 0, 0}, Point{0, 1, 0}, Point{1, 0, 0}, Point{1, 1, 0}},
            {1, 1, 1, 1}};
}

// The corners of a polygon in the domain of both of them, counterclockwise.
inline std::vector<Param> corners() {
    constexpr int count = 1000;
    std::vector<Param> all;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        all.push_back({0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle)});
    }
    return all;
}

// The border of a trimmed shape: the polygon as one curve, or as a curve for each side.
enum class Trim { none, polyline, segments };
struct Kind {
    enum class Surface { patch, plane, sphere, torus, cylinder } surface;
    Trim trim = Trim::none;
};
inline constexpr double major = 3, minor = 1, height = 2; // spheres and cylinders have a radius of 1

inline Kind kind_of(std::string_view name) {
    using enum Kind::Surface;
    const Trim trim = name.ends_with("_polyline")   ? Trim::polyline
                      : name.ends_with("_segments") ? Trim::segments
                                                    : Trim::none;
    for (const auto &[known, surface] : {std::pair{"patch", patch},
                                         {"plane", plane},
                                         {"sphere", sphere},
                                         {"torus", torus},
                                         {"cylinder", cylinder}}) {
        if (name.starts_with(known)) {
            return {surface, trim};
        }
    }
    std::fprintf(stderr, "no shape %.*s\n", static_cast<int>(name.size()), name.data());
    std::exit(2);
}

} // namespace bench::meshes
