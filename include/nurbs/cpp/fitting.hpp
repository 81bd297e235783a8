/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file fitting.hpp
/// \brief Splines closest to data, and statistics of data.
#ifndef NURBS_CPP_FITTING_HPP
#define NURBS_CPP_FITTING_HPP

#include <nurbs/cpp/data.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// How smooth a fit is.
inline constexpr std::int32_t smoothing_none = NURBS_SMOOTHING_NONE;
inline constexpr std::int32_t smoothing_lambda = NURBS_SMOOTHING_LAMBDA;
inline constexpr std::int32_t smoothing_gcv = NURBS_SMOOTHING_GCV;
inline constexpr std::int32_t smoothing_reml = NURBS_SMOOTHING_REML;
inline constexpr std::int32_t smoothing_discrepancy = NURBS_SMOOTHING_DISCREPANCY;

/// What outliers are worth.
inline constexpr std::int32_t robust_none = NURBS_ROBUST_NONE;
inline constexpr std::int32_t robust_huber = NURBS_ROBUST_HUBER;
inline constexpr std::int32_t robust_tukey = NURBS_ROBUST_TUKEY;

/// Shapes along an axis; they can be added.
inline constexpr std::int32_t trend_rising = NURBS_TREND_RISING;
inline constexpr std::int32_t trend_falling = NURBS_TREND_FALLING;
inline constexpr std::int32_t trend_convex = NURBS_TREND_CONVEX;
inline constexpr std::int32_t trend_concave = NURBS_TREND_CONCAVE;

/// What the report of a fit tells besides.
inline constexpr std::int32_t fit_target_missed = NURBS_FIT_TARGET_MISSED;
inline constexpr std::int32_t fit_not_converged = NURBS_FIT_NOT_CONVERGED;

/// What the report of a fit of points without parameters tells besides.
inline constexpr std::int32_t cloud_not_converged = NURBS_CLOUD_NOT_CONVERGED;

/// What a fit is to be besides close to the data, initialised to the defaults. Later versions of this header
/// may know more of them: where libraries that were compiled with two versions meet in one program, each has
/// to say its own size, and none the other's.
struct FitOptions : nurbs_fit_options {
    [[gnu::always_inline]] FitOptions() : nurbs_fit_options{} {
        detail::call(nurbs_fit_options_init, this, static_cast<std::int64_t>(sizeof(nurbs_fit_options)));
    }
};

/// What a fit tells.
struct FitReport : nurbs_fit_report {
    [[gnu::always_inline]] FitReport() noexcept : nurbs_fit_report{} {
        struct_size = static_cast<std::int64_t>(sizeof(nurbs_fit_report));
    }
};

/// How a fit of points without parameters goes on, initialised to the defaults. Later versions of this header
/// may know more of them: where libraries that were compiled with two versions meet in one program, each has
/// to say its own size, and none the other's.
struct CloudOptions : nurbs_cloud_options {
    [[gnu::always_inline]] CloudOptions() : nurbs_cloud_options{} {
        detail::call(nurbs_cloud_options_init, this, static_cast<std::int64_t>(sizeof(nurbs_cloud_options)));
    }
};

/// What a fit of points without parameters tells.
struct CloudReport : nurbs_cloud_report {
    [[gnu::always_inline]] CloudReport() noexcept : nurbs_cloud_report{} {
        struct_size = static_cast<std::int64_t>(sizeof(nurbs_cloud_report));
    }
};

/// How much data statistics hold.
struct StatisticsSize {
    std::int32_t axes;  ///< Number of axes.
    std::int32_t dim;   ///< Dimension of the values.
    std::int64_t count; ///< Number of data that count.
    std::int64_t cells; ///< Number of cells that hold any of them.
    double weight;      ///< Sum of the weights.
};

/// The spline, and what the fit tells.
struct Fitted {
    Spline spline;    ///< The spline.
    FitReport report; ///< What the fit tells.
};

/// The spline over full knot vectors, all axes one after the other, that is closest to data.
inline Returned<Fitted> fit_points(const Data &data, View<std::int32_t> degrees, View<std::int64_t> counts,
                                   View<double> knots, const FitOptions &options = {},
                                   std::uint32_t flags = 0) {
    const std::int64_t axes = detail::axes(data);
    detail::require(degrees, axes, "degrees");
    detail::require(counts, axes, "counts");
    Fitted made{};
    made.spline = detail::made<Spline>(nurbs_fit_points, &data, degrees.data(), counts.data(), knots.data(),
                                       detail::length(knots), flags, &options, &made.report);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Fitted> fit_points(const Data &data, View<std::int32_t> degrees, View<std::int64_t> counts,
                                   View<double> knots, const FitOptions &options, std::uint32_t flags,
                                   const CallOptions &call) {
    const std::int64_t axes = detail::axes(data);
    detail::require(degrees, axes, "degrees");
    detail::require(counts, axes, "counts");
    Fitted made{};
    const detail::Watch watch(call);
    made.spline =
        detail::made<Spline>(nurbs_fit_points_with, &data, degrees.data(), counts.data(), knots.data(),
                             detail::length(knots), flags, &options, &made.report, watch.get());
    return made;
}

/// A spline with few control points that no datum is farther from than the tolerance.
inline Returned<Fitted> fit_tolerance(const Data &data, View<std::int32_t> degrees, double tolerance,
                                      View<double> domain = {}, std::int64_t max_count = 0,
                                      const FitOptions &options = {}, std::uint32_t flags = 0) {
    const std::int64_t axes = detail::axes(data);
    detail::require(degrees, axes, "degrees");
    detail::require_given(domain, 2 * axes, "domain");
    Fitted made{};
    made.spline = detail::made<Spline>(nurbs_fit_tolerance, &data, degrees.data(), detail::pointer(domain),
                                       tolerance, max_count, flags, &options, &made.report);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Fitted> fit_tolerance(const Data &data, View<std::int32_t> degrees, double tolerance,
                                      View<double> domain, std::int64_t max_count, const FitOptions &options,
                                      std::uint32_t flags, const CallOptions &call) {
    const std::int64_t axes = detail::axes(data);
    detail::require(degrees, axes, "degrees");
    detail::require_given(domain, 2 * axes, "domain");
    Fitted made{};
    const detail::Watch watch(call);
    made.spline =
        detail::made<Spline>(nurbs_fit_tolerance_with, &data, degrees.data(), detail::pointer(domain),
                             tolerance, max_count, flags, &options, &made.report, watch.get());
    return made;
}

/// A spline over full knot vectors, all axes one after the other, along the principal directions of points.
inline Returned<Spline> cloud_start(View<std::int32_t> degrees, View<std::int64_t> counts, View<double> knots,
                                    std::int32_t dim, Input points, std::uint32_t flags = 0) {
    detail::require(counts, detail::length(degrees), "counts");
    const std::int64_t n = detail::records(points, dim, "points");
    return detail::made<Spline>(nurbs_cloud_start, detail::axes_of(degrees), degrees.data(), counts.data(),
                                knots.data(), detail::length(knots), n, dim, points.data(), points.stride(),
                                points.component_stride(), flags);
}

/// The spline, and what the fit of points without parameters tells.
struct FittedCloud {
    Spline spline;      ///< The spline.
    CloudReport report; ///< What the fit tells.
};

/// The spline over the same knots that is closest to points without parameters, found from this one.
inline Returned<FittedCloud> fit_cloud(const Spline &g, Input points, Input weights = {},
                                       const CloudOptions &options = {}) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    detail::require_wanted(weights, n, 1, "weights");
    FittedCloud made{};
    made.spline = detail::made<Spline>(nurbs_fit_cloud, g.get(), n, points.data(), points.stride(),
                                       points.component_stride(), detail::pointer(weights), weights.step(),
                                       &options, &made.report);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<FittedCloud> fit_cloud(const Spline &g, Input points, Input weights,
                                       const CloudOptions &options, const CallOptions &call) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    detail::require_wanted(weights, n, 1, "weights");
    FittedCloud made{};
    const detail::Watch watch(call);
    made.spline = detail::made<Spline>(nurbs_fit_cloud_with, g.get(), n, points.data(), points.stride(),
                                       points.component_stride(), detail::pointer(weights), weights.step(),
                                       &options, &made.report, watch.get());
    return made;
}

/// What fits need to know of data: a handle that is copied in constant time and freed by its destructor.
class Statistics : public detail::StatisticsHandle {
public:
    using StatisticsHandle::StatisticsHandle;

    // Splines closest to data, and statistics of data

    /// Statistics of no data, about cells between breaks and splines of at most the given degrees.
    [[nodiscard]] static Returned<Statistics> create(View<std::int32_t> degrees,
                                                     View<std::int64_t> break_counts, View<double> breaks,
                                                     std::int32_t dim, double value_scale,
                                                     double weight_scale = 1) {
        detail::require(break_counts, detail::length(degrees), "break_counts");
        return detail::made<Statistics>(nurbs_statistics_create, detail::axes_of(degrees), degrees.data(),
                                        break_counts.data(), breaks.data(), detail::length(breaks), dim,
                                        value_scale, weight_scale);
    }
    /// Statistics with more data; the sums are exact.
    [[nodiscard]] Returned<Statistics> add(const Data &data) const {
        return detail::made<Statistics>(nurbs_statistics_add, get(), &data);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Statistics> add(const Data &data, const CallOptions &call) const {
        const detail::Watch watch(call);
        return detail::made<Statistics>(nurbs_statistics_add_with, get(), &data, watch.get());
    }
    /// The sum of statistics, of some of them with the sign -1: the same bits for any order and partition of the
    /// data.
    [[nodiscard]] static Returned<Statistics> merge(std::span<const Statistics> parts,
                                                    View<std::int32_t> signs = {}) {
        const std::int64_t count = detail::length(parts);
        detail::require_given(signs, count, "signs");
        return detail::made<Statistics>(nurbs_statistics_merge, count, detail::handle_list(parts).data(),
                                        detail::pointer(signs));
    }
    /// How much data they hold.
    [[nodiscard]] Returned<StatisticsSize> size() const {
        StatisticsSize found{};
        detail::call(nurbs_statistics_size, get(), &found.axes, &found.dim, &found.count, &found.cells,
                     &found.weight);
        return found;
    }
    /// Statistics from what to_bytes() made of them.
    [[nodiscard]] static Returned<Statistics> from_bytes(std::span<const std::byte> bytes) {
        return detail::made<Statistics>(nurbs_statistics_from_bytes, bytes.data(), detail::length(bytes));
    }
    /// The spline over full knot vectors, all axes one after the other, that is closest to the data.
    [[nodiscard]] Returned<Fitted> fit(View<std::int32_t> degrees, View<std::int64_t> counts,
                                       View<double> knots, const FitOptions &options = {},
                                       std::uint32_t flags = 0) const {
        const std::int64_t axes = detail::axes(get());
        detail::require(degrees, axes, "degrees");
        detail::require(counts, axes, "counts");
        Fitted made{};
        made.spline = detail::made<Spline>(nurbs_fit, get(), degrees.data(), counts.data(), knots.data(),
                                           detail::length(knots), flags, &options, &made.report);
        return made;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Fitted> fit(View<std::int32_t> degrees, View<std::int64_t> counts,
                                       View<double> knots, const FitOptions &options, std::uint32_t flags,
                                       const CallOptions &call) const {
        const std::int64_t axes = detail::axes(get());
        detail::require(degrees, axes, "degrees");
        detail::require(counts, axes, "counts");
        Fitted made{};
        const detail::Watch watch(call);
        made.spline = detail::made<Spline>(nurbs_fit_with, get(), degrees.data(), counts.data(), knots.data(),
                                           detail::length(knots), flags, &options, &made.report, watch.get());
        return made;
    }
    /// Pointwise standard errors of a fit over the knots of g.
    [[nodiscard]] Returned<std::vector<double>> fit_errors(const Spline &g, std::int32_t penalty_order,
                                                           double lambda, double sigma, Input params,
                                                           std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        std::vector<double> values = detail::room(n);
        detail::call(nurbs_fit_errors, get(), g.get(), penalty_order, lambda, sigma, n, params.data(),
                     params.stride(), params.component_stride(), flags, values.data());
        return values;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<std::vector<double>> fit_errors(const Spline &g, std::int32_t penalty_order,
                                                           double lambda, double sigma, Input params,
                                                           std::uint32_t flags,
                                                           const CallOptions &call) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        const detail::Watch watch(call);
        std::vector<double> values = detail::room(n);
        detail::call(nurbs_fit_errors_with, get(), g.get(), penalty_order, lambda, sigma, n, params.data(),
                     params.stride(), params.component_stride(), flags, values.data(), watch.get());
        return values;
    }
    /// Squares, freedom, GCV and REML, four numbers for each factor of the penalty.
    [[nodiscard]] Returned<std::vector<double>> fit_criteria(const Spline &g, std::int32_t penalty_order,
                                                             View<double> lambdas) const {
        const std::int64_t n = detail::length(lambdas);
        std::vector<double> values = detail::room(n, 4);
        detail::call(nurbs_fit_criteria, get(), g.get(), penalty_order, n, lambdas.data(), values.data());
        return values;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<std::vector<double>> fit_criteria(const Spline &g, std::int32_t penalty_order,
                                                             View<double> lambdas,
                                                             const CallOptions &call) const {
        const std::int64_t n = detail::length(lambdas);
        const detail::Watch watch(call);
        std::vector<double> values = detail::room(n, 4);
        detail::call(nurbs_fit_criteria_with, get(), g.get(), penalty_order, n, lambdas.data(), values.data(),
                     watch.get());
        return values;
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_FITTING_HPP
