// SPDX-License-Identifier: MIT
#include "io/step/boundary.h"

#include "base/error.h"
#include "io/faces/make_face.h"
#include "io/iges/text.h"
#include "io/step/geometry/placements.h"
#include "model/shapes/curve_spline.h"

#include <algorithm>

namespace nrb::io::step {

std::string name_of(const Instances &instances, const Instance &instance) {
    Attributes attributes(instances, instance);
    attributes.part("REPRESENTATION_ITEM");
    const std::string name(iges::trim(attributes.string("name")));
    return name.empty() ? "#" + std::to_string(instance.number()) : name;
}

Point read_vertex(Geometry &geometry, int64_t number, const Attributes &owner, const char *attribute) {
    Entities &entities = geometry.entities();
    Attributes attributes(entities.instances(),
                          entities.at(number, Kind::vertex_point, owner, attribute, "a VERTEX_POINT"));
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("VERTEX_POINT");
    return read_point(entities, attributes.reference("vertex_geometry"), attributes, "vertex_geometry",
                      geometry.units().length);
}

namespace {

Vector3 vector_of(const Point &point) noexcept {
    return {point.x[0], point.x[1], point.x[2]};
}

class Boundary {
public:
    Boundary(Geometry &geometry, const EdgeSplines &edges) noexcept
        : geometry_(geometry), entities_(geometry.entities()), edges_(edges) {}

    std::vector<Vector3> run(const Instance &face) {
        Attributes attributes = named(face);
        attributes.part("FACE");
        attributes.open("bounds");
        while (attributes.more("bounds")) {
            const Instance &bound = entities_.at(attributes.reference("bounds"), Kind::face_bound, attributes,
                                                 "bounds", "a FACE_BOUND");
            add_bound(bound);
        }
        return std::move(points_);
    }

private:
    Attributes named(const Instance &instance) {
        Attributes attributes(entities_.instances(), instance);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        return attributes;
    }

    void add_bound(const Instance &bound) {
        Attributes attributes = named(bound);
        attributes.part("FACE_BOUND");
        const Instance &loop = entities_.at(attributes.reference("bound"), attributes, "bound");
        switch (loop.kind()) {
        case Kind::edge_loop:
            return add_edges(loop);
        case Kind::poly_loop:
            return add_polygon(loop);
        case Kind::vertex_loop: {
            Attributes vertex = named(loop);
            vertex.part("VERTEX_LOOP");
            points_.push_back(
                vector_of(read_vertex(geometry_, vertex.reference("loop_vertex"), vertex, "loop_vertex")));
            return;
        }
        default:
            entities_.fail_kind(loop, attributes, "bound", "a loop");
        }
    }

    void add_polygon(const Instance &loop) {
        Attributes attributes = named(loop);
        attributes.part("POLY_LOOP");
        attributes.open("polygon");
        while (attributes.more("polygon")) {
            entities_.spend(3);
            points_.push_back(vector_of(read_point(entities_, attributes.reference("polygon"), attributes,
                                                   "polygon", geometry_.units().length)));
        }
    }

    void add_edges(const Instance &loop) {
        Attributes attributes = named(loop);
        attributes.part(attributes.has_part("PATH") ? "PATH" : "EDGE_LOOP");
        attributes.open("edge_list");
        while (attributes.more("edge_list")) {
            const Instance &oriented = entities_.at(attributes.reference("edge_list"), Kind::oriented_edge,
                                                    attributes, "edge_list", "an ORIENTED_EDGE");
            Attributes edge = named(oriented);
            edge.part("EDGE");
            edge.skip("edge_start");
            edge.skip("edge_end");
            edge.part("ORIENTED_EDGE");
            const int64_t number = edge.reference("edge_element");
            const Spline *spline = edges_.find(number);
            if (spline == nullptr) {
                edge.fail_attribute(Status::unsupported, "edge_element",
                                    "#" + std::to_string(number) + " is no edge that could be read");
            }
            entities_.spend(3 * spline->point_count());
            append_points(*spline, points_);
        }
    }

    Geometry &geometry_;
    Entities &entities_;
    const EdgeSplines &edges_;
    std::vector<Vector3> points_;
};

} // namespace

model::CurvePiece read_edge(Geometry &geometry, const Instance &edge) {
    return naming(geometry.entities().instances(), edge, [&] {
        Attributes attributes(geometry.entities().instances(), edge);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("EDGE");
        const int64_t start = attributes.reference("edge_start"), end = attributes.reference("edge_end");
        const Point first = read_vertex(geometry, start, attributes, "edge_start");
        const Point last = read_vertex(geometry, end, attributes, "edge_end");
        attributes.part("EDGE_CURVE");
        const model::CurveShapePtr curve =
            geometry.curve(attributes.reference("edge_geometry"), attributes, "edge_geometry");
        if (first.dim != 3 || last.dim != 3 || curve->place.dim != 3) {
            attributes.fail_attribute(Status::dimension, "edge_geometry",
                                      "an edge of the plane, expected one of space");
        }
        const bool forward = attributes.boolean("same_sense");
        const double tolerance = geometry.units().tolerance;
        return model::piece_between(curve, {first.x.data(), last.x.data(), forward, tolerance});
    });
}

const Spline *EdgeSplines::find(int64_t number) const noexcept {
    const auto found = std::ranges::lower_bound(edges_, number, {}, &Edge::number);
    return found != edges_.end() && found->number == number ? found->spline.get() : nullptr;
}

std::vector<Vector3> boundary_points(Geometry &geometry, const EdgeSplines &edges, const Instance &face) {
    return Boundary(geometry, edges).run(face);
}

std::vector<Vector3> outline_points(Geometry &geometry, const Instance &surface) {
    Attributes attributes(geometry.entities().instances(), surface);
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("CURVE_BOUNDED_SURFACE");
    attributes.skip("basis_surface");
    std::vector<Vector3> points;
    attributes.open("boundaries");
    while (attributes.more("boundaries")) {
        const model::CurveShapePtr curve =
            geometry.curve(attributes.reference("boundaries"), attributes, "boundaries");
        append_points(*model::curve_spline(*curve), points);
    }
    return points;
}

} // namespace nrb::io::step
