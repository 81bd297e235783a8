/* SPDX-License-Identifier: MIT */
/// \file calls.hpp
/// \brief Calls that can be watched, limited and ended.
#ifndef NURBS_CPP_CALLS_HPP
#define NURBS_CPP_CALLS_HPP

#include <nurbs/cpp/result.hpp>

#include <cstdint>
#include <exception>
#include <functional>
#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// What a caller wants of a long call: the last argument of the functions that can take long.
struct CallOptions {
    /// Most multiply-adds; 0 sets no limit. At the limit searches answer with what is proven so far; other calls fail
    /// with Status::work.
    std::int64_t work = 0;
    /// Called at most every 10 ms with an estimate from 0 to 1 of how much is done. Returns whether the call is to go
    /// on; else it fails with Status::cancelled. An exception ends the call, which then throws it; where nothing
    /// throws, the call is cancelled.
    std::function<bool(double done)> progress = {};
};

namespace detail {

// The options as the library has them, for one call.
class Watch {
public:
    explicit Watch(const CallOptions &call) : call_(call) {
        static_cast<void>(nurbs_call_options_init(&options_, sizeof options_));
        options_.work = call.work;
        options_.progress = call.progress ? &Watch::progress : nullptr;
        options_.user = this;
    }
    Watch(const Watch &) = delete;
    Watch &operator=(const Watch &) = delete;

    [[nodiscard]] const nurbs_call_options *get() const noexcept { return &options_; }

private:
    static std::int32_t progress(double done, void *user) {
        const Watch &watch = *static_cast<const Watch *>(user);
#ifdef __cpp_exceptions
        try {
            return watch.call_.progress(done) ? 0 : 1;
#ifdef __GLIBCXX__
        } catch (abi::__forced_unwind &) { // the thread ends
            throw;
#endif
        } catch (...) {
            keep(std::current_exception());
            return 1;
        }
#else
        return watch.call_.progress(done) ? 0 : 1;
#endif
    }

    const CallOptions &call_;
    nurbs_call_options options_{};
};

// The long calls that take structs, with the arguments of their plain forms.

using Extremal = nurbs_status(const nurbs *, const nurbs_closest_query *, const nurbs_closest_answer *,
                              const nurbs_call_options *);

inline nurbs_closest_query closest_query(std::int64_t n, const double *points, std::int64_t stride,
                                         std::int64_t component_stride, std::uint32_t flags) {
    nurbs_closest_query query{};
    query.struct_size = sizeof query;
    query.n = n;
    query.points = points;
    query.point_stride = stride;
    query.point_component_stride = component_stride;
    query.flags = flags;
    return query;
}

inline nurbs_closest_answer closest_answer(double *params, std::int64_t param_stride,
                                           std::int64_t param_component_stride, double *feet,
                                           std::int64_t foot_stride, std::int64_t foot_component_stride,
                                           double *distances, std::int64_t distance_stride,
                                           std::int32_t *status) {
    return {sizeof(nurbs_closest_answer),
            params,
            param_stride,
            param_component_stride,
            feet,
            foot_stride,
            foot_component_stride,
            distances,
            distance_stride,
            status};
}

template <Extremal *find>
nurbs_status extremal_points(const nurbs *g, std::int64_t n, const double *points, std::int64_t point_stride,
                             std::int64_t point_component_stride, const double *range, double tolerance,
                             std::int64_t budget, double *params, std::int64_t param_stride,
                             std::int64_t param_component_stride, double *feet, std::int64_t foot_stride,
                             std::int64_t foot_component_stride, double *distances,
                             std::int64_t distance_stride, std::int32_t *status, std::uint32_t flags,
                             const nurbs_call_options *call) {
    nurbs_closest_query query = closest_query(n, points, point_stride, point_component_stride, flags);
    query.range = range;
    query.tolerance = tolerance;
    query.budget = budget;
    const nurbs_closest_answer answer =
        closest_answer(params, param_stride, param_component_stride, feet, foot_stride, foot_component_stride,
                       distances, distance_stride, status);
    return find(g, &query, &answer, call);
}
inline constexpr auto nurbs_closest_points_with = &extremal_points<::nurbs_closest_points_with>;
inline constexpr auto nurbs_farthest_points_with = &extremal_points<::nurbs_farthest_points_with>;

inline nurbs_status nurbs_closest_local_with(const nurbs *g, std::int64_t n, const double *points,
                                             std::int64_t point_stride, std::int64_t point_component_stride,
                                             const double *guesses, std::int64_t guess_stride,
                                             std::int64_t guess_component_stride, double *params,
                                             std::int64_t param_stride, std::int64_t param_component_stride,
                                             double *feet, std::int64_t foot_stride,
                                             std::int64_t foot_component_stride, double *distances,
                                             std::int64_t distance_stride, std::int32_t *status,
                                             std::uint32_t flags, const nurbs_call_options *call) {
    nurbs_closest_query query = closest_query(n, points, point_stride, point_component_stride, flags);
    query.guesses = guesses;
    query.guess_stride = guess_stride;
    query.guess_component_stride = guess_component_stride;
    const nurbs_closest_answer answer =
        closest_answer(params, param_stride, param_component_stride, feet, foot_stride, foot_component_stride,
                       distances, distance_stride, status);
    return ::nurbs_closest_local_with(g, &query, &answer, call);
}

inline nurbs_status nurbs_curve_signed_distances_with(const nurbs *g, std::int64_t n, const double *points,
                                                      std::int64_t point_stride,
                                                      std::int64_t point_component_stride, double tolerance,
                                                      std::int64_t budget, double *distances,
                                                      std::int64_t distance_stride, double *params,
                                                      std::int64_t param_stride, std::int32_t *status,
                                                      std::uint32_t flags, const nurbs_call_options *call) {
    nurbs_closest_query query = closest_query(n, points, point_stride, point_component_stride, flags);
    query.tolerance = tolerance;
    query.budget = budget;
    const nurbs_closest_answer answer =
        closest_answer(params, param_stride, 0, nullptr, 0, 0, distances, distance_stride, status);
    return ::nurbs_curve_signed_distances_with(g, &query, &answer, call);
}

inline nurbs_status nurbs_constrain_with(const nurbs *g, std::int64_t count, const std::int32_t *kinds,
                                         const std::int32_t *orders, const double *params,
                                         const double *targets, const std::int32_t *keep, const double *costs,
                                         const double *weight_costs, double tolerance, double *residuals,
                                         std::int64_t *rank, double *moved, double *optimality,
                                         const nurbs_call_options *call, nurbs **out) {
    const nurbs_constraints constraints{
        sizeof constraints, count, kinds, orders, params, targets, keep, costs, weight_costs, tolerance};
    nurbs_constraint_report report{sizeof report, residuals, 0, 0, 0};
    const nurbs_status status = ::nurbs_constrain_with(g, &constraints, &report, call, out);
    if (status == NURBS_OK) {
        const auto put = [](auto *to, auto value) {
            if (to != nullptr) {
                *to = value;
            }
        };
        put(rank, report.rank);
        put(moved, report.moved);
        put(optimality, report.optimality);
    }
    return status;
}

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CALLS_HPP
