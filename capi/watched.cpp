// SPDX-License-Identifier: MIT
// Call options, buffers for the results of watched batches, and those functions nurbs_X_with() that only run
// nurbs_X() as a watched call.
#include "watched.h"

#include "base/error.h"
#include "structs.h"

using namespace nrb;
using namespace nrb::capi;

namespace nrb::capi {

Watch::Wishes wishes_of(const nurbs_call_options *call) {
    if (call == nullptr) {
        return {};
    }
    checked_struct("call", call);
    if (call->work < 0) {
        fail(Status::options, "call: work = %lld, expected >= 0", static_cast<long long>(call->work));
    }
    return {call->work, call->progress, call->user};
}

StagedRecords::StagedRecords(const Records &wanted) : wanted_(wanted), view_(wanted) {
    if (wanted.data != nullptr) {
        values_.resize(static_cast<size_t>(wanted.count * wanted.width));
        view_ = {values_.data(), wanted.count, wanted.width, wanted.width, 1};
    }
}

void StagedRecords::commit() const noexcept {
    for (int64_t i = 0; !values_.empty() && i < wanted_.count; ++i) {
        for (int64_t c = 0; c < wanted_.width; ++c) {
            wanted_(i, c) = view_(i, c);
        }
    }
}

StagedStatus::StagedStatus(int32_t *wanted, int64_t count) : wanted_(wanted) {
    if (wanted != nullptr) {
        values_.resize(static_cast<size_t>(count));
    }
}

} // namespace nrb::capi

nurbs_status nurbs_call_options_init(nurbs_call_options *options, int64_t struct_size) {
    return guard([&] { clear_struct("options", options, struct_size); });
}

nurbs_status nurbs_product_with(const nurbs *a, const nurbs *b, uint32_t flags,
                                const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] { return nurbs_product(a, b, flags, out); });
}

nurbs_status nurbs_compose_with(const nurbs *g, const nurbs *f, const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] { return nurbs_compose(g, f, out); });
}

nurbs_status nurbs_reduce_knots_with(const nurbs *g, int32_t axis, double tolerance, double *bound,
                                     const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] { return nurbs_reduce_knots(g, axis, tolerance, bound, out); });
}

nurbs_status nurbs_reduce_degree_with(const nurbs *g, int32_t axis, int32_t times, double *bound,
                                      const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] { return nurbs_reduce_degree(g, axis, times, bound, out); });
}

nurbs_status nurbs_simplify_with(const nurbs *g, double tolerance, double *bound,
                                 const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] { return nurbs_simplify(g, tolerance, bound, out); });
}

nurbs_status nurbs_recognize_with(const nurbs *g, double tolerance, int32_t *shape, double *placement,
                                  double *sizes, double *deviation, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_recognize(g, tolerance, shape, placement, sizes, deviation); });
}

nurbs_status nurbs_closest_all_with(const nurbs *g, const double *point, const double *range,
                                    double tolerance, int64_t budget, int64_t cap, double *params,
                                    double *distances, int64_t *count, int32_t *status,
                                    const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_closest_all(g, point, range, tolerance, budget, cap, params, distances, count, status);
    });
}

nurbs_status nurbs_critical_points_with(const nurbs *g, const double *point, const double *range,
                                        double tolerance, int64_t budget, int64_t cap, double *params,
                                        double *distances, int32_t *kinds, int64_t *count, int32_t *status,
                                        const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_critical_points(g, point, range, tolerance, budget, cap, params, distances, kinds, count,
                                     status);
    });
}

nurbs_status nurbs_distance_with(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                                 double *at_least, double *at_most, double *params_a, double *params_b,
                                 int32_t *status, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_distance(a, b, tolerance, budget, at_least, at_most, params_a, params_b, status);
    });
}

nurbs_status nurbs_hausdorff_distance_with(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                                           double *at_least, double *at_most, double *params_a,
                                           double *params_b, int32_t *status,
                                           const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_hausdorff_distance(a, b, tolerance, budget, at_least, at_most, params_a, params_b,
                                        status);
    });
}

nurbs_status nurbs_curve_length_with(const nurbs *g, const double *range, double relative_tolerance,
                                     double *length, double *error, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_curve_length(g, range, relative_tolerance, length, error); });
}

nurbs_status nurbs_curve_lengths_with(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                      double relative_tolerance, double *lengths, int64_t length_stride,
                                      const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_curve_lengths(g, n, params, param_stride, relative_tolerance, lengths, length_stride);
    });
}

nurbs_status nurbs_curve_params_at_lengths_with(const nurbs *g, int64_t n, const double *lengths,
                                                int64_t length_stride, double relative_tolerance,
                                                double *params, int64_t param_stride, uint32_t flags,
                                                const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_curve_params_at_lengths(g, n, lengths, length_stride, relative_tolerance, params,
                                             param_stride, flags);
    });
}

nurbs_status nurbs_curve_divide_with(const nurbs *g, const double *range, int64_t parts,
                                     double relative_tolerance, uint32_t flags, double *params, double *size,
                                     const nurbs_call_options *call) {
    return watched(
        call, [&] { return nurbs_curve_divide(g, range, parts, relative_tolerance, flags, params, size); });
}

nurbs_status nurbs_surface_area_with(const nurbs *g, const double *range, double relative_tolerance,
                                     double *area, double *error, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_surface_area(g, range, relative_tolerance, area, error); });
}

nurbs_status nurbs_moments_with(const nurbs *g, double relative_tolerance, double *content, double *centroid,
                                double *inertia, double *error, const nurbs_call_options *call) {
    return watched(call,
                   [&] { return nurbs_moments(g, relative_tolerance, content, centroid, inertia, error); });
}

nurbs_status nurbs_enclosed_area_with(int64_t count, const nurbs *const *curves, double tolerance,
                                      double relative_tolerance, double *area, double *centroid,
                                      double *inertia, double *error, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_enclosed_area(count, curves, tolerance, relative_tolerance, area, centroid, inertia,
                                   error);
    });
}

nurbs_status nurbs_enclosed_volume_with(int64_t count, const nurbs *const *surfaces,
                                        double relative_tolerance, double *volume, double *centroid,
                                        double *inertia, double *openness, double *error,
                                        const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_enclosed_volume(count, surfaces, relative_tolerance, volume, centroid, inertia, openness,
                                     error);
    });
}

nurbs_status nurbs_curve_features_with(const nurbs *g, uint32_t kinds, int64_t cap, double *params,
                                       int32_t *found, double *values, int64_t *count, int32_t *complete,
                                       const nurbs_call_options *call) {
    return watched(
        call, [&] { return nurbs_curve_features(g, kinds, cap, params, found, values, count, complete); });
}

nurbs_status nurbs_extrema_with(const nurbs *g, uint32_t kinds, int64_t cap, double *params, double *values,
                                int32_t *found, double *boxes, int64_t *count, int32_t *complete,
                                const nurbs_call_options *call) {
    return watched(
        call, [&] { return nurbs_extrema(g, kinds, cap, params, values, found, boxes, count, complete); });
}

nurbs_status nurbs_mesh_curve_with(const nurbs *g, double chord, double angle, double longest, int64_t cap,
                                   double *params, double *points, double *bound, int32_t *reached,
                                   int64_t *count, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_mesh_curve(g, chord, angle, longest, cap, params, points, bound, reached, count);
    });
}

nurbs_status nurbs_roots_with(const nurbs *g, double value, double tolerance, int64_t cap, double *params,
                              int32_t *kinds, double *ranges, int64_t *count, int32_t *complete,
                              const nurbs_call_options *call) {
    return watched(
        call, [&] { return nurbs_roots(g, value, tolerance, cap, params, kinds, ranges, count, complete); });
}

nurbs_status nurbs_curve_level_with(const nurbs *g, int32_t degree, const double *coefficients,
                                    double tolerance, int64_t cap, double *params, int32_t *kinds,
                                    double *ranges, int64_t *count, int32_t *complete,
                                    const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_curve_level(g, degree, coefficients, tolerance, cap, params, kinds, ranges, count,
                                 complete);
    });
}

nurbs_status nurbs_curve_intersections_with(const nurbs *a, const nurbs *b, double tolerance, int64_t cap,
                                            double *params_a, double *params_b, int32_t *kinds,
                                            double *ranges_a, double *ranges_b, int64_t *count,
                                            int32_t *complete, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_curve_intersections(a, b, tolerance, cap, params_a, params_b, kinds, ranges_a, ranges_b,
                                         count, complete);
    });
}

nurbs_status nurbs_curve_surface_intersections_with(const nurbs *curve, const nurbs *surface,
                                                    double tolerance, int64_t cap, double *params_curve,
                                                    double *params_surface, int32_t *kinds,
                                                    double *ranges_curve, double *ranges_surface,
                                                    int64_t *count, int32_t *complete,
                                                    const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_curve_surface_intersections(curve, surface, tolerance, cap, params_curve, params_surface,
                                                 kinds, ranges_curve, ranges_surface, count, complete);
    });
}

nurbs_status nurbs_surfaces_common_points_with(const nurbs *a, const nurbs *b, const nurbs *c,
                                               double tolerance, int64_t cap, double *params, double *points,
                                               int32_t *kinds, double *ranges, int64_t *count,
                                               int32_t *complete, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_surfaces_common_points(a, b, c, tolerance, cap, params, points, kinds, ranges, count,
                                            complete);
    });
}

nurbs_status nurbs_curve_self_intersections_with(const nurbs *g, double tolerance, int64_t cap,
                                                 double *params_a, double *params_b, int32_t *kinds,
                                                 double *ranges_a, double *ranges_b, int64_t *count,
                                                 int32_t *complete, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_curve_self_intersections(g, tolerance, cap, params_a, params_b, kinds, ranges_a,
                                              ranges_b, count, complete);
    });
}

nurbs_status nurbs_surface_rays_with(const nurbs *g, int64_t n, const double *origins, int64_t origin_stride,
                                     int64_t origin_component_stride, const double *directions,
                                     int64_t direction_stride, int64_t direction_component_stride,
                                     double *params, double *distances, int32_t *status,
                                     const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_surface_rays(g, n, origins, origin_stride, origin_component_stride, directions,
                                  direction_stride, direction_component_stride, params, distances, status);
    });
}

nurbs_status nurbs_face_rays_with(const nurbs_face *face, int64_t n, const double *origins,
                                  int64_t origin_stride, int64_t origin_component_stride,
                                  const double *directions, int64_t direction_stride,
                                  int64_t direction_component_stride, double *params, double *distances,
                                  int32_t *status, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_face_rays(face, n, origins, origin_stride, origin_component_stride, directions,
                               direction_stride, direction_component_stride, params, distances, status);
    });
}

nurbs_status nurbs_model_rays_with(const nurbs_model *model, int64_t n, const double *origins,
                                   const double *directions, double *params, double *distances,
                                   int32_t *status, int64_t *places, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_model_rays(model, n, origins, directions, params, distances, status, places);
    });
}

nurbs_status nurbs_model_ray_hits_with(const nurbs_model *model, const double *origin,
                                       const double *direction, const double *range, int64_t cap,
                                       double *params, double *distances, int32_t *kinds, int64_t *places,
                                       int64_t *count, int32_t *complete, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_model_ray_hits(model, origin, direction, range, cap, params, distances, kinds, places,
                                    count, complete);
    });
}

nurbs_status nurbs_model_classify_with(const nurbs_model *model, int64_t n, const double *points,
                                       int64_t point_stride, int64_t point_component_stride, double tolerance,
                                       int32_t *sides, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_model_classify(model, n, points, point_stride, point_component_stride, tolerance, sides);
    });
}

nurbs_status nurbs_fold_test_with(const nurbs *g, const double *reference, int32_t *result, double *positive,
                                  double *negative, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_fold_test(g, reference, result, positive, negative); });
}

nurbs_status nurbs_fold_pieces_with(const nurbs *g, const double *reference, int64_t cap, int32_t *folds,
                                    int32_t *signs, int64_t *count, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_fold_pieces(g, reference, cap, folds, signs, count); });
}

nurbs_status nurbs_bend_with(const nurbs *g, const double *origin, const double *along, const double *across,
                             double curvature, double lower, double upper, double tolerance,
                             double *deviation, int32_t *proven, const nurbs_call_options *call,
                             nurbs **out) {
    return watched(call, out, [&] {
        return nurbs_bend(g, origin, along, across, curvature, lower, upper, tolerance, deviation, proven,
                          out);
    });
}

nurbs_status nurbs_free_form_deform_with(const nurbs *g, const nurbs *volume, const double *lower,
                                         const double *upper, double tolerance, double *deviation,
                                         int32_t *proven, const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] {
        return nurbs_free_form_deform(g, volume, lower, upper, tolerance, deviation, proven, out);
    });
}

nurbs_status nurbs_fair_with(const nurbs *g, int32_t order, const int32_t *keep, double tolerance,
                             double *energies, double *bound, const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] { return nurbs_fair(g, order, keep, tolerance, energies, bound, out); });
}

nurbs_status nurbs_read_with(const void *bytes, int64_t size, const nurbs_read_options *options,
                             const nurbs_call_options *call, nurbs_list **out) {
    return watched(call, out, [&] { return nurbs_read(bytes, size, options, out); });
}

nurbs_status nurbs_read_file_with(const char *path, const nurbs_read_options *options,
                                  const nurbs_call_options *call, nurbs_list **out) {
    return watched(call, out, [&] { return nurbs_read_file(path, options, out); });
}
