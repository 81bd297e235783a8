// SPDX-License-Identifier: MIT
#include "intersect/surfaces/contact/contact_chart.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/intervals.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::intersect {

namespace {

// A part over the plane: the components along e_0, e_1 and n of its derivatives by parameters that, to first
// order, are the coordinates of the plane.
struct Graph {
    std::array<std::array<Interval, 2>, 3> first;  // [e_0, e_1, n][parameter]
    std::array<std::array<Interval, 3>, 3> second; // [e_0, e_1, n][00, 01, 11]
};

// Bounds of the a_ij of ContactChart; none: J is too far from the identity.
std::optional<std::array<Interval, 3>> bends_of(const Graph &graph) noexcept {
    constexpr double most_off = 0.4;
    double off = 0;
    for (size_t i = 0; i < 2; ++i) {
        double row = 0;
        for (size_t j = 0; j < 2; ++j) {
            row += magnitude_of(graph.first[i][j] - Interval{i == j ? 1.0 : 0.0, i == j ? 1.0 : 0.0});
        }
        off = std::max(off, row);
    }
    if (!(off <= most_off)) {
        return std::nullopt;
    }
    const double wide = off / (1 - off); // bounds the row sums of |J^-1 - 1|, and so each entry
    const std::array<std::array<Interval, 2>, 2> q{
        {{Interval{1, 1} + around(wide), around(wide)}, {around(wide), Interval{1, 1} + around(wide)}}};
    std::array<Interval, 3> result{};
    for (size_t d = 0; d < 3; ++d) {
        const auto &p = q[d == 2 ? 1 : 0], &r = q[d == 0 ? 0 : 1];
        const auto form = [&](const std::array<Interval, 3> &second) {
            return second[0] * (p[0] * r[0]) + second[1] * (p[0] * r[1] + p[1] * r[0]) +
                   second[2] * (p[1] * r[1]);
        };
        const std::array<Interval, 2> turn{form(graph.second[0]), form(graph.second[1])};
        const double most = (1 + wide) * std::max(magnitude_of(turn[0]), magnitude_of(turn[1]));
        result[d] =
            form(graph.second[2]) - graph.first[2][0] * around(most) - graph.first[2][1] * around(most);
    }
    return result;
}

// By the parameters p_j that stand for the place p_0 q_0 + p_1 q_1 from the middle.
Graph graph_of(const CrossCell &cell, const std::array<Vector3, 3> &axes,
               const std::array<std::array<double, 2>, 2> &q) {
    Graph graph;
    for (size_t i = 0; i < 3; ++i) {
        const CrossBends of = cell.bends_along(axes[i]);
        for (size_t j = 0; j < 2; ++j) {
            graph.first[i][j] = q[j][0] * of.extents.slopes[0] + q[j][1] * of.extents.slopes[1];
        }
        for (size_t d = 0; d < 3; ++d) {
            const auto &p = q[d == 2 ? 1 : 0], &r = q[d == 0 ? 0 : 1];
            graph.second[i][d] = (p[0] * r[0]) * of.bends[0] + (p[0] * r[1] + p[1] * r[0]) * of.bends[1] +
                                 (p[1] * r[1]) * of.bends[2];
        }
    }
    return graph;
}

} // namespace

bool ContactChart::set_bends(const CrossCell &a, const CrossCell &b) {
    const std::array<Vector3, 3> axes{place_.along, place_.across, place_.normal};
    std::array<std::optional<std::array<Interval, 3>>, 2> bends;
    for (size_t s = 0; s < 2; ++s) {
        const CrossCell &cell = s == 0 ? a : b;
        std::array<std::array<double, 2>, 2> q;
        for (size_t k = 0; k < 2; ++k) {
            const Interval &range = cell.piece().range[k];
            const double length = (range.upper - range.lower) * cell.length(k);
            q[0][k] = place_.along_on[2 * s + k] / length;
            q[1][k] = place_.across_on[2 * s + k] / length;
        }
        bends[s] = bends_of(graph_of(cell, axes, q));
        if (!bends[s]) {
            return false;
        }
    }
    for (size_t d = 0; d < 3; ++d) {
        bends_[d] = (*bends[0])[d] - (*bends[1])[d];
    }
    return bends_[2].lower > 0 || bends_[2].upper < 0;
}

// Whether a point is in the wide part of a cell.
bool ContactChart::is_near(const CrossCell &cell, size_t surface, const ContactPoint &point) const {
    const std::array<double, 2> place =
        solver_.place_in(surface, cell.piece(), point.at.data() + 2 * surface);
    for (size_t k = 0; k < 2; ++k) {
        const double x = cell.in_part(k, place[k]);
        if (!(x >= -widening && x <= 1 + widening)) {
            return false;
        }
    }
    return true;
}

ContactChart::Verdict ContactChart::look(const CrossCell &a, const CrossCell &b) {
    constexpr double flat = 0x1p-6, bent = 0x1p-12; // surfaces that bend less from each other may be one
    const bool first = a.size() <= b.size();
    const std::optional<CrossPlace> start = solver_.from_middle(first ? a : b, first ? 0 : 1, first ? b : a);
    std::optional<ContactPoint> found = start ? solver_.ridge(*start) : std::nullopt;
    found = found ? solver_.in_domain(*found) : std::nullopt;
    if (!found || !is_near(a, 0, *found) || !is_near(b, 1, *found)) {
        return Verdict::open;
    }
    if (!(std::abs(found->height) <= zero_height(a.piece().error + b.piece().error)) ||
        !(std::abs(found->least) <= flat * std::abs(found->most)) || !(std::abs(found->most) >= bent)) {
        return Verdict::apart;
    }
    place_ = *found;
    return set_bends(a, b) ? Verdict::contact : Verdict::open;
}

double ContactChart::change() const noexcept {
    const double least = std::min(std::abs(bends_[2].lower), std::abs(bends_[2].upper));
    return magnitude_of(bends_[0]) + magnitude_of(bends_[1]) * magnitude_of(bends_[1]) / least;
}

} // namespace nrb::intersect
