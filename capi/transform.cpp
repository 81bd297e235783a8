// SPDX-License-Identifier: MIT
// Affine and projective maps.
#include "refine/forms/transform.h"

#include "base/checked.h"
#include "checks.h"
#include "guard.h"

#include <cmath>
#include <limits>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_out_dim(int32_t out_dim) {
    constexpr int32_t limit = std::numeric_limits<int32_t>::max() - 1;
    if (out_dim < 1 || out_dim > limit) {
        fail(Status::dimension, "out_dim = %d, expected 1 to %d", out_dim, limit);
    }
}

void check_matrix(const double *matrix, int64_t rows, int64_t columns) {
    require(matrix, "matrix");
    const int64_t size = checked_product(rows, columns, "matrix");
    for (int64_t i = 0; i < size; ++i) {
        if (!std::isfinite(matrix[i])) {
            fail(Status::matrix, "matrix[%lld][%lld] = %s is not finite", static_cast<long long>(i / columns),
                 static_cast<long long>(i % columns), Number(matrix[i]).text);
        }
    }
}

void check_translation(const double *translation, int32_t out_dim) {
    for (int32_t i = 0; translation != nullptr && i < out_dim; ++i) {
        if (!std::isfinite(translation[i])) {
            fail(Status::matrix, "translation[%d] = %s is not finite", i, Number(translation[i]).text);
        }
    }
}

} // namespace

nurbs_status nurbs_transform(const nurbs *g, int32_t out_dim, const double *matrix, const double *translation,
                             nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_out_dim(out_dim);
        check_matrix(matrix, out_dim, spline.dim());
        check_translation(translation, out_dim);
        give(refine::transform(spline, {out_dim, spline.dim(), matrix}, translation), out);
    });
}

nurbs_status nurbs_transform_projective(const nurbs *g, int32_t out_dim, const double *matrix, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_out_dim(out_dim);
        check_matrix(matrix, int64_t{out_dim} + 1, int64_t{spline.dim()} + 1);
        give(refine::transform_projective(spline, {out_dim + 1, spline.dim() + 1, matrix}), out);
    });
}
