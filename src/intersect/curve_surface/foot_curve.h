// SPDX-License-Identifier: MIT
// The curve of foot points of a curve piece on a surface piece that it runs along.
#pragma once

#include "intersect/curve_surface/patch_point.h"
#include "intersect/curve_surface/space_chart.h"
#include "intersect/pairs/piece_point.h"

#include <optional>

namespace nrb::intersect {

// A polynomial curve p(t) of places on S, over the local parameter t of C, that interpolates foot points: for
// some t, the places at which C(t) - S has no component in the tangent plane in the middle. So a curve that
// is made of another one in the parameters of a surface has the difference 0, and others have one of a high
// order.
class FootCurve {
public:
    // False if a foot point is not found on S or shortly beyond it, or if some foot points are farther than
    // `far` from C, while others are nearer than `near` or on the other side.
    bool interpolate(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double far);

    // The Bernstein coefficients of p along an axis of S.
    [[nodiscard]] const std::vector<double> &coefficients(int axis) const noexcept {
        return places_[static_cast<size_t>(axis)];
    }
    [[nodiscard]] Interval hull(int axis) const noexcept;
    [[nodiscard]] Place<2> at(double t) const;

    // Sets the differences: the quotients of the Bernstein coefficients of C w - S(p) v and v w, where C and
    // S(p) are weighted points with the weights v and w. Returns a bound on their rounding, with moved() of
    // both included; infinite where weights may have zeros.
    double compare(const pieces::SlopedPiece &arc, const SlopedPatch &patch);
    [[nodiscard]] size_t count() const noexcept { return differences_.size() / 3; }
    [[nodiscard]] const double *difference(size_t i) const noexcept { return differences_.data() + 3 * i; }

private:
    bool find_foot(const SlopedPatch &patch, const double *point, Place<2> &foot);
    [[nodiscard]] double height_of(const SlopedPatch &patch) const noexcept;
    void set_powers(size_t axis, int degree);
    void compose(const pieces::BezierPiece &patch);
    bool set_differences(const pieces::BezierPiece &arc);

    int degree_ = 0;
    std::array<std::vector<double>, 2> places_;
    std::array<double, 3> centre_{}; // of coefficients, so that their rounding is relative to the local size
    std::array<double, 3> offset_{}; // of a point from its foot point
    PiecePoint arc_point_;
    PatchPoint patch_point_;
    std::array<std::vector<std::vector<double>>, 2>
        powers_; // of the Bernstein functions of S at p, coefficients times binomials
    std::vector<double> image_, differences_;
};

} // namespace nrb::intersect
