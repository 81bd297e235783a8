// SPDX-License-Identifier: MIT
// Curves through as many places as a bound on their error takes.
#pragma once

#include "face/made/effort.h"
#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::face {

// What a curve is to follow. Places are asked for one at a time, because the next one may depend on its neighbours.
class CurveModel {
public:
    virtual ~CurveModel() = default;
    [[nodiscard]] virtual int dim() const noexcept = 0;
    // The place [dim()] at a parameter; `near`, if not null, is about where it has to be.
    virtual void place(double t, const double *near, double *out) const = 0;
    // The largest of the errors that count of a candidate at these parameters; each to its place in `errors`.
    virtual void errors(const Spline &candidate, std::span<const double> params, double *errors) const = 0;
    // How many pieces of its own the model passes between two places, at these parameters: errors are looked at in each.
    [[nodiscard]] virtual int64_t pieces_between(double, const double *, double, const double *) const {
        return 1;
    }
    // In how many steps to go from one parameter to another so that each place is about where the one before is: 1 where places
    // have no copies.
    [[nodiscard]] virtual int64_t steps_between(double, double) const { return 1; }
    // Whether two places are so far apart that a copy of one of them may be meant.
    [[nodiscard]] virtual bool may_be_copy(const double *, const double *) const { return false; }
    // Whether a place leaves its coordinate `free` open, which then follows its neighbours.
    [[nodiscard]] virtual int open_coordinate(const double *) const { return -1; }
};

struct FittedCurve {
    SplinePtr spline;
    double error = 0; // the largest one seen between the places
};

// Over the intervals between breaks: the line between the places at the ends, else cubic splines through more and more places,
// halving the intervals in which the error is above the tolerance. Where coordinates of all places of an interval agree to
// `same[k]`, they are made equal. Throws Status::not_converged.
FittedCurve fit_curve(const CurveModel &model, std::span<const double> breaks, std::span<const double> same,
                      double tolerance, Effort &effort);

} // namespace nrb::face
