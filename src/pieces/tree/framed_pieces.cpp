// SPDX-License-Identifier: MIT
#include "pieces/tree/framed_pieces.h"

#include "base/numbers.h"
#include "numeric/norm.h"

#include <array>
#include <cmath>

namespace nrb::pieces {

FramedPieces::FramedPieces(const PieceTree &tree, const Frame &frame)
    : tree_(tree), exponent_(tree.grid().frame().exponent - frame.exponent) {
    const std::vector<double> &centre = tree.grid().frame().centre;
    for (size_t c = 0; c < centre.size(); ++c) {
        shift_.push_back(frame.difference(centre[c], frame.centre[c]));
    }
    const PatchShape &shape = tree.grid().shape();
    shape_.width = shape.dim + 1;
    for (int k = 0; k < shape.axes; ++k) {
        const auto axis =
            static_cast<size_t>(max_axes - tree.grid().spline_axes() + tree.grid().spline_axis(k));
        shape_.degrees[axis] = shape.degree(k);
    }
    set_rounding();
}

// A 2^exponent + w shift has one more rounding in w shift, in the sum and in the shift itself. Where errors
// are not relative to the weights, which are below 2, the error of w is multiplied by the shift; that of a
// record is at least eps times the largest record.
void FramedPieces::set_rounding() noexcept {
    const PieceGrid &grid = tree_.grid();
    const Rounding &own = grid.rounding();
    const double shift = norm(shift_.data(), dim()), radius = times_power_of_two(grid.radius(), exponent_);
    if (own.relative()) {
        rounding_.apart = times_power_of_two(own.apart, exponent_) + 2 * eps * (shift + radius);
        moved_ = rounding_.apart + 4 * eps * (shift + radius);
        return;
    }
    rounding_.record = 2 * times_power_of_two(own.record, exponent_) + (own.weight + 4 * eps) * shift;
    rounding_.weight = own.weight;
}

void FramedPieces::box(int level, int64_t node, double *out) const {
    tree_.box(level, node, out);
    move(out);
}

void FramedPieces::disc_box(int level, int64_t node, int64_t i, double *out) const noexcept {
    tree_.disc_box(level, node, i, out);
    move(out);
}

void FramedPieces::move(double *box) const noexcept {
    for (int c = 0; c < dim(); ++c) {
        const double shift = shift_[static_cast<size_t>(c)];
        double &low = box[c], &high = box[dim() + c];
        low = times_power_of_two(low, exponent_) + shift;
        high = times_power_of_two(high, exponent_) + shift;
        low -= 2 * eps * (std::abs(low) + std::abs(shift));
        high += 2 * eps * (std::abs(high) + std::abs(shift));
    }
}

BezierPiece FramedPieces::piece(int64_t index) const {
    const PieceGrid &grid = tree_.grid();
    const auto size = static_cast<size_t>(grid.shape().values());
    std::array<double, 256> local; // enough for most pieces; many are computed at a time
    std::vector<double> large(2 * size <= local.size() ? 0 : 2 * size), values;
    double *const patch = large.empty() ? local.data() : large.data();
    grid.patch(index, patch + size, patch);
    values.reserve(
        static_cast<size_t>(2 * shape_.values() + 2 * dim())); // also for the control points and the box
    for (const double *record = patch; record < patch + size; record += grid.shape().lanes) {
        const double w = record[dim()];
        for (int c = 0; c < dim(); ++c) {
            values.push_back(times_power_of_two(record[c], exponent_) + w * shift_[static_cast<size_t>(c)]);
        }
        values.push_back(w);
    }
    return {grid.spline_axes(), shape_, std::move(values), grid.part(index), rounding_};
}

} // namespace nrb::pieces
