// SPDX-License-Identifier: MIT
// The entities that are known by their keywords.
#pragma once

#include <cstdint>
#include <string_view>

namespace nrb::io::step {

// Entities that are read alike have one kind. Among the parts of a complex instance the greatest kind of its group
// counts, so that the supertypes stand before their subtypes.
enum class Kind : uint16_t {
    other,
    // curves
    line,
    circle,
    ellipse,
    parabola,
    hyperbola,
    polyline,
    b_spline_curve,
    bezier_curve,
    uniform_curve,
    quasi_uniform_curve,
    b_spline_curve_with_knots,
    trimmed_curve,
    composite_curve,
    surface_curve,
    pcurve,
    offset_curve_2d,
    offset_curve_3d,
    curve_replica,
    unread_curve,
    // surfaces
    plane,
    cylindrical_surface,
    conical_surface,
    spherical_surface,
    toroidal_surface,
    degenerate_toroidal_surface,
    surface_of_revolution,
    surface_of_linear_extrusion,
    offset_surface,
    b_spline_surface,
    bezier_surface,
    uniform_surface,
    quasi_uniform_surface,
    b_spline_surface_with_knots,
    rectangular_trimmed_surface,
    curve_bounded_surface,
    surface_replica,
    unread_surface,
    // other geometry
    cartesian_point,
    direction,
    vector,
    axis1_placement,
    axis2_placement_2d,
    axis2_placement_3d,
    unread_placement,
    composite_curve_segment,
    point_on_geometry,
    geometric_set,
    // topology
    vertex_point,
    edge_curve,
    oriented_edge,
    edge_loop,
    vertex_loop,
    poly_loop,
    face_bound,
    face,
    topology,
    // units and contexts
    si_unit,
    conversion_based_unit,
    measure_with_unit,
    uncertainty,
    unit_context,
    // what puts items together
    shape_representation,
    definitional_representation,
    placed_part,
    mapped_item,
    shape_relationship,
    placed_relationship,
    shape_definition,
    styled_item,
    layer,
    colour,
};

Kind kind_of(std::string_view keyword) noexcept;

inline bool is_curve(Kind kind) noexcept {
    return kind >= Kind::line && kind <= Kind::unread_curve;
}
inline bool is_offset_curve(Kind kind) noexcept {
    return kind == Kind::offset_curve_2d || kind == Kind::offset_curve_3d;
}
inline bool is_surface(Kind kind) noexcept {
    return kind >= Kind::plane && kind <= Kind::unread_surface;
}
// Geometry and topology: what belongs to a shape, and names nothing but what belongs to it.
inline bool is_shape(Kind kind) noexcept {
    return kind >= Kind::line && kind <= Kind::topology;
}
inline bool is_axis2_placement(Kind kind) noexcept {
    return kind == Kind::axis2_placement_2d || kind == Kind::axis2_placement_3d;
}

// Whether an instance of this kind makes the curves and surfaces that it names parts of itself.
bool owns_geometry(Kind kind) noexcept;

} // namespace nrb::io::step
