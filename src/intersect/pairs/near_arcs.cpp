// SPDX-License-Identifier: MIT
#include "intersect/pairs/near_arcs.h"

#include "base/watch.h"
#include "intersect/pairs/periods.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

NearArcs::NearArcs(const Spline &curve)
    : curve_(curve), tree_(pieces::piece_tree_of(curve)), pieces_(tree_, tree_.grid().frame()) {}

bool NearArcs::hold(Interval arc, std::span<const double> point, double distance) const {
    const pieces::Frame &frame = tree_.grid().frame();
    Ball ball{{}, frame.scaled(distance)};
    for (size_t c = 0; c < point.size(); ++c) {
        ball.centre.push_back(frame.coordinate(c, point[c]));
    }
    const Interval domain = curve_.axis(0).domain();
    const double period = period_of(curve_);
    double turn = period > 0 ? std::floor((arc.lower - domain.lower) / period) : 0;
    do {
        const Interval part = {std::max(arc.lower - turn * period, domain.lower),
                               std::min(arc.upper - turn * period, domain.upper)};
        if (!holds_part(part, ball)) {
            return false;
        }
        ++turn;
    } while (period > 0 && domain.lower + turn * period < arc.upper);
    return true;
}

bool NearArcs::holds_part(Interval part, const Ball &ball) const {
    const pieces::PieceGrid &grid = tree_.grid();
    for (int64_t i = grid.find(0, part.lower); i < grid.count() && grid.break_at(0, i) < part.upper; ++i) {
        const Interval own{std::max(part.lower, grid.break_at(0, i)),
                           std::min(part.upper, grid.break_at(0, i + 1))};
        count_work(4 * grid.shape().values());
        if (own.lower < own.upper && !holds_piece(pieces_.piece(i).between(own), ball, most_halvings)) {
            return false;
        }
    }
    return true;
}

// The halves are looked at until their control points are inside, or one of their ends is outside.
bool NearArcs::holds_piece(pieces::BezierPiece piece, const Ball &ball, int halvings) {
    if (!piece.sound()) {
        return false;
    }
    const auto away = [&](int64_t i) {
        const double *centre = ball.centre.data();
        return piece.has_point(i) ? distance(piece.point(i), centre, piece.dim()) : 0;
    };
    const int64_t last = piece.coefficients() - 1;
    double most = 0;
    for (int64_t i = 0; i <= last; ++i) {
        most = std::max(most, away(i));
    }
    if (most + piece.moved() <= ball.radius) {
        return true;
    }
    if (halvings == 0 || std::max(away(0), away(last)) > ball.radius) {
        return false;
    }
    std::optional<pieces::BezierPiece> lower = piece.halve();
    return lower && holds_piece(std::move(*lower), ball, halvings - 1) &&
           holds_piece(std::move(piece), ball, halvings - 1);
}

} // namespace nrb::intersect
