// SPDX-License-Identifier: MIT
#include "io/step/read_step.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/text.h"
#include "io/step/boundary.h"
#include "io/step/contexts.h"
#include "io/step/parts.h"
#include "io/step/structure/exchange.h"
#include "model/shapes/curve_spline.h"
#include "model/shapes/surface_spline.h"

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

constexpr int64_t work_of_an_entity = 1000; // beyond what its numbers count
// How far surfaces without ends go on behind the boundary of their face, as a part of its size.
constexpr double margin = 1.0 / 64;

// Schemas whose entities have names of their own.
void check_schemas(const std::vector<std::string> &schemas) {
    for (const std::string &schema : schemas) {
        if (schema.starts_with("IFC") || schema.starts_with("ifc")) {
            fail(Status::format, "FILE_SCHEMA names %s, which is not read; AP203, AP214 and AP242 are",
                 iges::excerpt(schema).c_str());
        }
    }
}

double unit_factor(double metres, double wanted) {
    if (wanted == 0) {
        return 1;
    }
    if (metres == 0) {
        fail(Status::options, "unit = %s cannot be reached: the unit of the file is not known",
             Number(wanted).text);
    }
    const double factor = metres / wanted;
    if (!std::isnormal(factor)) {
        fail(Status::options, "unit = %s cannot be reached from units of %s metres", Number(wanted).text,
             Number(metres).text);
    }
    return factor;
}

class Reader {
public:
    Reader(const Instances &instances, const ReadSettings &settings)
        : instances_(instances), entities_(instances), contexts_(entities_),
          part_(step::find_parts(instances)) {
        const double stated = contexts_.all().front().metres;
        model_.metres_per_unit = settings.unit > 0 ? settings.unit : stated;
        unit_factor(stated, settings.unit);
        for (const step::ContextDamage &damage : contexts_.damages()) {
            add_note(damage.number, damage.reason, damage.text.c_str());
        }
        for (const int64_t number : instances_.repeated()) {
            add_note(
                number, Status::syntax,
                ("#" + std::to_string(number) + ": stands for several instances, of which the first counts")
                    .c_str());
        }
    }

    model::Model run() {
        Steps steps(3);
        std::vector<model::NamedSpline> edges = read_all(&Reader::wants_edge, &Reader::add_edge);
        steps.next();
        std::vector<model::NamedSpline> faces = read_all(&Reader::wants_face, &Reader::add_face);
        steps.next();
        std::vector<model::NamedSpline> others = read_all(&Reader::wants_free, &Reader::add_free);
        steps.next();
        model_.splines = std::move(faces);
        for (std::vector<model::NamedSpline> *more : {&edges, &others}) {
            std::move(more->begin(), more->end(), std::back_inserter(model_.splines));
        }
        note_items();
        std::ranges::stable_sort(model_.notes, {}, &model::Note::line);
        return std::move(model_);
    }

private:
    using Splines = std::vector<model::NamedSpline>;

    [[nodiscard]] bool wants_edge(int64_t place) const noexcept {
        return instances_[place].kind() == Kind::edge_curve;
    }
    [[nodiscard]] bool wants_face(int64_t place) const noexcept {
        return instances_[place].kind() == Kind::face;
    }
    [[nodiscard]] bool wants_free(int64_t place) const noexcept {
        const Kind kind = instances_[place].kind();
        return (step::is_curve(kind) || step::is_surface(kind)) && kind != Kind::pcurve &&
               !part_[static_cast<size_t>(place)];
    }

    Splines read_all(bool (Reader::*wants)(int64_t) const noexcept, void (Reader::*add)(int64_t, Splines &)) {
        Splines splines;
        Steps steps(instances_.size());
        for (int64_t place = 0; place < instances_.size(); ++place) {
            const bool wanted = (this->*wants)(place);
            if (wanted) {
                try {
                    (this->*add)(place, splines);
                } catch (const Error &error) {
                    note_error(instances_[place], error);
                }
            }
            steps.next(wanted ? work_of_an_entity : 1);
        }
        return splines;
    }

    // The measures of what stands at a place, as factors to the unit of the model.
    [[nodiscard]] Units units_of(int64_t place) const {
        const step::Measures &measures = contexts_.of(place);
        const double factor =
            measures.metres > 0 && model_.metres_per_unit > 0 ? measures.metres / model_.metres_per_unit : 1;
        return {factor, measures.radians, factor * measures.uncertainty};
    }

    void add_edge(int64_t place, Splines &splines) {
        const Instance &edge = instances_[place];
        edges_.add(edge.number(), nullptr);
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        SplinePtr spline = made(edge, [&] { return model::piece_spline(step::read_edge(geometry, edge)); });
        edges_.set_last(spline);
        splines.push_back({name_of(edge), std::move(spline)});
    }

    void add_face(int64_t place, Splines &splines) {
        const Instance &face = instances_[place];
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        SplinePtr spline = made(face, [&] {
            Attributes attributes(instances_, face);
            attributes.part("REPRESENTATION_ITEM");
            attributes.skip("name");
            attributes.part("FACE");
            attributes.skip("bounds");
            attributes.part("FACE_SURFACE");
            const int64_t number = attributes.reference("face_geometry");
            // Faces may share a surface, and a surface with ends is the same for all of them.
            if (const auto known = surfaces_.find({number, units.length, units.angle});
                known != surfaces_.end()) {
                return known->second;
            }
            const model::SurfaceShapePtr surface = geometry.surface(number, attributes, "face_geometry");
            if (!model::bounded(*surface)) {
                return cut_surface(*surface, step::boundary_points(geometry, edges_, face));
            }
            return surfaces_[{number, units.length, units.angle}] =
                       model::surface_spline(*surface, model::natural_range(*surface));
        });
        splines.push_back({name_of(face), std::move(spline)});
    }

    static SplinePtr cut_surface(const model::SurfaceShape &surface, const std::vector<Vector3> &points) {
        return model::surface_spline(surface, model::range_around(surface, points, margin));
    }

    void add_free(int64_t place, Splines &splines) {
        const Instance &instance = instances_[place];
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        SplinePtr spline = made(instance, [&] {
            return step::is_curve(instance.kind()) ? model::curve_spline(*geometry.curve(instance))
                                                   : free_surface(geometry, instance);
        });
        splines.push_back({name_of(instance), std::move(spline)});
    }

    static SplinePtr free_surface(Geometry &geometry, const Instance &instance) {
        const model::SurfaceShapePtr surface = geometry.surface(instance);
        const bool outlined = instance.kind() == Kind::curve_bounded_surface && !model::bounded(*surface);
        return cut_surface(*surface,
                           outlined ? step::outline_points(geometry, instance) : std::vector<Vector3>());
    }

    // What make() returns. Splines count before they are kept, whoever shares their points.
    template <class Make>
    SplinePtr made(const Instance &instance, Make &&make) {
        return step::naming(instances_, instance, [&] {
            entities_.spend(step::Entities::size_of_a_shape);
            SplinePtr spline = make();
            entities_.spend(spline->point_count() * spline->width());
            return spline;
        });
    }

    // The name of a representation item; "#12" if it has none.
    [[nodiscard]] std::string name_of(const Instance &instance) const {
        Attributes attributes(instances_, instance);
        attributes.part("REPRESENTATION_ITEM");
        const std::string name(iges::trim(attributes.string("name")));
        return name.empty() ? "#" + std::to_string(instance.number()) : name;
    }

    // What shapes consist of and is not read, and where parts are placed, which these splines are not.
    void note_items() {
        for (const Instance &instance : instances_.all()) {
            if (instance.kind() == Kind::placed_part) {
                note_unread(instance, "places a part, whose splines stay where it has them");
            } else if (instance.kind() == Kind::shape_representation ||
                       instance.kind() == Kind::geometric_set) {
                step::for_each_reference(instances_.text(), instance,
                                         [&](int64_t number) { note_item(instance, number); });
            }
        }
    }

    void note_item(const Instance &owner, int64_t number) {
        const int64_t place = instances_.find(number);
        if (place < 0) {
            return note_unread(owner, ("#" + std::to_string(number) + " is not in the file").c_str());
        }
        const Instance &item = instances_[place];
        const bool context = is_context(item);
        if (item.kind() == Kind::other && !context && !part_[static_cast<size_t>(place)]) {
            part_[static_cast<size_t>(place)] = true; // one note is enough
            note_unread(item, "does not become a spline in this version");
        }
    }

    [[nodiscard]] bool is_context(const Instance &instance) const {
        return instances_.keyword(instance).ends_with("_CONTEXT");
    }

    void note_unread(const Instance &instance, const char *what) {
        add_note(instance.number(), Status::unsupported,
                 (step::label_of(instances_, instance) + ": " + what).c_str());
    }

    // With the label of the instance, unless the message begins with it.
    void note_error(const Instance &instance, const Error &error) {
        const std::string start = "#" + std::to_string(instance.number()) + " ";
        const std::string text = error.what();
        if (text.starts_with(start)) {
            return add_note(instance.number(), error.status(), text.c_str());
        }
        add_note(instance.number(), error.status(),
                 (step::label_of(instances_, instance) + ": " + text).c_str());
    }

    void add_note(int64_t number, Status reason, const char *text) {
        model_.notes.push_back({0, number, reason, text});
    }

    struct SurfaceKey {
        int64_t number;
        double length;
        double angle;
        auto operator<=>(const SurfaceKey &) const = default;
    };

    const Instances &instances_;
    step::Entities entities_;
    step::Contexts contexts_;
    std::vector<bool> part_;
    step::EdgeSplines edges_;
    std::map<SurfaceKey, SplinePtr> surfaces_;
    model::Model model_;
};

} // namespace

model::Model read_step(std::span<const char> bytes, const ReadSettings &settings) {
    const step::Exchange file = step::read_exchange(bytes);
    check_schemas(file.schemas);
    return Reader(file.instances, settings).run();
}

} // namespace nrb::io
