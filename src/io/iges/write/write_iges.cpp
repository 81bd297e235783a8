// SPDX-License-Identifier: MIT
#include "io/iges/write/write_iges.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "io/faces/make_face.h"
#include "io/iges/read_model.h"
#include "io/iges/types.h"
#include "io/iges/write/confirmed.h"
#include "io/iges/write/write_assembly.h"
#include "io/iges/write/write_global.h"
#include "io/iges/write/write_topology.h"
#include "io/unit_factor.h"
#include "io/written/index_of_error.h"
#include "io/written/shells.h"
#include "io/written/spline_facts.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {
namespace {

using iges::FileText;
using iges::GeometryWriter;
using iges::GlobalFacts;
using iges::StatedShapes;

constexpr int closed_form = 1, open_form = 2;
// The resolution of a model without faces, in metres.
constexpr double usual_resolution = 1e-7;

// The resolution is the least tolerance of the faces, because readers treat smaller distances as 0; but it
// must be large enough that readers find the larger tolerances of other faces from it.
double resolution_of(const model::Model &model, double metres) {
    double least = infinity, needed = 0;
    for (const model::ModelFace &face : model.faces) {
        const double tolerance = face.face->tolerance();
        least = std::min(least, tolerance > 0 ? tolerance : infinity);
        if (tolerance > iges::largest_gap(*face.face->surface())) {
            needed = std::max(needed, tolerance / most_of_stated);
        }
    }
    return std::isfinite(least) ? std::max(least, needed) : usual_resolution / metres;
}

// The largest coordinate in space, including control points.
double extent_of(const model::Model &model) {
    double extent = 0;
    const auto cover = [&extent](const Spline &spline) {
        for (int64_t i = 0; spline.dim() == 3 && i < spline.point_count(); ++i) {
            for (int c = 0; c < spline.dim(); ++c) {
                extent = std::max(extent, std::fabs(spline.coordinate(i, c)));
            }
        }
    };
    for (const model::NamedSpline &one : model.splines) {
        cover(*one.spline);
    }
    for (const model::Edge &edge : model.edges) {
        cover(*edge.curve);
    }
    for (const model::ModelFace &face : model.faces) {
        cover(*face.face->surface());
    }
    return extent;
}

class IgesWriter {
public:
    IgesWriter(const model::Model &model, const Topology &topology, const StatedShapes &stated, double length,
               double resolution)
        : model_(model), topology_(topology), geometry_(text_, length), levels_(text_, model.layers),
          faces_(geometry_, levels_, model, topology, stated, resolution),
          items_(std::max<size_t>(model.parts.size(), 1)) {}

    std::string all(const GlobalFacts &facts) {
        {
            const Phase phase;
            faces_.run();
        }
        add_shells();
        add_splines();
        iges::AssemblyWriter(geometry_, model_, items_).run();
        levels_.write_names();
        return text_.file(write_global(facts));
    }
    // Edges and faces without what they are part of.
    std::string topology_alone(const GlobalFacts &facts) {
        faces_.run();
        return text_.file(write_global(facts));
    }
    [[nodiscard]] const std::vector<int64_t> &faces() const noexcept { return faces_.faces(); }

private:
    int64_t add_shell(const Shell &shell, std::string_view status) {
        const int64_t number =
            text_.begin({iges::shell_type, shell.closed ? closed_form : open_form, status});
        text_.put(std::ssize(shell.faces));
        for (const size_t face : shell.faces) {
            text_.put(faces_.faces()[face], model_.faces[face].against ? 0 : 1);
        }
        text_.end();
        return number;
    }

    int64_t add_solid(int64_t outer, const std::vector<int64_t> &voids, std::string_view status) {
        const int64_t number = text_.begin({iges::solid_type, 0, status});
        text_.put(outer, 1, std::ssize(voids));
        for (const int64_t shell : voids) {
            text_.put(shell, 1);
        }
        text_.end();
        return number;
    }

    void add_shells() {
        const bool whole = iges::first_is_whole(model_);
        const std::vector<Shell> shells = shells_of(model_, topology_);
        for (const Shell &shell : shells) {
            if (shell.inner) {
                continue;
            }
            const bool alone = whole && shell.part == 0;
            const std::string_view status = alone ? iges::independent : iges::dependent;
            int64_t item = add_shell(shell, shell.closed ? iges::dependent : status);
            if (shell.closed) {
                std::vector<int64_t> voids;
                for (const size_t index : shell.voids) {
                    voids.push_back(add_shell(shells[index], iges::dependent));
                }
                item = add_solid(item, voids, status);
            }
            items_[static_cast<size_t>(shell.part)].push_back(item);
        }
    }

    void add_splines() {
        Steps steps(std::ssize(model_.splines));
        for (size_t i = 0; i < model_.splines.size(); ++i) {
            const model::NamedSpline &one = model_.splines[i];
            const int64_t level = levels_.level(one.layers);
            named("splines", i, [&] { geometry_.named_spline(*one.spline, one.name, level); });
            steps.next();
        }
    }

    const model::Model &model_;
    const Topology &topology_;
    FileText text_;
    GeometryWriter geometry_;
    iges::LevelWriter levels_;
    iges::TopologyWriter faces_;
    std::vector<std::vector<int64_t>> items_; // of parts
};

void check_splines(const model::Model &model) {
    for (size_t i = 0; i < model.splines.size(); ++i) {
        named("splines", i, [&] { check_writable(*model.splines[i].spline, "IGES"); });
    }
}

// Confirms the shapes of edges by reading back a file without faces.
void confirm_edges(const Topology &topology, const GlobalFacts &facts, StatedShapes &stated) {
    if (stated.any_edge()) {
        const model::Model none;
        const auto write = [&](const StatedShapes &shapes) {
            return IgesWriter(none, topology, shapes, 1, facts.resolution).topology_alone(facts);
        };
        iges::confirm_edges(write, topology, facts.resolution, stated);
    }
}

void confirm_faces(const model::Model &model, const Topology &topology, const GlobalFacts &facts,
                   StatedShapes &stated) {
    if (stated.any_face()) {
        const Phase phase;
        model::Model nameless{{}, {}, 0};
        nameless.parts = model.parts;
        nameless.faces = model.faces;
        for (model::ModelFace &face : nameless.faces) {
            face.name.clear();
            face.layers.clear();
        }
        IgesWriter writer(nameless, topology, stated, 1, facts.resolution);
        const std::string text = writer.topology_alone(facts);
        iges::confirm_faces(text, model, writer.faces(), stated);
    }
}

} // namespace

std::string write_iges(const model::Model &model, const WriteSettings &settings) {
    const Lengths lengths = lengths_of(model.metres_per_unit, settings);
    check_splines(model);
    const Topology topology = topology_of(model);
    const double own = lengths.metres / lengths.factor, factor = lengths.factor,
                 resolution =
                     settings.tolerance > 0 ? settings.tolerance / factor : resolution_of(model, own),
                 extent = extent_of(model);
    StatedShapes stated = iges::statable_shapes(model, topology, resolution);
    const bool named = iges::first_is_whole(model) && !model.parts.empty();
    const GlobalFacts facts{named ? model.parts.front().name : std::string(), own, resolution, extent};
    confirm_edges(topology, facts, stated);
    confirm_faces(model, topology, facts, stated);
    return IgesWriter(model, topology, stated, factor, resolution)
        .all({facts.product, lengths.metres,
              settings.tolerance > 0 ? settings.tolerance : factor * resolution, factor * extent});
}

} // namespace nrb::io
