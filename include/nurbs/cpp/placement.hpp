/* SPDX-License-Identifier: MIT */
/// \file placement.hpp
/// \brief Where shapes stand, and the forms of their arcs.
#ifndef NURBS_CPP_PLACEMENT_HPP
#define NURBS_CPP_PLACEMENT_HPP

#include <nurbs/cpp/sizes.hpp>

#include <cstdint>
#include <numbers>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Forms of an arc.
inline constexpr std::int32_t arc_quarters = NURBS_ARC_QUARTERS;
inline constexpr std::int32_t arc_thirds = NURBS_ARC_THIRDS;
inline constexpr std::int32_t arc_smooth = NURBS_ARC_SMOOTH;

inline constexpr double full_turn = 2 * std::numbers::pi;

/// Origin (centre, vertex), axis and direction x of a shape, all of one length: its dimension. What is left
/// empty is the default of nurbs.h; if all is, surfaces and helices stand in space and other curves in the
/// plane.
struct Placement {
    std::vector<double> origin{};
    std::vector<double> axis{};
    std::vector<double> x{};
};

namespace detail {

// The arguments origin, axis and x of a shape in space.
struct Space {
    const double *origin, *axis, *x;
    explicit Space(const Placement &at)
        : origin(pointer(at.origin)), axis(pointer(at.axis)), x(pointer(at.x)) {
        require_space({at.origin, at.axis, at.x}, "placement");
    }
};

// The arguments dim, origin, axis and x of a shape of the plane or of space.
struct Place {
    std::int32_t dim;
    const double *origin, *axis, *x;
    explicit Place(const Placement &at, std::int32_t otherwise = 2)
        : dim(dimension_of({at.origin, at.axis, at.x}, otherwise)), origin(pointer(at.origin)),
          axis(pointer(at.axis)), x(pointer(at.x)) {}
};

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_PLACEMENT_HPP
