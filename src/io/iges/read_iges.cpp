// SPDX-License-Identifier: MIT
#include "io/iges/read_iges.h"

#include "base/error.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/iges/roles.h"
#include "io/iges/source.h"
#include "io/iges/types.h"

namespace nrb::io {
namespace {

using iges::Entry;

class ListReader : public iges::Source {
public:
    ListReader(std::span<const char> bytes, const iges::Sections &sections, const iges::Global &global,
               const ReadSettings &settings)
        : Source(bytes, sections, global, settings),
          parameter_plane_(iges::find_parameter_plane_curves(directory_, data_)) {}

    model::Model run() {
        read_all([this](const Entry &entry) { read_entity(entry); });
        return finished();
    }

private:
    void read_entity(const Entry &entry) {
        if (entry.type == iges::spline_curve_type) {
            add_spline(entry, iges::spline_of(parameter_plane_[*directory_.find(entry.line)]
                                                  ? geometry_.parameter_curve(entry.line)
                                                  : geometry_.curve(entry.line)));
        } else if (entry.type == iges::spline_surface_type) {
            const model::SurfaceShapePtr shape = geometry_.surface(entry.line).shape;
            add_spline(entry, shape->spline);
        } else {
            fail(Status::unsupported, "does not become a spline in this version");
        }
    }
    void add_spline(const Entry &entry, SplinePtr spline) {
        model_.splines.push_back({geometry_.name(entry.line), std::move(spline)});
    }

    std::vector<bool> parameter_plane_;
};

} // namespace

model::Model read_iges(std::span<const char> bytes, const ReadSettings &settings) {
    const iges::Sections sections = iges::split_sections(bytes);
    const iges::Global global = iges::read_global(sections.global);
    return ListReader(bytes, sections, global, settings).run();
}

} // namespace nrb::io
