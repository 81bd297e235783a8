/* SPDX-License-Identifier: MIT */
/// \file segments.hpp
/// \brief Hermite data, and the matrices between bases of a segment.
#ifndef NURBS_CPP_SEGMENTS_HPP
#define NURBS_CPP_SEGMENTS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace libnurbs {

/// Bases of a polynomial over [0, 1].
inline constexpr std::int32_t basis_power = NURBS_BASIS_POWER;
inline constexpr std::int32_t basis_bernstein = NURBS_BASIS_BERNSTEIN;
inline constexpr std::int32_t basis_hermite = NURBS_BASIS_HERMITE;
inline constexpr std::int32_t basis_bspline = NURBS_BASIS_BSPLINE;

/// The piecewise cubic through points with tangents, both packed.
inline Spline create_hermite(View<double> params, std::int32_t dim, View<double> points,
                             View<double> tangents) {
    const auto wanted = params.size() * static_cast<std::size_t>(dim < 0 ? 0 : dim);
    for (const View<double> &values : {points, tangents}) {
        if (values.size() != wanted) {
            detail::wrong_size("points and tangents", values.size(), std::to_string(wanted));
        }
    }
    nurbs *out = nullptr;
    detail::check(nurbs_create_hermite(static_cast<std::int64_t>(params.size()), params.data(), dim,
                                       points.data(), 0, 0, tangents.data(), 0, 0, &out));
    return Spline(out);
}

/// The matrix, row by row, that takes coefficients of one basis to those of another.
inline std::vector<double> basis_matrix(std::int32_t from, std::int32_t to, std::int32_t degree) {
    const std::int64_t size = degree < 0 || degree > NURBS_MAX_DEGREE ? 0 : (degree + 1) * (degree + 1);
    std::vector<double> matrix(static_cast<std::size_t>(size));
    detail::check(nurbs_basis_matrix(from, to, degree, size, matrix.data()));
    return matrix;
}

} // namespace libnurbs

#endif // NURBS_CPP_SEGMENTS_HPP
