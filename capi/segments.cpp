// SPDX-License-Identifier: MIT
// Cubic Hermite curves, and the matrices that change the basis of a polynomial segment.
#include "base/checked.h"
#include "basis/basis_matrix.h"
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "refine/forms/hermite.h"

#include <algorithm>
#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

SegmentBasis basis_of(int32_t value, const char *name) {
    if (value < NURBS_BASIS_POWER || value > NURBS_BASIS_BSPLINE) {
        fail(Status::basis, "%s = %d, expected one of the NURBS_BASIS_ constants", name, value);
    }
    return static_cast<SegmentBasis>(value);
}

void check_matrix_degree(int32_t degree, SegmentBasis from, SegmentBasis to) {
    if (degree < 0 || degree > max_matrix_degree) {
        fail(Status::degree, "degree = %d, expected 0 to %d", degree, max_matrix_degree);
    }
    if (degree % 2 == 0 && (from == SegmentBasis::hermite || to == SegmentBasis::hermite)) {
        fail(Status::degree, "degree = %d, expected an odd one for a Hermite basis", degree);
    }
}

void check_rising(const double *params, int64_t n) {
    for (int64_t i = 0; i < n; ++i) {
        if (!std::isfinite(params[i])) {
            fail(Status::parameter_not_finite, "params[%lld] = %s is not finite", static_cast<long long>(i),
                 Number(params[i]).text);
        }
        if (i > 0 && !(params[i] > params[i - 1])) {
            fail(Status::knots_decreasing, "params[%lld] = %s, expected more than params[%lld] = %s",
                 static_cast<long long>(i), Number(params[i]).text, static_cast<long long>(i - 1),
                 Number(params[i - 1]).text);
        }
    }
}

// The knots of a C^1 cubic: both ends have multiplicity 4, all other parameters multiplicity 2.
std::vector<double> hermite_knots(const double *params, int64_t n) {
    std::vector<double> knots(2, params[0]);
    for (int64_t i = 0; i < n; ++i) {
        knots.insert(knots.end(), 2, params[i]);
    }
    knots.insert(knots.end(), 2, params[n - 1]);
    return knots;
}

void check_finite(const ConstRecords &records, const char *name) {
    for (int64_t i = 0; i < records.count; ++i) {
        for (int64_t c = 0; c < records.width; ++c) {
            if (!std::isfinite(records(i, c))) {
                fail(Status::point_not_finite, "%s[%lld][%lld] = %s is not finite", name,
                     static_cast<long long>(i), static_cast<long long>(c), Number(records(i, c)).text);
            }
        }
    }
}

// Component c of the Bezier point next to point P on one side of it: P + side * h T / 3, where T is the
// tangent at P, h the length of the span on that side, and side = -1 or 1.
double beside(const ConstRecords &points, const ConstRecords &tangents, int64_t i, int64_t c, double h,
              int side) {
    const double result = points(i, c) + side * (h * tangents(i, c)) / 3;
    if (!std::isfinite(result)) {
        const auto at = static_cast<long long>(i), in = static_cast<long long>(c);
        fail(Status::not_representable,
             "points[%lld][%lld] %c tangents[%lld][%lld] * %s / 3 = %s %c %s * %s / 3 overflows", at, in,
             side < 0 ? '-' : '+', at, in, Number(h).text, Number(points(i, c)).text, side < 0 ? '-' : '+',
             Number(tangents(i, c)).text, Number(h).text);
    }
    return result;
}

// The control points, two for each point: the Bezier points before and after it. At an end of the curve the
// point itself takes the place of the one that is missing.
std::vector<double> hermite_points(const double *params, const ConstRecords &points,
                                   const ConstRecords &tangents) {
    const int64_t n = points.count, dim = points.width;
    std::vector<double> result;
    result.reserve(static_cast<size_t>(2 * n * dim));
    for (int64_t i = 0; i < n; ++i) {
        for (const int side : {-1, 1}) {
            const bool outer = side < 0 ? i == 0 : i == n - 1;
            const double h = outer ? 0 : side < 0 ? params[i] - params[i - 1] : params[i + 1] - params[i];
            for (int64_t c = 0; c < dim; ++c) {
                result.push_back(outer ? points(i, c) : beside(points, tangents, i, c, h, side));
            }
        }
    }
    return result;
}

} // namespace

nurbs_status nurbs_create_hermite(int64_t n, const double *params, int32_t dim, const double *points,
                                  int64_t point_stride, int64_t point_component_stride,
                                  const double *tangents, int64_t tangent_stride,
                                  int64_t tangent_component_stride, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_at_least(n, 2, "n");
        if (dim < 1) {
            fail(Status::dimension, "dim = %d, expected at least 1", dim);
        }
        require(params, "params");
        checked_product(checked_product(n, 2, "points"), dim, "points");
        const ConstRecords values = input("points", points, n, dim, point_stride, point_component_stride);
        const ConstRecords slopes =
            input("tangents", tangents, n, dim, tangent_stride, tangent_component_stride);
        check_rising(params, n);
        check_finite(values, "points");
        check_finite(slopes, "tangents");
        Spline::Axes axes{make_knot_vector(3, hermite_knots(params, n))};
        give(make_spline(std::move(axes), dim, Form::polynomial, hermite_points(params, values, slopes)),
             out);
    });
}

nurbs_status nurbs_to_hermite(const nurbs *g, int64_t cap, double *params, double *points, double *tangents,
                              int64_t *count) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        const int64_t n = curve.axis(0).spans().size() + 1;
        const int64_t filled = checked_cap(cap, n), values = checked_product(filled, curve.dim(), "points");
        check_apart({memory("params", params, filled), memory("points", points, values),
                     memory("tangents", tangents, values), memory("count", count, 1)},
                    {});
        const refine::HermiteData data = refine::hermite_data(g->spline); // also if cap is 0, for its errors
        if (cap != 0) {
            put_all(params, data.params);
            put_all(points, data.points);
            put_all(tangents, data.tangents);
        }
        put(count, n);
    });
}

nurbs_status nurbs_basis_matrix(int32_t from, int32_t to, int32_t degree, int64_t size, double *matrix) {
    return guard([&] {
        const SegmentBasis first = basis_of(from, "from"), second = basis_of(to, "to");
        check_matrix_degree(degree, first, second);
        check_size(size, (int64_t{degree} + 1) * (degree + 1), "size");
        require(matrix, "matrix");
        basis_matrix(first, second, degree, matrix);
    });
}
