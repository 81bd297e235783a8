// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/patch_point.h"

#include "bernstein/de_casteljau.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

// The last two steps of de Casteljau's algorithm: the value, which replaces the first `inner` numbers, and
// the derivative as a difference.
void last_steps(int degree, int64_t inner, double t, double *b, double *derivative) {
    for (int level = degree; level > 1; --level) {
        casteljau_step(level * inner, inner, t, b);
    }
    for (int64_t i = 0; i < inner; ++i) {
        derivative[i] = degree > 0 ? degree * (b[i + inner] - b[i]) : 0;
    }
    if (degree > 0) {
        casteljau_step(inner, inner, t, b);
    }
}

} // namespace

void PatchPoint::evaluate(const pieces::BezierPiece &piece, const Place<2> &place) {
    dim_ = piece.dim();
    const int q = piece.degree(1), width = dim_ + 1;
    const int64_t row = int64_t{q + 1} * width;
    records_.assign(piece.record(0), piece.record(piece.coefficients()));
    along_.resize(static_cast<size_t>(row + width));
    last_steps(piece.degree(0), row, place[0], records_.data(), along_.data());
    nrb::evaluate(q, width, place[1], along_.data());
    last_steps(q, width, place[1], records_.data(), along_.data() + row);
    const double *x = records_.data(), w = x[dim_];
    value_.resize(static_cast<size_t>(dim_));
    derivatives_.resize(2 * static_cast<size_t>(dim_));
    std::transform(x, x + dim_, value_.begin(), [w](double a) { return a / w; });
    for (int k = 0; k < 2; ++k) {
        const double *by = along_.data() + (k == 0 ? 0 : row);
        for (int c = 0; c < dim_; ++c) {
            derivatives_[static_cast<size_t>(k * dim_ + c)] =
                (by[c] - value_[static_cast<size_t>(c)] * by[dim_]) / w;
        }
    }
}

} // namespace nrb::intersect
