// SPDX-License-Identifier: MIT
// The area of the faces of a model, and volume, centroid and inertia of its solids.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "watched.h"

#include "base/tolerance.h"
#include "model/integrals/model_moments.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_model_area(const nurbs_model *model, double relative_tolerance, double *area,
                              double *error) {
    return guard([&] {
        const model::Model &own = model_of(model);
        require(area, "area");
        check_tolerance(relative_tolerance, "relative_tolerance");
        check_apart({memory("area", area, 1), memory("error", error, 1)}, {});
        const measure::Moments found = model::area(own, relative_tolerance);
        *area = found.content;
        put(error, found.error);
    });
}

nurbs_status nurbs_model_area_with(const nurbs_model *model, double relative_tolerance, double *area,
                                   double *error, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_model_area(model, relative_tolerance, area, error); });
}

nurbs_status nurbs_model_volume(const nurbs_model *model, double relative_tolerance, double *volume,
                                double *centroid, double *inertia, double *openness, double *error) {
    return guard([&] {
        const model::Model &own = model_of(model);
        require(volume, "volume");
        check_tolerance(relative_tolerance, "relative_tolerance");
        check_apart({memory("volume", volume, 1), memory("centroid", centroid, 3),
                     memory("inertia", inertia, 9), memory("openness", openness, 1),
                     memory("error", error, 1)},
                    {});
        const measure::MomentOrder order = inertia != nullptr    ? measure::MomentOrder::inertia
                                           : centroid != nullptr ? measure::MomentOrder::centroid
                                                                 : measure::MomentOrder::content;
        const measure::Moments found = model::volume(own, order, relative_tolerance);
        *volume = found.content;
        put_all(centroid, found.centroid);
        put_all(inertia, found.inertia);
        put(openness, found.openness);
        put(error, found.error);
    });
}

nurbs_status nurbs_model_volume_with(const nurbs_model *model, double relative_tolerance, double *volume,
                                     double *centroid, double *inertia, double *openness, double *error,
                                     const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_model_volume(model, relative_tolerance, volume, centroid, inertia, openness, error);
    });
}
