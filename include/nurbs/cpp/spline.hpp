/* SPDX-License-Identifier: MIT */
/// \file spline.hpp
/// \brief The class of curves, surfaces and volumes.
#ifndef NURBS_CPP_SPLINE_HPP
#define NURBS_CPP_SPLINE_HPP

#include <nurbs/cpp/arrays.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

struct DistinctKnots {
    std::vector<double> knots;
    std::vector<std::int32_t> multiplicities;
};

/// Active basis functions at parameters: where they start, and their values.
struct Basis {
    std::vector<std::int64_t> spans;
    std::vector<double> values;
};

namespace detail {

// What the functions of this header ask themselves; 0 after a failure.
inline std::int32_t axes(const nurbs *g) {
    return result_of<std::int32_t>([&](auto *v) { return nurbs_axes(g, v); });
}
inline std::int32_t dimension(const nurbs *g) {
    return result_of<std::int32_t>([&](auto *v) { return nurbs_dimension(g, v); });
}
inline std::int32_t degree(const nurbs *g, std::int32_t axis) {
    return result_of<std::int32_t>([&](auto *v) { return nurbs_degree(g, axis, v); });
}
inline std::int64_t count(const nurbs *g, std::int32_t axis) {
    return result_of<std::int64_t>([&](auto *v) { return nurbs_count(g, axis, v); });
}
inline std::int64_t point_count(const nurbs *g) {
    return result_of<std::int64_t>([&](auto *v) { return nurbs_point_count(g, v); });
}
inline bool is_rational(const nurbs *g) {
    return result_of<std::int32_t>([&](auto *v) { return nurbs_is_rational(g, v); }) != 0;
}
inline std::int64_t derivative_slots(std::int32_t axes, std::int32_t order) {
    return result_of<std::int64_t>([&](auto *v) { return nurbs_derivative_slots(axes, order, v); });
}

} // namespace detail

/// Number of derivative slots, binomial(order + axes, axes).
inline Returned<std::int64_t> derivative_slots(std::int32_t axes, std::int32_t order) {
    return detail::derivative_slots(axes, order);
}

/// A curve, surface or volume: a handle that is copied in constant time and freed by its destructor.
class Spline {
public:
    Spline() noexcept = default;
    explicit Spline(nurbs *owned) noexcept : handle_(owned) {}
    /// Only memory can be missing; where nothing throws, the copy is then empty, and clone() tells.
    Spline(const Spline &other) {
        if (other.handle_ != nullptr) {
            detail::check_copy(nurbs_clone(other.handle_, &handle_));
        }
    }
    Spline(Spline &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Spline &operator=(Spline other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Spline() { nurbs_destroy(handle_); }

    [[nodiscard]] const nurbs *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs *release() noexcept { return std::exchange(handle_, nullptr); }

    // Construction

    [[nodiscard]] Returned<Spline> clone() const { return made(nurbs_clone, handle_); }
    static Returned<Spline> create(View<std::int32_t> degrees, View<std::int64_t> counts, View<double> knots,
                                   std::int32_t dim, Input points, Input weights = {},
                                   std::uint32_t flags = 0) {
        check_net(degrees, counts, dim, points, weights);
        return made(nurbs_create, axes_of(degrees), degrees.data(), counts.data(), knots.data(),
                    detail::length(knots), dim, points.data(), points.stride(), points.component_stride(),
                    weights.data(), weights.step(), flags);
    }
    static Returned<Spline> create_homogeneous(View<std::int32_t> degrees, View<std::int64_t> counts,
                                               View<double> knots, std::int32_t dim, Input points,
                                               std::uint32_t flags = 0) {
        check_net(degrees, counts, dim < max_width ? dim + 1 : dim, points, {});
        return made(nurbs_create_homogeneous, axes_of(degrees), degrees.data(), counts.data(), knots.data(),
                    detail::length(knots), dim, points.data(), points.stride(), points.component_stride(),
                    flags);
    }
    static Returned<Spline> create_short(View<std::int32_t> degrees, View<std::int64_t> counts,
                                         View<double> knots, std::int32_t dim, Input points,
                                         Input weights = {}, std::uint32_t flags = 0) {
        check_net(degrees, counts, dim, points, weights);
        return made(nurbs_create_short, axes_of(degrees), degrees.data(), counts.data(), knots.data(),
                    detail::length(knots), dim, points.data(), points.stride(), points.component_stride(),
                    weights.data(), weights.step(), flags);
    }
    static Returned<Spline> create_multiplicities(View<std::int32_t> degrees, View<std::int64_t> counts,
                                                  View<std::int64_t> distinct_counts,
                                                  View<double> distinct_knots,
                                                  View<std::int32_t> multiplicities, std::int32_t dim,
                                                  Input points, Input weights = {}, std::uint32_t flags = 0) {
        check_net(degrees, counts, dim, points, weights);
        check_distinct(degrees.size(), distinct_counts, distinct_knots, multiplicities);
        return made(nurbs_create_multiplicities, axes_of(degrees), degrees.data(), counts.data(),
                    distinct_counts.data(), distinct_knots.data(), multiplicities.data(), dim, points.data(),
                    points.stride(), points.component_stride(), weights.data(), weights.step(), flags);
    }
    static Returned<Spline> create_bezier(View<std::int32_t> degrees, std::int32_t dim, Input points,
                                          Input weights = {}) {
        std::vector<std::int64_t> counts(degrees.begin(), degrees.end());
        for (auto &count : counts) {
            ++count;
        }
        check_net(degrees, counts, dim, points, weights);
        return made(nurbs_create_bezier, axes_of(degrees), degrees.data(), dim, points.data(),
                    points.stride(), points.component_stride(), weights.data(), weights.step());
    }
    [[nodiscard]] Returned<Spline> with_points(Input points, Input weights = {}) const {
        points.require(detail::point_count(handle_), detail::dimension(handle_), "points");
        require_weights(weights, detail::point_count(handle_));
        return made(nurbs_with_points, handle_, points.data(), points.stride(), points.component_stride(),
                    weights.data(), weights.step());
    }

    // Inspection

    [[nodiscard]] Returned<std::int32_t> axes() const { return detail::axes(handle_); }
    [[nodiscard]] Returned<std::int32_t> dimension() const { return detail::dimension(handle_); }
    [[nodiscard]] Returned<std::int32_t> degree(std::int32_t axis) const {
        return detail::degree(handle_, axis);
    }
    [[nodiscard]] Returned<std::int64_t> count(std::int32_t axis) const {
        return detail::count(handle_, axis);
    }
    [[nodiscard]] Returned<std::int64_t> point_count() const { return detail::point_count(handle_); }
    [[nodiscard]] Returned<bool> is_rational() const { return detail::is_rational(handle_); }
    /// Whether homogeneous points are stored, and not Cartesian ones with or without weights.
    [[nodiscard]] Returned<bool> is_homogeneous() const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_is_homogeneous(handle_, v); }) !=
               0;
    }
    [[nodiscard]] Returned<std::int32_t> knot_form(std::int32_t axis) const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_knot_form(handle_, axis, v); });
    }
    [[nodiscard]] Returned<std::array<double, 2>> domain(std::int32_t axis) const {
        return detail::result_of<std::array<double, 2>>(
            [&](auto *v) { return nurbs_domain(handle_, axis, v->data()); });
    }
    [[nodiscard]] Returned<std::vector<double>> knots(std::int32_t axis) const {
        const std::int64_t size = detail::count(handle_, axis) + detail::degree(handle_, axis) + 1;
        return detail::filled(
            size, [&](auto &v) { return detail::call(nurbs_knots, handle_, axis, size, v.data()); });
    }
    [[nodiscard]] Returned<DistinctKnots> distinct_knots(std::int32_t axis) const {
        auto size = detail::result_of<std::int64_t>(
            [&](auto *v) { return nurbs_distinct_knots(handle_, axis, 0, nullptr, nullptr, v); });
        DistinctKnots result{std::vector<double>(detail::to_size(size)),
                             std::vector<std::int32_t>(detail::to_size(size))};
        detail::call(nurbs_distinct_knots, handle_, axis, size, result.knots.data(),
                     result.multiplicities.data(), &size);
        return result;
    }
    [[nodiscard]] Returned<std::vector<double>> greville(std::int32_t axis) const {
        const std::int64_t size = detail::count(handle_, axis);
        return detail::filled(
            size, [&](auto &v) { return detail::call(nurbs_greville, handle_, axis, size, v.data()); });
    }
    Returned<void> points(Output points) const {
        points.require(detail::point_count(handle_), detail::dimension(handle_), "points");
        return detail::call(nurbs_points, handle_, detail::point_count(handle_), points.data(),
                            points.stride(), points.component_stride());
    }
    [[nodiscard]] Returned<std::vector<double>> points() const {
        return detail::filled(detail::point_count(handle_) * detail::dimension(handle_),
                              [&](auto &v) { return points(v); });
    }
    Returned<void> weights(Output weights) const {
        weights.require(detail::point_count(handle_), 1, "weights");
        return detail::call(nurbs_weights, handle_, detail::point_count(handle_), weights.data(),
                            weights.step());
    }
    [[nodiscard]] Returned<std::vector<double>> weights() const {
        return detail::filled(detail::point_count(handle_), [&](auto &v) { return weights(v); });
    }
    Returned<void> homogeneous_points(Output points) const {
        points.require(detail::point_count(handle_), detail::dimension(handle_) + 1, "points");
        return detail::call(nurbs_homogeneous_points, handle_, detail::point_count(handle_), points.data(),
                            points.stride(), points.component_stride());
    }
    [[nodiscard]] Returned<std::vector<double>> homogeneous_points() const {
        return detail::filled(detail::point_count(handle_) * (detail::dimension(handle_) + 1),
                              [&](auto &v) { return homogeneous_points(v); });
    }
    Returned<void> hull_size(Input params, Output sizes, std::uint32_t flags = 0) const {
        const std::int64_t n = batch(params, sizes, 1, "sizes");
        return detail::call(nurbs_hull_size, handle_, n, params.data(), params.stride(),
                            params.component_stride(), sizes.data(), sizes.step(), flags);
    }
    [[nodiscard]] Returned<std::vector<double>> hull_size(Input params, std::uint32_t flags = 0) const {
        return detail::filled(number_of(params), [&](auto &v) { return hull_size(params, v, flags); });
    }

    // Evaluation

    Returned<void> eval(Input params, Output points, std::uint32_t flags = 0) const {
        const std::int64_t n = batch(params, points, detail::dimension(handle_), "points");
        return detail::call(nurbs_eval, handle_, n, params.data(), params.stride(), params.component_stride(),
                            points.data(), points.stride(), points.component_stride(), flags);
    }
    [[nodiscard]] Returned<std::vector<double>> eval(Input params, std::uint32_t flags = 0) const {
        return detail::filled(number_of(params) * detail::dimension(handle_),
                              [&](auto &v) { return eval(params, v, flags); });
    }
    Returned<void> eval_derivs(std::int32_t order, Input params, Output derivs,
                               std::uint32_t flags = 0) const {
        const std::int64_t n = batch(params, derivs, slots(order) * detail::dimension(handle_), "derivs");
        return detail::call(nurbs_eval_derivs, handle_, order, n, params.data(), params.stride(),
                            params.component_stride(), derivs.data(), derivs.stride(),
                            derivs.component_stride(), flags);
    }
    [[nodiscard]] Returned<std::vector<double>> eval_derivs(std::int32_t order, Input params,
                                                            std::uint32_t flags = 0) const {
        return detail::filled(number_of(params) * slots(order) * detail::dimension(handle_),
                              [&](auto &v) { return eval_derivs(order, params, v, flags); });
    }
    Returned<void> eval_grid(View<std::int64_t> counts, View<double> params, Output points,
                             std::uint32_t flags = 0) const {
        points.require(grid(counts, params), detail::dimension(handle_), "points");
        return detail::call(nurbs_eval_grid, handle_, counts.data(), params.data(), points.data(),
                            points.stride(), points.component_stride(), flags);
    }
    [[nodiscard]] Returned<std::vector<double>> eval_grid(View<std::int64_t> counts, View<double> params,
                                                          std::uint32_t flags = 0) const {
        return detail::filled(grid(counts, params) * detail::dimension(handle_),
                              [&](auto &v) { return eval_grid(counts, params, v, flags); });
    }
    Returned<void> eval_grid_derivs(std::int32_t order, View<std::int64_t> counts, View<double> params,
                                    Output derivs, std::uint32_t flags = 0) const {
        derivs.require(grid(counts, params), slots(order) * detail::dimension(handle_), "derivs");
        return detail::call(nurbs_eval_grid_derivs, handle_, order, counts.data(), params.data(),
                            derivs.data(), derivs.stride(), derivs.component_stride(), flags);
    }
    [[nodiscard]] Returned<std::vector<double>> eval_grid_derivs(std::int32_t order,
                                                                 View<std::int64_t> counts,
                                                                 View<double> params,
                                                                 std::uint32_t flags = 0) const {
        return detail::filled(grid(counts, params) * slots(order) * detail::dimension(handle_),
                              [&](auto &v) { return eval_grid_derivs(order, counts, params, v, flags); });
    }
    /// The points of eval(), rounded once to single precision.
    Returned<void> eval_f32(Input params, FloatOutput points, std::uint32_t flags = 0) const {
        const std::int64_t n = number_of(params);
        points.require(n, detail::dimension(handle_), "points");
        return detail::call(nurbs_eval_f32, handle_, n, params.data(), params.stride(),
                            params.component_stride(), points.data(), points.stride(),
                            points.component_stride(), flags);
    }
    [[nodiscard]] Returned<std::vector<float>> eval_f32(Input params, std::uint32_t flags = 0) const {
        return detail::filled<float>(number_of(params) * detail::dimension(handle_),
                                     [&](auto &v) { return eval_f32(params, v, flags); });
    }
    Returned<void> eval_grid_f32(View<std::int64_t> counts, View<double> params, FloatOutput points,
                                 std::uint32_t flags = 0) const {
        points.require(grid(counts, params), detail::dimension(handle_), "points");
        return detail::call(nurbs_eval_grid_f32, handle_, counts.data(), params.data(), points.data(),
                            points.stride(), points.component_stride(), flags);
    }
    [[nodiscard]] Returned<std::vector<float>> eval_grid_f32(View<std::int64_t> counts, View<double> params,
                                                             std::uint32_t flags = 0) const {
        return detail::filled<float>(grid(counts, params) * detail::dimension(handle_),
                                     [&](auto &v) { return eval_grid_f32(counts, params, v, flags); });
    }
    /// R_i at each parameter; the spans are [n][axes].
    [[nodiscard]] Returned<Basis> rational_basis(Input params, std::uint32_t flags = 0) const {
        std::int64_t active = 1;
        for (std::int32_t axis = 0; axis < detail::axes(handle_); ++axis) {
            active *= detail::degree(handle_, axis) + 1;
        }
        const std::int64_t n = number_of(params);
        Basis result{std::vector<std::int64_t>(detail::to_size(n * detail::axes(handle_))),
                     std::vector<double>(detail::to_size(n * active))};
        detail::call(nurbs_rational_basis, handle_, n, params.data(), params.stride(),
                     params.component_stride(), result.spans.data(), result.values.data(), 0, 0, flags);
        return result;
    }

    // Operations

    [[nodiscard]] Returned<Spline> iso(std::int32_t axis, double param, std::uint32_t flags = 0) const {
        return made(nurbs_iso, handle_, axis, param, flags);
    }
    [[nodiscard]] Returned<Spline> insert_knot(std::int32_t axis, double knot, std::int32_t times = 1) const {
        return made(nurbs_insert_knot, handle_, axis, knot, times);
    }
    [[nodiscard]] Returned<Spline> elevate(std::int32_t axis, std::int32_t times = 1) const {
        return made(nurbs_elevate, handle_, axis, times);
    }
    [[nodiscard]] Returned<Spline> reverse(std::int32_t axis, std::uint32_t flags = 0) const {
        return made(nurbs_reverse, handle_, axis, flags);
    }
    [[nodiscard]] Returned<Spline> transpose(View<std::int32_t> permutation) const {
        if (detail::length(permutation) != detail::axes(handle_)) {
            detail::wrong_size("permutation", permutation.size(), std::to_string(detail::axes(handle_)));
        }
        return made(nurbs_transpose, handle_, permutation.data());
    }
    [[nodiscard]] Returned<Spline> reparametrize(std::int32_t axis, double lower, double upper) const {
        return made(nurbs_reparametrize, handle_, axis, lower, upper);
    }
    [[nodiscard]] Returned<Spline> make_rational() const { return made(nurbs_make_rational, handle_); }
    [[nodiscard]] Returned<Spline> to_homogeneous() const { return made(nurbs_to_homogeneous, handle_); }
    [[nodiscard]] Returned<Spline> from_homogeneous() const { return made(nurbs_from_homogeneous, handle_); }
    /// matrix: [out_dim][dim], row by row; translation: [out_dim], or empty for 0.
    [[nodiscard]] Returned<Spline> transform(std::int32_t out_dim, View<double> matrix,
                                             View<double> translation = {}) const {
        check_matrix(matrix, out_dim, detail::dimension(handle_));
        if (!translation.empty() && detail::length(translation) != out_dim) {
            detail::wrong_size("translation", translation.size(), std::to_string(out_dim));
        }
        return made(nurbs_transform, handle_, out_dim, matrix.data(),
                    translation.empty() ? nullptr : translation.data());
    }
    /// matrix: [out_dim + 1][dim + 1], row by row.
    [[nodiscard]] Returned<Spline> transform_projective(std::int32_t out_dim, View<double> matrix) const {
        check_matrix(matrix, std::int64_t{out_dim} + 1, std::int64_t{detail::dimension(handle_)} + 1);
        return made(nurbs_transform_projective, handle_, out_dim, matrix.data());
    }
    /// The same shape with a list of knots inserted, in any order.
    [[nodiscard]] Returned<Spline> refine(std::int32_t axis, View<double> knots) const {
        return made(nurbs_refine, handle_, axis, detail::length(knots), knots.data());
    }
    /// The same shape with every non-empty span divided into equal parts.
    [[nodiscard]] Returned<Spline> refine_uniform(std::int32_t axis, std::int64_t parts) const {
        return made(nurbs_refine_uniform, handle_, axis, parts);
    }
    /// The parts below and above a parameter.
    [[nodiscard]] Returned<std::pair<Spline, Spline>> split(std::int32_t axis, double param) const {
        nurbs *lower = nullptr, *upper = nullptr;
        detail::call(nurbs_split, handle_, axis, param, &lower, &upper);
        return std::pair(Spline(lower), Spline(upper));
    }
    /// The part over a box in the domain: the ends on each axis.
    [[nodiscard]] Returned<Spline> extract(View<double> lower, View<double> upper) const {
        const auto wanted = static_cast<std::size_t>(detail::axes(handle_));
        if (lower.size() != wanted || upper.size() != wanted) {
            const bool short_lower = lower.size() != wanted;
            detail::wrong_size(short_lower ? "lower" : "upper", (short_lower ? lower : upper).size(),
                               std::to_string(wanted));
        }
        return made(nurbs_extract, handle_, lower.data(), upper.data());
    }
    /// The same shape with clamped ends; flags 0 only open a periodic axis.
    [[nodiscard]] Returned<Spline>
    clamp(std::int32_t axis, std::uint32_t flags = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END) const {
        return made(nurbs_clamp_ends, handle_, axis, flags);
    }
    /// The same shape on a periodic axis over [param, param + period].
    [[nodiscard]] Returned<Spline> move_seam(std::int32_t axis, double param) const {
        return made(nurbs_move_seam, handle_, axis, param);
    }

private:
    static constexpr std::int32_t max_width = INT32_MAX;
    nurbs *handle_ = nullptr;

    template <class F, class... Arguments>
    static Spline made(F &&f, const Arguments &...arguments) {
        Spline result;
        detail::attempt([&] { return f(arguments..., &result.handle_); });
        return result;
    }
    static std::int32_t axes_of(View<std::int32_t> degrees) {
        return degrees.size() > 3 ? max_axes + 1 : static_cast<std::int32_t>(degrees.size());
    }
    static void require_weights(Input weights, std::int64_t n) {
        if (!weights.empty()) {
            weights.require(n, 1, "weights");
        }
    }
    // Checks what only this side can see: that the arrays are as long as the counts say.
    static void check_net(View<std::int32_t> degrees, View<std::int64_t> counts, std::int32_t width,
                          Input points, Input weights) {
        if (counts.size() != degrees.size()) {
            detail::wrong_size("counts", counts.size(), std::to_string(degrees.size()));
        }
        const std::int64_t n = detail::product<std::int64_t>(counts);
        points.require(n, width, "points");
        require_weights(weights, n);
    }
    static void check_distinct(std::size_t axes, View<std::int64_t> counts, View<double> knots,
                               View<std::int32_t> multiplicities) {
        const std::int64_t total = detail::sum(counts);
        if (counts.size() != axes) {
            detail::wrong_size("distinct_counts", counts.size(), std::to_string(axes));
        }
        if (detail::length(knots) != total || multiplicities.size() != knots.size()) {
            detail::wrong_size("distinct_knots", knots.size(),
                               std::to_string(total) + ", with as many multiplicities");
        }
    }
    static void check_matrix(View<double> matrix, std::int64_t rows, std::int64_t columns) {
        // A spline that is empty has no columns, and has failed already.
        if (columns > 0 &&
            (detail::length(matrix) / columns != rows || detail::length(matrix) % columns != 0)) {
            detail::wrong_size("matrix", matrix.size(),
                               std::to_string(rows) + " rows of " + std::to_string(columns));
        }
    }
    [[nodiscard]] std::int64_t slots(std::int32_t order) const {
        return detail::derivative_slots(detail::axes(handle_), order);
    }
    [[nodiscard]] std::int64_t number_of(Input params) const {
        const std::int64_t n = params.count(detail::axes(handle_), "params");
        params.require(n, detail::axes(handle_), "params");
        return n;
    }
    [[nodiscard]] std::int64_t batch(Input params, Output out, std::int64_t width, const char *what) const {
        const std::int64_t n = number_of(params);
        out.require(n, width, what);
        return n;
    }
    [[nodiscard]] std::int64_t grid(View<std::int64_t> counts, View<double> params) const {
        if (detail::length(counts) != detail::axes(handle_)) {
            detail::wrong_size("counts", counts.size(), std::to_string(detail::axes(handle_)));
        }
        const std::int64_t total = detail::sum(counts);
        if (detail::length(params) != total) {
            detail::wrong_size("params", params.size(), std::to_string(total));
        }
        return detail::product<std::int64_t>(counts);
    }
};

namespace detail {

// The spline that f(arguments..., &handle) makes.
template <class F, class... Arguments>
Spline spline_of(F &&f, const Arguments &...arguments) {
    nurbs *out = nullptr;
    attempt([&] { return f(arguments..., &out); });
    return Spline(out);
}

inline std::vector<const nurbs *> handle_list(std::span<const Spline> splines) {
    std::vector<const nurbs *> handles;
    for (const Spline &spline : splines) {
        handles.push_back(spline.get());
    }
    return handles;
}

// A part of the domain, [axes][2], or NULL for all of it.
inline const double *range_of(const Spline &g, View<double> range) {
    return if_given(std::span(range), std::int64_t{2} * axes(g.get()), "range");
}

// A parameter [axes], a point [dim].
inline const double *param_of(const Spline &g, View<double> params) {
    return exactly(std::span(params), detail::axes(g.get()), "params");
}
inline const double *point_of(const Spline &g, View<double> point, const char *what) {
    return exactly(std::span(point), detail::dimension(g.get()), what);
}

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_SPLINE_HPP
