// SPDX-License-Identifier: MIT
#include "closest/patch/patch_item.h"

#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

constexpr double smallest_weight = 0x1p-200; // the squares of smaller weights come near underflow

} // namespace

// The product w x, the difference A - w x and the earlier difference of x and the centre are rounded: errors
// of eps / 2 relative to |x - c| each, and relative to the result.
PatchItems::PatchItems(const PieceGrid &pieces, const double *point, PatchMemory &memory)
    : pieces_(pieces), memory_(memory), x_(memory.take(pieces.shape().lanes)),
      kept_(pieces.shape().values() <= small_piece ? most_kept : 1),
      values_(memory.take(kept_ * pieces.shape().values())) {
    pieces.place(point, x_);
    moved_ = pieces.moved() + 2 * eps * (norm(x_, pieces.shape().dim) + pieces.radius());
}

bool PatchItems::far_away() const noexcept {
    return !(norm(x_, pieces_.shape().dim) < 0x1p100);
}

const double *PatchItems::values(int64_t piece) const {
    const PatchShape &shape = pieces_.shape();
    const int64_t *const found = std::find(made_.data(), made_.data() + kept_, piece);
    if (found != made_.data() + kept_) {
        return values_ + (found - made_.data()) * shape.values();
    }
    const PatchMemory::Hold hold(memory_);
    double *work = memory_.take(shape.values()), *patch = memory_.take(shape.values());
    double *values = values_ + next_ * shape.values();
    pieces_.patch(piece, work, patch);
    shift_patch(shape, patch, x_, values);
    made_[static_cast<size_t>(next_)] = piece;
    next_ = (next_ + 1) % kept_;
    return values;
}

PatchItem PatchItems::whole(int64_t piece) const {
    PatchItem item;
    item.values = memory_.take(pieces_.shape().values());
    std::copy_n(values(piece), pieces_.shape().values(), item.values);
    item.piece = piece;
    item.moved = moved_;
    return item;
}

// The factors of the matrix are products of `degree` rounded numbers, and the sums have degree + 1 terms: an
// error of 2 degree eps relative to the mean of the magnitudes, for the point and for the weight.
PatchItem PatchItems::part(const PatchItem &item, int axis, double lower, double upper,
                           const double *matrix) const {
    const auto at = static_cast<size_t>(axis);
    PatchItem result = item;
    result.values = memory_.take(pieces_.shape().values());
    apply_matrix(pieces_.shape(), axis, matrix, item.values, result.values);
    result.lower[at] = item.to_piece(axis, lower);
    result.length[at] = item.length[at] * (upper - lower);
    result.moved +=
        (pieces_.shape().weighted ? 4 : 2) * (pieces_.shape().degree(axis) + 1) * eps * item.reach;
    return result;
}

PatchItem PatchItems::part(const PatchItem &item, int axis, double lower, double upper) const {
    double matrix[(max_degree + 1) * (max_degree + 1)];
    pieces::part_matrix(pieces_.shape().degree(axis), lower, upper, matrix);
    return part(item, axis, lower, upper, matrix);
}

// Halving takes `degree` successive means, each with an error of eps / 2 relative to the mean of the
// magnitudes, for the point and for the weight.
PatchItem PatchItems::halve_item(PatchItem &item, int axis) const {
    const PatchShape &shape = pieces_.shape();
    const auto at = static_cast<size_t>(axis);
    BernsteinShape net{{}, shape.lanes};
    std::copy_n(shape.degrees.begin(), shape.axes, net.degrees.begin());
    item.moved += (shape.weighted ? 1.02 : 0.51) * shape.degree(axis) * eps * item.reach;
    item.length[at] /= 2;
    ++item.depth;
    PatchItem lower = item;
    lower.values = memory_.take(shape.values());
    halve(net, axis, item.values, lower.values);
    item.lower[at] += item.length[at];
    return lower;
}

void PatchItems::measure(PatchItem &item) const noexcept {
    switch (pieces_.shape().dim) {
    case 2:
        return measure<2>(item);
    case 3:
        return measure<3>(item);
    default:
        return measure<-1>(item);
    }
}

// kDim < 0: any number of coordinates.
template <int kDim>
void PatchItems::measure(PatchItem &item) const noexcept {
    const PatchShape &shape = pieces_.shape();
    const int64_t count = shape.coefficients();
    const int dim = kDim < 0 ? shape.dim : kDim;
    const double *q = item.values;
    double least = infinity, most = 0, square = 0, quotient = 0;
    bool negative = false;
    for (int64_t i = 0; i < count; ++i, q += shape.lanes) {
        double sum = q[0] * q[0];
        for (int c = 1; c < dim; ++c) {
            sum += q[c] * q[c];
        }
        const double w = q[dim];
        square = std::max(square, sum);
        if (!(w > 0)) {
            if (w == 0 && sum == 0 && pieces_.positive()) {
                continue;
            }
            negative = true;
        }
        least = std::min(least, w);
        most = std::max(most, w);
    }
    item.sound = !negative && least >= smallest_weight && std::isfinite(square);
    if (!item.sound) {
        return;
    }
    if (most > 2 * least) {
        q = item.values;
        for (int64_t i = 0; i < count; ++i, q += shape.lanes) {
            const double w = q[shape.dim];
            quotient = w > 0 ? std::max(quotient, norm(q, shape.dim) / w) : quotient;
        }
        item.reach = quotient * (1 + 8 * eps);
    } else {
        item.reach = std::sqrt(square) / least * (1 + (shape.dim + 8) * eps);
    }
    item.least_weight = least;
    item.most_weight = most;
    if (!pieces_.positive()) { // errors of records, weights and halving relative to the least weight
        const double reach = item.reach + norm(x_, shape.dim);
        item.sound = pieces_.rounding().positive(least);
        item.moved = std::max(item.moved, pieces_.moved_by_weights(reach, least, item.depth));
    }
}

int longest_axis(const PatchShape &shape, const PatchItem &item) noexcept {
    int longest = -1;
    double most = -1;
    int64_t step = shape.lanes;
    for (int k = shape.axes; k-- > 0; step *= shape.degree(k) + 1) {
        double spread = 0;
        const int64_t period = step * (shape.degree(k) + 1);
        for (int64_t i = 0; i < shape.values(); i += shape.lanes) {
            const double *q = item.values + i;
            const double w = q[shape.dim], other = i % period + step < period ? q[step + shape.dim] : 0;
            if (w > 0 && other > 0) {
                spread += norm_of(shape.dim, [&](int c) { return q[c] / w - q[step + c] / other; });
            }
        }
        spread *= 1 + 1.0 / shape.degree(k);
        if (spread > most) {
            most = spread;
            longest = k;
        }
    }
    return longest;
}

} // namespace nrb::closest
