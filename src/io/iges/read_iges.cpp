// SPDX-License-Identifier: MIT
#include "io/iges/read_iges.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/directory.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/iges/names.h"
#include "io/iges/roles.h"
#include "io/iges/spline.h"
#include "io/iges/transform.h"

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

constexpr int64_t work_of_an_entity = 1000; // beyond what its parameters count

class Reader {
public:
    Reader(const iges::Sections &sections, const iges::Global &global, const ReadSettings &settings)
        : directory_(sections.directory), data_(sections.parameter, global.delimiters),
          parameter_plane_(iges::find_parameter_plane_curves(directory_, data_)),
          transforms_(directory_, data_), names_(directory_, data_),
          factor_(unit_factor(global.metres_per_unit, settings)) {
        model_.metres_per_unit = settings.unit > 0 ? settings.unit : global.metres_per_unit;
    }

    model::Model run() {
        Steps steps(std::ssize(directory_.entries()));
        for (size_t i = 0; i < directory_.entries().size(); ++i, steps.next(work_of_an_entity)) {
            const Entry &entry = directory_.entries()[i];
            try {
                read_entity(entry, parameter_plane_[i]);
            } catch (const Error &error) {
                add_note(entry, error.status(), error.what());
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
        if (entry.type == iges::curve_type || entry.type == iges::surface_type) {
            add_spline(entry, parameter_plane && entry.type == iges::curve_type);
        } else {
            add_note(entry, Status::unsupported, "does not become a spline in this version");
        }
    }

    // Matrices and names that became part of a spline are not lost. Which ones these are is known only at the
    // end.
    [[nodiscard]] bool used(const model::Note &note) const noexcept {
        const std::optional<size_t> index = directory_.find(note.line);
        return index && (transforms_.used(*index) || names_.used(*index));
    }

    void add_spline(const Entry &entry, bool parameter_plane) {
        iges::Record record = data_.take(entry);
        iges::SplineData data =
            entry.type == iges::curve_type ? iges::read_curve_data(record) : iges::read_surface_data(record);
        iges::Placement placement;
        placement.transform = entry.transform == 0 ? nullptr : &transforms_.resolve(entry.transform);
        placement.factor = parameter_plane ? 1 : factor_;
        placement.parameter_plane = parameter_plane;
        SplinePtr spline = iges::build_spline(std::move(data), placement);
        model_.splines.push_back({names_.name(entry, record), std::move(spline)});
    }

    void add_note(const Entry &entry, Status reason, const char *text) {
        const std::string where = std::string(iges::type_name(entry.type)) + " (" +
                                  std::to_string(entry.type) + ") at directory line " +
                                  std::to_string(entry.line) + ": ";
        model_.notes.push_back({entry.type, entry.line, reason, where + text});
    }

    iges::Directory directory_;
    iges::ParameterData data_;
    std::vector<bool> parameter_plane_;
    iges::Transforms transforms_;
    iges::Names names_;
    double factor_;
    model::Model model_;
};

} // namespace

model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings) {
    const iges::Sections sections = iges::split_sections(bytes);
    const iges::Global global = iges::read_global(sections.global);
    return Reader(sections, global, settings).run();
}

} // namespace nrb::io
