// SPDX-License-Identifier: MIT
// The bending energy of a curve, the integral of its squared second derivative, as a function of the lengths
// of its tangents.
#pragma once

#include "fit/axis_interpolation.h"
#include "numeric/double_double.h"
#include "numeric/solvers/sparse/sparse_columns.h"

#include <span>
#include <vector>

namespace nrb::fit {

// Half the gradient of the energy with respect to the layers of control points: their product with a banded
// matrix.
class Bending {
public:
    explicit Bending(const KnotVectorPtr &knots);

    [[nodiscard]] std::vector<double> operator()(const std::vector<double> &layers, int64_t width) const;

private:
    ColumnsOf<DoubleDouble> columns_;
};

// The energy as a quadratic function of unknowns u, the scaled lengths of the tangents. They are scaled so
// that a tangent with u = 1 adds about 1 to the energy, as far as that can be estimated from the neighbouring
// conditions.
class LengthEnergy {
public:
    // The axis and the directions must outlive this.
    LengthEnergy(const AxisInterpolation &axis, std::span<const int64_t> directions, int dim,
                 const std::vector<double> &targets);

    // Half the gradient with respect to u, at the curve whose conditions have the right-hand sides
    // values[n][dim].
    [[nodiscard]] std::vector<double> slope(std::vector<double> values) const;
    // The same for the curve with tangents u and all other right-hand sides 0: half the Hessian matrix times
    // u.
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
