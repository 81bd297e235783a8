/* SPDX-License-Identifier: MIT */
/// \file sizes.hpp
/// \brief The lengths of arrays: of a spline, and of knot vectors and bases without one.
#ifndef NURBS_CPP_SIZES_HPP
#define NURBS_CPP_SIZES_HPP

#include <nurbs/cpp/arrays.hpp>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

// What the wrapper asks a spline; 0 after a failure.
inline std::int32_t axes(const nurbs *g) {
    return result_of<std::int32_t>([&](auto *v) { return nurbs_axes(g, v); });
}
inline std::int32_t dimension(const nurbs *g) {
    return result_of<std::int32_t>([&](auto *v) { return nurbs_dimension(g, v); });
}
inline std::int32_t axes(const nurbs_statistics *statistics) {
    return result_of<std::int32_t>(
        [&](auto *v) { return nurbs_statistics_size(statistics, v, nullptr, nullptr, nullptr, nullptr); });
}
// Of the surface of a face.
inline std::int32_t dimension(const nurbs_face *face) {
    nurbs *surface = result_of<nurbs *>([&](auto *v) { return nurbs_face_surface(face, v); });
    const std::int32_t dim = surface == nullptr ? 0 : dimension(surface);
    nurbs_destroy(surface);
    return dim;
}
inline std::int32_t axes(const nurbs_data &data) noexcept {
    return data.axes;
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
// Of the spline's own axes.
inline std::int64_t slots(const nurbs *g, std::int32_t order) {
    return derivative_slots(axes(g), order);
}
// The number of basis functions that are not 0 at a parameter.
inline std::int64_t active(const nurbs *g) {
    std::int64_t functions = 1;
    for (std::int32_t axis = 0; axis < axes(g); ++axis) {
        functions *= degree(g, axis) + 1;
    }
    return functions;
}

// Their product, in the same manner as product().
template <class... Extents>
std::int64_t times(Extents... extents) {
    const std::int64_t sizes[] = {std::int64_t{extents}...};
    return product<std::int64_t>(sizes);
}
// An array of these extents. An empty one has a place too: what makes it empty is the library's to name, and not NULL.
template <class T = double, class... Extents>
std::vector<T> room(Extents... extents) {
    std::vector<T> values(to_size(times(extents...)));
    values.reserve(1);
    return values;
}

// For as many axes as a library takes, and then for too many.
template <class T>
std::int32_t axes_of(View<T> by_axis) {
    return by_axis.size() > 3 ? max_axes + 1 : static_cast<std::int32_t>(by_axis.size());
}
// Control points of one piece of these degrees; -1 if one is negative, as product() says it.
inline std::int64_t piece_points(View<std::int32_t> degrees) {
    std::vector<std::int64_t> orders(degrees.begin(), degrees.end());
    for (std::int64_t &order : orders) {
        order += order < 0 ? 0 : 1;
    }
    return product<std::int64_t>(orders);
}
inline std::int64_t positive(std::int64_t n) {
    return std::clamp(n, std::int64_t{0}, INT64_MAX - 1);
}
inline std::int64_t homogeneous(std::uint32_t flags) {
    return (flags & homogeneous_records) != 0 ? 1 : 0;
}

// The length of the first vector that is not empty, or another dimension if all are; the rest must have it
// too.
inline std::int32_t dimension_of(std::initializer_list<View<double>> vectors, std::int32_t dim) {
    bool known = false;
    for (const View<double> &vector : vectors) {
        if (!vector.empty() && !known) {
            dim = static_cast<std::int32_t>(vector.size());
            known = true;
        }
        if (!vector.empty() && vector.size() != to_size(dim)) {
            wrong_size("vector", vector.size(), std::to_string(dim));
        }
    }
    return dim;
}

// All vectors, none of them empty, have `dim` components.
inline void require_length(std::int32_t dim, std::initializer_list<View<double>> vectors) {
    for (const View<double> &vector : vectors) {
        if (vector.size() != to_size(dim)) {
            wrong_size("vector", vector.size(), std::to_string(dim));
        }
    }
}

// Vectors in space, some of which may be left out.
inline void require_space(std::initializer_list<View<double>> vectors, const char *what) {
    const std::int32_t dim = dimension_of(vectors, 3);
    if (dim != 3) {
        wrong_size(what, to_size(dim), "3");
    }
}

inline bool is_degree(std::int32_t degree) {
    return degree >= 0 && degree <= max_degree;
}
// Knots of `count` control points. A count that no memory holds is left to the library to refuse, before it touches
// the array.
inline std::int64_t knot_count(std::int32_t degree, std::int64_t count) {
    const bool sane = is_degree(degree) && count >= 0 && count < (std::int64_t{1} << 48);
    return sane ? count + degree + 1 : 0;
}
inline std::int64_t bezier_count(std::int32_t degree, std::int64_t pieces) {
    const bool sane = pieces >= 0 && pieces < (std::int64_t{1} << 48);
    return sane ? (degree == 0 ? pieces : pieces * degree + 1) : -1;
}
// Control points of a period: the breaks but the last, which repeats the first.
inline std::int64_t periodic_count(std::int32_t degree, View<double> breaks,
                                   View<std::int32_t> multiplicities) {
    const std::int64_t distinct =
        multiplicities.empty()
            ? length(breaks) - 1
            : std::accumulate(multiplicities.begin(), multiplicities.end() - 1, std::int64_t{0});
    return distinct + degree;
}
// Values per parameter, and numbers of a matrix; 0 where the library will refuse the degree or the order.
inline std::int64_t basis_width(std::int32_t degree, std::int32_t order) {
    const bool sane = is_degree(degree) && order >= 0 && order <= max_order;
    return sane ? (std::int64_t{order} + 1) * (degree + 1) : 0;
}
inline std::int64_t matrix_size(std::int32_t degree) {
    return is_degree(degree) ? std::int64_t{degree + 1} * (degree + 1) : 0;
}
// Coefficients of a polynomial in the coordinates; 0 where the library will refuse the degree.
inline std::int64_t monomials(std::int32_t dim, std::int32_t degree) {
    std::int64_t count = degree >= 1 && degree <= 8 ? 1 : 0;
    for (std::int32_t i = 1; i <= degree && count > 0; ++i) {
        const bool fits = count <= (std::numeric_limits<std::int64_t>::max)() / (std::int64_t{dim} + i);
        count = fits ? count * (std::int64_t{dim} + i) / i : 0;
    }
    return count;
}

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_SIZES_HPP
