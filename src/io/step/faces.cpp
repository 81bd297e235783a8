// SPDX-License-Identifier: MIT
#include "io/step/faces.h"

#include "base/error.h"
#include "build/polylines.h"
#include "io/faces/make_face.h"
#include "io/step/boundary.h"
#include "model/shapes/curve_spline.h"
#include "model/shapes/nearest_place.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <map>

namespace nrb::io::step {
namespace {

Attributes item(const Instances &instances, const Instance &instance) {
    Attributes attributes(instances, instance);
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    return attributes;
}

// The numbers of the parameter curves (pcurves) that belong to the curve of an edge.
std::vector<int64_t> parameter_curves(const Instances &instances, int64_t number) {
    std::vector<int64_t> result;
    const int64_t place = instances.find(number);
    if (place < 0 || instances[place].kind() != Kind::surface_curve) {
        return result;
    }
    Attributes attributes = item(instances, instances[place]);
    attributes.part("SURFACE_CURVE");
    attributes.skip("curve_3d");
    attributes.open("associated_geometry");
    while (attributes.more("associated_geometry")) {
        result.push_back(attributes.reference("associated_geometry"));
    }
    return result;
}

class FaceReader {
public:
    FaceReader(Geometry &geometry, const EdgeSources &sources, const std::vector<model::Edge> &edges,
               double tolerance)
        : geometry_(geometry), entities_(geometry.entities()), sources_(sources), edges_(edges),
          tolerance_(tolerance) {}

    FaceSource read(const Instance &face) {
        Attributes attributes = item(entities_.instances(), face);
        attributes.part("FACE");
        std::vector<int64_t> bounds;
        attributes.open("bounds");
        while (attributes.more("bounds")) {
            bounds.push_back(attributes.reference("bounds"));
        }
        attributes.part("FACE_SURFACE");
        surface_number_ = attributes.reference("face_geometry");
        FaceSource source{geometry_.surface(surface_number_, attributes, "face_geometry"), {}, false, 0};
        source.against = !attributes.boolean("same_sense");
        for (const int64_t number : bounds) {
            add_bound(entities_.at(number, Kind::face_bound, attributes, "bounds", "a FACE_BOUND"),
                      source.against);
        }
        model::MadeSurface made = spline_of(*source.shape);
        source.parts.surface = std::move(made.spline);
        source.parts.nearest = model::nearest_place(*source.shape, source.parts.surface);
        source.distance = made.distance;
        if (source.shape->kind == model::SurfaceKind::spline) {
            add_parameter_curves(*source.parts.surface);
        }
        for (Bound &bound : bounds_) {
            source.parts.loops.push_back(std::move(bound.loop));
        }
        return source;
    }

private:
    struct Bound {
        face::Loop loop;
        std::vector<const EdgeSource *> sources; // null for edges of polygons
    };

    void add_bound(const Instance &bound, bool against) {
        Attributes attributes = item(entities_.instances(), bound);
        attributes.part("FACE_BOUND");
        const Instance &loop = entities_.at(attributes.reference("bound"), attributes, "bound");
        const bool turned = attributes.boolean("orientation") == against;
        Bound made;
        if (loop.kind() == Kind::edge_loop) {
            add_edges(loop, made);
        } else if (loop.kind() == Kind::poly_loop) {
            add_polygon(loop, made);
        } else if (loop.kind() == Kind::vertex_loop) {
            Attributes vertex = item(entities_.instances(), loop);
            vertex.part("VERTEX_LOOP");
            const Point at = read_vertex(geometry_, vertex.reference("loop_vertex"), vertex, "loop_vertex");
            poles_.push_back({at.x[0], at.x[1], at.x[2]});
            return; // a pole, which has no curve
        } else {
            entities_.fail_kind(loop, attributes, "bound", "a loop");
        }
        if (turned) {
            std::reverse(made.loop.begin(), made.loop.end());
            std::reverse(made.sources.begin(), made.sources.end());
            std::for_each(made.loop.begin(), made.loop.end(),
                          [](face::Coedge &coedge) { coedge.against = !coedge.against; });
        }
        bounds_.push_back(std::move(made));
    }
    void add_edges(const Instance &loop, Bound &made) {
        Attributes attributes = item(entities_.instances(), loop);
        attributes.part(attributes.has_part("PATH") ? "PATH" : "EDGE_LOOP");
        attributes.open("edge_list");
        while (attributes.more("edge_list")) {
            const Instance &oriented = entities_.at(attributes.reference("edge_list"), Kind::oriented_edge,
                                                    attributes, "edge_list", "an ORIENTED_EDGE");
            Attributes edge = item(entities_.instances(), oriented);
            edge.part("EDGE");
            edge.skip("edge_start");
            edge.skip("edge_end");
            edge.part("ORIENTED_EDGE");
            const int64_t number = edge.reference("edge_element");
            const EdgeSource *source = sources_.find(number);
            if (source == nullptr) {
                edge.fail_attribute(Status::unsupported, "edge_element",
                                    "#" + std::to_string(number) + " is no edge that could be read");
            }
            const SplinePtr &curve = edges_[static_cast<size_t>(source->index)].curve;
            made.loop.push_back({nullptr, curve, source->index + 1, !edge.boolean("orientation")});
            made.sources.push_back(source);
            entities_.spend(3 * curve->point_count());
        }
    }
    void add_polygon(const Instance &loop, Bound &made) {
        Attributes attributes = item(entities_.instances(), loop);
        attributes.part("POLY_LOOP");
        std::vector<Point> corners;
        attributes.open("polygon");
        while (attributes.more("polygon")) {
            entities_.spend(Entities::size_of_a_shape);
            corners.push_back(read_point(entities_, attributes.reference("polygon"), attributes, "polygon",
                                         geometry_.units().length));
        }
        for (size_t i = 0; i < corners.size(); ++i) {
            const auto &a = corners[i].x, &b = corners[(i + 1) % corners.size()].x;
            made.loop.push_back({nullptr, build::polyline(3, {a[0], a[1], a[2], b[0], b[1], b[2]}, {0, 1})});
            made.sources.push_back(nullptr);
        }
    }

    // The spline of the surface; if the surface is unbounded, of as much of it as the edges need.
    model::MadeSurface spline_of(const model::SurfaceShape &shape) const {
        std::vector<Vector3> points = poles_;
        for (const Bound &bound : bounds_) {
            for (const face::Coedge &coedge : bound.loop) {
                append_points(*coedge.edge, points);
            }
        }
        return surface_around(entities_, shape, points, geometry_.units().tolerance);
    }

    // A seam edge has two parameter curves, one for each use.
    void add_parameter_curves(const Spline &surface) {
        std::map<int64_t, int> uses;
        for (Bound &bound : bounds_) {
            for (size_t i = 0; i < bound.loop.size(); ++i) {
                if (bound.sources[i] != nullptr) {
                    add_parameter_curve(surface, *bound.sources[i], uses[bound.sources[i]->number]++,
                                        bound.loop[i]);
                }
            }
        }
    }
    // Takes one of the parameter curves that can be read and lie under their edge: the one that `others` such
    // curves precede, or else the last one.
    void add_parameter_curve(const Spline &surface, const EdgeSource &source, int others,
                             face::Coedge &coedge) {
        const Instances &instances = entities_.instances();
        for (const int64_t number : parameter_curves(instances, source.geometry)) {
            const int64_t place = instances.find(number);
            if (place < 0 || instances[place].kind() != Kind::pcurve) {
                continue;
            }
            try {
                const ParameterCurve found = geometry_.parameter_curve(instances[place]);
                if (found.surface != surface_number_) {
                    continue;
                }
                const SplinePtr curve =
                    model::piece_spline({found.curve, source.piece.range, source.piece.forward});
                if (lies_under(surface, *curve, *coedge.edge, tolerance_)) {
                    coedge.curve = coedge.against ? refine::reverse(*curve, 0, false) : curve;
                    if (others-- == 0) {
                        return;
                    }
                }
            } catch (const Error &) {
                continue;
            }
        }
    }
    Geometry &geometry_;
    Entities &entities_;
    const EdgeSources &sources_;
    const std::vector<model::Edge> &edges_;
    double tolerance_;
    int64_t surface_number_ = 0;
    std::vector<Bound> bounds_;
    std::vector<Vector3> poles_; // vertices that are bounds of the face (VERTEX_LOOP)
};

} // namespace

const EdgeSource *EdgeSources::find(int64_t number) const noexcept {
    const auto found =
        std::lower_bound(edges_.begin(), edges_.end(), number,
                         [](const EdgeSource &edge, int64_t wanted) { return edge.number < wanted; });
    return found != edges_.end() && found->number == number ? &*found : nullptr;
}

FaceSource read_face(Geometry &geometry, const EdgeSources &sources, const std::vector<model::Edge> &edges,
                     const Instance &face, double tolerance) {
    return naming(geometry.entities().instances(), face,
                  [&] { return FaceReader(geometry, sources, edges, tolerance).read(face); });
}

} // namespace nrb::io::step
