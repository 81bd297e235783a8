// SPDX-License-Identifier: MIT
// Models (boundary representations): reading them, and access to their faces, edges, vertices, parts, uses
// and layers.
#include "checks.h"
#include "guard.h"
#include "lists.h"
#include "outputs.h"
#include "read_settings.h"
#include "watched.h"

#include "base/error.h"
#include "base/numbers.h"
#include "io/file.h"
#include "io/formats.h"
#include "model/edge_gaps.h"
#include "model/numbering.h"

#include <algorithm>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

template <class Item>
const Item &item_of(const std::vector<Item> &items, int64_t index, const char *what) {
    if (index < 0 || index >= std::ssize(items)) {
        fail(Status::index, "index = %lld, expected one of the %zu %s", static_cast<long long>(index),
             items.size(), what);
    }
    return items[static_cast<size_t>(index)];
}

int32_t shape_of(const model::CurveShapePtr &shape) noexcept {
    switch (shape == nullptr ? model::CurveKind::spline : shape->kind) {
    case model::CurveKind::line:
        return NURBS_SHAPE_LINE;
    case model::CurveKind::circle:
        return NURBS_SHAPE_CIRCLE;
    case model::CurveKind::ellipse:
        return NURBS_SHAPE_ELLIPSE;
    case model::CurveKind::parabola:
        return NURBS_SHAPE_PARABOLA;
    case model::CurveKind::hyperbola:
        return NURBS_SHAPE_HYPERBOLA;
    case model::CurveKind::trimmed:
        return shape_of(shape->pieces.front().curve);
    default:
        return NURBS_SHAPE_NONE;
    }
}

int32_t shape_of(const model::SurfaceShapePtr &shape) noexcept {
    switch (shape == nullptr ? model::SurfaceKind::spline : shape->kind) {
    case model::SurfaceKind::plane:
        return NURBS_SHAPE_PLANE;
    case model::SurfaceKind::cylinder:
        return NURBS_SHAPE_CYLINDER;
    case model::SurfaceKind::cone:
        return NURBS_SHAPE_CONE;
    case model::SurfaceKind::sphere:
        return NURBS_SHAPE_SPHERE;
    case model::SurfaceKind::torus:
        return NURBS_SHAPE_TORUS;
    case model::SurfaceKind::revolution:
        return NURBS_SHAPE_REVOLUTION;
    case model::SurfaceKind::extrusion:
        return NURBS_SHAPE_EXTRUSION;
    case model::SurfaceKind::offset:
        return NURBS_SHAPE_OFFSET;
    case model::SurfaceKind::trimmed:
        return shape_of(shape->basis);
    default:
        return NURBS_SHAPE_NONE;
    }
}

void require_layers(int64_t cap, const int64_t *layers) {
    if (cap > 0) {
        require(layers, "layers");
    }
}

void put_layers(const std::vector<int64_t> &own, int64_t cap, int64_t *layers, int64_t *count) {
    const int64_t used = checked_cap(cap, std::ssize(own));
    check_apart({memory("layers", layers, used), memory("count", count, 1)}, {});
    std::copy_n(own.begin(), used, layers);
    put(count, std::ssize(own));
}

} // namespace

nurbs_status nurbs_read_model(const void *bytes, int64_t size, const nurbs_read_options *options,
                              nurbs_model **out) {
    return guard([&] {
        require_out(out);
        give(io::read_model(checked_text(bytes, size), settings_of(options)), out);
    });
}

nurbs_status nurbs_read_model_with(const void *bytes, int64_t size, const nurbs_read_options *options,
                                   const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out, [&] { return nurbs_read_model(bytes, size, options, out); });
}

nurbs_status nurbs_read_model_file(const char *path, const nurbs_read_options *options, nurbs_model **out) {
    return guard([&] {
        require_out(out);
        require(path, "path");
        const io::ReadSettings settings = settings_of(options);
        give(io::read_model(io::read_whole_file(path, settings.max_bytes), settings), out);
    });
}

nurbs_status nurbs_read_model_file_with(const char *path, const nurbs_read_options *options,
                                        const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out, [&] { return nurbs_read_model_file(path, options, out); });
}

nurbs_status nurbs_model_clone(const nurbs_model *model, nurbs_model **out) {
    return guard([&] {
        require_out(out);
        require(model, "model");
        *out = new nurbs_model{model->model};
    });
}

void nurbs_model_destroy(nurbs_model *model) {
    delete model;
}

nurbs_status nurbs_model_counts(const nurbs_model *model, int64_t *parts, int64_t *uses, int64_t *faces,
                                int64_t *edges, int64_t *vertices) {
    return guard([&] {
        const model::Model &own = model_of(model);
        check_apart({memory("parts", parts, 1), memory("uses", uses, 1), memory("faces", faces, 1),
                     memory("edges", edges, 1), memory("vertices", vertices, 1)},
                    {});
        put(parts, static_cast<int64_t>(own.parts.size()));
        put(uses, static_cast<int64_t>(own.uses.size()));
        put(faces, static_cast<int64_t>(own.faces.size()));
        put(edges, static_cast<int64_t>(own.edges.size()));
        put(vertices, static_cast<int64_t>(own.vertices.size()));
    });
}

nurbs_status nurbs_model_face(const nurbs_model *model, int64_t index, int64_t *part, int32_t *shape,
                              int32_t *against, double *colour, nurbs_face **out) {
    return guard([&] {
        require_out(out);
        const model::ModelFace &face = item_of(model_of(model).faces, index, "faces");
        check_apart({memory("part", part, 1), memory("shape", shape, 1), memory("against", against, 1),
                     memory("colour", colour, 3)},
                    {});
        *out = new nurbs_face{face.face};
        put(part, face.part);
        put(shape, shape_of(face.shape));
        put(against, face.against ? 1 : 0);
        put_all(colour, face.colour.value_or(std::array<double, 3>{nan_value, nan_value, nan_value}));
    });
}

nurbs_status nurbs_model_face_name(const nurbs_model *model, int64_t index, char *buf, int64_t cap,
                                   int64_t *length) {
    return guard([&] {
        const std::string &name = item_of(model_of(model).faces, index, "faces").name;
        check_buffer(buf, cap);
        copy_text(name, buf, cap, length);
    });
}

nurbs_status nurbs_model_face_solid(const nurbs_model *model, int64_t index, int64_t *solid,
                                    int32_t *in_void) {
    return guard([&] {
        const model::ModelFace &face = item_of(model_of(model).faces, index, "faces");
        check_apart({memory("solid", solid, 1), memory("in_void", in_void, 1)}, {});
        put(solid, face.solid);
        put(in_void, face.in_void ? 1 : 0);
    });
}

nurbs_status nurbs_model_face_layers(const nurbs_model *model, int64_t index, int64_t cap, int64_t *layers,
                                     int64_t *count) {
    return guard([&] {
        const model::Model &own = model_of(model);
        require_layers(cap, layers);
        put_layers(item_of(own.faces, index, "faces").layers, cap, layers, count);
    });
}

nurbs_status nurbs_model_edge(const nurbs_model *model, int64_t index, int64_t *part, int64_t *end_vertices,
                              int32_t *shape, nurbs **out) {
    return guard([&] {
        require_out(out);
        const model::Edge &edge = item_of(model_of(model).edges, index, "edges");
        check_apart(
            {memory("part", part, 1), memory("end_vertices", end_vertices, 2), memory("shape", shape, 1)},
            {});
        give(edge.curve, out);
        put(part, edge.part);
        put_all(end_vertices, edge.vertices);
        put(shape, shape_of(edge.shape));
    });
}

nurbs_status nurbs_model_edge_uses(const nurbs_model *model, int64_t index, int64_t cap, int64_t *places,
                                   int64_t *count) {
    return guard([&] {
        const model::Model &own = model_of(model);
        if (cap > 0) {
            require(places, "places");
        }
        const model::Edge &edge = item_of(own.edges, index, "edges");
        const int64_t used = checked_cap(cap, std::ssize(edge.uses));
        check_apart({memory("places", places, 3 * used), memory("count", count, 1)}, {});
        for (int64_t i = 0; i < used; ++i) {
            const model::EdgeUse &use = edge.uses[static_cast<size_t>(i)];
            places[3 * i] = use.face;
            places[3 * i + 1] = use.loop;
            places[3 * i + 2] = use.index;
        }
        put(count, static_cast<int64_t>(edge.uses.size()));
    });
}

nurbs_status nurbs_model_edge_gaps(const nurbs_model *model, int64_t cap, int64_t *uses, double *gaps,
                                   int32_t *bounded, int64_t *count) {
    return guard([&] {
        const model::Model &own = model_of(model);
        const int64_t filled = checked_cap(cap, std::ssize(own.edges));
        check_apart({memory("uses", uses, filled), memory("gaps", gaps, filled),
                     memory("bounded", bounded, filled), memory("count", count, 1)},
                    {});
        const bool wanted = gaps != nullptr || bounded != nullptr;
        const std::vector<face::Deviation> found = model::edge_gaps(own, wanted ? filled : 0);
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(uses, i, static_cast<int64_t>(own.edges[i].uses.size()));
            put(gaps, i, wanted ? found[i].distance : 0);
            put(bounded, i, wanted && found[i].proven ? 1 : 0);
        }
        put(count, static_cast<int64_t>(own.edges.size()));
    });
}

nurbs_status nurbs_model_vertex(const nurbs_model *model, int64_t index, double *point) {
    return guard([&] {
        const model::Model &own = model_of(model);
        require(point, "point");
        const Vector3 &vertex = item_of(own.vertices, index, "vertices");
        point[0] = vertex.x;
        point[1] = vertex.y;
        point[2] = vertex.z;
    });
}

nurbs_status nurbs_model_part(const nurbs_model *model, int64_t index, char *buf, int64_t cap,
                              int64_t *length) {
    return guard([&] {
        const std::string &name = item_of(model_of(model).parts, index, "parts").name;
        check_buffer(buf, cap);
        copy_text(name, buf, cap, length);
    });
}

nurbs_status nurbs_model_use(const nurbs_model *model, int64_t index, int64_t *parent, int64_t *part,
                             double *placement) {
    return guard([&] {
        const model::Use &use = item_of(model_of(model).uses, index, "uses");
        check_apart(
            {memory("parent", parent, 1), memory("part", part, 1), memory("placement", placement, 12)}, {});
        put(parent, use.parent);
        put(part, use.part);
        put_all(placement, use.placement);
    });
}

nurbs_status nurbs_model_splines(const nurbs_model *model, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        const model::Model &own = model_of(model);
        model::Model list;
        list.splines = own.splines;
        list.notes = own.notes;
        list.metres_per_unit = own.metres_per_unit;
        list.layers = own.layers;
        model::number_layers(list);
        *out = new nurbs_list{std::move(list)};
    });
}

nurbs_status nurbs_model_spline_layers(const nurbs_model *model, int64_t index, int64_t cap, int64_t *layers,
                                       int64_t *count) {
    return guard([&] {
        const model::Model &own = model_of(model);
        require_layers(cap, layers);
        put_layers(item_of(own.splines, index, "splines").layers, cap, layers, count);
    });
}

nurbs_status nurbs_model_layer_count(const nurbs_model *model, int64_t *count) {
    return guard([&] {
        const model::Model &own = model_of(model);
        require(count, "count");
        *count = std::ssize(own.layers);
    });
}

nurbs_status nurbs_model_layer(const nurbs_model *model, int64_t index, char *buf, int64_t cap,
                               int64_t *length) {
    return guard([&] {
        const std::string &name = item_of(model_of(model).layers, index, "layers");
        check_buffer(buf, cap);
        copy_text(name, buf, cap, length);
    });
}
