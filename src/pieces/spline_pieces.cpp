// SPDX-License-Identifier: MIT
#include "pieces/spline_pieces.h"

#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nrb::pieces {

namespace {

BernsteinNet::Breaks breaks_of_part(const Spline &spline, const Part &part) {
    BernsteinNet::Breaks breaks;
    for (int k = 0; k < spline.axes(); ++k) {
        breaks[static_cast<size_t>(k)] = breaks_in(spline.axis(k), part[static_cast<size_t>(k)]);
    }
    return breaks;
}

} // namespace

std::vector<double> breaks_in(const KnotVector &axis, Interval part) {
    std::vector<double> breaks{part.lower};
    std::copy_if(axis.knots().begin(), axis.knots().end(), std::back_inserter(breaks),
                 [part](double t) { return t > part.lower && t < part.upper; });
    breaks.push_back(part.upper);
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
}

SplinePieces::SplinePieces(const Spline &spline, const Part &part)
    : SplinePieces(spline, part, centre_of(spline)) {}

SplinePieces::SplinePieces(const Spline &spline, const Part &part, std::vector<double> centre)
    : axes_(spline.axes()), centre_(std::move(centre)), breaks_(breaks_of_part(spline, part)),
      net_(spline, centred_records(spline, centre_, spline.rational(), weight_exponent(spline)), breaks_,
           degrees_of(spline)) {
    coordinates_.resize(static_cast<size_t>(net_.shape().coefficients()) * centre_.size());
}

std::array<double, max_axes> SplinePieces::parameter(int64_t piece,
                                                     const std::array<double, max_axes> &place) const {
    std::array<double, max_axes> result{};
    for (int k = axes_; k-- > 0;) {
        const std::vector<double> &breaks = breaks_[static_cast<size_t>(k)];
        const int64_t pieces = std::ssize(breaks) - 1;
        const auto at = static_cast<size_t>(piece % pieces);
        const double fraction = place[static_cast<size_t>(k + max_axes - axes_)];
        const double low = breaks[at], high = breaks[at + 1];
        result[static_cast<size_t>(k)] =
            fraction == 1 ? high : std::clamp(low * (1 - fraction) + high * fraction, low, high);
        piece /= pieces;
    }
    return result;
}

// Where weights are positive, |A - A*| <= error H w and |w - w*| <= error w, so that quotients of A have an
// error within error H, before that of w is counted; otherwise the same holds with the largest values.
void SplinePieces::begin(int64_t piece, int rows, double norm, double rounding, QuotientPiece &out) const {
    out = QuotientPiece{};
    out.shape = net_.shape();
    out.shape.width = rows;
    const auto count = static_cast<size_t>(out.shape.coefficients());
    out.numerators.assign(count * static_cast<size_t>(rows), 0.0);
    out.denominators.resize(net_.weighted() ? count : 0);
    net_.copy(piece, coordinates_.data(), out.denominators.data());
    const double error = 1.01 * norm * (net_.error() + rounding);
    if (net_.positive()) {
        out.quotient_error = error * net_.size(piece);
        out.denominator_factor = net_.weighted() ? 1.01 * net_.error() : 0;
    } else {
        out.numerator_error = error * net_.largest_record();
        out.denominator_error = 1.01 * net_.error() * net_.largest_weight();
    }
}

void SplinePieces::fill(int64_t piece, int coordinate, double sign, QuotientPiece &out) const {
    begin(piece, 1, 1, 0, out);
    const size_t dim = centre_.size();
    for (size_t i = 0; i < out.numerators.size(); ++i) {
        out.numerators[i] = sign * coordinates_[i * dim + static_cast<size_t>(coordinate)];
    }
}

void SplinePieces::fill(int64_t piece, const double *direction, QuotientPiece &out) const {
    fill(piece, direction, 1, norm(direction, static_cast<int>(centre_.size())), out);
}

void SplinePieces::fill(int64_t piece, const double *matrix, int rows, double norm,
                        QuotientPiece &out) const {
    const size_t dim = centre_.size();
    begin(piece, rows, norm, eps * (static_cast<double>(dim) + 2) * std::sqrt(rows), out);
    double *value = out.numerators.data();
    for (const double *x = coordinates_.data(); value != out.numerators.data() + out.numerators.size();
         x += dim) {
        for (int r = 0; r < rows; ++r, ++value) {
            for (size_t c = 0; c < dim; ++c) {
                *value += matrix[static_cast<size_t>(r) * dim + c] * x[c];
            }
        }
    }
}

} // namespace nrb::pieces
