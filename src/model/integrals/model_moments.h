// SPDX-License-Identifier: MIT
// The area of the faces of a model, and the volume, centroid and inertia of its solids.
#pragma once

#include "measure/moments.h"
#include "model/model.h"

namespace nrb::model {

// The area of all faces where they stand in the whole. Throws what instances_of(), Placement() and
// face::integrate() throw, and Status::not_converged, not_representable.
measure::Moments area(const Model &model, double relative_tolerance);

// The moments of all solids where they stand in the whole, by the divergence theorem over their faces. The
// faces of a part that bound no solid are taken to enclose one together; of these, the faces of each shell
// (connected by edges) are oriented like the first one. A solid whose volume comes out negative is taken to
// be turned inside out. Throws what check_closed(), instances_of(), face::integrate() and measure::moments()
// throw.
measure::Moments volume(const Model &model, measure::MomentOrder order, double relative_tolerance);

} // namespace nrb::model
