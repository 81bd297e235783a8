// SPDX-License-Identifier: MIT
// The points of a spline that are nearest to those of a cloud.
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

    // For the spline in the units of the cloud. Feet have a few pieces each, which is enough to prove those of shapes with a
    // tangent space: on others whole arcs are equally near, to rounding, which takes 1000 times as long to tell.
    CloudFeet(const Spline &spline, const Cloud &cloud);
    // Looks longer for a proof of those that have none, all together not much longer than a round takes at most, and again
    // while that leaves far fewer of them.
    void prove(const Spline &spline, const Cloud &cloud);
    // The distances from the spline of the caller, whose control points are rounded, at the same feet.
    void measure_given(const Spline &spline, const Cloud &cloud);

private:
    // With so many pieces each.
    CloudFeet(const Spline &spline, const Cloud &cloud, int64_t pieces);
    void set_squares(const Cloud &cloud);
    [[nodiscard]] std::vector<int64_t> without_proof() const; // points
    // Their feet.
    void take(const CloudFeet &found, const std::vector<int64_t> &places, int axes);
};

// How far a distance may be from the true one that is proven: twice what rounding adds to a proof of closest/, which holds
// for the place that was found, once more for its parameter; in units of the cloud, and with what coordinates of the caller
// add, in those of the caller.
double distance_noise(const Spline &spline, const Cloud &cloud);
double given_noise(const Spline &spline, const Cloud &cloud);

// Adds the models of all squared distances.
void add_models(const Spline &spline, const Cloud &cloud, const CloudFeet &feet, CloudEquations &equations);

} // namespace nrb::fit
