// SPDX-License-Identifier: MIT
#include "io/iges/read_iges.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/directory.h"
#include "io/iges/geometry/shapes.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/iges/names.h"
#include "io/iges/roles.h"
#include "io/iges/types.h"
#include "io/unit_factor.h"
#include "model/shapes/surface_spline.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {
namespace {

using iges::Entry;

iges::Units units_of(const iges::Global &global, const ReadSettings &settings) {
    const double factor = unit_factor(global.metres_per_unit, settings);
    return {factor, factor * global.resolution};
}

constexpr int64_t work_of_an_entity = 1000; // beyond what its parameters count

class Reader {
public:
    Reader(std::span<const char> bytes, const iges::Sections &sections, const iges::Global &global,
           const ReadSettings &settings)
        : directory_(sections.directory), data_(sections.parameter, global.delimiters),
          parameter_plane_(iges::find_parameter_plane_curves(directory_, data_)),
          transforms_(directory_, data_), names_(directory_, data_),
          entities_(bytes.size(), directory_, data_, transforms_, names_),
          geometry_(entities_, units_of(global, settings)), splines_(directory_.entries().size()),
          is_part_(directory_.entries().size(), false) {
        model_.metres_per_unit = settings.unit > 0 ? settings.unit : global.metres_per_unit;
    }

    // What other splines consist of is known once they have been read, so they come first.
    model::Model run() {
        Steps steps(2);
        read_entities(true);
        steps.next();
        read_entities(false);
        steps.next();
        collect_splines();
        collect_remarks();
        std::erase_if(model_.notes, [this](const model::Note &note) { return used(note); });
        std::ranges::stable_sort(model_.notes, {}, &model::Note::line);
        return std::move(model_);
    }

private:
    void read_entities(bool with_parts) {
        Steps steps(std::ssize(directory_.entries()));
        for (size_t i = 0; i < directory_.entries().size(); ++i) {
            const Entry &entry = directory_.entries()[i];
            const bool wanted =
                has_parts(entry.type) == with_parts && (!is_part_[i] || always_listed(entry.type));
            if (wanted) {
                read_entity(i);
            }
            steps.next(wanted ? work_of_an_entity : 1);
        }
    }

    void read_entity(size_t index) {
        const Entry &entry = directory_.entries()[index];
        try {
            splines_[index] = spline_of(entry, parameter_plane_[index]);
            for (const int64_t pointer : geometry_.parts(entry.line)) {
                is_part_[*directory_.find(pointer)] = true;
            }
        } catch (const Error &error) {
            note_error(entry, error);
        }
    }

    // Whose spline takes the place of those of its parts.
    static bool has_parts(int type) noexcept {
        return type == iges::composite_type || (iges::is_surface(type) && type != iges::offset_surface_type);
    }
    static bool always_listed(int type) noexcept {
        return type == iges::spline_curve_type || type == iges::spline_surface_type;
    }

    SplinePtr spline_of(const Entry &entry, bool parameter_plane) {
        if (!entry.damage.empty()) {
            fail(Status::syntax, "%s", entry.damage.c_str());
        }
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
        return surface_spline(surface);
    }

    SplinePtr surface_spline(const iges::Surface &surface) {
        const model::SurfaceShape &shape = *surface.shape;
        if (shape.kind == model::SurfaceKind::spline) {
            return shape.spline;
        }
        if (model::bounded(shape)) {
            return model::surface_spline(shape, model::natural_range(shape));
        }
        if (surface.boundary == 0 || surface.hole) {
            fail(Status::length, "the surface has no ends");
        }
        constexpr double margin = 1.0 / 64; // of the size of the boundary
        const SplinePtr boundary = iges::spline_of(geometry_.curve(surface.boundary));
        std::vector<Vector3> points;
        for (int64_t i = 0; i < boundary->point_count(); ++i) {
            points.push_back(
                {boundary->coordinate(i, 0), boundary->coordinate(i, 1), boundary->coordinate(i, 2)});
        }
        return model::surface_spline(shape, model::range_around(shape, points, margin));
    }

    void collect_splines() {
        for (size_t i = 0; i < splines_.size(); ++i) {
            const Entry &entry = directory_.entries()[i];
            if (splines_[i] != nullptr && (!is_part_[i] || always_listed(entry.type))) {
                model_.splines.push_back({geometry_.name(entry.line), std::move(splines_[i])});
            }
        }
    }

    // Matrices, names, points and directions that became part of a spline are not lost. Which ones these are is known
    // only at the end.
    [[nodiscard]] bool used(const model::Note &note) const noexcept {
        const std::optional<size_t> index = directory_.find(note.line);
        return index && (transforms_.used(*index) || names_.used(*index) ||
                         (is_part_[*index] && note.reason == Status::unsupported));
    }

    void collect_remarks() {
        for (const iges::Remark &remark : geometry_.remarks()) {
            const Entry &entry = directory_.entries()[*directory_.find(remark.pointer)];
            model_.notes.push_back(
                {entry.type, entry.line, Status::unsupported, iges::label_of(entry) + remark.text});
        }
    }

    // With the label of the entity, unless the message begins with it.
    void note_error(const Entry &entry, const Error &error) {
        const std::string label = iges::label_of(entry), text = error.what();
        model_.notes.push_back(
            {entry.type, entry.line, error.status(), text.starts_with(label) ? text : label + text});
    }

    iges::Directory directory_;
    iges::ParameterData data_;
    std::vector<bool> parameter_plane_;
    iges::Transforms transforms_;
    iges::Names names_;
    iges::Entities entities_;
    iges::Geometry geometry_;
    std::vector<SplinePtr> splines_; // of the entries of the directory; null for those that have none
    std::vector<bool> is_part_;      // of another entry's spline
    model::Model model_;
};

} // namespace

model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings) {
    const iges::Sections sections = iges::split_sections(bytes);
    const iges::Global global = iges::read_global(sections.global);
    return Reader(bytes, sections, global, settings).run();
}

} // namespace nrb::io
