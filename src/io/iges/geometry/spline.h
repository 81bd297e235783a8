// SPDX-License-Identifier: MIT
// Rational B-spline curves (entity 126) and surfaces (entity 128).
#pragma once

#include "io/iges/geometry/placement.h"
#include "io/iges/record.h"
#include "io/iges/types.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// The parameters of an entity as they are in the file, but in the order of this library: last axis fastest.
struct SplineData {
    struct Axis {
        int degree = 0;
        int64_t count = 0;
        bool periodic = false; // as stated in the file
        std::vector<double> knots;
        bool whole = true; // no range given: the whole domain
        double lower = 0;
        double upper = 0;
    };
    std::vector<Axis> axes;
    std::vector<double> weights;
    std::vector<double> points; // records of three
};

// Read an entity from its record, which is left after the geometry, at the pointers that may follow. Throw
// Error: Status::syntax, degree, count, too_few_points, overflow. Stated counts are checked against the
// parameters present before anything is allocated.
SplineData read_curve_data(Record &record);
SplineData read_surface_data(Record &record);

// The placed spline of an entity. It is polynomial if all weights are equal. It is periodic if the file says
// so and the data confirm it bit for bit; axes that are only closed are converted to wrapped ones. It is cut
// to the parameter range where that lies inside the domain. Throws what make_spline() throws, and
// Status::empty_domain or outside_domain for a range that contains no parameters of the domain.
SplinePtr build_spline(SplineData data, const Placement &placement);

} // namespace nrb::io::iges
