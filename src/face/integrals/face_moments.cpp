// SPDX-License-Identifier: MIT
#include "face/integrals/face_moments.h"

#include "face/integrals/face_integral.h"
#include "measure/elements.h"
#include "measure/moment_integrand.h"

namespace nrb::face {

measure::Moments moments(const Face &face, measure::MomentOrder order, double relative_tolerance) {
    const Spline &surface = *face.surface();
    const pieces::Frame frame = measure::integral_frame(surface);
    const measure::MomentIntegrand integrand(2, surface.dim(), order);
    const TrimmedSurface own{&surface, &face.trims()};
    const measure::Integrals sums = integrate({&own, 1}, integrand, frame, relative_tolerance);
    return measure::moments_from(sums, 0, {1, 1, 1, 2}, frame, order, relative_tolerance);
}

} // namespace nrb::face
