// SPDX-License-Identifier: MIT
// The distance from the query point on a patch, with its derivatives, local minima and maxima.
#pragma once

#include "closest/patch/patch_item.h"
#include "pieces/damped_descent.h"

namespace nrb::closest {

// |S|^2 for S = Q / w, with its derivatives; Q is the homogeneous patch with the query point as its origin.
using PatchJet = pieces::SquareJet<max_axes>;
using PatchBox = pieces::ParameterBox<max_axes>;

// The homogeneous values that a proof starts from.
struct PatchValues {
    double length = 0; // |Q|
    double weight = 1;
    AxisValues products{};    // Q . Q_k
    AxisValues derivatives{}; // |Q_k|
    AxisValues weights{};     // w_k
};

class PatchDescent {
public:
    PatchDescent(const PatchShape &shape, PatchMemory &memory) : shape_(shape), memory_(memory) {}

    [[nodiscard]] PatchJet jet(const double *values, const AxisValues &at) const;
    [[nodiscard]] PatchValues values(const double *values, const AxisValues &at) const;
    [[nodiscard]] double distance(const double *values, const AxisValues &at) const;
    // The point itself, [dim].
    void point(const double *values, const AxisValues &at, double *out) const;

    // Descends from `at` to a minimum of sign * |S| in the box, with sign = 1 or -1; `at` becomes that place.
    // Returns the distance there.
    pieces::Descent descend(const double *values, const PatchBox &box, double sign, double floor,
                            AxisValues &at, int steps = 60) const;

private:
    const PatchShape &shape_;
    PatchMemory &memory_;
};

} // namespace nrb::closest
