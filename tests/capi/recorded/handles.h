/* SPDX-License-Identifier: MIT */
// What handles hold: everything that they can be asked for, by the library's functions themselves. No
// question fails, for messages stay those of the calls that are recorded.
#ifndef NURBS_TESTS_CAPI_RECORDED_HANDLES_H
#define NURBS_TESTS_CAPI_RECORDED_HANDLES_H

#include "guarded/shape_terms.h"
#include "recorded/record.h"

#include <string>
#include <vector>

namespace recorded {

inline std::string last_message() {
    std::string text(static_cast<size_t>(nurbs_last_error(nullptr, 0)) + 1, '\0');
    (void)nurbs_last_error(text.data(), static_cast<int64_t>(text.size()));
    text.pop_back();
    return text;
}

inline void add_axis(Output &output, const nurbs *g, int32_t axis) {
    const int32_t degree = shape_terms::degree_of(g, axis);
    const int64_t count = shape_terms::count_of(g, axis);
    std::vector<double> knots(static_cast<size_t>(count + degree + 1));
    (void)nurbs_knots(g, axis, count + degree + 1, knots.data());
    output.add(degree);
    output.add(count);
    output.add(shape_terms::ask<int32_t>(nurbs_knot_form, g, axis));
    output.add(knots.data(), count + degree + 1);
}

// As they are stored: Cartesian with their weights, or homogeneous.
inline void add_points(Output &output, const nurbs *g, bool homogeneous) {
    const int64_t count = shape_terms::points_of(g), width = shape_terms::dim_of(g) + (homogeneous ? 1 : 0);
    std::vector<double> points(static_cast<size_t>(count * width)), weights(static_cast<size_t>(count));
    if (homogeneous) {
        (void)nurbs_homogeneous_points(g, count, points.data(), 0, 0);
    } else {
        (void)nurbs_points(g, count, points.data(), 0, 0);
        (void)nurbs_weights(g, count, weights.data(), 0);
    }
    output.add(points.data(), count * width);
    output.add(weights.data(), count);
}

// Nothing of NULL.
inline void add_handle(Output &output, const nurbs *g) {
    if (g == nullptr) {
        return;
    }
    const auto homogeneous = shape_terms::ask<int32_t>(nurbs_is_homogeneous, g);
    for (const int32_t number :
         {shape_terms::axes_of(g), shape_terms::dim_of(g), shape_terms::rational_of(g), homogeneous}) {
        output.add(number);
    }
    for (int32_t axis = 0; axis < shape_terms::axes_of(g); ++axis) {
        add_axis(output, g, axis);
    }
    add_points(output, g, homogeneous != 0);
}

inline void add_text(Output &output, const std::string &text) {
    output.add(text.data(), static_cast<int64_t>(text.size()));
}

inline void add_item(Output &output, const nurbs_list *list, int64_t index) {
    std::string name(256, '\0');
    (void)nurbs_list_name(list, index, name.data(), 256, nullptr);
    add_text(output, name);
    nurbs *item = nullptr;
    (void)nurbs_list_get(list, index, &item);
    add_handle(output, item);
    nurbs_destroy(item);
}

inline void add_note(Output &output, const nurbs_list *list, int64_t index) {
    int32_t entity = 0;
    int64_t line = 0;
    nurbs_status reason = NURBS_OK;
    std::string text(512, '\0');
    (void)nurbs_list_note(list, index, &entity, &line, &reason, text.data(), 512, nullptr);
    output.add(entity);
    output.add(line);
    output.add(reason);
    add_text(output, text);
}

inline void add_handle(Output &output, const nurbs_list *list) {
    if (list == nullptr) {
        return;
    }
    const auto items = shape_terms::ask<int64_t>(nurbs_list_count, list);
    const auto notes = shape_terms::ask<int64_t>(nurbs_list_note_count, list);
    output.add(items);
    output.add(notes);
    output.add(shape_terms::ask<double>(nurbs_list_unit, list));
    for (int64_t i = 0; i < items; ++i) {
        add_item(output, list, i);
    }
    for (int64_t i = 0; i < notes; ++i) {
        add_note(output, list, i);
    }
}

inline void discard(nurbs *g) {
    nurbs_destroy(g);
}
inline void discard(nurbs_list *list) {
    nurbs_list_destroy(list);
}

inline void add_handle(Output &output, const nurbs_statistics *statistics) {
    if (statistics == nullptr) {
        return;
    }
    int64_t size = 0;
    (void)nurbs_statistics_to_bytes(statistics, 0, nullptr, &size);
    std::string bytes(static_cast<size_t>(size), '\0');
    (void)nurbs_statistics_to_bytes(statistics, size, bytes.data(), nullptr);
    add_text(output, bytes);
}
inline void discard(nurbs_statistics *statistics) {
    nurbs_statistics_destroy(statistics);
}

inline void add_curve(Output &output, const nurbs_face *face, int64_t loop, int64_t index) {
    nurbs *curve = nullptr;
    (void)nurbs_face_curve(face, loop, index, &curve);
    add_handle(output, curve);
    nurbs_destroy(curve);
}

inline void add_handle(Output &output, const nurbs_face *face) {
    if (face == nullptr) {
        return;
    }
    int64_t loops = 0;
    (void)nurbs_face_loops(face, 0, nullptr, &loops);
    std::vector<int64_t> sizes(static_cast<size_t>(loops));
    (void)nurbs_face_loops(face, loops, sizes.data(), nullptr);
    output.add(sizes.data(), loops);
    for (int64_t loop = 0; loop < loops; ++loop) {
        for (int64_t i = 0; i < sizes[static_cast<size_t>(loop)]; ++i) {
            add_curve(output, face, loop, i);
        }
    }
}
inline void discard(nurbs_face *face) {
    nurbs_face_destroy(face);
}

inline void add_handle(Output &output, const nurbs_model *model) {
    if (model == nullptr) {
        return;
    }
    int64_t counts[5] = {0, 0, 0, 0, 0};
    (void)nurbs_model_counts(model, &counts[0], &counts[1], &counts[2], &counts[3], &counts[4]);
    output.add(counts, 5);
    for (int64_t i = 0; i < counts[2]; ++i) {
        nurbs_face *face = nullptr;
        (void)nurbs_model_face(model, i, nullptr, nullptr, nullptr, nullptr, &face);
        add_handle(output, face);
        nurbs_face_destroy(face);
    }
    for (int64_t i = 0; i < counts[3]; ++i) {
        nurbs *edge = nullptr;
        (void)nurbs_model_edge(model, i, nullptr, nullptr, nullptr, &edge);
        add_handle(output, edge);
        nurbs_destroy(edge);
    }
}
inline void discard(nurbs_model *model) {
    nurbs_model_destroy(model);
}

inline void add_handle(Output &output, const nurbs_meet *meet) {
    if (meet == nullptr) {
        return;
    }
    int64_t counts[2] = {0, 0};
    (void)nurbs_meet_counts(meet, &counts[0], &counts[1], nullptr);
    output.add(counts, 2);
    for (int64_t i = 0; i < counts[0]; ++i) {
        nurbs *curves[2] = {nullptr, nullptr};
        (void)nurbs_meet_branch(meet, i, &curves[0], &curves[1]);
        for (nurbs *curve : curves) {
            add_handle(output, curve);
            nurbs_destroy(curve);
        }
    }
}
inline void discard(nurbs_meet *meet) {
    nurbs_meet_destroy(meet);
}

inline void add_handle(Output &output, const nurbs_mesh *mesh) {
    if (mesh == nullptr) {
        return;
    }
    int64_t counts[2] = {0, 0};
    (void)nurbs_mesh_counts(mesh, &counts[0], nullptr, &counts[1], nullptr, nullptr, nullptr);
    std::vector<double> points(static_cast<size_t>(3 * counts[0]));
    std::vector<int64_t> corners(static_cast<size_t>(3 * counts[1]));
    (void)nurbs_mesh_points(mesh, counts[0], points.data(), nullptr);
    (void)nurbs_mesh_triangles(mesh, 0, counts[1], corners.data(), nullptr);
    output.add(counts, 2);
    output.add(points.data(), std::ssize(points));
    output.add(corners.data(), std::ssize(corners));
}
inline void discard(nurbs_mesh *mesh) {
    nurbs_mesh_destroy(mesh);
}

} // namespace recorded

#endif
