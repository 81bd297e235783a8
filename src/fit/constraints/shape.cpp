// SPDX-License-Identifier: MIT
#include "fit/constraints/shape.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::fit {

namespace {

using Shape = ShapeWishes;

bool bends(int shape) noexcept {
    return (shape & (Shape::convex | Shape::concave)) != 0;
}

// The knot distance by which the difference of control points j and j + 1 has to be divided to give a slope,
// up to the degree.
double slope_length(const KnotVector &axis, int64_t j) noexcept {
    return axis[j + axis.degree() + 1] - axis[j + 1];
}

void check_bending(const KnotVector &axis, size_t k) {
    if (axis.degree() < 1) {
        fail(Status::order, "shapes: a convex axis %zu needs at least degree 1", k);
    }
    for (int64_t j = 0; j < axis.count() - 1; ++j) {
        if (!(slope_length(axis, j) > 0)) {
            fail(Status::multiplicity,
                 "shapes: axis %zu may jump at the knot %s of multiplicity degree + 1, which no convex or "
                 "concave axis does",
                 k, Number(axis[j + 1]).text);
        }
    }
}

void check_along(const KnotVector &axis, size_t k, int c, int shape) {
    const int all = Shape::rising | Shape::falling | Shape::convex | Shape::concave;
    const auto both = [shape](int bits) { return (shape & bits) == bits; };
    if ((shape & ~all) != 0 || both(Shape::rising | Shape::falling) || both(Shape::convex | Shape::concave)) {
        fail(Status::rule,
             "shapes[%zu][%d] = %d, expected a sum of NURBS_TREND_ constants without opposite ones", k, c,
             shape);
    }
    if (shape != 0 && axis.periodic()) {
        fail(Status::rule, "shapes[%zu][%d] = %d, expected 0: the axis is periodic", k, c, shape);
    }
    if (bends(shape)) {
        check_bending(axis, k);
    }
}

double bound(const std::vector<double> &bounds, int c, double none) noexcept {
    return bounds.empty() ? none : bounds[static_cast<size_t>(c)];
}

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

void check_shape(const std::vector<KnotVectorPtr> &axes, int dim, const ShapeWishes &wishes) {
    for (size_t k = 0; k < axes.size() && !wishes.along.empty(); ++k) {
        for (int c = 0; c < dim; ++c) {
            check_along(*axes[k], k, c, wishes.along[k * static_cast<size_t>(dim) + static_cast<size_t>(c)]);
        }
    }
    for (int c = 0; c < dim; ++c) {
        const double lower = bound(wishes.lower, c, -infinity), upper = bound(wishes.upper, c, infinity);
        if (!(lower <= upper && lower < infinity && upper > -infinity)) {
            fail(Status::contradiction, "lower[%d] = %s, upper[%d] = %s: no number lies between them", c,
                 Number(lower).text, c, Number(upper).text);
        }
    }
}

Index shape_reach(const std::vector<KnotVectorPtr> &axes, const ShapeWishes &wishes) {
    Index reach{};
    const size_t dim = wishes.along.size() / axes.size();
    for (size_t i = 0; i < wishes.along.size(); ++i) {
        const int64_t needed = bends(wishes.along[i]) ? 2 : wishes.along[i] != 0 ? 1 : 0;
        reach[i / dim] = std::max(reach[i / dim], needed);
    }
    return reach;
}

CoordinateShape::CoordinateShape(const std::vector<KnotVectorPtr> &axes, int dim, const ShapeWishes &wishes,
                                 int coordinate)
    : axes_(axes), along_(axes.size(), 0), lower_(bound(wishes.lower, coordinate, -infinity)),
      upper_(bound(wishes.upper, coordinate, infinity)) {
    for (size_t k = 0; k < axes.size(); ++k) {
        counts_[k] = axes[k]->distinct_layers();
        if (!wishes.along.empty()) {
            along_[k] = wishes.along[k * static_cast<size_t>(dim) + static_cast<size_t>(coordinate)];
        }
    }
}

bool CoordinateShape::empty() const noexcept {
    return lower_ == -infinity && upper_ == infinity &&
           std::ranges::all_of(along_, [](int shape) { return shape == 0; });
}

int64_t CoordinateShape::number(const Index &layer) const noexcept {
    return (layer[0] * counts_[1] + layer[1]) * counts_[2] + layer[2];
}

template <class Visit>
void CoordinateShape::for_each_run(size_t axis, int64_t layers, Visit &&visit) const {
    Index counts = counts_;
    counts[axis] = std::max<int64_t>(0, counts[axis] - layers + 1);
    for_each_index({}, counts, visit);
}

void CoordinateShape::add_row(size_t axis, const Index &first, const std::vector<double> &values,
                              double least, std::vector<LinearRow> &rows) const {
    LinearRow row{{}, {least}};
    Index layer = first;
    for (const double value : values) {
        row.coefficients.push_back({layer, number(layer), value});
        ++layer[axis];
    }
    rows.push_back(std::move(row));
}

std::vector<LinearRow> CoordinateShape::rows(double margin, double limit) const {
    std::vector<LinearRow> rows;
    for (size_t k = 0; k < axes_.size(); ++k) {
        if (const double sign = (along_[k] & Shape::rising) != 0    ? 1
                                : (along_[k] & Shape::falling) != 0 ? -1
                                                                    : 0;
            sign != 0) {
            for_each_run(k, 2, [&](const Index &i) { add_row(k, i, {-sign, sign}, 0, rows); });
        }
        if (bends(along_[k])) {
            const double sign = (along_[k] & Shape::convex) != 0 ? 1 : -1;
            for_each_run(k, 3, [&](const Index &i) {
                // The difference of the slopes, times both lengths and relative to the sum of these.
                const double before = slope_length(*axes_[k], i[k]),
                             after = slope_length(*axes_[k], i[k] + 1), part = after / (before + after);
                add_row(k, i, {sign * part, -sign, sign * (1 - part)}, margin, rows);
            });
        }
    }
    for_each_index({}, counts_, [&](const Index &i) {
        if (lower_ > -infinity && std::abs(lower_) <= limit) {
            add_row(0, i, {1}, lower_, rows);
        }
        if (upper_ < infinity && std::abs(upper_) <= limit) {
            add_row(0, i, {-1}, -upper_, rows);
        }
    });
    return rows;
}

void CoordinateShape::settle(std::vector<double> &points) const {
    for (size_t k = 0; k < axes_.size(); ++k) {
        const bool falls = (along_[k] & Shape::falling) != 0;
        if (!falls && (along_[k] & Shape::rising) == 0) {
            continue;
        }
        for_each_run(k, 2, [&](Index i) { // in the order of the layers
            const double before = points[static_cast<size_t>(number(i))];
            ++i[k];
            double &after = points[static_cast<size_t>(number(i))];
            after = falls ? std::min(before, after) : std::max(before, after);
        });
    }
    for (double &point : points) {
        point = std::clamp(point, lower_, upper_);
    }
}

// The sign of (c2 - c1) h0 - (c1 - c0) h1, the differences exact and the products in double-double precision.
bool CoordinateShape::is_convex(size_t axis, const Index &first, int64_t step,
                                const std::vector<double> &points) const {
    constexpr double rounding = 0x1p-90;
    const KnotVector &knots = *axes_[axis];
    const auto length = [&](int64_t j) {
        return DoubleDouble::sum(knots[j + knots.degree() + 1], -knots[j + 1]);
    };
    const auto at = static_cast<size_t>(number(first)), by = static_cast<size_t>(step);
    const DoubleDouble after = DoubleDouble::sum(points[at + 2 * by], -points[at + by]) * length(first[axis]),
                       before = DoubleDouble::sum(points[at + by], -points[at]) * length(first[axis] + 1);
    const DoubleDouble bend = (along_[axis] & Shape::convex) != 0 ? after - before : before - after;
    return bend.high >= rounding * (std::abs(after.high) + std::abs(before.high));
}

bool CoordinateShape::holds(const std::vector<double> &points) const {
    bool all = std::ranges::all_of(points, [&](double x) { return x >= lower_ && x <= upper_; });
    for (size_t k = 0; k < axes_.size(); ++k) {
        const int64_t step = k == 0 ? counts_[1] * counts_[2] : k == 1 ? counts_[2] : 1;
        if ((along_[k] & (Shape::rising | Shape::falling)) != 0) {
            for_each_run(k, 2, [&](const Index &i) {
                const double before = points[static_cast<size_t>(number(i))],
                             after = points[static_cast<size_t>(number(i) + step)];
                all = all && ((along_[k] & Shape::rising) != 0 ? before <= after : before >= after);
            });
        }
        if (bends(along_[k])) {
            for_each_run(k, 3, [&](const Index &i) { all = all && is_convex(k, i, step, points); });
        }
    }
    return all;
}

} // namespace nrb::fit
