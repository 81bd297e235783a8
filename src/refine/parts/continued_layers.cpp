// SPDX-License-Identifier: MIT
#include "refine/parts/continued_layers.h"

#include "base/representable.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

// The terms of a row: its coefficients, and values that lie `step` apart.
struct Terms {
    const double *coefficients;
    int size;
    const double *values;
    int64_t step;

    [[nodiscard]] double value(int i) const noexcept { return values[i * step]; }
    [[nodiscard]] double sum() const noexcept {
        double result = 0;
        for (int i = 0; i < size; ++i) {
            result += coefficients[i] * value(i);
        }
        return result;
    }
    [[nodiscard]] double centre() const noexcept { // value with the largest coefficient
        const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
        return value(
            static_cast<int>(std::max_element(coefficients, coefficients + size, less) - coefficients));
    }
};

// The sum of the terms, as the value with the largest coefficient plus differences from it, if the magnitudes
// of these terms are smaller, and thus their rounding errors. Otherwise `plain`, which is the sum as it
// stands.
double centred_sum(const Terms &terms, double plain) noexcept {
    const double centre = terms.centre();
    double rest = 0, size = 0, plain_size = 0;
    for (int i = 0; i < terms.size; ++i) {
        const double term = terms.coefficients[i] * (terms.value(i) - centre);
        rest += term;
        size += std::abs(term);
        plain_size += std::abs(terms.coefficients[i] * terms.value(i));
    }
    return size <= plain_size ? centre + rest : plain;
}

// A table applied to the homogeneous records of a spline.
class ContinuedRecords {
public:
    ContinuedRecords(const Spline &spline, int axis, const LayerTable &table)
        : spline_(spline), table_(table), view_(axis_view(spline, axis, 1)), dim_(spline.dim()),
          sums_(apply_along(records_of(spline), axis, table).points) {
        for_each([this](int64_t to, const LayerTable::Row &row, int64_t from) {
            if (row.size != 0) {
                double &weight = record(to)[dim_];
                weight = centred_sum(
                    terms(row, spline_.records().data() + from * (dim_ + 1) + dim_, dim_ + 1), weight);
            }
        });
    }

    [[nodiscard]] std::vector<double> take() { return std::move(sums_); }

    // The result as Cartesian points and weights.
    [[nodiscard]] ContinuedNet projected() {
        const auto dim = static_cast<size_t>(dim_), records = sums_.size() / (dim + 1);
        ContinuedNet made{{std::vector<double>(records * dim), std::vector<double>(records)}, -1};
        for_each([&](int64_t to, const LayerTable::Row &row, int64_t from) {
            double *point = made.net.points.data() + to * dim_,
                   &weight = made.net.weights[static_cast<size_t>(to)];
            if (row.size == 0) {
                std::copy_n(spline_.points().data() + from * dim_, dim_, point);
                weight = spline_.weight(from);
                return;
            }
            weight = std::ldexp(record(to)[dim_], spline_.records_exponent());
            if (weight != 0) {
                divide(record(to), point);
            } else if (!combine_places(row, from, record(to), point)) {
                made.infinite = to;
            }
        });
        require_representable(made.net.points, "control points");
        require_representable(made.net.weights, "weights");
        return made;
    }

private:
    static Spline records_of(const Spline &spline) {
        return {spline.knot_vectors(),
                spline.width(),
                Form::polynomial,
                std::vector<double>(spline.records().begin(), spline.records().end()),
                {}};
    }

    // f(new control point, row, first old control point of the row)
    template <class F>
    void for_each(F f) const {
        for (int64_t o = 0; o < view_.outer; ++o) {
            for (int64_t r = 0; r < table_.rows(); ++r) {
                const LayerTable::Row &row = table_.row(r);
                for (int64_t i = 0; i < view_.inner; ++i) {
                    f((o * table_.rows() + r) * view_.inner + i, row,
                      (o * view_.count + row.first) * view_.inner + i);
                }
            }
        }
    }

    [[nodiscard]] double *record(int64_t i) noexcept { return sums_.data() + i * (dim_ + 1); }
    // The terms of a row over one component of records of `width` values.
    [[nodiscard]] Terms terms(const LayerTable::Row &row, const double *first, int width) const noexcept {
        return {table_.coefficients(row), row.size, first, view_.inner * width};
    }

    void divide(const double *record, double *point) const noexcept {
        std::transform(record, record + dim_, point, [w = record[dim_]](double x) { return x / w; });
    }

    // For a weight of 0: combines the Cartesian points. Returns whether the record is all zeros, so that any
    // position is right; otherwise it is a point at infinity.
    bool combine_places(const LayerTable::Row &row, int64_t from, const double *record,
                        double *point) const noexcept {
        for (int c = 0; c < dim_; ++c) {
            point[c] = terms(row, spline_.points().data() + from * dim_ + c, dim_).sum();
        }
        return std::all_of(record, record + dim_, [](double x) { return x == 0; });
    }

    const Spline &spline_;
    const LayerTable &table_;
    AxisView view_; // in control points
    int dim_;
    std::vector<double> sums_;
};

} // namespace

ContinuedNet continued_along(const Spline &spline, int axis, const LayerTable &table) {
    if (!spline.rational()) {
        return {apply_along(spline, axis, table), -1};
    }
    ContinuedRecords records(spline, axis, table);
    return spline.form() == Form::homogeneous ? ContinuedNet{{records.take(), {}}, -1} : records.projected();
}

} // namespace nrb::refine
