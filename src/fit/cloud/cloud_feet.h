// SPDX-License-Identifier: MIT
// The feet of a cloud: the points of a spline that are nearest to its points.
#pragma once

#include "fit/cloud/cloud.h"
#include "fit/cloud/cloud_equations.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

struct CloudFeet {
    std::vector<double> params;    // [size][axes]
    std::vector<double> distances; // [size]
    std::vector<int32_t> status;   // [size], closest_ bits
    double squares = 0;            // sum w d^2
    int exponent;                  // distances are in units of 2^exponent

    // For the spline in the units of the cloud. The search for a foot looks at a few pieces only. That is
    // enough to prove feet on shapes with a tangent space; on others whole arcs are equally near up to
    // rounding, which takes 1000 times as long to establish.
    CloudFeet(const Spline &spline, const Cloud &cloud);
    // Searches longer for proofs of the feet that have none: for all together not much longer than a round
    // takes, and again while that leaves far fewer of them.
    void prove(const Spline &spline, const Cloud &cloud);
    // Replaces the distances by those from the spline in coordinates of the caller, whose control points are
    // rounded, at the same feet.
    void measure_given(const Spline &spline, const Cloud &cloud);

private:
    // With up to `pieces` pieces for each foot.
    CloudFeet(const Spline &spline, const Cloud &cloud, int64_t pieces);
    void set_squares(const Cloud &cloud);
    [[nodiscard]] std::vector<int64_t> without_proof() const; // of points
    // Copies the feet `found` to the points `places`.
    void take(const CloudFeet &found, const std::vector<int64_t> &places, int axes);
};

// How far a distance may be from the proven true one: twice the rounding error that a proof of closest/
// allows for, once for the place that was found and once more for its parameter. distance_noise() is in units
// of the cloud. given_noise() is in those of the caller, and adds the rounding error of the caller's
// coordinates.
double distance_noise(const Spline &spline, const Cloud &cloud);
double given_noise(const Spline &spline, const Cloud &cloud);

// Adds the quadratic models of all squared distances to the equations.
void add_models(const Spline &spline, const Cloud &cloud, const CloudFeet &feet, CloudEquations &equations);

} // namespace nrb::fit
