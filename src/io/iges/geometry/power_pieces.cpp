// SPDX-License-Identifier: MIT
#include "io/iges/geometry/power_pieces.h"

#include "base/checked.h"
#include "base/error.h"
#include "bounds/box.h"
#include "io/iges/geometry/placed_splines.h"
#include "reduce/reduce_knots.h"
#include "refine/forms/power.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::io::iges {
namespace {

using refine::PowerForm;

constexpr int64_t powers = 4; // of the cubic polynomials in the entities
constexpr int64_t dim = 3;

int64_t read_count(Record &record, const char *name) {
    const int64_t count = record.integer(name);
    if (count < 1 || count > record.remaining()) {
        fail(Status::count, "%s = %lld where the record has %lld more parameters", name,
             static_cast<long long>(count), static_cast<long long>(record.remaining()));
    }
    return count;
}

void require_parameters(int64_t needed, const Record &record) {
    if (needed > record.remaining()) {
        fail(Status::syntax, "breakpoints and coefficients need %lld parameters, the record has %lld more",
             static_cast<long long>(needed), static_cast<long long>(record.remaining()));
    }
}

std::vector<double> read_breaks(Record &record, int64_t pieces, const char *name) {
    std::vector<double> breaks;
    for (int64_t i = 0; i <= pieces; ++i) {
        breaks.push_back(record.real(name, i));
        if (i > 0 && !(breaks.back() > *(breaks.end() - 2))) {
            fail(Status::knots_decreasing, "%s[%lld] = %s, expected more than %s", name,
                 static_cast<long long>(i), Number(breaks.back()).text, Number(*(breaks.end() - 2)).text);
        }
    }
    return breaks;
}

// The polynomials of a grid of pieces, each [power along axis 0][power along axis 1][dim] with all four
// powers.
class Pieces {
public:
    Pieces(std::vector<std::vector<double>> breaks, size_t axes) : breaks_(std::move(breaks)), axes_(axes) {}

    // A piece lists the powers of one coordinate after the other; the first axis varies fastest.
    void read(Record &record, int64_t piece) {
        const int64_t per_coordinate = axes_ == 1 ? powers : powers * powers;
        const size_t start = coefficients_.size();
        coefficients_.resize(start + static_cast<size_t>(per_coordinate * dim));
        for (int64_t c = 0; c < dim; ++c) {
            for (int64_t i = 0; i < per_coordinate; ++i) {
                const int64_t place = axes_ == 1 ? i : i % powers * powers + i / powers;
                coefficients_[start + static_cast<size_t>(place * dim + c)] =
                    record.real("coefficients of piece", piece);
            }
        }
    }

    [[nodiscard]] PowerForm form() {
        PowerForm form{{}, std::move(breaks_), static_cast<int>(dim), {}};
        for (size_t axis = 0; axis < axes_; ++axis) {
            form.degrees.push_back(degree(axis));
        }
        const int64_t second = axes_ == 1 ? 0 : form.degrees[1];
        const int64_t records = std::ssize(coefficients_) / dim;
        for (int64_t i = 0; i < records; ++i) {
            if (power(i, 0) <= form.degrees[0] && power(i, 1) <= second) {
                const auto *const at = coefficients_.data() + i * dim;
                form.coefficients.insert(form.coefficients.end(), at, at + dim);
            }
        }
        return form;
    }

private:
    // The power of a record along an axis; 0 along an axis that does not exist.
    [[nodiscard]] int64_t power(int64_t record, size_t axis) const noexcept {
        return axis + 1 == axes_ ? record % powers : (axis + 1 < axes_ ? record / powers % powers : 0);
    }

    // The highest power with a nonzero coefficient, but at least 1.
    [[nodiscard]] int degree(size_t axis) const noexcept {
        int64_t highest = 1;
        for (int64_t i = 0; i < std::ssize(coefficients_); ++i) {
            if (coefficients_[static_cast<size_t>(i)] != 0) {
                highest = std::max(highest, power(i / dim, axis));
            }
        }
        return static_cast<int>(highest);
    }

    std::vector<std::vector<double>> breaks_;
    size_t axes_;
    std::vector<double> coefficients_;
};

// The largest distance between two adjacent layers of control points, coordinate by coordinate.
double gap_between(const Spline &spline, const AxisView &view, int64_t layer) noexcept {
    double gap = 0;
    const double *const points = spline.points().data();
    for (int64_t outer = 0; outer < view.outer; ++outer) {
        const double *const first = points + (outer * view.count + layer) * view.inner;
        for (int64_t i = 0; i < view.inner; ++i) {
            gap = std::max(gap, std::fabs(first[i + view.inner] - first[i]));
        }
    }
    return gap;
}

std::vector<double> without_layers(const Spline &spline, const AxisView &view,
                                   const std::vector<bool> &dropped) {
    std::vector<double> kept;
    for (int64_t i = 0; i < view.outer * view.count; ++i) {
        if (!dropped[static_cast<size_t>(i % view.count)]) {
            const double *const layer = spline.points().data() + i * view.inner;
            kept.insert(kept.end(), layer, layer + view.inner);
        }
    }
    return kept;
}

// Breaks have multiplicity degree + 1. Where the end layers of two pieces meet, they are merged into that of
// the earlier piece.
SplinePtr joined(const Spline &spline, int axis, double tolerance) {
    const KnotVector &old = spline.axis(axis);
    const AxisView view = axis_view(spline, axis, spline.dim());
    std::vector<bool> dropped(static_cast<size_t>(view.count), false);
    std::vector<double> knots(old.knots().begin(), old.knots().end());
    const int64_t each = int64_t{old.degree()} + 1;
    for (int64_t next = view.count - each; next > 0; next -= each) {
        if (gap_between(spline, view, next - 1) <= tolerance) {
            dropped[static_cast<size_t>(next)] = true;
            knots.erase(knots.begin() + next);
        }
    }
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        axes.push_back(k == axis ? make_knot_vector(old.degree(), knots)
                                 : spline.knot_vectors()[static_cast<size_t>(k)]);
    }
    return make_result(std::move(axes), spline.dim(), Form::polynomial,
                       without_layers(spline, view, dropped));
}

// The spline, as smooth as its pieces are up to the rounding of their coefficients.
SplinePtr spline_of(Pieces &pieces, const Placement &place, double tolerance) {
    SplinePtr spline = placed_spline(*refine::from_power(pieces.form(), false), place);
    const double size = bounds::extent(*spline);
    for (int axis = 0; axis < spline->axes(); ++axis) {
        spline = joined(*spline, axis, std::max(tolerance, 1e-9 * size));
    }
    return size > 0 ? reduce::reduce_knots(spline, -1, 0x1p-44 * size).spline : spline;
}

} // namespace

SplinePtr read_spline_pieces(Record &record, const Placement &place, double tolerance) {
    record.skip(3); // type, continuity, number of dimensions
    const int64_t count = read_count(record, "N");
    require_parameters(
        checked_sum(count + 1, checked_product(powers * dim, count, "coefficients"), "parameters"), record);
    Pieces pieces({read_breaks(record, count, "T")}, 1);
    for (int64_t i = 0; i < count; ++i) {
        pieces.read(record, i);
    }
    record.skip(powers * dim); // derivatives at the end
    return spline_of(pieces, place, tolerance);
}

// The file has one more patch of arbitrary values after each row, and one more row of them at the end.
SplinePtr read_spline_patches(Record &record, const Placement &place, double tolerance) {
    constexpr int64_t size = powers * powers * dim;
    record.skip(2); // type of the curves and of the patches
    const int64_t rows = read_count(record, "M"), columns = read_count(record, "N");
    const int64_t patches = checked_product(rows, columns + 1, "patches") - 1;
    require_parameters(
        checked_sum(rows + columns + 2, checked_product(size, patches, "coefficients"), "parameters"),
        record);
    std::vector<double> u = read_breaks(record, rows, "TU"), v = read_breaks(record, columns, "TV");
    Pieces pieces({std::move(u), std::move(v)}, 2);
    for (int64_t i = 0; i < rows; ++i) {
        for (int64_t j = 0; j < columns; ++j) {
            pieces.read(record, i * columns + j);
        }
        record.skip(size);
    }
    record.skip(size * (columns + 1));
    return spline_of(pieces, place, tolerance);
}

} // namespace nrb::io::iges
