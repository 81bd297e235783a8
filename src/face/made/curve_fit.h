// SPDX-License-Identifier: MIT
// Curves that follow a model, interpolated at as many places as a tolerance takes.
#pragma once

#include "face/made/effort.h"
#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::face {

// What a curve is to follow. Places are requested one at a time, because a place may depend on its
// neighbours.
class CurveModel {
public:
    virtual ~CurveModel() = default;
    [[nodiscard]] virtual int dim() const noexcept = 0;
    // The place [dim()] at a parameter. near: about where it has to be, or null.
    virtual void place(double t, const double *near, double *out) const = 0;
    // The error of a candidate, as far as it counts, at each of these parameters.
    virtual void errors(const Spline &candidate, std::span<const double> params, double *errors) const = 0;
    // How many pieces of its own the model passes between two places, given with their parameters. Errors are
    // sampled in each of them.
    [[nodiscard]] virtual int64_t pieces_between(double, const double *, double, const double *) const {
        return 1;
    }
    // In how many steps to go from one parameter to another so that each place is found near the one before
    // it; 1 where places have no copies.
    [[nodiscard]] virtual int64_t steps_between(double, double) const { return 1; }
    // Whether two consecutive places are so far apart that a copy of one of them may be meant.
    [[nodiscard]] virtual bool may_be_copy(const double *, const double *) const { return false; }
    // The coordinate that is arbitrary at a place, so that it has to follow the neighbours; -1: none.
    [[nodiscard]] virtual int open_coordinate(const double *) const { return -1; }
};

struct FittedCurve {
    SplinePtr spline;
    double error = 0; // the largest one seen between the places
};

// Fits each interval between breaks by the line between the places at its ends or, where the error of that is
// above the tolerance, by cubic splines through more and more places: the intervals between places in which
// the error is above the tolerance are halved. Where coordinates k of all places of an interval agree to
// `same[k]`, they are made equal. Throws Status::not_converged.
FittedCurve fit_curve(const CurveModel &model, std::span<const double> breaks, std::span<const double> same,
                      double tolerance, Effort &effort);

} // namespace nrb::face
