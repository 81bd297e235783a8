// SPDX-License-Identifier: MIT
// The numbers of the entity types.
#pragma once

namespace nrb::io::iges {

// clang-format off
enum EntityType : int {
    circular_arc_type = 100, composite_type = 102, conic_arc_type = 104, copious_data_type = 106, plane_type = 108,
    line_type = 110, spline_pieces_type = 112, spline_patches_type = 114, point_type = 116, ruled_type = 118,
    revolution_type = 120, tabulated_type = 122, direction_type = 123, matrix_type = 124, spline_curve_type = 126,
    spline_surface_type = 128, offset_curve_type = 130, connect_point_type = 132, offset_surface_type = 140, boundary_type = 141,
    curve_on_surface_type = 142, bounded_surface_type = 143, trimmed_surface_type = 144, plane_surface_type = 190,
    cylinder_type = 192, cone_type = 194, sphere_type = 196, torus_type = 198,
    solid_type = 186, subfigure_type = 308, colour_type = 314, associativity_type = 402, property_type = 406,
    subfigure_instance_type = 408, solid_instance_type = 430, vertex_list_type = 502, edge_list_type = 504,
    loop_type = 508, face_type = 510, shell_type = 514
};
// clang-format on

} // namespace nrb::io::iges
