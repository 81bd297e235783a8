/* SPDX-License-Identifier: MIT */
/// \file segments.hpp
/// \brief Hermite data, the power basis of pieces, and the matrices between bases of a segment.
#ifndef NURBS_CPP_SEGMENTS_HPP
#define NURBS_CPP_SEGMENTS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
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
    const auto wanted = params.size() * static_cast<std::size_t>(dim < 0 ? 0 : dim);
    for (const View<double> &values : {points, tangents}) {
        if (values.size() != wanted) {
            detail::wrong_size("points and tangents", values.size(), std::to_string(wanted));
        }
    }
    return detail::spline_of(nurbs_create_hermite, static_cast<std::int64_t>(params.size()), params.data(),
                             dim, points.data(), 0, 0, tangents.data(), 0, 0);
}

/// Points and tangents, packed, of a piecewise cubic at its breaks.
struct Hermite {
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> tangents;
};

/// The data from which create_hermite() makes a C^1 piecewise cubic again.
inline Returned<Hermite> to_hermite(const Spline &g) {
    const auto n = detail::result_of<std::int64_t>(
        [&](auto *v) { return nurbs_to_hermite(g.get(), 0, nullptr, nullptr, nullptr, v); });
    std::vector<double> values(detail::to_size(n * detail::dimension(g.get())));
    Hermite result{std::vector<double>(detail::to_size(n)), values, values};
    detail::call(nurbs_to_hermite, g.get(), n, result.params.data(), result.points.data(),
                 result.tangents.data(), nullptr);
    return result;
}

/// The power basis of all pieces, packed, and the breaks of the axes one after the other.
struct PowerForm {
    std::vector<double> coefficients;
    std::vector<double> breaks;
    std::vector<std::int64_t> piece_counts;
};

/// The power basis of every piece, of homogeneous points if the spline is rational.
inline Returned<PowerForm> to_power(const Spline &g) {
    PowerForm form{{}, {}, std::vector<std::int64_t>(detail::to_size(detail::axes(g.get())))};
    const auto n = detail::result_of<std::int64_t>(
        [&](auto *v) { return nurbs_to_power(g.get(), 0, nullptr, nullptr, form.piece_counts.data(), v); });
    form.coefficients.resize(detail::to_size(n));
    form.breaks.resize(detail::to_size(detail::sum(form.piece_counts)) + form.piece_counts.size());
    detail::call(nurbs_to_power, g.get(), n, form.coefficients.data(), form.breaks.data(), nullptr, nullptr);
    return form;
}

/// The spline of pieces in the power basis; flags: homogeneous_records.
inline Returned<Spline> create_power(View<std::int32_t> degrees, std::int32_t dim, const PowerForm &form,
                                     std::uint32_t flags = 0) {
    std::vector<std::int64_t> factors = form.piece_counts;
    for (const std::int32_t p : degrees) {
        factors.push_back(std::int64_t{p} + 1);
    }
    factors.push_back(std::int64_t{dim} + ((flags & homogeneous_records) != 0 ? 1 : 0));
    if (form.piece_counts.size() != degrees.size()) {
        detail::wrong_size("piece_counts", form.piece_counts.size(), std::to_string(degrees.size()));
    }
    const std::int64_t wanted = detail::product(std::span<const std::int64_t>(factors));
    if (wanted >= 0 && wanted != detail::length(form.coefficients)) {
        detail::wrong_size("coefficients", form.coefficients.size(), std::to_string(wanted));
    }
    return detail::spline_of(nurbs_create_power, static_cast<std::int32_t>(degrees.size()), degrees.data(),
                             form.piece_counts.data(), form.breaks.data(), detail::length(form.breaks), dim,
                             form.coefficients.data(), 0, 0, flags);
}

/// The matrix, row by row, that takes coefficients of one basis to those of another.
inline Returned<std::vector<double>> basis_matrix(std::int32_t from, std::int32_t to, std::int32_t degree) {
    const std::int64_t size = degree < 0 || degree > NURBS_MAX_DEGREE ? 0 : (degree + 1) * (degree + 1);
    std::vector<double> matrix(static_cast<std::size_t>(size));
    detail::call(nurbs_basis_matrix, from, to, degree, size, matrix.data());
    return matrix;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_SEGMENTS_HPP
