// SPDX-License-Identifier: MIT
#include "build/conics/arc.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nrb::build {

namespace {

// The smallest number of equal pieces that are at most `largest`, an angle that divides the full turn. A
// sweep that is a multiple of `largest` to within rounding gets no extra piece.
int64_t piece_count(const Angle &sweep, double largest) noexcept {
    const double pieces = std::fabs(sweep.radians()) / largest;
    return std::max<int64_t>(1, static_cast<int64_t>(std::ceil(pieces * (1 - 0x1p-50))));
}

Arc pieced_arc(const Turn &turn, int64_t pieces) {
    const int64_t halves = 2 * pieces;
    const double weight = turn.sweep.part(1, halves).direction().cos;
    Arc arc{piecewise_knots(pieces), {}};
    for (int64_t i = 0; i <= halves; ++i) {
        const Direction d = turn.start.plus(turn.sweep, i, halves).direction();
        const double w = i % 2 == 0 ? 1 : weight;
        arc.points.push_back({d.cos / w, d.sin / w, w});
    }
    return arc;
}

Arc smooth_arc(const Turn &turn) {
    std::array<Direction, 5> z{};
    for (size_t k = 0; k < z.size(); ++k) {
        z[k] = turn.start.plus(turn.sweep, static_cast<int64_t>(k), 4).direction();
    }
    const double c = turn.sweep.part(1, 4).direction().cos;
    const double middle = 2 + turn.sweep.part(1, 2).direction().cos; // three times the weight of z[2]
    std::vector<ArcPoint> points = {{z[0].cos, z[0].sin, 1}};
    const auto add = [&](Direction a, double ka, Direction b, double kb, double weight) {
        points.push_back(
            {(ka * a.cos + kb * b.cos) / weight, (ka * a.sin + kb * b.sin) / weight, weight / 5});
    };
    add(z[0], 1, z[1], 4, 1 + 4 * c);
    add(z[1], 2, z[2], 3, 2 * c + middle);
    add(z[2], 3, z[3], 2, 2 * c + middle);
    add(z[3], 4, z[4], 1, 1 + 4 * c);
    points.push_back({z[4].cos, z[4].sin, 1});
    std::vector<double> knots(12, 0);
    std::fill(knots.begin() + 6, knots.end(), 1);
    return {make_knot_vector(5, std::move(knots), false, 0, 0), std::move(points)};
}

} // namespace

KnotVectorPtr piecewise_knots(int64_t pieces) {
    std::vector<double> knots = {0, 0, 0};
    for (int64_t i = 1; i < pieces; ++i) {
        const double knot = static_cast<double>(i) / static_cast<double>(pieces);
        knots.insert(knots.end(), 2, knot);
    }
    knots.insert(knots.end(), 3, 1);
    return make_knot_vector(2, std::move(knots), false, 0, 0);
}

void check_arc_form(int32_t form, int32_t last) {
    if (form < arc_quarters || form > last) {
        fail(Status::form, "form = %d, expected a NURBS_ARC_ constant from 0 to %d", form, last);
    }
}

Arc unit_hyperbola(double start, double end) {
    const double length = end - start;
    if (!(length < 4096)) { // cosh() overflows at one end
        fail(Status::not_representable, "the hyperbola from %s to %s overflows", Number(start).text,
             Number(end).text);
    }
    const auto pieces = std::max<int64_t>(1, static_cast<int64_t>(std::ceil(length / 2)));
    Arc arc{piecewise_knots(pieces), {{std::cosh(start), std::sinh(start), 1}}};
    for (int64_t i = 1; i <= pieces; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(pieces);
        const double u = i == pieces ? end : start + length * part;
        const ArcPoint a = arc.points.back(), b{std::cosh(u), std::sinh(u), 1};
        const double t = (b.y - a.y) / (a.x + b.x); // tanh(d / 2), from the rounded points
        const double narrow = (1 - t) * (1 + t);    // 1 / cosh^2 (d / 2)
        arc.points.push_back({(a.x + b.x) / 2 * narrow, (a.y + b.y) / 2 * narrow, 1 / std::sqrt(narrow)});
        arc.points.push_back(b);
    }
    return arc;
}

Arc unit_arc(const Turn &turn, int32_t form) {
    check_arc_form(form);
    constexpr double third = 2 * std::numbers::pi / 3;
    if (form == arc_quarters) {
        return pieced_arc(turn, piece_count(turn.sweep, std::numbers::pi / 2));
    }
    const int64_t pieces = piece_count(turn.sweep, third);
    return form == arc_thirds || pieces == 1 ? pieced_arc(turn, pieces) : smooth_arc(turn);
}

} // namespace nrb::build
