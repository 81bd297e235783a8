// SPDX-License-Identifier: MIT
#include "refine/knots/blossom.h"

#include "basis/bspline.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <array>

namespace nrb::refine {

namespace {

using Rows = std::array<BlossomRow, max_axes>;

// Arguments still to be used.
class Arguments {
public:
    explicit Arguments(std::span<const double> values) noexcept : size_(static_cast<int>(values.size())) {
        std::copy(values.begin(), values.end(), values_.begin());
    }
    [[nodiscard]] std::span<const double> values() const noexcept {
        return std::span(values_).first(static_cast<size_t>(size_));
    }
    // Whether a knot was among them; if so, it is used up.
    bool take(double knot) noexcept {
        double *const end = values_.data() + size_;
        double *const found = std::find(values_.data(), end, knot);
        if (found == end) {
            return false;
        }
        std::copy(found + 1, end, found);
        --size_;
        return true;
    }

private:
    std::array<double, max_basis> values_{};
    int size_;
};

} // namespace

OpenRow::OpenRow(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept
    : knots_(axis.knots()), begin_(span + 1), end_(span + 1), size_(1) {
    Arguments arguments(values);
    for (bool taken = true; taken;) {
        const bool below = begin_ > 0 && arguments.take(axis[begin_ - 1]);
        const bool above = end_ < std::ssize(knots_) && arguments.take(axis[end_]);
        begin_ -= below ? 1 : 0;
        end_ += above ? 1 : 0;
        taken = below || above;
    }
    coefficients_[0] = 1;
    for (const double t : arguments.values()) {
        append_argument(knots_.data() + begin_, knots_.data() + end_, size_++, t, coefficients_.data());
    }
}

void OpenRow::append_to(const OpenRow &other, double t) noexcept {
    knots_ = other.knots_;
    begin_ = other.begin_;
    end_ = other.end_;
    size_ = other.size_ + 1;
    std::copy_n(other.coefficients_.begin(), other.size_, coefficients_.begin());
    append_argument(knots_.data() + begin_, knots_.data() + end_, other.size_, t, coefficients_.data());
}

BlossomRow blossom_row(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept {
    const OpenRow open(axis, span, values);
    BlossomRow row;
    row.first = open.first();
    row.size = static_cast<int>(open.coefficients().size());
    std::ranges::copy(open.coefficients(), row.coefficients);
    return row;
}

namespace {

Rows rows_at(const Spline &spline, const int64_t *spans, std::span<const double> arguments) noexcept {
    Rows rows;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const auto degree = static_cast<size_t>(spline.axis(k).degree());
        rows[at] = blossom_row(spline.axis(k), spans[k], arguments.first(degree));
        arguments = arguments.subspan(degree);
    }
    return rows;
}

// Component c of control point i, multiplied by its weight where it has one.
double record_value(const Spline &spline, int64_t i, int c) noexcept {
    const double stored =
        c < spline.stored_width() ? spline.points()[static_cast<size_t>(i * spline.stored_width() + c)] : 1;
    return spline.form() == Form::rational ? spline.weight(i) * stored : stored;
}

// The sum over the axes from k on, of the points that begin at `base`: the last axis first.
double sum(const Spline &spline, const Rows &rows, int k, int64_t base, int c) noexcept {
    if (k == spline.axes()) {
        return record_value(spline, base, c);
    }
    const BlossomRow &row = rows[static_cast<size_t>(k)];
    double result = 0;
    for (int i = 0; i < row.size; ++i) {
        const int64_t next = base * spline.count(k) + row.first + i;
        result += row.coefficients[i] * sum(spline, rows, k + 1, next, c);
    }
    return result;
}

} // namespace

void blossom(const Spline &spline, const int64_t *spans, std::span<const double> arguments, double *out) {
    const Rows rows = rows_at(spline, spans, arguments);
    for (int c = 0; c < spline.width(); ++c) {
        out[c] = sum(spline, rows, 0, 0, c);
    }
}

} // namespace nrb::refine
