// SPDX-License-Identifier: MIT
// Where a piece of a curve runs on a piece of a surface beside it.
#pragma once

#include "intersect/curve_surface/patch_point.h"
#include "intersect/curve_surface/space_chart.h"
#include "intersect/pairs/piece_point.h"

#include <optional>

namespace nrb::intersect {

// Over the places t of C a polynomial curve of places on S, p(t), by interpolation between feet: at some t the places at
// which C(t) - S has no component in the tangent plane of the middle. So a curve made of another one in the parameters of a
// surface has the difference 0, and others one of a high order.
class FootCurve {
public:
    // False if a foot is not found on S or shortly beyond it, or if some are nearer than `near` or on another side than some
    // that are farther than `far`.
    bool interpolate(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double far);

    // The Bernstein coefficients along an axis of S.
    [[nodiscard]] const std::vector<double> &coefficients(int axis) const noexcept {
        return places_[static_cast<size_t>(axis)];
    }
    [[nodiscard]] Interval hull(int axis) const noexcept;
    [[nodiscard]] Place<2> at(double t) const;

    // Sets differences(): of the coefficients of C w - S(p) v and v w the quotients. Returns what rounding may have made of
    // them, moved() of both included; infinite where weights may have zeros.
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
    std::array<double, 3> centre_{}; // of coefficients, so that they are rounded by what is near only
    std::array<double, 3> offset_{}; // of a point from its foot
    PiecePoint arc_point_;
    PatchPoint patch_point_;
    std::array<std::vector<std::vector<double>>, 2>
        powers_; // of each Bernstein function of p, times binomials
    std::vector<double> image_, differences_;
};

} // namespace nrb::intersect
