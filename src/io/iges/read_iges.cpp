// SPDX-License-Identifier: MIT
#include "io/iges/read_iges.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/directory.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/iges/names.h"
#include "io/iges/roles.h"
#include "io/iges/types.h"

#include <cmath>

namespace nrb::io {
namespace {

using iges::Entry;

// The factor from the unit of the file to the wanted one. A unit that the file does not state cannot be
// converted.
double unit_factor(double metres_per_unit, const ReadSettings &settings) {
    if (settings.unit == 0) {
        return 1;
    }
    if (metres_per_unit == 0) {
        fail(Status::options, "unit = %s cannot be reached: the unit of the file is not known",
             Number(settings.unit).text);
    }
    const double factor = metres_per_unit / settings.unit;
    if (!std::isnormal(factor)) {
        fail(Status::options, "unit = %s cannot be reached from units of %s metres",
             Number(settings.unit).text, Number(metres_per_unit).text);
    }
    return factor;
}

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
          geometry_(entities_, units_of(global, settings)) {
        model_.metres_per_unit = settings.unit > 0 ? settings.unit : global.metres_per_unit;
    }

    model::Model run() {
        Steps steps(std::ssize(directory_.entries()));
        for (size_t i = 0; i < directory_.entries().size(); ++i, steps.next(work_of_an_entity)) {
            const Entry &entry = directory_.entries()[i];
            try {
                read_entity(entry, parameter_plane_[i]);
            } catch (const Error &error) {
                note_error(entry, error);
            }
        }
        std::erase_if(model_.notes, [this](const model::Note &note) { return used(note); });
        return std::move(model_);
    }

private:
    void read_entity(const Entry &entry, bool parameter_plane) {
        if (!entry.damage.empty()) {
            fail(Status::syntax, "%s", entry.damage.c_str());
        }
        if (entry.type == iges::spline_curve_type) {
            add_spline(entry, iges::spline_of(parameter_plane ? geometry_.parameter_curve(entry.line)
                                                              : geometry_.curve(entry.line)));
        } else if (entry.type == iges::spline_surface_type) {
            const model::SurfaceShapePtr shape = geometry_.surface(entry.line).shape;
            add_spline(entry, shape->spline);
        } else {
            fail(Status::unsupported, "does not become a spline in this version");
        }
    }

    // Matrices and names that became part of a spline are not lost. Which ones these are is known only at the
    // end.
    [[nodiscard]] bool used(const model::Note &note) const noexcept {
        const std::optional<size_t> index = directory_.find(note.line);
        return index && (transforms_.used(*index) || names_.used(*index));
    }

    void add_spline(const Entry &entry, SplinePtr spline) {
        model_.splines.push_back({geometry_.name(entry.line), std::move(spline)});
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
    model::Model model_;
};

} // namespace

model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings) {
    const iges::Sections sections = iges::split_sections(bytes);
    const iges::Global global = iges::read_global(sections.global);
    return Reader(bytes, sections, global, settings).run();
}

} // namespace nrb::io
