// SPDX-License-Identifier: MIT
#include "io/step/read_step.h"

#include "io/faces/make_face.h"
#include "io/step/boundary.h"
#include "io/step/source.h"
#include "model/shapes/curve_spline.h"
#include "model/shapes/surface_spline.h"

#include <map>

namespace nrb::io {
namespace {

using step::Attributes;
using step::Geometry;
using step::Instance;
using step::Kind;
using step::Units;

class ListReader : public step::Source {
public:
    using Source::Source;

    model::Model run() {
        Steps steps(3);
        Splines edges, faces;
        // Edges come first, because unbounded surfaces are cut to the edges of their faces.
        read_all([this](int64_t place) { return is(place, Kind::edge_curve); },
                 [&](int64_t place) { add_edge(place, edges); });
        steps.next();
        read_all([this](int64_t place) { return is(place, Kind::face) && settings_.wants(kind_surfaces); },
                 [&](int64_t place) { add_face(place, faces); });
        steps.next();
        Splines others = free_splines({});
        steps.next();
        if (!settings_.wants(kind_curves)) {
            edges.clear();
        }
        model_.splines = std::move(faces);
        for (Splines *more : {&edges, &others}) {
            std::move(more->begin(), more->end(), std::back_inserter(model_.splines));
        }
        note_items(false);
        return finished();
    }

private:
    using Splines = std::vector<model::NamedSpline>;

    void add_edge(int64_t place, Splines &splines) {
        const Instance &edge = instances_[place];
        edges_.add(edge.number(), nullptr);
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        SplinePtr spline = made(edge, [&] { return model::piece_spline(step::read_edge(geometry, edge)); });
        edges_.set_last(spline);
        splines.push_back({step::name_of(instances_, edge), std::move(spline)});
    }

    void add_face(int64_t place, Splines &splines) {
        const Instance &face = instances_[place];
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        SplinePtr spline = made_surface(face, [&] {
            Attributes attributes(instances_, face);
            attributes.part("REPRESENTATION_ITEM");
            attributes.skip("name");
            attributes.part("FACE");
            attributes.skip("bounds");
            attributes.part("FACE_SURFACE");
            const int64_t number = attributes.reference("face_geometry");
            // Faces may share a surface. A bounded surface has the same spline for all of them that are in
            // contexts with the same measures.
            const SurfaceKey key{number, units.length, units.angle, units.tolerance};
            if (const auto known = surfaces_.find(key); known != surfaces_.end()) {
                return known->second;
            }
            const model::SurfaceShapePtr surface = geometry.surface(number, attributes, "face_geometry");
            if (!model::bounded(*surface)) {
                return surface_around(entities_, *surface, step::boundary_points(geometry, edges_, face),
                                      units.tolerance);
            }
            return surfaces_[key] = surface_around(entities_, *surface, {}, units.tolerance);
        });
        splines.push_back({step::name_of(instances_, face), std::move(spline)});
    }

    struct SurfaceKey {
        int64_t number;
        double length;
        double angle;
        double tolerance; // within which it is approximated
        auto operator<=>(const SurfaceKey &) const = default;
    };

    step::EdgeSplines edges_;
    std::map<SurfaceKey, model::MadeSurface> surfaces_;
};

} // namespace

model::Model read_step(std::span<const char> bytes, const ReadSettings &settings) {
    const step::Exchange file = step::read_exchange(bytes);
    return ListReader(file, settings).run();
}

} // namespace nrb::io
