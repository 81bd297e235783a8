// SPDX-License-Identifier: MIT
#include "mesh/polyline/chord.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"
#include "pieces/slopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::mesh {

namespace {

// The maximum of a (1 - s) + b s + 4 h s (1 - s) over s from 0 to 1.
double highest(double a, double b, double h) noexcept {
    const double slope = std::abs(b - a);
    return slope >= 4 * h ? std::max(a, b) : a / 2 + b / 2 + h + slope * (slope / (16 * h));
}

} // namespace

Chord::Chord(int dim) : dim_(dim) {
    const auto n = static_cast<size_t>(dim);
    start_.resize(n);
    end_.resize(n);
    direction_.resize(n);
}

void Chord::set(const double *start, const double *end) {
    start_.assign(start, start + dim_);
    end_.assign(end, end + dim_);
    length_ = nrb::distance(start, end, dim_);
    for (size_t c = 0; c < direction_.size(); ++c) {
        direction_[c] = length_ > 0 ? (end[c] - start[c]) / length_ : 0;
    }
    rounding_ = (dim_ + 4) * eps * (norm(start, dim_) + norm(end, dim_));
}

// The vectors from the start to control points, their products with the direction, and their components
// across it each have errors of about (dim + 4) eps times the distances of both points from the centre. The
// ends of the segment are within eps times their own distances.
double Chord::noise(const pieces::BezierPiece &piece) const noexcept {
    return piece.moved() + 4 * ((dim_ + 4) * eps * piece.reach() + rounding_);
}

Chord::Spread Chord::spread(const pieces::BezierPiece &piece) {
    const auto n = static_cast<size_t>(dim_);
    Spread all{0, infinity, -infinity};
    numerators_.resize(static_cast<size_t>(piece.coefficients()) * n);
    double *across = numerators_.data();
    for (int64_t i = 0; i < piece.coefficients(); ++i, across += n) {
        const double *x = piece.point(i);
        if (!piece.has_point(i)) {
            std::fill_n(across, n, 0.0);
            continue;
        }
        double along = 0;
        for (size_t c = 0; c < n; ++c) {
            across[c] = x[c] - start_[c];
            along += across[c] * direction_[c];
        }
        for (size_t c = 0; c < n; ++c) {
            across[c] -= along * direction_[c];
        }
        all.across = std::max(all.across, norm(across, dim_));
        all.least = std::min(all.least, along);
        all.most = std::max(all.most, along);
        std::for_each_n(across, n, [w = piece.weight(i)](double &v) { v *= w; });
    }
    return all;
}

// The vector across the segment has a numerator N(s) over the piece. It differs from linear interpolation
// between its ends by at most s (1 - s) / 2 max |N''|, where N'' is in the convex hull of degree (degree - 1)
// times the second differences of its coefficients. This bound is exact up to the third order of the length
// of the piece, whereas control points are farther away than the curve, twice as far for degree 2.
Chord::Bends Chord::bends(const pieces::BezierPiece &piece) const noexcept {
    const auto n = static_cast<size_t>(dim_);
    const int64_t last = piece.coefficients() - 1;
    double bend = 0, least_bend = infinity, largest = 0, least = infinity, heaviest = 0;
    for (int64_t i = 0; i <= last; ++i) {
        const double *v = numerators_.data() + static_cast<size_t>(i) * n;
        largest = std::max(largest, norm(v, dim_));
        least = std::min(least, piece.weight(i));
        heaviest = std::max(heaviest, piece.weight(i));
        if (i + 2 <= last) {
            const double *next = v + n, *second = next + n;
            const double found = norm_of(dim_, [=](int c) { return v[c] - 2 * next[c] + second[c]; });
            bend = std::max(bend, found);
            least_bend = std::min(least_bend, found);
        }
    }
    const double factor = static_cast<double>(last) * static_cast<double>(last - 1) / 8;
    const double lift = factor * (bend + 8 * eps * largest);
    const double *first = numerators_.data(), *end = first + static_cast<size_t>(last) * n;
    const double a = norm(first, dim_), b = norm(end, dim_);
    const bool uneven = heaviest > 1.1 * least || bend > 2 * least_bend;
    return {highest(a, b, lift) * (1 + (dim_ + 8) * eps) / least, uneven && lift > 0.25 * std::max(a, b)};
}

double Chord::distance(const pieces::BezierPiece &piece) {
    return distance(piece, 2);
}

// The distance of a point whose foot point is between the ends is its distance across the segment; beyond an
// end, the distance along the segment counts, too.
double Chord::distance(const pieces::BezierPiece &piece, int halvings) {
    if (!piece.sound()) {
        return infinity;
    }
    count_work(6 * piece.coefficients() * dim_);
    const Spread all = spread(piece);
    const Bends found = bends(piece);
    if (found.rough && halvings > 0) {
        return distance_of_halves(piece, halvings - 1);
    }
    const double beyond = std::max({0.0, -all.least, all.most - length_});
    const double bound =
        std::hypot(std::min(all.across, found.across), beyond) * (1 + 4 * eps) + noise(piece);
    return std::isfinite(bound) ? bound : infinity;
}

double Chord::distance_of_halves(const pieces::BezierPiece &piece, int halvings) {
    pieces::BezierPiece upper = piece;
    const pieces::BezierPiece lower = upper.halve(0);
    return std::max(distance(lower, halvings), distance(upper, halvings));
}

double Chord::start_gap(const pieces::BezierPiece &piece) const noexcept {
    return nrb::distance(piece.point(0), start_.data(), dim_) + noise(piece);
}

double Chord::end_gap(const pieces::BezierPiece &piece) const noexcept {
    return nrb::distance(piece.point(piece.coefficients() - 1), end_.data(), dim_) + noise(piece);
}

// The largest angle of the segment with a vector that is within `error` of this one.
double Chord::angle_with(const double *vector, double error) const noexcept {
    const double size = norm(vector, dim_);
    const double along = dot(vector, direction_.data(), dim_);
    const double across =
        norm_of(dim_, [&](int c) { return vector[c] - along * direction_[static_cast<size_t>(c)]; });
    const double off = error + (2 * dim_ + 8) * eps * size;
    if (!(size > off)) {
        return std::numbers::pi;
    }
    const double more = std::asin(std::min(1.0, off / size));
    return std::min(std::numbers::pi, (std::atan2(across, along) + more) * (1 + 4 * eps));
}

double Chord::turn(const pieces::BezierPiece &piece) const {
    if (piece.degree(0) == 0) {
        return 0;
    }
    if (!piece.positive() || !(length_ > 4 * rounding_)) {
        return std::numbers::pi;
    }
    const pieces::Slopes slopes(piece);
    double turn = 0;
    for (size_t i = 0; i < slopes.count(); ++i) {
        turn = std::max(turn, angle_with(slopes.vector(i), slopes.error()));
    }
    // The direction of the segment is off by the rounding of its ends. A cone of half-angle less than pi / 2
    // is convex, so it contains the convex hull of the vectors.
    turn += std::asin(std::min(1.0, 4 * rounding_ / length_));
    return turn < std::numbers::pi / 2 ? turn : std::numbers::pi;
}

} // namespace nrb::mesh
