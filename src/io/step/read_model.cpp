// SPDX-License-Identifier: MIT
#include "io/step/read_model.h"

#include "base/error.h"
#include "io/faces/make_face.h"
#include "io/step/assembly.h"
#include "io/step/boundary.h"
#include "io/step/colours.h"
#include "io/step/faces.h"
#include "io/step/solids.h"
#include "io/step/source.h"
#include "model/from_faces.h"
#include "model/numbering.h"
#include "model/shapes/curve_spline.h"

#include <map>

namespace nrb::io {
namespace {

using step::Attributes;
using step::Geometry;
using step::Instance;
using step::Kind;
using step::Units;

class ModelReader : public step::Source {
public:
    using Source::Source;

    model::Model run() {
        Steps steps(3);
        read_parts();
        const bool faces = settings_.wants(kind_faces);
        read_all([&](int64_t place) { return faces && is(place, Kind::edge_curve); },
                 [this](int64_t place) { add_edge(place); });
        steps.next();
        const auto tell = [this](const Instance &instance, const Error &error) {
            note_error(instance, error);
        };
        colours_ = step::read_colours(entities_, tell);
        solids_ = step::read_solids(entities_, tell);
        layers_ = step::read_layers(entities_, tell);
        model_.layers = layers_.names;
        read_all([&](int64_t place) { return faces && is(place, Kind::face); },
                 [this](int64_t place) { add_face(place); });
        steps.next();
        model_.splines = free_splines(layers_);
        steps.next();
        model::index_uses(model_);
        model::number_solids(model_);
        model::number_layers(model_);
        note_items(true);
        return finished();
    }

private:
    void read_parts() {
        step::Assembly assembly =
            step::read_assembly(entities_, [this](int64_t place) { return units_of(place).length; });
        model_.parts = std::move(assembly.parts);
        model_.uses = std::move(assembly.uses);
        part_of_ = std::move(assembly.part_of);
        for (const step::PlacementDamage &damage : assembly.damages) {
            add_note(damage.number, damage.reason, damage.text.c_str());
        }
    }

    void add_edge(int64_t place) {
        const Instance &instance = instances_[place];
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        model::CurvePiece piece = step::read_edge(geometry, instance);
        model::Edge edge;
        edge.curve = made(instance, [&] { return model::piece_spline(piece); });
        edge.shape = piece.curve;
        edge.part = part_of_[static_cast<size_t>(place)];
        Attributes attributes(instances_, instance);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("EDGE");
        for (const char *end : {"edge_start", "edge_end"}) {
            edge.vertices[end[5] == 's' ? 0 : 1] = vertex(attributes.reference(end), geometry, attributes);
        }
        attributes.part("EDGE_CURVE");
        const int64_t curve = attributes.reference("edge_geometry");
        sources_.add({instance.number(), curve, std::move(piece), std::ssize(model_.edges)});
        model_.edges.push_back(std::move(edge));
    }
    int64_t vertex(int64_t number, Geometry &geometry, const Attributes &owner) {
        const auto [known, fresh] = vertices_.try_emplace(number, std::ssize(model_.vertices));
        if (fresh) {
            const step::Point point = step::read_vertex(geometry, number, owner, "edge_start");
            model_.vertices.push_back({point.x[0], point.x[1], point.x[2]});
        }
        return known->second;
    }

    // Adds a face with the tolerance of its context, or with the least larger one that its edges need.
    void add_face(int64_t place) {
        const Instance &instance = instances_[place];
        const Units units = units_of(place);
        const double stated = units.tolerance > 0 ? units.tolerance : usual_tolerance;
        entities_.spend(step::Entities::size_of_a_shape);
        double approximated = 0;
        const double tolerance = least_tolerance(stated, most_of_stated * stated, [&](double wide) {
            approximated = add_face(place, units, wide);
        });
        note_approximation(instance, approximated, units.tolerance);
        if (tolerance > stated) {
            const std::string text = step::label_of(instances_, instance) +
                                     ": its edges need the tolerance " + Number(tolerance).text;
            add_note(instance.number(), Status::tolerance, text.c_str());
        }
    }
    // Adds a face with a given tolerance. Returns the distance of its spline from the surface in the file.
    double add_face(int64_t place, const Units &units, double tolerance) {
        const Instance &instance = instances_[place];
        Geometry geometry(entities_, units);
        step::FaceSource source = step::read_face(geometry, sources_, model_.edges, instance, tolerance);
        entities_.spend(step::Entities::size_of_a_shape +
                        source.parts.surface->point_count() * source.parts.surface->width());
        model::ModelFace made;
        made.name = step::name_of(instances_, instance);
        made.shape = source.shape;
        made.against = source.against;
        made.part = part_of_[static_cast<size_t>(place)];
        if (const auto colour = colours_.find(instance.number()); colour != colours_.end()) {
            made.colour = colour->second;
        }
        if (const auto found = solids_.find(instance.number()); found != solids_.end()) {
            made.solid = found->second.solid;
            made.in_void = found->second.in_void;
            made.against = made.against != found->second.turned;
        }
        made.layers = layers_.at(instance.number());
        made.face = make_face(std::move(source.parts), tolerance);
        spend(entities_, *made.face);
        model_.faces.push_back(std::move(made));
        return source.distance;
    }
    std::vector<int64_t> part_of_;
    step::EdgeSources sources_;
    step::Colours colours_;
    step::PlacesInSolids solids_;
    step::Layers layers_;
    std::map<int64_t, int64_t> vertices_; // by the numbers of their instances
};

} // namespace

model::Model read_step_model(std::span<const char> bytes, const ReadSettings &settings) {
    const step::Exchange file = step::read_exchange(bytes);
    return ModelReader(file, settings).run();
}

} // namespace nrb::io
