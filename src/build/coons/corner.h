// SPDX-License-Identifier: MIT
// The corner data of a Coons surface: positions, tangents and twists, each of which two curves give.
#pragma once

#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::build {

// The four boundaries of a surface, and the derivatives across them (cross tangents) or none. All are
// clamped, over the domain of the surface, and have finite ends.
struct PatchCurves {
    std::vector<SplinePtr> boundaries;
    std::vector<SplinePtr> cross;

    [[nodiscard]] int dim() const noexcept { return boundaries[0]->dim(); }
    // Axis 0 or 1 of the surface.
    [[nodiscard]] Interval domain(int axis) const noexcept {
        return boundaries[axis == 0 ? 2 : 0]->axis(0).domain();
    }
};

// Clamps the curves and maps their domains as nurbs.h says. Throws Status::axes, dimension, knots_merge,
// weights_vanish for an end at infinity, and what clamping throws. Preconditions: 4 boundaries, 4 or no cross
// tangents.
PatchCurves make_patch_curves(const std::vector<SplinePtr> &boundaries, const std::vector<SplinePtr> &cross);

// The spline with clamped ends along an axis, mapped to a domain there.
SplinePtr clamped_over(const SplinePtr &spline, int axis, Interval domain);

// The Cartesian value and derivative at an end of a clamped curve of degree p. Let A be the homogeneous
// points and w the weights, with the index 0 at the end and 1 next to it, P_0 = A_0 / w_0, and h the length
// of the knots over which control point 1 acts, t_(p+1) - t_1 at the start. Then the derivative is p / h (A_1
// - w_1 P_0) / w_0, with the opposite sign at the upper end.
struct EndJet {
    std::vector<double> value;
    std::vector<double> slope;
};
EndJet end_jet(const Spline &curve, bool upper);

// Entry (i, j): value or derivative i by the parameter of axis 0 and j by that of axis 1, where 0 and 1 stand
// for the values at the start and end, 2 and 3 for the derivatives there.
class CornerMatrix {
public:
    // A matrix of 2 or 4 rows and columns.
    CornerMatrix(int order, int dim)
        : order_(order), dim_(dim), values_(static_cast<size_t>(order * order) * static_cast<size_t>(dim)) {}

    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] double *at(int i, int j) noexcept { return values_.data() + place(i, j); }
    [[nodiscard]] const double *at(int i, int j) const noexcept { return values_.data() + place(i, j); }
    void set(int i, int j, const std::vector<double> &value) noexcept {
        std::copy(value.begin(), value.end(), at(i, j));
    }

private:
    [[nodiscard]] size_t place(int i, int j) const noexcept {
        return static_cast<size_t>(i * order_ + j) * static_cast<size_t>(dim_);
    }
    int order_;
    int dim_;
    std::vector<double> values_;
};

// The corner data according to the curves along axis 1 (boundaries 0 and 1 with the derivatives across them),
// and according to the curves along axis 0 (2 and 3). Without cross tangents, the entries that only these
// determine are 0.
struct CornerPair {
    CornerMatrix along1;
    CornerMatrix along0;
};
CornerPair corner_pair(const PatchCurves &curves, int order);

// The corners are in the order of nurbs_coons_gaps().
inline constexpr int corner_count = 4;

struct CornerGaps {
    std::array<double, corner_count> positions{};
    std::array<std::array<double, 2>, corner_count> tangents{};
    std::array<double, corner_count> twists{};
};
// Throws Status::not_representable.
CornerGaps corner_gaps(const PatchCurves &curves);

// Throw Status::gap and Status::tangent, naming the corner.
void check_positions(const CornerPair &pair, double tolerance);
void check_tangents(const CornerGaps &gaps, double tolerance);
// Throws Status::twist, naming the corner.
void check_twists(const CornerGaps &gaps, double tolerance);

} // namespace nrb::build
