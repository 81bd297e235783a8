/* SPDX-License-Identifier: MIT */
/// \file measure.hpp
/// \brief Lengths, areas and moments.
#ifndef NURBS_CPP_MEASURE_HPP
#define NURBS_CPP_MEASURE_HPP

#include <nurbs/cpp/spline.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// An integral, and an estimate of its error.
struct Measured {
    double value;
    double error;
};

/// Length of a curve over a range [2] of its domain, or all of it.
inline Returned<Measured> length(const Spline &g, double relative_tolerance = 0, View<double> range = {}) {
    Measured found{};
    detail::call(nurbs_curve_length, g.get(), detail::range_of(g, range), relative_tolerance, &found.value,
                 &found.error);
    return found;
}

/// Lengths from the start of the domain to parameters.
inline Returned<void> lengths(const Spline &g, Input params, Output lengths, double relative_tolerance = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    lengths.require(n, 1, "lengths");
    return detail::call(nurbs_curve_lengths, g.get(), n, params.data(), params.step(), relative_tolerance,
                        lengths.data(), lengths.step());
}
[[nodiscard]] inline Returned<std::vector<double>> lengths(const Spline &g, Input params,
                                                           double relative_tolerance = 0) {
    return detail::filled(detail::records(params, 1, "params"), [&](auto &values) {
        return lengths(g, params, Output(values), relative_tolerance);
    });
}

/// Parameters at lengths from the start of the domain; flags: 0 or clamp.
inline Returned<void> params_at_lengths(const Spline &g, Input lengths, Output params,
                                        double relative_tolerance = 0, std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(lengths, 1, "lengths");
    params.require(n, 1, "params");
    return detail::call(nurbs_curve_params_at_lengths, g.get(), n, lengths.data(), lengths.step(),
                        relative_tolerance, params.data(), params.step(), flags);
}
[[nodiscard]] inline Returned<std::vector<double>>
params_at_lengths(const Spline &g, Input lengths, double relative_tolerance = 0, std::uint32_t flags = 0) {
    return detail::filled(detail::records(lengths, 1, "lengths"), [&](auto &params) {
        return params_at_lengths(g, lengths, Output(params), relative_tolerance, flags);
    });
}

/// Parameters [parts + 1], and the length or chord of a part.
struct Division {
    std::vector<double> params;
    double size;
};

/// A curve in parts of equal length, or with flags equal_chords with points at equal distances.
inline Returned<Division> divide(const Spline &g, std::int64_t parts, double relative_tolerance = 0,
                                 std::uint32_t flags = 0, View<double> range = {}) {
    Division found{std::vector<double>(detail::to_size(parts) + 1), 0};
    detail::call(nurbs_curve_divide, g.get(), detail::range_of(g, range), parts, relative_tolerance, flags,
                 found.params.data(), &found.size);
    return found;
}

/// Area of a surface over a range [2][2] of its domain, or all of it.
inline Returned<Measured> area(const Spline &g, double relative_tolerance = 0, View<double> range = {}) {
    Measured found{};
    detail::call(nurbs_surface_area, g.get(), detail::range_of(g, range), relative_tolerance, &found.value,
                 &found.error);
    return found;
}

namespace detail {

// Calls f(centroid, inertia), which returns a status and refuses what it cannot give if that is asked for: then it is
// asked for less, and the rest is NaN. A content of 0 has no centroid, and inertia overflows first.
template <class F>
void call_moments(F &&f, std::span<double> centroid, std::span<double> inertia) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    attempt([&] {
        nurbs_status status = f(centroid.data(), inertia.data());
        if (status == NURBS_ERROR_NOT_REPRESENTABLE) {
            std::fill(inertia.begin(), inertia.end(), none);
            status = f(centroid.data(), static_cast<double *>(nullptr));
        }
        if (status == NURBS_ERROR_LENGTH || status == NURBS_ERROR_NOT_REPRESENTABLE) {
            std::fill(centroid.begin(), centroid.end(), none);
            std::fill(inertia.begin(), inertia.end(), none);
            status = f(static_cast<double *>(nullptr), static_cast<double *>(nullptr));
        }
        return status;
    });
}

} // namespace detail

/// Length, area or volume, centroid [dim], inertia [dim][dim] about it, and an estimate of the error of
/// content. Where the content is 0 there is no centroid: it and the inertia are NaN, as is what overflows; the same
/// holds for what curves and surfaces enclose.
struct Moments {
    double content;
    std::vector<double> centroid;
    std::vector<double> inertia;
    double error;
};

/// Of the spline itself: a wire, a sheet or a body.
inline Returned<Moments> moments(const Spline &g, double relative_tolerance = 0) {
    const auto dim = detail::to_size(detail::dimension(g.get()));
    Moments found{0, std::vector<double>(dim), std::vector<double>(dim * dim), 0};
    detail::call_moments(
        [&](double *centroid, double *inertia) {
            return nurbs_moments(g.get(), relative_tolerance, &found.content, centroid, inertia,
                                 &found.error);
        },
        found.centroid, found.inertia);
    return found;
}

/// Of a region of the plane.
struct EnclosedArea {
    double area;
    std::array<double, 2> centroid;
    std::array<std::array<double, 2>, 2> inertia;
    double error;
};

/// What closed chains of curves enclose; counterclockwise counts positive.
inline Returned<EnclosedArea> enclosed_area(std::span<const Spline> curves, double tolerance = 0,
                                            double relative_tolerance = 0) {
    const std::vector<const nurbs *> handles = detail::handle_list(curves);
    EnclosedArea found{};
    std::array<double, 4> inertia{};
    detail::call_moments(
        [&](double *centroid, double *second) {
            return nurbs_enclosed_area(detail::length(handles), handles.data(), tolerance, relative_tolerance,
                                       &found.area, centroid, second, &found.error);
        },
        found.centroid, inertia);
    found.inertia = {{{inertia[0], inertia[1]}, {inertia[2], inertia[3]}}};
    return found;
}

/// Of a body; openness is the length of the vector area, 0 of a closed shell.
struct EnclosedVolume {
    double volume;
    std::array<double, 3> centroid;
    std::array<std::array<double, 3>, 3> inertia;
    double openness;
    double error;
};

/// What surfaces enclose whose normals point outwards.
inline Returned<EnclosedVolume> enclosed_volume(std::span<const Spline> surfaces,
                                                double relative_tolerance = 0) {
    const std::vector<const nurbs *> handles = detail::handle_list(surfaces);
    EnclosedVolume found{};
    std::array<double, 9> inertia{};
    detail::call_moments(
        [&](double *centroid, double *second) {
            return nurbs_enclosed_volume(detail::length(handles), handles.data(), relative_tolerance,
                                         &found.volume, centroid, second, &found.openness, &found.error);
        },
        found.centroid, inertia);
    for (std::size_t i = 0; i < inertia.size(); ++i) {
        found.inertia[i / 3][i % 3] = inertia[i];
    }
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MEASURE_HPP
