// SPDX-License-Identifier: MIT
// Which spans have polynomial pieces, and the pieces of a curve.
#include "base/finite.h"
#include "spline/spline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::inline spline {

bool Spline::even(WeightRange range) noexcept {
    constexpr double largest_ratio = 4;
    return range.smallest > 0 && range.largest <= largest_ratio * range.smallest;
}

Spline::WeightRange Spline::weight_range(int64_t first, int64_t count) const noexcept {
    if (form_ == Form::polynomial) {
        return {};
    }
    if (form_ == Form::rational) {
        const auto [smallest, largest] =
            extremes(weights().subspan(static_cast<size_t>(first), static_cast<size_t>(count)));
        return {smallest, largest};
    }
    const int64_t step = weight_step();
    const double *at = weight_data() + first * step;
    WeightRange range{*at, *at};
    for (int64_t i = 1; i < count; ++i) {
        range.smallest = std::min(range.smallest, at[i * step]);
        range.largest = std::max(range.largest, at[i * step]);
    }
    return range;
}

bool Spline::has_piece(int64_t span) const noexcept {
    const int degree = axis(0).degree();
    return axis(0).has_piece(span) && (even_weights_ || even(weight_range(span - degree, degree + 1))) &&
           (moderate_.load(std::memory_order_relaxed) || moderate_window(span));
}

// True of every window if moderate() is true of the whole curve: a span is evaluated the same way whether
// that is known or not.
bool Spline::moderate_window(int64_t span) const noexcept {
    bool moderate = true;
    for (int64_t i = span - axis(0).degree(); i <= span; ++i) {
        const double factor = form_ == Form::rational ? scaled_weight(i) : 1;
        for (int c = 0; c < stored_width(); ++c) {
            const double value = std::abs(points_[static_cast<size_t>(i * stored_width() + c)]);
            moderate = moderate && value < moderate_limit && factor * value < moderate_product;
        }
    }
    return moderate;
}

// From the basis of a span, whose points are copied to `points`: [degree + 1][lanes].
void Spline::combine(int64_t span, const double *basis, const double *rests, double *points,
                     double *piece) const noexcept {
    const int degree = axis(0).degree();
    const int lanes = Piece::lanes(width());
    double weights[max_piece_degree + 1];
    for (int j = 0; j <= degree; ++j) {
        const int64_t i = span - degree + j;
        double *point = points + static_cast<int64_t>(j) * lanes;
        std::fill(std::copy_n(points_.data() + i * stored_width(), stored_width(), point), point + lanes,
                  0.0);
        weights[j] = 1;
        if (form_ == Form::rational) {
            point[dim_] = 1;
            weights[j] = scaled_weight(i);
        }
    }
    std::copy_n(basis, static_cast<int>(Piece::head_size), piece);
    combine_pieces(basis, rests, degree, weights, points, lanes, piece + Piece::head_size);
}

void Spline::curve_piece(int64_t span, double *points, double *piece) const noexcept {
    double basis[max_basis_piece];
    double rests[max_basis_piece];
    double *const pieces[1] = {basis};
    double *const low[1] = {rests};
    basis_pieces(axis(0).knots().data(), axis(0).degree(), &span, 1, pieces, low);
    combine(span, basis, rests, points, piece);
}

PieceArray Spline::curve_pieces() const {
    static_cast<void>(moderate()); // which makes it unnecessary to look at every window
    const SpanTable &spans = axis(0).spans();
    const int degree = axis(0).degree();
    PieceArray pieces(spans.size(), Piece::size(degree, width()));
    std::vector<double> points(static_cast<size_t>(degree + 1) * static_cast<size_t>(Piece::lanes(width())));
    double basis[most_pieces_together][max_basis_piece];
    double rests[most_pieces_together][max_basis_piece];
    double *together[most_pieces_together];
    double *low[most_pieces_together];
    for (int l = 0; l < most_pieces_together; ++l) {
        together[l] = basis[l];
        low[l] = rests[l];
    }
    for (int64_t first = 0; first < spans.size(); first += pieces_together()) {
        const auto count = static_cast<int>(std::min<int64_t>(pieces_together(), spans.size() - first));
        const int64_t *indices = spans.indices().data() + first;
        basis_pieces(axis(0).knots().data(), degree, indices, count, together, low);
        for (int l = 0; l < count; ++l) {
            if (has_piece(indices[l])) {
                combine(indices[l], basis[l], rests[l], points.data(), pieces[first + l]);
            } else {
                std::fill_n(pieces[first + l], static_cast<int>(Piece::head_size),
                            std::numeric_limits<double>::quiet_NaN());
            }
        }
    }
    return pieces;
}

const PieceArray *Spline::pieces_after(int64_t uses) const {
    if (pieces_.peek() != nullptr || (piece_degree(axis(0).degree()) && uses_.pay(uses, count(0) / 3))) {
        return &pieces_.get([this] { return curve_pieces(); });
    }
    return nullptr;
}

} // namespace nrb::inline spline
