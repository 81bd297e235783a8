// Local minima and maxima of the distance on a patch: Newton's method in a box.
#pragma once

#include "closest/patch/patch_item.h"

namespace nrb::closest {

// S = Q / w at a place, as far as the distance needs it: derivatives of |S|^2 / 2.
struct PatchJet {
    double square = 0;                            // |S|^2
    AxisValues gradient{};                        // S S_k
    std::array<AxisValues, max_axes> metric{};    // S_k S_l
    std::array<AxisValues, max_axes> curvature{}; // S S_kl
};

// The homogeneous values that a proof starts from.
struct PatchValues {
    double length = 0; // |Q|
    double weight = 1;
    AxisValues products{};    // Q Q_k
    AxisValues derivatives{}; // |Q_k|
    AxisValues weights{};     // w_k
};

struct PatchBox {
    AxisValues lower{};
    AxisValues upper{1, 1, 1};
};

class PatchDescent {
public:
    PatchDescent(const PatchShape &shape, PatchMemory &memory) : shape_(shape), memory_(memory) {}

    [[nodiscard]] PatchJet jet(const double *values, const AxisValues &at) const;
    [[nodiscard]] PatchValues values(const double *values, const AxisValues &at) const;
    [[nodiscard]] double distance(const double *values, const AxisValues &at) const;
    // The point itself, [dim].
    void point(const double *values, const AxisValues &at, double *out) const;

    // Descends from `at` to where sign * |S| has a minimum in the box, sign = 1 or -1, which becomes `at`;
    // the distance there. Less than `floor` counts as 0. Takes at most `steps` of them; converged: fewer.
    struct Result {
        double distance;
        bool converged;
    };
    Result descend(const double *values, const PatchBox &box, double sign, double floor, AxisValues &at,
                   int steps = 60) const;

private:
    // The step of a Newton method with a positive definite matrix: metric and curvature, with `damping` of
    // the metric, on the axes that are free.
    bool step(const PatchJet &jet, double sign, double damping, const std::array<bool, max_axes> &free,
              AxisValues &out) const noexcept;

    const PatchShape &shape_;
    PatchMemory &memory_;
};

} // namespace nrb::closest
