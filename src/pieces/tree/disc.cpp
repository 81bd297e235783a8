// SPDX-License-Identifier: MIT
#include "pieces/tree/disc.h"

#include "base/numbers.h"
#include "numeric/norm.h"
#include "pieces/tree/patch_kernel.h"

#include <algorithm>
#include <cmath>

namespace nrb::pieces {

namespace {

void cross_product(const double *a, const double *b, double *out) noexcept {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

// Calls visit(point, weight, moved) for the homogeneous control points, where `moved` bounds the effect of
// absolute rounding errors; false if some points are not bounded. Where the errors are relative to the
// weights, control points of weight 0 do not count.
template <class Visit>
bool for_points(const PieceGrid &pieces, const double *patch, Visit &&visit) noexcept {
    const PatchShape &shape = pieces.shape();
    bool bounded = true;
    for (int64_t i = 0; i < shape.coefficients(); ++i, patch += shape.lanes) {
        const double w = patch[shape.dim];
        if (pieces.rounding().positive(w)) {
            visit(patch, w, pieces.positive() ? 0 : pieces.moved_by_weights(norm(patch, shape.dim) / w, w));
        } else if (!(pieces.positive() && w == 0)) {
            bounded = false;
        }
    }
    return bounded;
}

} // namespace

Disc::Disc(const PatchShape &shape, const double *patch, bool with_normal) {
    std::vector<double> work(static_cast<size_t>(evaluation_work(shape)) + 1),
        jet(static_cast<size_t>(4 * shape.lanes));
    evaluate_patch(shape, patch, {0.5, 0.5, 0.5}, with_normal ? 1 : 0, work.data(), jet.data());
    const double w = jet[static_cast<size_t>(shape.dim)];
    for (int c = 0; c < shape.dim; ++c) {
        const double x = jet[static_cast<size_t>(c)] / w;
        centre.push_back(std::isfinite(x) ? std::clamp(x, -far_away, far_away) : 0.0);
    }
    if (with_normal) {
        set_normal(shape, jet.data());
    }
}

void Disc::set_normal(const PatchShape &shape, const double *jet) noexcept {
    double tangents[2][3];
    for (int k = 0; k < 2; ++k) {
        const double *d = jet + static_cast<ptrdiff_t>((k + 1) * shape.lanes);
        for (int c = 0; c < 3; ++c) {
            tangents[k][c] = d[c] - d[3] * centre[static_cast<size_t>(c)];
        }
    }
    double n[3];
    cross_product(tangents[0], tangents[1], n);
    const double length = std::hypot(n[0], n[1], n[2]) * (1 + 4 * eps);
    if (length > 0x1p-400 && std::isfinite(length)) {
        for (size_t c = 0; c < 3; ++c) {
            normal[c] = n[c] / length;
        }
    }
}

// The normal is shortened first, so that rounding does not make it longer than 1.
void Disc::make_single() noexcept {
    for (double &x : centre) {
        x = static_cast<float>(x);
    }
    for (double &x : normal) {
        x = static_cast<float>(x * (1 - 0x1p-22));
    }
}

// The difference under the square root may cancel; a term that bounds the loss is added back.
void Disc::add_point(int dim, const double *point, double weight, double moved) noexcept {
    double square = 0, height = 0;
    for (int c = 0; c < dim; ++c) {
        const double delta = point[c] / weight - centre[static_cast<size_t>(c)];
        square += delta * delta;
        height += dim == 3 ? delta * normal[static_cast<size_t>(c)] : 0.0;
    }
    const double across = std::max(0.0, square - height * height) + (dim + 8) * eps * square;
    radius = std::max(radius, std::sqrt(across) + moved);
    low = std::min(low, height - moved);
    high = std::max(high, height + moved);
}

void Disc::add(const PieceGrid &pieces, const double *patch) noexcept {
    const bool bounded = for_points(pieces, patch, [&](const double *point, double weight, double moved) {
        add_point(pieces.shape().dim, point, weight, moved);
    });
    if (!(bounded && radius < unbounded)) {
        radius = unbounded;
        low = -unbounded;
        high = unbounded;
    }
}

void add_to_box(const PieceGrid &pieces, const double *patch, double *box) noexcept {
    const int dim = pieces.shape().dim;
    const bool bounded = for_points(pieces, patch, [&](const double *point, double weight, double moved) {
        for (int c = 0; c < dim; ++c) {
            const double x = point[c] / weight;
            box[c] = std::min(box[c], x - moved);
            box[dim + c] = std::max(box[dim + c], x + moved);
        }
    });
    if (!bounded) {
        std::fill_n(box, dim, -infinity);
        std::fill_n(box + dim, dim, infinity);
    }
}

} // namespace nrb::pieces
