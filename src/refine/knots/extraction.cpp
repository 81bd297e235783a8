// SPDX-License-Identifier: MIT
#include "refine/knots/extraction.h"

#include "basis/bspline.h"

#include <algorithm>

namespace nrb::refine {

namespace {

// Steps of raise_degree() (basis/bspline.h) with one argument t, for all degrees d up to that of an axis.
class Steps {
public:
    Steps(const double *knots, int /* degree */, int64_t span, double t) noexcept
        : knots_(knots), span_(span), t_(t) {}
    void raise(int d, double *values) const noexcept { raise_degree(knots_, d, span_, t_, values); }

private:
    const double *knots_;
    int64_t span_;
    double t_;
};

// The same in double-double arithmetic. Divisions take most of the time, so each quotient is computed only
// once, and those that are 0 or 1 because t is a knot not at all.
class PreciseSteps {
public:
    PreciseSteps(const double *knots, int degree, int64_t span, double t) noexcept {
        for (int d = 1; d <= degree; ++d) {
            for (int r = 0; r < d; ++r) {
                const double left = knots[span + 1 - d + r], right = knots[span + 1 + r];
                set(place(d, r), t == left ? DoubleDouble(0)
                                 : t == right
                                     ? DoubleDouble(1)
                                     : DoubleDouble::sum(t, -left) / DoubleDouble::sum(right, -left));
            }
        }
    }
    void raise(int d, DoubleDouble *values) const noexcept {
        DoubleDouble carried;
        for (int r = 0; r < d; ++r) {
            const DoubleDouble value = values[r];
            const size_t at = place(d, r);
            const DoubleDouble part = value * DoubleDouble(high_[at], low_[at]);
            values[r] = carried + (value - part);
            carried = part;
        }
        values[d] = carried;
    }

private:
    static constexpr size_t most = max_degree * (max_degree + 1) / 2;
    static size_t place(int d, int r) noexcept { return static_cast<size_t>(d * (d - 1) / 2 + r); }
    void set(size_t at, const DoubleDouble &share) noexcept {
        high_[at] = share.high;
        low_[at] = share.low;
    }

    // The quotient (t - left) / (right - left) for each degree and function; only those up to `degree` are
    // set.
    double high_[most], low_[most];
};

template <class Number, class StepsOf>
void extract(const double *knots, int degree, int64_t span, Number *matrix) noexcept {
    const StepsOf to_start(knots, degree, span, knots[span]), to_end(knots, degree, span, knots[span + 1]);
    Number starts[max_basis] = {1}; // the polar form at `count` times the start of the span
    for (int count = 0; count <= degree; ++count) {
        Number column[max_basis];
        std::copy_n(starts, count + 1, column);
        for (int d = count + 1; d <= degree; ++d) {
            to_end.raise(d, column);
        }
        for (int j = 0; j <= degree; ++j) {
            matrix[j * (degree + 1) + degree - count] = column[j];
        }
        if (count < degree) {
            to_start.raise(count + 1, starts);
        }
    }
}

} // namespace

void bezier_extraction(const double *knots, int degree, int64_t span, double *matrix) noexcept {
    extract<double, Steps>(knots, degree, span, matrix);
}

void bezier_extraction(const double *knots, int degree, int64_t span, DoubleDouble *matrix) noexcept {
    extract<DoubleDouble, PreciseSteps>(knots, degree, span, matrix);
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
