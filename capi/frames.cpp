// SPDX-License-Identifier: MIT
// Frames and curvatures of curves and surfaces.
#include "batch.h"
#include "guard.h"
#include "outputs.h"

#include "eval/frames/curvature.h"
#include "eval/frames/curve_frames.h"
#include "eval/frames/minimal_frames.h"
#include "eval/frames/single_frame.h"
#include "eval/frames/surface_frames.h"
#include "spline/kind.h"

#include <cmath>
#include <span>

using namespace nrb;
using namespace nrb::capi;

namespace {

const Spline &surface_in_space(const ::nurbs *g) {
    const Spline &spline = surface_of(g);
    check_dimension(spline, 3, 3);
    return spline;
}

void check_plane(const Spline &spline, const double *values, const char *name) {
    if (spline.dim() == 2 && values != nullptr) {
        fail(Status::dimension, "%s of a curve of dimension 2: expected NULL", name);
    }
}

void check_finite(const double *direction, const char *name) {
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(direction[c])) {
            fail(Status::direction, "%s[%d] = %s is not finite", name, c, Number(direction[c]).text);
        }
    }
}

// The fast path for the frame at one point of a surface that has its tables. False, and nothing is written,
// where arguments need further checks, or an error may have to be reported, or the normal may not be regular.
bool evaluated_single(const nurbs *g, const double *params, int64_t param_stride,
                      int64_t param_component_stride, std::initializer_list<Wanted> outputs,
                      int32_t *status) noexcept {
    const eval::SingleFrameTables *tables = g == nullptr ? nullptr : eval::single_frame_tables(*g->spline);
    if (tables == nullptr || params == nullptr || !in_a_row(2, param_stride, param_component_stride)) {
        return false;
    }
    const Memory input = memory("params", params, 2), bits = memory("status", status, 1);
    bool separate = apart(input, bits);
    for (const Wanted *out = outputs.begin(); out != outputs.end(); ++out) {
        const Memory own = memory(out->name, out->data, 3);
        separate = separate && (out->data == nullptr || in_a_row(3, out->stride, out->component_stride)) &&
                   apart(own, input) && apart(own, bits);
        for (const Wanted *other = outputs.begin(); other != out; ++other) {
            separate = separate && apart(own, memory(other->name, other->data, 3));
        }
    }
    eval::SingleFrame frame;
    if (!separate || !eval::evaluate_single_frame(*tables, params, frame)) {
        return false;
    }
    std::span<const double> rest = frame;
    for (const Wanted &out : outputs) {
        put_all(out.data, rest.first(3));
        rest = rest.subspan(3);
    }
    put(status, int32_t{0});
    return true;
}

} // namespace

nurbs_status nurbs_surface_eval_frames(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                       int64_t param_component_stride, double *points, int64_t point_stride,
                                       int64_t point_component_stride, double *du, int64_t du_stride,
                                       int64_t du_component_stride, double *dv, int64_t dv_stride,
                                       int64_t dv_component_stride, double *normals, int64_t normal_stride,
                                       int64_t normal_component_stride, int32_t *status, uint32_t flags) {
    if (n == 1 && flags == 0 &&
        evaluated_single(g, params, param_stride, param_component_stride,
                         {{"points", points, 3, point_stride, point_component_stride},
                          {"du", du, 3, du_stride, du_component_stride},
                          {"dv", dv, 3, dv_stride, dv_component_stride},
                          {"normals", normals, 3, normal_stride, normal_component_stride}},
                         status)) {
        return NURBS_OK;
    }
    return guard([&] {
        const Spline &spline = surface_in_space(g);
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, flags);
        Outputs outputs(n, status);
        const eval::SurfaceFrames out{
            outputs.add({"points", points, 3, point_stride, point_component_stride}),
            outputs.add({"du", du, 3, du_stride, du_component_stride}),
            outputs.add({"dv", dv, 3, dv_stride, dv_component_stride}),
            outputs.add({"normals", normals, 3, normal_stride, normal_component_stride}), status};
        outputs.check("params", batch.params);
        check_values(batch);
        eval::surface_frames(spline, batch.rules, batch.params, out);
    });
}

nurbs_status nurbs_surface_eval_grid_frames(const nurbs *g, const int64_t *counts, const double *params,
                                            double *points, int64_t point_stride,
                                            int64_t point_component_stride, double *du, int64_t du_stride,
                                            int64_t du_component_stride, double *dv, int64_t dv_stride,
                                            int64_t dv_component_stride, double *normals,
                                            int64_t normal_stride, int64_t normal_component_stride,
                                            int32_t *status, uint32_t flags) {
    return guard([&] {
        const Spline &spline = surface_in_space(g);
        const eval::AxisRules rules = decode_rules(flags, spline.axes());
        const Grid grid = grid_of(spline, counts, params);
        Outputs outputs(grid.point_count, status);
        const eval::SurfaceFrames out{
            outputs.add({"points", points, 3, point_stride, point_component_stride}),
            outputs.add({"du", du, 3, du_stride, du_component_stride}),
            outputs.add({"dv", dv, 3, dv_stride, dv_component_stride}),
            outputs.add({"normals", normals, 3, normal_stride, normal_component_stride}), status};
        outputs.check("params", input("params", grid.params[0].data, grid.param_count, 0));
        outputs.check(memory("counts", grid.counts, grid.axes));
        check_values(spline, rules, grid);
        eval::surface_frames(spline, rules, grid.params, out);
    });
}

nurbs_status nurbs_surface_eval_curvatures(const nurbs *g, int64_t n, const double *params,
                                           int64_t param_stride, int64_t param_component_stride,
                                           double *principal, int64_t principal_stride,
                                           int64_t principal_component_stride, double *directions,
                                           int64_t direction_stride, int64_t direction_component_stride,
                                           double *mean, int64_t mean_stride, double *gaussian,
                                           int64_t gaussian_stride, int32_t *status, uint32_t flags) {
    return guard([&] {
        const Spline &spline = surface_in_space(g);
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, flags);
        Outputs outputs(n, status);
        const eval::SurfaceCurvatures out{
            outputs.add({"principal", principal, 2, principal_stride, principal_component_stride}),
            outputs.add({"directions", directions, 6, direction_stride, direction_component_stride}),
            outputs.add({"mean", mean, 1, mean_stride, 0}),
            outputs.add({"gaussian", gaussian, 1, gaussian_stride, 0}), status};
        outputs.check("params", batch.params);
        check_values(batch);
        eval::surface_curvatures(spline, batch.rules, batch.params, out);
    });
}

nurbs_status nurbs_curve_eval_frames(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                     double *points, int64_t point_stride, int64_t point_component_stride,
                                     double *tangents, int64_t tangent_stride,
                                     int64_t tangent_component_stride, double *normals, int64_t normal_stride,
                                     int64_t normal_component_stride, double *binormals,
                                     int64_t binormal_stride, int64_t binormal_component_stride,
                                     double *curvatures, int64_t curvature_stride, double *torsions,
                                     int64_t torsion_stride, int32_t *status, uint32_t flags) {
    return guard([&] {
        const Spline &spline = curve_of(g);
        check_dimension(spline, 2, 3);
        check_plane(spline, binormals, "binormals");
        check_plane(spline, torsions, "torsions");
        const SplineBatch batch = spline_batch(g, n, params, param_stride, 0, flags);
        const int dim = spline.dim();
        Outputs outputs(n, status);
        const eval::CurveFrames out{
            outputs.add({"points", points, dim, point_stride, point_component_stride}),
            outputs.add({"tangents", tangents, dim, tangent_stride, tangent_component_stride}),
            outputs.add({"normals", normals, dim, normal_stride, normal_component_stride}),
            outputs.add({"binormals", binormals, 3, binormal_stride, binormal_component_stride}),
            outputs.add({"curvatures", curvatures, 1, curvature_stride, 0}),
            outputs.add({"torsions", torsions, 1, torsion_stride, 0}),
            status};
        outputs.check("params", batch.params);
        check_values(batch);
        eval::curve_frames(spline, batch.rules, batch.params, out);
    });
}

nurbs_status nurbs_curve_rotation_minimizing_frames(
    const nurbs *g, int64_t n, const double *params, int64_t param_stride, const double *first_normal,
    double *points, int64_t point_stride, int64_t point_component_stride, double *tangents,
    int64_t tangent_stride, int64_t tangent_component_stride, double *normals, int64_t normal_stride,
    int64_t normal_component_stride, double *binormals, int64_t binormal_stride,
    int64_t binormal_component_stride, int32_t *status, uint32_t flags) {
    return guard([&] {
        const Spline &spline = curve_of(g);
        check_dimension(spline, 3, 3);
        const SplineBatch batch = spline_batch(g, n, params, param_stride, 0, flags);
        Outputs outputs(n, status);
        const eval::MinimalFrames out{
            outputs.add({"points", points, 3, point_stride, point_component_stride}),
            outputs.add({"tangents", tangents, 3, tangent_stride, tangent_component_stride}),
            outputs.add({"normals", normals, 3, normal_stride, normal_component_stride}),
            outputs.add({"binormals", binormals, 3, binormal_stride, binormal_component_stride}), status};
        outputs.check("params", batch.params);
        if (first_normal != nullptr) {
            outputs.check(memory("first_normal", first_normal, 3));
            check_finite(first_normal, "first_normal");
        }
        check_values(batch);
        eval::minimal_frames(spline, batch.rules, batch.params, first_normal, out);
    });
}
