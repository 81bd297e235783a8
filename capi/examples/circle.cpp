// SPDX-License-Identifier: MIT
// A circle is a rational curve: its points and tangents, a knot more, the point that is closest to another,
// its length, and what a bad call says.
//     c++ -std=c++20 circle.cpp $(pkg-config --cflags --libs nurbs) -o circle && ./circle
#include <cmath>
#include <cstdio>
#include <nurbs/nurbs.hpp>

// The first two of every `step` values are x and y.
static void report(const libnurbs::Spline &curve, const std::vector<double> &values, std::size_t step) {
    double error = 0;
    for (std::size_t i = 0; i < values.size(); i += step) {
        error = std::fmax(error, std::abs(std::hypot(values[i], values[i + 1]) - 1));
    }
    std::printf("%d control points, radius 1 to within %.2g\n", static_cast<int>(curve.count(0)), error);
}

int main() try {
    std::vector<double> params(1000);
    for (std::size_t i = 0; i < 1000; ++i) {
        params[i] = static_cast<double>(i) / 999;
    }
    const libnurbs::Spline circle = libnurbs::circle({}, 1), finer = circle.insert_knot(0, 0.3, 2);
    const std::vector<double> derivs = circle.eval_derivs(1, params), after = finer.eval(params);
    double slant = 0, moved = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
        const double *c = &derivs[4 * i], *q = &after[2 * i];
        slant = std::fmax(slant, std::abs(c[0] * c[2] + c[1] * c[3]));
        moved = std::fmax(moved, std::fmax(std::abs(q[0] - c[0]), std::abs(q[1] - c[1])));
    }
    report(circle, derivs, 4);
    std::printf("tangents at right angles to within %.2g\n", slant);
    report(finer, after, 2);
    std::printf("the points moved by at most %.2g\n", moved);
    const auto found = libnurbs::closest_points(circle, {3, 4});
    const bool certified = (found.status[0] & libnurbs::closest_certified) != 0;
    std::printf("closest to (3, 4): (%.6f, %.6f), distance %.6f, %s\n", found.points[0], found.points[1],
                found.distances[0], certified ? "certified" : "not certified");
    const auto length = libnurbs::length(circle);
    std::printf("length %.12f, error about %.2g\n", length.value, length.error);
    (void)circle.eval({2});
} catch (const libnurbs::Error &error) {
    std::printf("a bad call says: %s\n", error.what());
}
