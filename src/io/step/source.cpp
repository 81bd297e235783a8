// SPDX-License-Identifier: MIT
#include "io/step/source.h"

#include "base/error.h"
#include "io/faces/make_face.h"
#include "io/iges/text.h"
#include "io/step/boundary.h"
#include "io/step/parts.h"
#include "io/unit_factor.h"
#include "model/shapes/curve_spline.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

// Throws Status::format for schemas that have entities of their own, such as IFC.
void check_schemas(const std::vector<std::string> &schemas) {
    for (const std::string &schema : schemas) {
        if (schema.starts_with("IFC") || schema.starts_with("ifc")) {
            fail(Status::format, "FILE_SCHEMA names %s, which is not read; AP203, AP214 and AP242 are",
                 iges::excerpt(schema).c_str());
        }
    }
}

model::MadeSurface free_surface(Geometry &geometry, const Instance &instance) {
    const model::SurfaceShapePtr surface = geometry.surface(instance);
    const bool outlined = instance.kind() == Kind::curve_bounded_surface && !model::bounded(*surface);
    return surface_around(geometry.entities(), *surface,
                          outlined ? outline_points(geometry, instance) : std::vector<Vector3>(),
                          geometry.units().tolerance);
}

bool is_context(const Instances &instances, const Instance &instance) {
    return instances.keyword(instance).ends_with("_CONTEXT");
}

} // namespace

Source::Source(const Exchange &file, const ReadSettings &settings)
    : instances_(file.instances), entities_(file.instances), settings_(settings), contexts_(entities_),
      part_(find_parts(file.instances)), tolerance_(settings.tolerance) {
    check_schemas(file.schemas);
    entities_.share_among(std::ranges::count(instances_.all(), Kind::offset_surface, &Instance::kind));
    const double stated = contexts_.all().front().metres;
    model_.metres_per_unit = settings.unit > 0 ? settings.unit : stated;
    (void)unit_factor(stated, settings); // throws if it cannot be reached
    for (const ContextDamage &damage : contexts_.damages()) {
        add_note(damage.number, damage.reason, damage.text.c_str());
    }
    for (const int64_t number : instances_.repeated()) {
        add_note(number, Status::syntax,
                 ("#" + std::to_string(number) + ": stands for several instances, of which the first counts")
                     .c_str());
    }
}

Units Source::units_of(int64_t place) const {
    const Measures &measures = contexts_.of(place);
    const double factor =
        measures.metres > 0 && model_.metres_per_unit > 0 ? measures.metres / model_.metres_per_unit : 1;
    return {factor, measures.radians, tolerance_ > 0 ? tolerance_ : factor * measures.uncertainty};
}

std::vector<model::NamedSpline> Source::free_splines(const Layers &layers) {
    std::vector<model::NamedSpline> splines;
    const auto wanted = [this](int64_t place) {
        const Kind kind = instances_[place].kind();
        const bool wanted_kind = (is_curve(kind) && settings_.wants(kind_curves)) ||
                                 (is_surface(kind) && settings_.wants(kind_surfaces));
        return wanted_kind && kind != Kind::pcurve && !part_[static_cast<size_t>(place)];
    };
    read_all(wanted, [&](int64_t place) {
        const Instance &instance = instances_[place];
        const Units units = units_of(place);
        Geometry geometry(entities_, units);
        SplinePtr spline =
            is_curve(instance.kind())
                ? made(instance, [&] { return model::curve_spline(*geometry.curve(instance)); })
                : made_surface(instance, [&] { return free_surface(geometry, instance); });
        splines.push_back({name_of(instances_, instance), std::move(spline), layers.at(instance.number())});
    });
    return splines;
}

void Source::note_approximation(const Instance &instance, double distance, double stated) {
    if (distance > 0) {
        const std::string text = label_of(instances_, instance) + ": " + note_on_surface(distance, stated);
        add_note(instance.number(), Status::tolerance, text.c_str());
    }
}

void Source::note_items(bool placements_read) {
    for (const Instance &instance : instances_.all()) {
        if (instance.kind() == Kind::placed_part || instance.kind() == Kind::mapped_item) {
            if (!placements_read) {
                note_unread(instance, "places a part, whose splines stay where it has them");
            }
        } else if (instance.kind() == Kind::shape_representation || instance.kind() == Kind::geometric_set) {
            for_each_reference(instances_.text(), instance,
                               [&](int64_t number) { note_item(instance, number); });
        }
    }
}

void Source::note_item(const Instance &owner, int64_t number) {
    const int64_t place = instances_.find(number);
    if (place < 0) {
        return note_unread(owner, ("#" + std::to_string(number) + " is not in the file").c_str());
    }
    const Instance &item = instances_[place];
    if (item.kind() == Kind::other && !part_[static_cast<size_t>(place)]) {
        part_[static_cast<size_t>(place)] = true; // so that it is noted only once
        if (is_context(instances_, item)) {
            return;
        }
        note_unread(item, "does not become a spline in this version");
    }
}

void Source::note_unread(const Instance &instance, const char *what) {
    add_note(instance.number(), Status::unsupported, (label_of(instances_, instance) + ": " + what).c_str());
}

void Source::note_error(const Instance &instance, const Error &error) {
    const std::string start = "#" + std::to_string(instance.number()) + " ";
    const std::string text = error.what();
    const std::string whole = text.starts_with(start) ? text : label_of(instances_, instance) + ": " + text;
    add_note(instance.number(), error.status(), whole.c_str());
}

void Source::add_note(int64_t number, Status reason, const char *text) {
    model_.notes.push_back({0, number, reason, text});
}

model::Model Source::finished() {
    for (const auto &remark : entities_.remarks()) {
        const Instance &instance = instances_[instances_.find(remark.first)];
        add_note(remark.first, Status::tolerance,
                 (label_of(instances_, instance) + ": " + remark.second).c_str());
    }
    std::ranges::stable_sort(model_.notes, {}, &model::Note::line);
    return std::move(model_);
}

} // namespace nrb::io::step
