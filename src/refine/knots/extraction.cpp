// SPDX-License-Identifier: MIT
#include "refine/knots/extraction.h"

#include "basis/bspline.h"

#include <algorithm>

namespace nrb::refine {

namespace {

// One step of raise_degree() of basis/bspline.h.
void raise(const double *knots, int d, int64_t span, double t, double *values) noexcept {
    raise_degree(knots, d, span, t, values);
}
void raise(const double *knots, int d, int64_t span, double t, DoubleDouble *values) noexcept {
    DoubleDouble carried;
    for (int r = 0; r < d; ++r) {
        const double left = knots[span + 1 - d + r], right = knots[span + 1 + r];
        const DoubleDouble length = DoubleDouble::sum(right, -left);
        const DoubleDouble value = values[r];
        const DoubleDouble part = value * (DoubleDouble::sum(t, -left) / length);
        values[r] = carried + (value - part);
        carried = part;
    }
    values[d] = carried;
}

template <class Number>
void extract(const double *knots, int degree, int64_t span, Number *matrix) noexcept {
    Number starts[max_basis] = {1}; // coefficients at `count` times the start of the span
    for (int count = 0; count <= degree; ++count) {
        Number column[max_basis];
        std::copy_n(starts, count + 1, column);
        for (int d = count + 1; d <= degree; ++d) {
            raise(knots, d, span, knots[span + 1], column);
        }
        for (int j = 0; j <= degree; ++j) {
            matrix[j * (degree + 1) + degree - count] = column[j];
        }
        if (count < degree) {
            raise(knots, count + 1, span, knots[span], starts);
        }
    }
}

} // namespace

void bezier_extraction(const double *knots, int degree, int64_t span, double *matrix) noexcept {
    extract(knots, degree, span, matrix);
}

void bezier_extraction(const double *knots, int degree, int64_t span, DoubleDouble *matrix) noexcept {
    extract(knots, degree, span, matrix);
}

void bezier_extraction(const KnotVector &axis, double *matrices, int64_t *firsts, double *domains) {
    const int64_t size = int64_t{axis.degree() + 1} * (axis.degree() + 1);
    for (const int64_t span : axis.spans().indices()) {
        if (matrices != nullptr) {
            bezier_extraction(axis.knots().data(), axis.degree(), span, matrices);
            matrices += size;
        }
        if (firsts != nullptr) {
            *firsts++ = span - axis.degree();
        }
        if (domains != nullptr) {
            *domains++ = axis[span];
            *domains++ = axis[span + 1];
        }
    }
}

} // namespace nrb::refine
