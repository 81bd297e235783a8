// SPDX-License-Identifier: MIT
// The integral of the squared second derivative of a curve, as a function of the lengths of its tangents.
#pragma once

#include "fit/axis_interpolation.h"
#include "numeric/double_double.h"
#include "numeric/solvers/sparse/sparse_columns.h"

#include <span>
#include <vector>

namespace nrb::fit {

// Half of the derivatives of the energy by layers of control points: a banded matrix, times these.
class Bending {
public:
    explicit Bending(const KnotVectorPtr &knots);

    [[nodiscard]] std::vector<double> operator()(const std::vector<double> &layers, int64_t width) const;

private:
    ColumnsOf<DoubleDouble> columns_;
};

// The energy as a function of unknowns u, the lengths of tangents in units of what a tangent of length 1 adds to it, as far as
// that can be told from the conditions beside it.
class LengthEnergy {
public:
    // The axis and the directions must outlive this.
    LengthEnergy(const AxisInterpolation &axis, std::span<const int64_t> directions, int dim,
                 const std::vector<double> &targets);

    // Half of the derivatives by the unknowns, of the curve with right sides values[n][dim].
    [[nodiscard]] std::vector<double> slope(std::vector<double> values) const;
    // Of the curve that unknowns alone determine.
    [[nodiscard]] std::vector<double> product(const std::vector<double> &u) const;
    [[nodiscard]] double scale(size_t j) const noexcept { return scales_[j]; }

private:
    [[nodiscard]] double stiffness_at(int64_t i) const noexcept;
    [[nodiscard]] const double *unit(size_t j) const noexcept {
        return units_.data() + j * static_cast<size_t>(dim_);
    }

    const AxisInterpolation &axis_;
    std::span<const int64_t> where_;
    int dim_;
    Bending bending_;
    std::vector<double> units_; // [directions][dim]
    std::vector<double> scales_;
};

} // namespace nrb::fit
