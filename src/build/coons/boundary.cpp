// SPDX-License-Identifier: MIT
#include "build/coons/boundary.h"

#include "refine/parts/iso.h"

namespace nrb::build {

std::vector<SplinePtr> boundaries_of(const Spline &spline) {
    if (spline.axes() == 1) {
        fail(Status::axes, "g is a curve, expected a surface or a volume");
    }
    std::vector<SplinePtr> boundaries;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto [lower, upper] = spline.axis(k).domain();
        boundaries.push_back(refine::iso(spline, k, lower, {}));
        boundaries.push_back(refine::iso(spline, k, upper, {}));
    }
    return boundaries;
}

} // namespace nrb::build
