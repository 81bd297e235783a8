// SPDX-License-Identifier: MIT
#include "face/border_pieces.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

double BorderPieces::room() const noexcept {
    const Covering &covering = face_.covering();
    const Point2 units = covering.units();
    return 1e-9 * std::max(covering.period(0) * units[0], covering.period(1) * units[1]);
}

BorderPlace BorderPieces::place_of(const TrimPiece &piece, double at) const {
    const double param = parameter_at(piece, at);
    if (!is_turned(piece)) {
        return {piece.loop, piece.curve, param};
    }
    const auto count = static_cast<int32_t>(face_.loops()[static_cast<size_t>(piece.loop)].size());
    return {piece.loop, count - 1 - piece.curve, -param};
}

// The pieces of a segment follow each other, behind the same place of the same curve.
Interval BorderPieces::part_behind(const TrimPiece &piece) const {
    const auto &all = face_.trims().pieces().all();
    const auto is_of_it = [&](const TrimPiece &other) {
        return other.loop == piece.loop && other.curve == piece.curve &&
               other.range.lower == piece.range.lower && other.range.upper == piece.range.lower;
    };
    const auto size = [&](const TrimPiece &own) {
        const Covering &covering = face_.covering();
        return std::hypot((own.end[0] - own.start[0]) / covering.period(0),
                          (own.end[1] - own.start[1]) / covering.period(1));
    };
    double before = 0, behind = 0;
    const auto at = static_cast<size_t>(&piece - all.data());
    for (size_t i = at; i > 0 && is_of_it(all[i - 1]); --i) {
        before += size(all[i - 1]);
    }
    for (size_t i = at + 1; i < all.size() && is_of_it(all[i]); ++i) {
        behind += size(all[i]);
    }
    const double whole = before + size(piece) + behind;
    return {before / whole, behind > 0 ? (before + size(piece)) / whole : 1};
}

bool BorderPieces::is_turned(const TrimPiece &piece) const {
    return face_.trims().turned()[static_cast<size_t>(piece.loop)];
}

std::vector<BorderPlace> BorderPieces::nearest_to(const Point2 &x) const {
    const Covering &covering = face_.covering();
    Point2 around{}, lower{}, upper{};
    for (size_t k = 0; k < 2; ++k) {
        const double period = covering.period(static_cast<int>(k));
        const double share = covering.extent() > 0 ? face_.tolerance() / covering.extent() : 0;
        around[k] = std::max(4 * share, 1e-9) * period;
        lower[k] = x[k] - around[k];
        upper[k] = x[k] + around[k];
    }
    std::vector<BorderPlace> found;
    double least = 2;
    const auto look = [&](const Point2 &move) {
        const Point2 y = moved(x, move);
        face_.trims().any_in(moved(lower, move), moved(upper, move), [&](const TrimPiece &piece) {
            const double at = place_near(piece, y);
            const Point2 z = face_.trims().pieces().point(piece, at);
            const double far = std::hypot((z[0] - y[0]) / around[0], (z[1] - y[1]) / around[1]);
            if (far < least) {
                least = far;
                found = {place_of(piece, at)};
            }
            return false;
        });
        return false;
    };
    look({0, 0});
    covering.any_move(lower, upper, look);
    return found;
}

// The place with the same coordinate on the axis along which the piece is longer.
double BorderPieces::place_near(const TrimPiece &piece, const Point2 &x) const {
    const Covering &covering = face_.covering();
    const bool along_v = (piece.upper[1] - piece.lower[1]) / covering.period(1) >
                         (piece.upper[0] - piece.lower[0]) / covering.period(0);
    const size_t k = along_v ? 1 : 0;
    const bool before = piece.start[k] < piece.end[k] ? x[k] <= piece.start[k] : x[k] >= piece.start[k];
    const bool beyond = piece.start[k] < piece.end[k] ? x[k] >= piece.end[k] : x[k] <= piece.end[k];
    return before ? 0 : beyond ? 1 : face_.trims().pieces().place_of(piece, static_cast<int>(k), x[k]);
}

// By the boxes of the control points that are active on each span (convex hull property).
std::set<BorderPieces::Key> BorderPieces::near(const Spline &curve) const {
    std::set<Key> found;
    const int p = curve.axis(0).degree();
    for (const int64_t span : curve.axis(0).spans().indices()) {
        Point2 lower{infinity, infinity}, upper{-infinity, -infinity};
        for (int64_t i = span - p; i <= span; ++i) {
            for (size_t k = 0; k < 2; ++k) {
                const double x = curve.coordinate(i, static_cast<int>(k));
                lower[k] = std::min(lower[k], x);
                upper[k] = std::max(upper[k], x);
            }
        }
        const Point2 units = face_.covering().units(), around{room() / units[0], room() / units[1]};
        add_in({lower[0] - around[0], lower[1] - around[1]}, {upper[0] + around[0], upper[1] + around[1]},
               found);
    }
    return found;
}

void BorderPieces::add_in(const Point2 &lower, const Point2 &upper, std::set<Key> &found) const {
    const std::array<std::array<int, 2>, 2> range{turns_of(0, lower[0], upper[0]),
                                                  turns_of(1, lower[1], upper[1])};
    for (int i = range[0][0]; i <= range[0][1]; ++i) {
        for (int j = range[1][0]; j <= range[1][1]; ++j) {
            const Covering &covering = face_.covering();
            const Point2 by{i * covering.period(0), j * covering.period(1)};
            const Point2 from{lower[0] - by[0], lower[1] - by[1]}, to{upper[0] - by[0], upper[1] - by[1]};
            face_.trims().any_in(from, to, [&](const TrimPiece &piece) {
                found.insert({&piece, {i, j}});
                return false;
            });
        }
    }
}

// The numbers of periods, from the least to the largest, by which the domain is moved to meet an interval.
std::array<int, 2> BorderPieces::turns_of(int k, double lower, double upper) const noexcept {
    const Covering &covering = face_.covering();
    if (!covering.closed(k)) {
        return {0, 0};
    }
    const auto turn = [&](double x) {
        return static_cast<int>(std::floor((x - covering.domain(k).lower) / covering.period(k)));
    };
    return {turn(lower - 1e-9 * covering.period(k)), turn(upper + 1e-9 * covering.period(k))};
}

const SplinePtr &BorderPieces::moved_piece(const TrimPiece *piece, const Turns &turns) {
    SplinePtr &curve = curves_[{piece, turns}];
    if (!curve) {
        const std::span<const double> given = face_.trims().pieces().coefficients(*piece);
        std::vector<double> records(given.begin(), given.end());
        const size_t width = piece->weighted ? 3 : 2;
        const Point2 units = face_.covering().units();
        for (size_t i = 0; i < records.size(); i += width) {
            for (size_t k = 0; k < 2; ++k) {
                const double by = turns[k] * face_.covering().period(static_cast<int>(k));
                records[i + k] = (records[i + k] + by * (piece->weighted ? records[i + 2] : 1)) * units[k];
            }
        }
        std::vector<double> knots(static_cast<size_t>(piece->degree) + 1, 0.0);
        knots.insert(knots.end(), knots.size(), 1.0);
        curve = make_result({make_knot_vector(piece->degree, std::move(knots))}, 2,
                            piece->weighted ? Form::homogeneous : Form::polynomial, std::move(records));
    }
    return curve;
}

} // namespace nrb::face
