// SPDX-License-Identifier: MIT
// A circle is a rational curve: create it, evaluate a batch, insert a knot, and see that the radius did not
// change.
//     c++ -std=c++20 circle.cpp $(pkg-config --cflags --libs nurbs) -o circle && ./circle
#include <nurbs/nurbs.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

// The largest distance of 1000 points of the curve from the unit circle.
static double radius_error(const libnurbs::Spline &curve) {
    std::vector<double> params(1000);
    for (std::size_t i = 0; i < params.size(); ++i) {
        params[i] = static_cast<double>(i) / 999.0;
    }
    const std::vector<double> points = curve.eval(params);
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); i += 2) {
        largest = std::max(largest, std::abs(std::hypot(points[i], points[i + 1]) - 1));
    }
    return largest;
}

static void report(const libnurbs::Spline &curve) {
    std::cout << curve.count(0) << " control points, radius 1 to within " << radius_error(curve) << "\n";
}

int main() {
    try {
        const double s = std::sqrt(0.5);
        const auto circle = libnurbs::Spline::create(
            {2}, {9}, {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}, 2,
            {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0}, {1, s, 1, s, 1, s, 1, s, 1});
        report(circle);
        report(circle.insert_knot(0, 0.3, 2));
    } catch (const libnurbs::Error &error) {
        std::cerr << error.name() << ": " << error.what() << "\n";
        return 1;
    }
}
