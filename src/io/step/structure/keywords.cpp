// SPDX-License-Identifier: MIT
#include "io/step/structure/keywords.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

struct Keyword {
    std::string_view text;
    Kind kind;
};

// Sorted by the text.
constexpr Keyword keywords[] = {
    {"ADVANCED_BREP_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"ADVANCED_FACE", Kind::face},
    {"AXIS1_PLACEMENT", Kind::axis1_placement},
    {"AXIS2_PLACEMENT_2D", Kind::axis2_placement_2d},
    {"AXIS2_PLACEMENT_3D", Kind::axis2_placement_3d},
    {"BEZIER_CURVE", Kind::bezier_curve},
    {"BEZIER_SURFACE", Kind::bezier_surface},
    {"BOUNDARY_CURVE", Kind::composite_curve},
    {"BREP_WITH_VOIDS", Kind::topology},
    {"B_SPLINE_CURVE", Kind::b_spline_curve},
    {"B_SPLINE_CURVE_WITH_KNOTS", Kind::b_spline_curve_with_knots},
    {"B_SPLINE_SURFACE", Kind::b_spline_surface},
    {"B_SPLINE_SURFACE_WITH_KNOTS", Kind::b_spline_surface_with_knots},
    {"CARTESIAN_POINT", Kind::cartesian_point},
    {"CIRCLE", Kind::circle},
    {"CLOSED_SHELL", Kind::topology},
    {"CLOTHOID", Kind::unread_curve},
    {"COLOUR_RGB", Kind::colour},
    {"COMPOSITE_CURVE", Kind::composite_curve},
    {"COMPOSITE_CURVE_ON_SURFACE", Kind::composite_curve},
    {"COMPOSITE_CURVE_SEGMENT", Kind::composite_curve_segment},
    {"CONICAL_SURFACE", Kind::conical_surface},
    {"CONNECTED_EDGE_SET", Kind::topology},
    {"CONNECTED_FACE_SET", Kind::topology},
    {"CONSTRUCTIVE_GEOMETRY_REPRESENTATION", Kind::shape_representation},
    {"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", Kind::placed_part},
    {"CONVERSION_BASED_UNIT", Kind::conversion_based_unit},
    {"CSG_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"CURVE_BOUNDED_SURFACE", Kind::curve_bounded_surface},
    {"CURVE_REPLICA", Kind::curve_replica},
    {"CYLINDRICAL_SURFACE", Kind::cylindrical_surface},
    {"DEFINITIONAL_REPRESENTATION", Kind::definitional_representation},
    {"DEGENERATE_PCURVE", Kind::point_on_geometry},
    {"DEGENERATE_TOROIDAL_SURFACE", Kind::degenerate_toroidal_surface},
    {"DIRECTION", Kind::direction},
    {"DRAUGHTING_PRE_DEFINED_COLOUR", Kind::colour},
    {"EDGE_BASED_WIREFRAME_MODEL", Kind::topology},
    {"EDGE_BASED_WIREFRAME_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"EDGE_CURVE", Kind::edge_curve},
    {"EDGE_LOOP", Kind::edge_loop},
    {"ELLIPSE", Kind::ellipse},
    {"FACETED_BREP", Kind::topology},
    {"FACETED_BREP_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"FACE_BASED_SURFACE_MODEL", Kind::topology},
    {"FACE_BOUND", Kind::face_bound},
    {"FACE_OUTER_BOUND", Kind::face_bound},
    {"FACE_SURFACE", Kind::face},
    {"GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"GEOMETRIC_CURVE_SET", Kind::geometric_set},
    {"GEOMETRIC_SET", Kind::geometric_set},
    {"GLOBAL_UNIT_ASSIGNED_CONTEXT", Kind::unit_context},
    {"HYPERBOLA", Kind::hyperbola},
    {"INTERSECTION_CURVE", Kind::surface_curve},
    {"LENGTH_MEASURE_WITH_UNIT", Kind::measure_with_unit},
    {"LINE", Kind::line},
    {"MANIFOLD_SOLID_BREP", Kind::topology},
    {"MANIFOLD_SUBSURFACE_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"MANIFOLD_SURFACE_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"MAPPED_ITEM", Kind::mapped_item},
    {"MEASURE_WITH_UNIT", Kind::measure_with_unit},
    {"OFFSET_CURVE_2D", Kind::offset_curve_2d},
    {"OFFSET_CURVE_3D", Kind::offset_curve_3d},
    {"OFFSET_SURFACE", Kind::offset_surface},
    {"OPEN_SHELL", Kind::topology},
    {"ORIENTED_CLOSED_SHELL", Kind::topology},
    {"ORIENTED_EDGE", Kind::oriented_edge},
    {"ORIENTED_FACE", Kind::topology},
    {"ORIENTED_OPEN_SHELL", Kind::topology},
    {"ORIENTED_PATH", Kind::topology},
    {"OUTER_BOUNDARY_CURVE", Kind::composite_curve},
    {"OVER_RIDING_STYLED_ITEM", Kind::styled_item},
    {"PARABOLA", Kind::parabola},
    {"PATH", Kind::topology},
    {"PCURVE", Kind::pcurve},
    {"PLACEMENT", Kind::unread_placement},
    {"PLANE", Kind::plane},
    {"PLANE_ANGLE_MEASURE_WITH_UNIT", Kind::measure_with_unit},
    {"POINT_ON_CURVE", Kind::point_on_geometry},
    {"POINT_ON_SURFACE", Kind::point_on_geometry},
    {"POINT_REPLICA", Kind::point_on_geometry},
    {"POLYLINE", Kind::polyline},
    {"POLY_LOOP", Kind::poly_loop},
    {"PRESENTATION_LAYER_ASSIGNMENT", Kind::layer},
    {"QUASI_UNIFORM_CURVE", Kind::quasi_uniform_curve},
    {"QUASI_UNIFORM_SURFACE", Kind::quasi_uniform_surface},
    {"RECTANGULAR_COMPOSITE_SURFACE", Kind::unread_surface},
    {"RECTANGULAR_TRIMMED_SURFACE", Kind::rectangular_trimmed_surface},
    {"REPARAMETRISED_COMPOSITE_CURVE_SEGMENT", Kind::composite_curve_segment},
    {"REPRESENTATION_RELATIONSHIP", Kind::shape_relationship},
    {"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION", Kind::placed_relationship},
    {"SEAM_CURVE", Kind::surface_curve},
    {"SHAPE_DEFINITION_REPRESENTATION", Kind::shape_definition},
    {"SHAPE_REPRESENTATION", Kind::shape_representation},
    {"SHAPE_REPRESENTATION_RELATIONSHIP", Kind::shape_relationship},
    {"SHELL_BASED_SURFACE_MODEL", Kind::topology},
    {"SHELL_BASED_WIREFRAME_MODEL", Kind::topology},
    {"SHELL_BASED_WIREFRAME_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"SI_UNIT", Kind::si_unit},
    {"SPHERICAL_SURFACE", Kind::spherical_surface},
    {"STYLED_ITEM", Kind::styled_item},
    {"SURFACE_CURVE", Kind::surface_curve},
    {"SURFACE_OF_LINEAR_EXTRUSION", Kind::surface_of_linear_extrusion},
    {"SURFACE_OF_REVOLUTION", Kind::surface_of_revolution},
    {"SURFACE_PATCH", Kind::unread_surface},
    {"SURFACE_REPLICA", Kind::surface_replica},
    {"TESSELLATED_SHAPE_REPRESENTATION", Kind::shape_representation},
    {"TOROIDAL_SURFACE", Kind::toroidal_surface},
    {"TRIMMED_CURVE", Kind::trimmed_curve},
    {"UNCERTAINTY_MEASURE_WITH_UNIT", Kind::uncertainty},
    {"UNIFORM_CURVE", Kind::uniform_curve},
    {"UNIFORM_SURFACE", Kind::uniform_surface},
    {"VECTOR", Kind::vector},
    {"VERTEX_LOOP", Kind::vertex_loop},
    {"VERTEX_POINT", Kind::vertex_point},
    {"VERTEX_SHELL", Kind::topology},
    {"WIRE_SHELL", Kind::topology},
};
static_assert(std::ranges::is_sorted(keywords, {}, &Keyword::text));

} // namespace

Kind kind_of(std::string_view keyword) noexcept {
    const auto *const found = std::ranges::lower_bound(keywords, keyword, {}, &Keyword::text);
    return found != std::end(keywords) && found->text == keyword ? found->kind : Kind::other;
}

bool owns_geometry(Kind kind) noexcept {
    switch (kind) {
    case Kind::trimmed_curve:
    case Kind::composite_curve_segment:
    case Kind::surface_curve:
    case Kind::pcurve:
    case Kind::offset_curve_2d:
    case Kind::offset_curve_3d:
    case Kind::curve_replica:
    case Kind::unread_curve:
    case Kind::surface_of_revolution:
    case Kind::surface_of_linear_extrusion:
    case Kind::offset_surface:
    case Kind::rectangular_trimmed_surface:
    case Kind::curve_bounded_surface:
    case Kind::surface_replica:
    case Kind::unread_surface:
    case Kind::point_on_geometry:
    case Kind::edge_curve:
    case Kind::face:
    case Kind::definitional_representation:
        return true;
    default:
        return false;
    }
}

} // namespace nrb::io::step
