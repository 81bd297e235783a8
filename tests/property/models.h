// Models and faces that free themselves, and what tests ask of them.
#pragma once

#include "support/handle.h"

#include <array>
#include <string>

namespace support::models {

struct DestroyModel {
    void operator()(nurbs_model *model) const noexcept { nurbs_model_destroy(model); }
    void operator()(nurbs_face *face) const noexcept { nurbs_face_destroy(face); }
    void operator()(nurbs_list *list) const noexcept { nurbs_list_destroy(list); }
};
using Model = std::unique_ptr<nurbs_model, DestroyModel>;
using Face = std::unique_ptr<nurbs_face, DestroyModel>;

struct ModelCounts {
    int64_t parts = -1, uses = -1, faces = -1, edges = -1, vertices = -1;
    bool operator==(const ModelCounts &) const = default;
    // Of the surface that they cover, if every face is a disk.
    [[nodiscard]] int64_t euler() const { return vertices - edges + faces; }
};

inline ModelCounts counts_of(const nurbs_model *model) {
    ModelCounts n;
    require_ok(nurbs_model_counts(model, &n.parts, &n.uses, &n.faces, &n.edges, &n.vertices));
    return n;
}

inline Model read_model(const std::string &text) {
    nurbs_model *model = nullptr;
    require_ok(nurbs_read_model(text.data(), std::ssize(text), nullptr, &model));
    return Model(model);
}

inline Model model_of(const std::vector<const nurbs_face *> &faces) {
    nurbs_model *model = nullptr;
    require_ok(nurbs_model_create(std::ssize(faces), faces.data(), 1, &model));
    return Model(model);
}

inline Face face_of(const nurbs_model *model, int64_t index) {
    nurbs_face *face = nullptr;
    require_ok(nurbs_model_face(model, index, nullptr, nullptr, nullptr, nullptr, &face));
    return Face(face);
}

inline Handle edge_of(const nurbs_model *model, int64_t index) {
    nurbs *edge = nullptr;
    require_ok(nurbs_model_edge(model, index, nullptr, nullptr, nullptr, &edge));
    return Handle(edge);
}

using Place = std::array<int64_t, 3>; // face, loop, and place in the loop

inline std::vector<Place> places_of(const nurbs_model *model, int64_t edge) {
    int64_t count = -1;
    require_ok(nurbs_model_edge_uses(model, edge, 0, nullptr, &count));
    std::vector<Place> places(static_cast<size_t>(count));
    require_ok(
        nurbs_model_edge_uses(model, edge, count, places.empty() ? nullptr : places[0].data(), nullptr));
    return places;
}

// How many uses edges have: {2: 12} of a cube as [0, 0, 12].
inline std::vector<int64_t> uses_of(const nurbs_model *model) {
    std::vector<int64_t> found;
    for (int64_t i = 0; i < counts_of(model).edges; ++i) {
        const size_t uses = places_of(model, i).size();
        found.resize(std::max(found.size(), uses + 1));
        ++found[uses];
    }
    return found;
}

inline double area_of(const nurbs_model *model, double relative_tolerance) {
    double sum = 0;
    for (int64_t i = 0; i < counts_of(model).faces; ++i) {
        double area = 0;
        require_ok(nurbs_face_area(face_of(model, i).get(), relative_tolerance, &area, nullptr));
        sum += area;
    }
    return sum;
}

inline std::vector<std::string> notes_of(const nurbs_model *model) {
    nurbs_list *made = nullptr;
    require_ok(nurbs_model_splines(model, &made));
    const std::unique_ptr<nurbs_list, DestroyModel> list(made);
    int64_t count = 0;
    require_ok(nurbs_list_note_count(made, &count));
    std::vector<std::string> notes;
    for (int64_t i = 0; i < count; ++i) {
        char text[512] = "";
        require_ok(nurbs_list_note(made, i, nullptr, nullptr, nullptr, text, sizeof text, nullptr));
        notes.emplace_back(text);
    }
    return notes;
}

} // namespace support::models
