// SPDX-License-Identifier: MIT
#include "io/step/read_model.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/step/boundary.h"
#include "io/step/contexts.h"
#include "io/step/structure/exchange.h"
#include "io/step/faces.h"
#include "io/step/placements.h"
#include "model/from_faces.h"
#include "model/shapes/curve_spline.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace nrb::io {
namespace {

using step::Attributes;
using step::Geometry;
using step::Instance;
using step::Instances;
using step::Kind;
using step::Units;

// Where a file states no uncertainty, and how much larger ones are tried.
constexpr double usual_tolerance = 1e-7; // of the size of a face
constexpr int most_tolerances = 5;

class ModelReader {
public:
    ModelReader(const Instances &instances, const ReadSettings &settings)
        : instances_(instances), entities_(instances), contexts_(entities_) {
        const double stated = contexts_.all().front().metres;
        model_.metres_per_unit = settings.unit > 0 ? settings.unit : stated;
    }

    model::Model run() {
        model_.parts.push_back({});
        model_.uses.push_back({});
        for_each(Kind::edge_curve,
                 [this](const Instance &edge, const Units &units) { add_edge(edge, units); });
        for_each(Kind::face, [this](const Instance &face, const Units &units) { add_face(face, units); });
        model::index_uses(model_);
        return std::move(model_);
    }

private:
    template <class Add>
    void for_each(Kind kind, Add &&add) {
        Steps steps(instances_.size());
        for (int64_t place = 0; place < instances_.size(); ++place) {
            const Instance &instance = instances_[place];
            if (instance.kind() == kind) {
                try {
                    add(instance, units_of(place));
                } catch (const Error &error) {
                    note(instance, error.status(), error.what());
                }
            }
            steps.next(1);
        }
    }
    [[nodiscard]] Units units_of(int64_t place) const {
        const step::Measures &measures = contexts_.of(place);
        const double factor =
            measures.metres > 0 && model_.metres_per_unit > 0 ? measures.metres / model_.metres_per_unit : 1;
        return {factor, measures.radians, factor * measures.uncertainty};
    }
    void note(const Instance &instance, Status reason, const char *text) {
        model_.notes.push_back({0, instance.number(), reason, text});
    }

    void add_edge(const Instance &instance, const Units &units) {
        Geometry geometry(entities_, units);
        model::CurvePiece piece = step::read_edge(geometry, instance);
        model::Edge edge;
        edge.curve = model::piece_spline(piece);
        edge.shape = piece.curve;
        entities_.spend(edge.curve->point_count() * edge.curve->width());
        Attributes attributes(instances_, instance);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("EDGE");
        for (size_t end = 0; end < 2; ++end) {
            edge.vertices[end] = vertex(attributes.reference("edge_start"), geometry, attributes);
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

    void add_face(const Instance &instance, const Units &units) {
        Geometry geometry(entities_, units);
        double tolerance = units.tolerance > 0 ? units.tolerance : usual_tolerance;
        for (int attempt = 0;; ++attempt, tolerance *= 10) {
            try {
                step::FaceSource source =
                    step::read_face(geometry, sources_, model_.edges, instance, tolerance);
                model::ModelFace made;
                made.name = step::name_of(instances_, instance);
                made.shape = source.shape;
                made.against = source.against;
                made.face = std::make_shared<const face::Face>(std::move(source.parts), nullptr);
                model_.faces.push_back(std::move(made));
                if (attempt > 0) {
                    note(instance, Status::tolerance,
                         ("the face needs the tolerance " + std::string(Number(tolerance).text)).c_str());
                }
                return;
            } catch (const Error &error) {
                if (error.status() != Status::gap || attempt + 1 == most_tolerances) {
                    throw;
                }
            }
        }
    }

    const Instances &instances_;
    step::Entities entities_;
    step::Contexts contexts_;
    step::EdgeSources sources_;
    std::map<int64_t, int64_t> vertices_;
    model::Model model_;
};

} // namespace

model::Model read_step_model(std::span<const char> bytes, const ReadSettings &settings) {
    const step::Exchange file = step::read_exchange(bytes);
    return ModelReader(file.instances, settings).run();
}

} // namespace nrb::io
