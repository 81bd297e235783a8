/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file segments.hpp
/// \brief Hermite data, the power basis of pieces, and the matrices between bases of a segment.
#ifndef NURBS_CPP_SEGMENTS_HPP
#define NURBS_CPP_SEGMENTS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Bases of a polynomial over [0, 1].
inline constexpr std::int32_t basis_power = NURBS_BASIS_POWER;
inline constexpr std::int32_t basis_bernstein = NURBS_BASIS_BERNSTEIN;
inline constexpr std::int32_t basis_hermite = NURBS_BASIS_HERMITE;
inline constexpr std::int32_t basis_bspline = NURBS_BASIS_BSPLINE;

/// The piecewise cubic through points with tangents, both packed.
inline Returned<Spline> create_hermite(View<double> params, std::int32_t dim, View<double> points,
                                       View<double> tangents) {
    const std::int64_t n = detail::length(params);
    detail::require(points, n * detail::positive(dim), "points and tangents");
    detail::require(tangents, n * detail::positive(dim), "points and tangents");
    return detail::made<Spline>(nurbs_create_hermite, n, params.data(), dim, points.data(), 0, 0,
                                tangents.data(), 0, 0);
}

/// Points and tangents, packed, of a piecewise cubic at its breaks.
struct Hermite {
    std::vector<double> params;   ///< Breaks.
    std::vector<double> points;   ///< Points at them, packed.
    std::vector<double> tangents; ///< Derivatives at them, packed.
};

/// The data from which create_hermite() makes a C^1 piecewise cubic again.
inline Returned<Hermite> to_hermite(const Spline &g) {
    Hermite found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_to_hermite, g.get(), cap, found.params.data(), found.points.data(),
                     found.tangents.data(), &count);
    };
    ask(0);
    found.params = detail::room(count);
    const std::int64_t dim = detail::dimension(g.get());
    found.points = detail::room(count, dim);
    found.tangents = detail::room(count, dim);
    ask(count);
    return found;
}

/// The power basis of all pieces, packed, and the breaks of the axes one after the other.
struct PowerForm {
    std::vector<double> coefficients;       ///< Of all pieces, packed.
    std::vector<double> breaks;             ///< Of the axes one after the other.
    std::vector<std::int64_t> piece_counts; ///< Of each axis.
};

/// The power basis of every piece, of homogeneous points if the spline is rational.
inline Returned<PowerForm> to_power(const Spline &g) {
    const std::int64_t axes = detail::axes(g.get());
    PowerForm found{{}, {}, detail::room<std::int64_t>(axes)};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_to_power, g.get(), cap, found.coefficients.data(), found.breaks.data(),
                     found.piece_counts.data(), &count);
    };
    ask(0);
    found.coefficients = detail::room(count);
    found.breaks = detail::room(detail::sum(found.piece_counts) + axes);
    ask(count);
    return found;
}

/// The spline of pieces in the power basis; flags: homogeneous_records.
inline Returned<Spline> create_power(View<std::int32_t> degrees, std::int32_t dim, const PowerForm &form,
                                     std::uint32_t flags = 0) {
    detail::require(form.piece_counts, detail::length(degrees), "piece_counts");
    detail::require_unless_negative(form.coefficients,
                                    detail::times(detail::product<std::int64_t>(form.piece_counts),
                                                  detail::piece_points(degrees),
                                                  std::int64_t{dim} + detail::homogeneous(flags)),
                                    "coefficients");
    return detail::made<Spline>(nurbs_create_power, detail::axes_of(degrees), degrees.data(),
                                form.piece_counts.data(), form.breaks.data(), detail::length(form.breaks),
                                dim, form.coefficients.data(), 0, 0, flags);
}

/// The matrix, row by row, that takes coefficients of one basis to those of another.
inline Returned<std::vector<double>> basis_matrix(std::int32_t from, std::int32_t to, std::int32_t degree) {
    const std::int64_t size = detail::matrix_size(degree);
    std::vector<double> values = detail::room(size);
    detail::call(nurbs_basis_matrix, from, to, degree, size, values.data());
    return values;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_SEGMENTS_HPP
