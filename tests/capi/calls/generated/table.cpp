/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

static_assert(sizeof(Output::values) == 1024 * sizeof(double));
static_assert(sizeof(Output::singles) == 64 * sizeof(float));
static_assert(sizeof(Output::spans) == 64 * sizeof(int64_t));
static_assert(sizeof(Output::states) == 64 * sizeof(int32_t));
static_assert(sizeof(Output::states) == 64 * sizeof(nurbs_status));
static_assert(sizeof(Output::text) == 128 * sizeof(char));

nurbs_status make_curve(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr int64_t counts[] = {9};
    static constexpr double knots[] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    static constexpr double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
    static constexpr double weights[] = {1, 0.7071067811865476, 1, 0.7071067811865476, 1,
        0.7071067811865476, 1, 0.7071067811865476, 1};
    return nurbs_create(1, degrees, counts, knots, 12, 2, points, 0, 0, weights, 0, 0, out);
}

nurbs_status make_loop(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr int64_t counts[] = {6};
    static constexpr double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    static constexpr double points[] = {1, 1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1};
    return nurbs_create(1, degrees, counts, knots, 9, 2, points, 0, 0, nullptr, 0, NURBS_PERIODIC, out);
}

nurbs_status make_surface(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2, 1};
    static constexpr int64_t counts[] = {3, 4};
    static constexpr double knots[] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 2, 3, 3};
    static constexpr double points[] = {0, 0, 0, 0, 1, 1, 0, 2, 2, 0, 3, 3, 0.5, 0, 0, 0.5, 1, 1, 0.5, 2,
        2, 0.5, 3, 3, 1, 0, 1, 1, 1, 2, 1, 2, 3, 1, 3, 4};
    return nurbs_create(2, degrees, counts, knots, 12, 3, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_volume(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1, 1, 1};
    static constexpr int64_t counts[] = {2, 2, 2};
    static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
    static constexpr double points[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0,
        1, 0, 1, 1, 0, 0, 1, 1, 1, 1};
    return nurbs_create(3, degrees, counts, knots, 12, 4, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_solid(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1, 2, 1};
    static constexpr int64_t counts[] = {3, 3, 2};
    static constexpr double knots[] = {0, 0, 0.5, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0, 1, 1};
    static constexpr double points[] = {0, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0.5, 1, 0.25, 1, 0, 0.25, 1, 1,
        0.5, 0, 0, 0.5, 0, 1, 0.5, 0.5, 0, 0.5, 0.5, 1, 0.75, 1, 0, 0.75, 1, 1, 1, 0, 0, 1, 0, 1, 1, 0.5,
        0, 1, 0.5, 1, 1.25, 1, 0, 1.25, 1, 1};
    return nurbs_create(3, degrees, counts, knots, 15, 3, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_homogeneous(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr int64_t counts[] = {3};
    static constexpr double knots[] = {0, 0, 0, 1, 1, 1};
    static constexpr double points[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    return nurbs_create_homogeneous(1, degrees, counts, knots, 6, 2, points, 0, 0, 0, out);
}

nurbs_status make_twist(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {3};
    static constexpr int64_t counts[] = {4};
    static constexpr double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static constexpr double points[] = {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 3};
    return nurbs_create(1, degrees, counts, knots, 8, 3, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_segment(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr int64_t counts[] = {3};
    static constexpr double knots[] = {0, 1, 2, 3, 4, 5};
    static constexpr double points[] = {0, 0, 1, 1, 2, 0};
    static constexpr double weights[] = {1, 3, 5};
    return nurbs_create(1, degrees, counts, knots, 6, 2, points, 0, 0, weights, 0, 0, out);
}

nurbs_status make_list(const Inputs &, nurbs_list **out) {
    return nurbs_read(texts::file, 1134, nullptr, out);
}

nurbs_status make_no_statistics(const Inputs &, nurbs_statistics **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr int64_t break_counts[] = {3};
    static constexpr double breaks[] = {0, 0.5, 1};
    return nurbs_statistics_create(1, degrees, break_counts, breaks, 3, 1, 4, 1, out);
}

nurbs_status make_statistics(const Inputs &in, nurbs_statistics **out) {
    static constexpr double params[] = {0, 0.25, 0.5, 0.75, 1};
    static constexpr double values[] = {0, 1, 2, 1, 0};
    nurbs_data data = {};
    data.struct_size = sizeof(nurbs_data);
    data.n = 5;
    data.axes = 1;
    data.dim = 1;
    data.params = params;
    data.values = values;
    return nurbs_statistics_add(in.no_statistics, &data, out);
}

nurbs_status make_outline(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr int64_t counts[] = {4};
    static constexpr double knots[] = {0, 0, 1, 2, 3, 3};
    static constexpr double points[] = {0.25, 1, 0.75, 1, 0.5, 2, 0.25, 1};
    return nurbs_create(1, degrees, counts, knots, 6, 2, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_face(const Inputs &in, nurbs_face **out) {
    static constexpr int64_t sizes[] = {1};
    const nurbs *const curves[] = {in.outline};
    return nurbs_face_create(in.surface, 1, sizes, curves, nullptr, nullptr, 0.001, 0, nullptr, out);
}

nurbs_status make_model(const Inputs &in, nurbs_model **out) {
    const nurbs_face *const faces[] = {in.face, in.face};
    return nurbs_model_create(2, faces, 0.001, out);
}

nurbs_status make_layered(const Inputs &, nurbs_model **out) {
    return nurbs_read_model(texts::layers, 549, nullptr, out);
}

nurbs_status make_meet(const Inputs &in, nurbs_meet **out) {
    static constexpr double normal[] = {0, 0, 1};
    static constexpr double offsets[] = {0.5, 2};
    return nurbs_surface_sections(in.surface, normal, 2, offsets, 0.001, out);
}

nurbs_status make_mesh(const Inputs &in, nurbs_mesh **out) {
    nurbs_mesh_options options;
    (void)nurbs_mesh_options_init(&options, sizeof options);
    options.chord = 1;
    options.relative_chord = 0;
    return nurbs_mesh_face(in.face, &options, out);
}

nurbs_status make_block(const Inputs &in, nurbs_mesh **out) {
    nurbs_mesh_options options;
    (void)nurbs_mesh_options_init(&options, sizeof options);
    options.chord = 0.1;
    options.relative_chord = 0;
    return nurbs_mesh_volume(in.solid, &options, 100, out);
}

nurbs_status make_copy(const Inputs &in, nurbs **out) {
    return nurbs_clone(in.curve, out);
}

nurbs_status make_half(const Inputs &in, nurbs **out) {
    return nurbs_reparametrize_moebius(in.curve, 0, 2, out);
}

nurbs_status make_ramp(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr double points[] = {0, 0.25, 1};
    return nurbs_create_bezier(1, degrees, 1, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_heights(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1, 1};
    static constexpr int64_t counts[] = {2, 2};
    static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 3, 3};
    static constexpr double points[] = {0, 1, 1, 2};
    return nurbs_create(2, degrees, counts, knots, 8, 1, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_round(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr double points[] = {0, 2, 9};
    return nurbs_create_bezier(1, degrees, 1, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_diagonal(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr double points[] = {0, 0, 1, 0, 1, 1};
    return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_square(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1, 1};
    static constexpr double points[] = {0, 0, 0, 1, 1, 0, 1, 2};
    return nurbs_create_bezier(2, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_sphere(const Inputs &, nurbs **out) {
    return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
}

nurbs_status make_wall(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1, 1};
    static constexpr double points[] = {0.3, -1, -1, 0.3, -1, 9, 0.4, 9, -1, 0.4, 9, 9};
    return nurbs_create_bezier(2, degrees, 3, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_edges(const Inputs &in, nurbs_list **out) {
    return nurbs_boundaries(in.surface, out);
}

nurbs_status make_faces(const Inputs &in, nurbs_list **out) {
    return nurbs_boundaries(in.volume, out);
}

nurbs_status make_more_statistics(const Inputs &in, nurbs_statistics **out) {
    return nurbs_statistics_clone(in.statistics, out);
}

nurbs_status make_another_model(const Inputs &in, nurbs_model **out) {
    return nurbs_model_clone(in.model, out);
}

nurbs_status make_crossing(const Inputs &in, nurbs_meet **out) {
    Made made_wall(in, make_wall);
    if (made_wall.status() != NURBS_OK) {
        return made_wall.status();
    }
    return nurbs_surface_intersections(in.surface, made_wall, 0.01, out);
}

nurbs_status make_another_meet(const Inputs &in, nurbs_meet **out) {
    return nurbs_meet_clone(in.meet, out);
}

nurbs_status make_another_mesh(const Inputs &in, nurbs_mesh **out) {
    return nurbs_mesh_clone(in.mesh, out);
}

nurbs_status make_another_face(const Inputs &in, nurbs_face **out) {
    return nurbs_face_clone(in.face, out);
}

nurbs_status make_moved_outline(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr int64_t counts[] = {4};
    static constexpr double knots[] = {0, 0, 1, 2, 3, 3};
    static constexpr double points[] = {0.25, 1.25, 0.75, 1.25, 0.5, 2.25, 0.25, 1.25};
    return nurbs_create(1, degrees, counts, knots, 6, 2, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_moved_face(const Inputs &in, nurbs_face **out) {
    Made made_moved_outline(in, make_moved_outline);
    if (made_moved_outline.status() != NURBS_OK) {
        return made_moved_outline.status();
    }
    static constexpr int64_t sizes[] = {1};
    const nurbs *const curves[] = {made_moved_outline};
    return nurbs_face_create(in.surface, 1, sizes, curves, nullptr, nullptr, 0.001, 0, nullptr, out);
}

nurbs_status make_upright_outline(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr int64_t counts[] = {4};
    static constexpr double knots[] = {0, 0, 1, 2, 3, 3};
    static constexpr double points[] = {0, 0, 1, 0, 0, 1, 0, 0};
    return nurbs_create(1, degrees, counts, knots, 6, 2, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_upright(const Inputs &in, nurbs_face **out) {
    Made made_wall(in, make_wall);
    if (made_wall.status() != NURBS_OK) {
        return made_wall.status();
    }
    Made made_upright_outline(in, make_upright_outline);
    if (made_upright_outline.status() != NURBS_OK) {
        return made_upright_outline.status();
    }
    static constexpr int64_t sizes[] = {1};
    const nurbs *const curves[] = {made_upright_outline};
    return nurbs_face_create(made_wall, 1, sizes, curves, nullptr, nullptr, 0.001, 0, nullptr, out);
}

nurbs_status make_divider(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr double points[] = {0, 1.5, 1, 1.75};
    return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_cutter(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1, 1};
    static constexpr int64_t counts[] = {2, 2};
    static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 1, 1};
    static constexpr double points[] = {-1, 1.625, -9, -1, 1.625, 9, 2, 1.625, -9, 2, 1.625, 9};
    return nurbs_create(2, degrees, counts, knots, 8, 3, points, 0, 0, nullptr, 0, 0, out);
}

nurbs_status make_ball_face(const Inputs &in, nurbs_face **out) {
    Made made_sphere(in, make_sphere);
    if (made_sphere.status() != NURBS_OK) {
        return made_sphere.status();
    }
    return nurbs_face_create(made_sphere, 0, nullptr, nullptr, nullptr, nullptr, 1e-09, 0, nullptr, out);
}

nurbs_status make_ball(const Inputs &in, nurbs_model **out) {
    Made made_sphere(in, make_sphere);
    if (made_sphere.status() != NURBS_OK) {
        return made_sphere.status();
    }
    Made made_ball_face(in, make_ball_face);
    if (made_ball_face.status() != NURBS_OK) {
        return made_ball_face.status();
    }
    const nurbs_face *const faces[] = {made_ball_face};
    return nurbs_model_create(1, faces, 1, out);
}

nurbs_status make_south(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr double points[] = {0, 0, 1, 0};
    return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_east(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr double points[] = {1, 0, 1, 3};
    return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_north(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr double points[] = {1, 3, 0, 3};
    return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_west(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {1};
    static constexpr double points[] = {0, 3, 0, 0};
    return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_first_edge(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr double points[] = {0.25, 1, 1.0625, 0.5, 1, 1.1875, 0.75, 1, 1.5625};
    return nurbs_create_bezier(1, degrees, 3, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_second_edge(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr double points[] = {0.75, 1, 1.5625, 0.625, 1.5, 1.875, 0.5, 2, 2.25};
    return nurbs_create_bezier(1, degrees, 3, points, 0, 0, nullptr, 0, out);
}

nurbs_status make_third_edge(const Inputs &, nurbs **out) {
    static constexpr int32_t degrees[] = {2};
    static constexpr double points[] = {0.5, 2, 2.25, 0.375, 1.5, 1.625, 0.25, 1, 1.0625};
    return nurbs_create_bezier(1, degrees, 3, points, 0, 0, nullptr, 0, out);
}

Inputs make_inputs() {
    Inputs in{};
    CHECK_OK(make_curve(in, &in.curve));
    CHECK_OK(make_loop(in, &in.loop));
    CHECK_OK(make_surface(in, &in.surface));
    CHECK_OK(make_volume(in, &in.volume));
    CHECK_OK(make_solid(in, &in.solid));
    CHECK_OK(make_homogeneous(in, &in.homogeneous));
    CHECK_OK(make_twist(in, &in.twist));
    CHECK_OK(make_segment(in, &in.segment));
    CHECK_OK(make_list(in, &in.list));
    CHECK_OK(make_no_statistics(in, &in.no_statistics));
    CHECK_OK(make_statistics(in, &in.statistics));
    CHECK_OK(make_outline(in, &in.outline));
    CHECK_OK(make_face(in, &in.face));
    CHECK_OK(make_model(in, &in.model));
    CHECK_OK(make_layered(in, &in.layered));
    CHECK_OK(make_meet(in, &in.meet));
    CHECK_OK(make_mesh(in, &in.mesh));
    CHECK_OK(make_block(in, &in.block));
    return in;
}

std::vector<std::span<const Call>> allocating_groups() {
    return {data_calls(), edit_calls(), evaluation_calls(), form_calls(), query_calls(), shape_calls()};
}

} // namespace calls
