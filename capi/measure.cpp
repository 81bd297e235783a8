// SPDX-License-Identifier: MIT
// Arc lengths, areas, and moments (content, centroid, inertia).
#include "checks.h"
#include "guard.h"
#include "lists.h"
#include "outputs.h"
#include "part.h"
#include "watched.h"

#include "base/checked.h"
#include "base/tolerance.h"
#include "eval/parameters.h"
#include "measure/closed_chains.h"
#include "measure/length/divide.h"
#include "measure/length/length_table.h"
#include "measure/moments.h"
#include "spline/kind.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

measure::MomentOrder order_of(const double *centroid, const double *inertia) noexcept {
    return inertia != nullptr    ? measure::MomentOrder::inertia
           : centroid != nullptr ? measure::MomentOrder::centroid
                                 : measure::MomentOrder::content;
}

// The caller's outputs of a function that computes moments; all but `content` may be null.
struct MomentOutputs {
    double *content;
    double *centroid;
    double *inertia;
    double *error;
    double *openness = nullptr;
};

void check_outputs(const char *name, const MomentOutputs &out, int64_t dim, Memory input) {
    check_apart({memory(name, out.content, 1), memory("centroid", out.centroid, dim),
                 memory("inertia", out.inertia, dim * dim), memory("openness", out.openness, 1),
                 memory("error", out.error, 1)},
                {input});
}

void give_moments(const measure::Moments &found, const MomentOutputs &out) {
    put(out.content, found.content);
    put_all(out.centroid, found.centroid);
    put_all(out.inertia, found.inertia);
    put(out.error, found.error);
    put(out.openness, found.openness);
}

// The splines that bound a region of dimension `dim`. Checks that each has dim - 1 axes and dimension dim;
// messages call the array `name`.
std::vector<SplinePtr> boundary_of(int64_t count, const nurbs *const *handles, const char *name, int dim) {
    std::vector<SplinePtr> splines = splines_of(count, handles, name);
    for (size_t i = 0; i < splines.size(); ++i) {
        check_kind(*splines[i], dim - 1, name, static_cast<int64_t>(i));
        check_dimension(*splines[i], dim, dim, name, static_cast<int64_t>(i));
    }
    return splines;
}

} // namespace

nurbs_status nurbs_curve_length(const nurbs *g, const double *range, double relative_tolerance,
                                double *length, double *error) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_tolerance(relative_tolerance, "relative_tolerance");
        require(length, "length");
        check_apart({memory("length", length, 1), memory("error", error, 1)}, {memory("range", range, 2)});
        const measure::Integral found =
            measure::curve_length(curve, checked_part(curve, range)[0], relative_tolerance);
        *length = found.value;
        put(error, found.error);
    });
}

nurbs_status nurbs_curve_lengths(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                 double relative_tolerance, double *lengths, int64_t length_stride) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_length(n, "n");
        const ConstRecords in = input("params", params, n, param_stride);
        const Records out = output("lengths", lengths, n, 1, length_stride, 0);
        check_overlap("lengths", out, "params", in);
        check_tolerance(relative_tolerance, "relative_tolerance");
        eval::check_parameters(curve, {}, in);
        const StagedRecords staged(out);
        measure::curve_lengths(curve, in, relative_tolerance, staged.view());
        staged.commit();
    });
}

nurbs_status nurbs_curve_params_at_lengths(const nurbs *g, int64_t n, const double *lengths,
                                           int64_t length_stride, double relative_tolerance, double *params,
                                           int64_t param_stride, uint32_t flags) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_length(n, "n");
        const ConstRecords in = input("lengths", lengths, n, length_stride);
        const Records out = output("params", params, n, 1, param_stride, 0);
        check_overlap("params", out, "lengths", in);
        if ((flags & ~NURBS_CLAMP) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_CLAMP or 0", flags);
        }
        check_tolerance(relative_tolerance, "relative_tolerance");
        const StagedRecords staged(out);
        measure::curve_params_at_lengths(curve, in, relative_tolerance, flags != 0, staged.view());
        staged.commit();
    });
}

nurbs_status nurbs_curve_divide(const nurbs *g, const double *range, int64_t parts, double relative_tolerance,
                                uint32_t flags, double *params, double *size) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_at_least(parts, 1, "parts");
        const Records out = output("params", params, checked_sum(parts, 1, "params"), 1, 0, 0);
        if ((flags & ~NURBS_EQUAL_CHORDS) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_EQUAL_CHORDS or 0", flags);
        }
        check_tolerance(relative_tolerance, "relative_tolerance");
        check_apart({memory("params", params, out.count), memory("size", size, 1)},
                    {memory("range", range, 2)});
        std::vector<double> found;
        const Interval part = checked_part(curve, range)[0];
        const double each = flags != 0
                                ? measure::divide_by_chord(curve, part, parts, relative_tolerance, found)
                                : measure::divide_by_length(curve, part, parts, relative_tolerance, found);
        put_all(params, found);
        put(size, each);
    });
}

nurbs_status nurbs_surface_area(const nurbs *g, const double *range, double relative_tolerance, double *area,
                                double *error) {
    return guard([&] {
        const Spline &surface = surface_of(g);
        check_tolerance(relative_tolerance, "relative_tolerance");
        require(area, "area");
        const MomentOutputs out{area, nullptr, nullptr, error};
        check_outputs("area", out, 0, memory("range", range, 4));
        give_moments(measure::moments(surface, checked_part(surface, range), measure::MomentOrder::content,
                                      relative_tolerance),
                     out);
    });
}

nurbs_status nurbs_moments(const nurbs *g, double relative_tolerance, double *content, double *centroid,
                           double *inertia, double *error) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        if (spline.axes() == 3 && spline.dim() != 3) {
            fail(Status::dimension, "g is a volume of dimension %d, expected 3", spline.dim());
        }
        check_tolerance(relative_tolerance, "relative_tolerance");
        require(content, "content");
        const MomentOutputs out{content, centroid, inertia, error};
        check_outputs("content", out, spline.dim(), {});
        give_moments(
            measure::moments(spline, whole_domain(spline), order_of(centroid, inertia), relative_tolerance),
            out);
    });
}

nurbs_status nurbs_enclosed_area(int64_t count, const nurbs *const *curves, double tolerance,
                                 double relative_tolerance, double *area, double *centroid, double *inertia,
                                 double *error) {
    return guard([&] {
        const std::vector<SplinePtr> boundary = boundary_of(count, curves, "curves", 2);
        check_tolerance(tolerance);
        check_tolerance(relative_tolerance, "relative_tolerance");
        require(area, "area");
        const MomentOutputs out{area, centroid, inertia, error};
        check_outputs("area", out, 2, memory("curves", curves, count));
        measure::check_closed(boundary, tolerance);
        give_moments(measure::enclosed_moments(boundary, order_of(centroid, inertia), relative_tolerance),
                     out);
    });
}

nurbs_status nurbs_enclosed_volume(int64_t count, const nurbs *const *surfaces, double relative_tolerance,
                                   double *volume, double *centroid, double *inertia, double *openness,
                                   double *error) {
    return guard([&] {
        const std::vector<SplinePtr> boundary = boundary_of(count, surfaces, "surfaces", 3);
        check_tolerance(relative_tolerance, "relative_tolerance");
        require(volume, "volume");
        const MomentOutputs out{volume, centroid, inertia, error, openness};
        check_outputs("volume", out, 3, memory("surfaces", surfaces, count));
        give_moments(measure::enclosed_moments(boundary, order_of(centroid, inertia), relative_tolerance),
                     out);
    });
}
