/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file measure.hpp
/// \brief Lengths, areas and moments.
#ifndef NURBS_CPP_MEASURE_HPP
#define NURBS_CPP_MEASURE_HPP

#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// An integral, and an estimate of its error.
struct Measured {
    double value; ///< The integral.
    double error; ///< An estimate of its error.
};

/// Length of a curve over a range [2] of its domain, or all of it.
inline Returned<Measured> length(const Spline &g, double relative_tolerance = 0, View<double> range = {}) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    Measured found{};
    detail::call(nurbs_curve_length, g.get(), detail::pointer(range), relative_tolerance, &found.value,
                 &found.error);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Measured> length(const Spline &g, double relative_tolerance, View<double> range,
                                 const CallOptions &call) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    Measured found{};
    const detail::Watch watch(call);
    detail::call(nurbs_curve_length_with, g.get(), detail::pointer(range), relative_tolerance, &found.value,
                 &found.error, watch.get());
    return found;
}

/// Lengths from the start of the domain to parameters.
inline Returned<void> lengths(const Spline &g, Input params, Output lengths, double relative_tolerance = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    lengths.require(n, 1, "lengths");
    return detail::call(nurbs_curve_lengths, g.get(), n, params.data(), params.step(), relative_tolerance,
                        lengths.data(), lengths.step());
}
/// The same, as a vector.
[[nodiscard]] inline Returned<std::vector<double>> lengths(const Spline &g, Input params,
                                                           double relative_tolerance = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    std::vector<double> values = detail::room(n);
    detail::run([&] { return lengths(g, params, values, relative_tolerance); });
    return values;
}
/// The same; `call` can watch and end it.
inline Returned<void> lengths(const Spline &g, Input params, Output lengths, double relative_tolerance,
                              const CallOptions &call) {
    const std::int64_t n = detail::records(params, 1, "params");
    const detail::Watch watch(call);
    lengths.require(n, 1, "lengths");
    return detail::call(nurbs_curve_lengths_with, g.get(), n, params.data(), params.step(),
                        relative_tolerance, lengths.data(), lengths.step(), watch.get());
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<std::vector<double>>
lengths(const Spline &g, Input params, double relative_tolerance, const CallOptions &call) {
    const std::int64_t n = detail::records(params, 1, "params");
    std::vector<double> values = detail::room(n);
    detail::run([&] { return lengths(g, params, values, relative_tolerance, call); });
    return values;
}

/// Parameters at lengths from the start of the domain; flags: 0 or clamp.
inline Returned<void> params_at_lengths(const Spline &g, Input lengths, Output params,
                                        double relative_tolerance = 0, std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(lengths, 1, "lengths");
    params.require(n, 1, "params");
    return detail::call(nurbs_curve_params_at_lengths, g.get(), n, lengths.data(), lengths.step(),
                        relative_tolerance, params.data(), params.step(), flags);
}
/// The same, as a vector.
[[nodiscard]] inline Returned<std::vector<double>>
params_at_lengths(const Spline &g, Input lengths, double relative_tolerance = 0, std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(lengths, 1, "lengths");
    std::vector<double> values = detail::room(n);
    detail::run([&] { return params_at_lengths(g, lengths, values, relative_tolerance, flags); });
    return values;
}
/// The same; `call` can watch and end it.
inline Returned<void> params_at_lengths(const Spline &g, Input lengths, Output params,
                                        double relative_tolerance, std::uint32_t flags,
                                        const CallOptions &call) {
    const std::int64_t n = detail::records(lengths, 1, "lengths");
    const detail::Watch watch(call);
    params.require(n, 1, "params");
    return detail::call(nurbs_curve_params_at_lengths_with, g.get(), n, lengths.data(), lengths.step(),
                        relative_tolerance, params.data(), params.step(), flags, watch.get());
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<std::vector<double>> params_at_lengths(const Spline &g, Input lengths,
                                                                     double relative_tolerance,
                                                                     std::uint32_t flags,
                                                                     const CallOptions &call) {
    const std::int64_t n = detail::records(lengths, 1, "lengths");
    std::vector<double> values = detail::room(n);
    detail::run([&] { return params_at_lengths(g, lengths, values, relative_tolerance, flags, call); });
    return values;
}

/// Parameters [parts + 1], and the length or chord of a part.
struct Division {
    std::vector<double> params; ///< [parts + 1]
    double size;                ///< The length or the chord of a part.
};

/// A curve in parts of equal length, or with equal_chords with points at equal distances.
inline Returned<Division> divide(const Spline &g, std::int64_t parts, double relative_tolerance = 0,
                                 std::uint32_t flags = 0, View<double> range = {}) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    Division found{detail::room(detail::positive(parts) + 1), 0};
    detail::call(nurbs_curve_divide, g.get(), detail::pointer(range), parts, relative_tolerance, flags,
                 found.params.data(), &found.size);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Division> divide(const Spline &g, std::int64_t parts, double relative_tolerance,
                                 std::uint32_t flags, View<double> range, const CallOptions &call) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    Division found{detail::room(detail::positive(parts) + 1), 0};
    const detail::Watch watch(call);
    detail::call(nurbs_curve_divide_with, g.get(), detail::pointer(range), parts, relative_tolerance, flags,
                 found.params.data(), &found.size, watch.get());
    return found;
}

/// Area of a surface over a range [2][2] of its domain, or all of it.
inline Returned<Measured> area(const Spline &g, double relative_tolerance = 0, View<double> range = {}) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    Measured found{};
    detail::call(nurbs_surface_area, g.get(), detail::pointer(range), relative_tolerance, &found.value,
                 &found.error);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Measured> area(const Spline &g, double relative_tolerance, View<double> range,
                               const CallOptions &call) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    Measured found{};
    const detail::Watch watch(call);
    detail::call(nurbs_surface_area_with, g.get(), detail::pointer(range), relative_tolerance, &found.value,
                 &found.error, watch.get());
    return found;
}

/// Length, area or volume, centroid [dim], inertia [dim][dim] about it, and an estimate of the error of
/// content. Where the content is 0 there is no centroid: it and the inertia are NaN, as is what overflows;
/// the same holds for what curves and surfaces enclose.
struct Moments {
    double content;               ///< Length, area or volume.
    std::vector<double> centroid; ///< [dim]
    std::vector<double> inertia;  ///< About the centroid, [dim][dim].
    double error;                 ///< An estimate of the error of the content.
};

/// The moments of the spline itself: a wire, a sheet or a body.
inline Returned<Moments> moments(const Spline &g, double relative_tolerance = 0) {
    const std::int64_t dim = detail::dimension(g.get());
    Moments found{0, detail::room(dim), detail::room(dim, dim), 0};
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_moments(g.get(), relative_tolerance, &found.content, centroid, inertia,
                                 &found.error);
        },
        found.centroid, found.inertia);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Moments> moments(const Spline &g, double relative_tolerance, const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    Moments found{0, detail::room(dim), detail::room(dim, dim), 0};
    const detail::Watch watch(call);
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_moments_with(g.get(), relative_tolerance, &found.content, centroid, inertia,
                                      &found.error, watch.get());
        },
        found.centroid, found.inertia);
    return found;
}

/// What curves in the plane enclose.
struct EnclosedArea {
    double area;                                  ///< Positive inside counterclockwise curves.
    std::array<double, 2> centroid;               ///< Of the region.
    std::array<std::array<double, 2>, 2> inertia; ///< About the centroid.
    double error;                                 ///< An estimate of the error of the area.
};

/// The area of the region that closed chains of curves enclose; counterclockwise counts positive.
inline Returned<EnclosedArea> enclosed_area(std::span<const Spline> curves, double tolerance = 0,
                                            double relative_tolerance = 0) {
    EnclosedArea found{};
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_enclosed_area(detail::length(curves), detail::handle_list(curves).data(), tolerance,
                                       relative_tolerance, &found.area, centroid, inertia, &found.error);
        },
        found.centroid, {detail::flat(found.inertia), 4});
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<EnclosedArea> enclosed_area(std::span<const Spline> curves, double tolerance,
                                            double relative_tolerance, const CallOptions &call) {
    EnclosedArea found{};
    const detail::Watch watch(call);
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_enclosed_area_with(detail::length(curves), detail::handle_list(curves).data(),
                                            tolerance, relative_tolerance, &found.area, centroid, inertia,
                                            &found.error, watch.get());
        },
        found.centroid, {detail::flat(found.inertia), 4});
    return found;
}

/// What surfaces enclose.
struct EnclosedVolume {
    double volume;                                ///< Positive if the normals point outwards.
    std::array<double, 3> centroid;               ///< Of the body.
    std::array<std::array<double, 3>, 3> inertia; ///< About the centroid.
    double openness;                              ///< The length of the vector area: 0 of a closed shell.
    double error;                                 ///< An estimate of the error of the volume.
};

/// The volume of the body that surfaces enclose whose normals point outwards.
inline Returned<EnclosedVolume> enclosed_volume(std::span<const Spline> surfaces,
                                                double relative_tolerance = 0) {
    EnclosedVolume found{};
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_enclosed_volume(detail::length(surfaces), detail::handle_list(surfaces).data(),
                                         relative_tolerance, &found.volume, centroid, inertia,
                                         &found.openness, &found.error);
        },
        found.centroid, {detail::flat(found.inertia), 9});
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<EnclosedVolume> enclosed_volume(std::span<const Spline> surfaces, double relative_tolerance,
                                                const CallOptions &call) {
    EnclosedVolume found{};
    const detail::Watch watch(call);
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_enclosed_volume_with(detail::length(surfaces), detail::handle_list(surfaces).data(),
                                              relative_tolerance, &found.volume, centroid, inertia,
                                              &found.openness, &found.error, watch.get());
        },
        found.centroid, {detail::flat(found.inertia), 9});
    return found;
}

/// Points and weights of rules on the spans of a spline.
struct Quadrature {
    std::vector<double> params;   ///< Parameters [axes] of the points, packed.
    std::vector<double> weights;  ///< Weights of the parameters.
    std::vector<double> measures; ///< Weights of lengths, areas or volumes.
};

/// Points and weights for integrals of any function: so many nodes along each axis of a span, 0 for one more
/// than the degree.
inline Returned<Quadrature> quadrature(const Spline &g, std::int32_t nodes = 0) {
    Quadrature found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_quadrature, g.get(), nodes, cap, found.params.data(), found.weights.data(),
                     found.measures.data(), &count);
    };
    ask(0);
    found.params = detail::room(count, detail::axes(g.get()));
    found.weights = detail::room(count);
    found.measures = detail::room(count);
    ask(count);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MEASURE_HPP
