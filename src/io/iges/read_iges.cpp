// SPDX-License-Identifier: MIT
#include "io/iges/read_iges.h"

#include "io/faces/make_face.h"
#include "io/iges/geometry/shapes.h"
#include "io/iges/roles.h"
#include "io/iges/source.h"
#include "io/iges/types.h"

#include <algorithm>

namespace nrb::io {
namespace {

using iges::Entry;

class ListReader : public iges::Source {
public:
    ListReader(std::span<const char> bytes, const iges::Sections &sections, const iges::Global &global,
               const ReadSettings &settings)
        : Source(bytes, sections, global, settings),
          parameter_plane_(iges::find_parameter_plane_curves(directory_, data_)),
          splines_(directory_.entries().size()), is_part_(directory_.entries().size(), false) {}

    // Entities with parts are read first: what other splines consist of is known only after that.
    model::Model run() {
        Steps steps(2);
        read_entities(true);
        steps.next();
        read_entities(false);
        steps.next();
        collect_splines();
        drop_notes_on_parts();
        return finished();
    }

private:
    void read_entities(bool with_parts) {
        const auto wanted = [&](const Entry &entry) {
            return has_parts(entry.type) == with_parts &&
                   (!is_part_[index_of(entry)] || always_listed(entry.type));
        };
        read_all(wanted, [this](const Entry &entry) {
            splines_[index_of(entry)] = spline_of(entry, parameter_plane_[index_of(entry)]);
            mark_parts(entry.line);
        });
    }

    // If an entity is marked already, so are its parts.
    void mark_parts(int64_t owner) {
        for (const int64_t pointer : geometry_.parts(owner)) {
            const size_t index = *directory_.find(pointer);
            if (!is_part_[index]) {
                is_part_[index] = true;
                mark_parts(pointer);
            }
        }
    }

    // Types whose spline replaces those of their parts.
    static bool has_parts(int type) noexcept {
        return type == iges::composite_type || (iges::is_surface(type) && type != iges::offset_surface_type);
    }
    static bool always_listed(int type) noexcept {
        return type == iges::spline_curve_type || type == iges::spline_surface_type;
    }

    SplinePtr spline_of(const Entry &entry, bool parameter_plane) {
        entities_.spend(iges::Entities::size_of_a_shape);
        if (iges::is_curve(entry.type)) {
            const model::CurvePiece piece =
                parameter_plane ? geometry_.parameter_curve(entry.line) : geometry_.curve(entry.line);
            entities_.spend(piece.curve->kind == model::CurveKind::spline ? 0 : iges::size_of(piece));
            return iges::spline_of(piece);
        }
        if (!iges::is_surface(entry.type)) {
            fail(Status::unsupported, "does not become a spline in this version");
        }
        const iges::Surface surface = geometry_.surface(entry.line);
        entities_.spend(iges::size_of(*surface.shape));
        return surface_spline(entry, surface);
    }

    SplinePtr surface_spline(const Entry &entry, const iges::Surface &surface) {
        const model::SurfaceShape &shape = *surface.shape;
        if (shape.kind == model::SurfaceKind::spline) {
            return shape.spline;
        }
        std::vector<Vector3> points;
        if (!model::bounded(shape)) {
            if (surface.boundary == 0 || surface.hole) {
                fail(Status::length, "the surface has no ends");
            }
            append_points(*iges::spline_of(geometry_.curve(surface.boundary)), points);
        }
        model::MadeSurface made = surface_around(entities_, shape, points, geometry_.units().resolution);
        tell_approximation(entry, made.distance);
        return std::move(made.spline);
    }

    // The B-splines come first, in the order that they have without the others.
    void collect_splines() {
        for (const bool first : {true, false}) {
            for (size_t i = 0; i < splines_.size(); ++i) {
                const Entry &entry = directory_.entries()[i];
                if (splines_[i] != nullptr &&
                    settings_.wants(splines_[i]->axes() == 1 ? kind_curves : kind_surfaces) &&
                    always_listed(entry.type) == first && (first || !is_part_[i])) {
                    model_.splines.push_back({geometry_.name(entry.line), std::move(splines_[i])});
                }
            }
        }
    }

    // Points and directions that became part of a spline are not lost, so they need no note. Which ones these
    // are is known only at the end.
    void drop_notes_on_parts() {
        std::erase_if(model_.notes, [this](const model::Note &note) {
            const std::optional<size_t> index = directory_.find(note.line);
            return index && is_part_[*index] && note.reason == Status::unsupported;
        });
    }

    std::vector<bool> parameter_plane_;
    std::vector<SplinePtr> splines_; // by directory entry; null for entries without a spline
    std::vector<bool> is_part_;      // part of the spline of another entry
};

} // namespace

model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings) {
    const iges::Sections sections = iges::split_sections(bytes);
    const iges::Global global = iges::read_global(sections.global);
    return ListReader(bytes, sections, global, settings).run();
}

} // namespace nrb::io
