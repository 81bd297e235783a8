// SPDX-License-Identifier: MIT
#include "io/step/write/write_step.h"

#include "base/error.h"
#include "base/numbers.h"
#include "io/faces/make_face.h"
#include "io/step/write/write_colours.h"
#include "io/step/write/write_contexts.h"
#include "io/step/write/write_layers.h"
#include "io/step/write/write_products.h"
#include "io/step/write/write_topology.h"
#include "io/unit_factor.h"
#include "io/written/index_of_error.h"
#include "io/written/shells.h"
#include "io/written/spline_facts.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {
namespace {

using step::ExchangeText;
using step::PartItems;
using step::Ref;
using step::Refs;
using step::Text;

// Of what has no faces, in metres.
constexpr double usual_uncertainty = 1e-7;

// No time and no place, so that the same model is the same file.
constexpr std::string_view header = "ISO-10303-21;\n"
                                    "HEADER;\n"
                                    "FILE_DESCRIPTION((''),'2;1');\n"
                                    "FILE_NAME('','',(''),(''),'libnurbs','libnurbs','');\n"
                                    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\n"
                                    "ENDSEC;\n"
                                    "DATA;\n";
constexpr std::string_view footer = "ENDSEC;\n"
                                    "END-ISO-10303-21;\n";

class StepWriter {
public:
    StepWriter(const model::Model &model, const WriteSettings &settings)
        : model_(model), lengths_(lengths_of(model.metres_per_unit, settings)),
          geometry_(text_, lengths_.factor), contexts_(text_, lengths_.metres),
          parts_(std::max<size_t>(model.parts.size(), 1)) {
        set_tolerances(settings.tolerance);
    }

    std::string run() {
        check_splines();
        const Topology topology = topology_of(model_);
        step::TopologyWriter written(geometry_, model_, topology, tolerances_);
        written.run();
        add_shells(written, topology);
        add_wires(written, topology);
        const std::vector<int64_t> splines = add_splines();
        step::ProductWriter(geometry_, model_, parts_).run();
        step::write_colours(text_, model_, written.faces(), parts_.front().context);
        step::write_layers(text_, model_, written.faces(), splines);
        text_.raw(footer);
        return text_.take();
    }

private:
    // The least tolerance of the faces of a part, because readers take what is less than it for nothing; but no less than that from
    // which they find the largest one.
    void set_tolerances(double wanted) {
        const double own = lengths_.metres / lengths_.factor;
        std::vector<double> largest(parts_.size(), 0);
        tolerances_.assign(parts_.size(), infinity);
        for (const model::ModelFace &face : model_.faces) {
            const auto part = static_cast<size_t>(face.part);
            const double tolerance = face.face->tolerance();
            tolerances_[part] = std::min(tolerances_[part], tolerance > 0 ? tolerance : infinity);
            largest[part] = std::max(largest[part], tolerance);
        }
        for (size_t i = 0; i < parts_.size(); ++i) {
            double &stated = tolerances_[i];
            stated = wanted > 0              ? wanted / lengths_.factor
                     : std::isfinite(stated) ? std::max(stated, largest[i] / most_of_stated)
                                             : usual_uncertainty / own;
            parts_[i].context = contexts_.context(wanted > 0 ? wanted : lengths_.factor * stated);
        }
    }

    void check_splines() const {
        for (size_t i = 0; i < model_.splines.size(); ++i) {
            named("splines", i, [&] { check_writable(*model_.splines[i].spline, "STEP"); });
        }
    }

    [[nodiscard]] Text name_of_part(int64_t part) const {
        return model_.parts.empty() ? step::no_name : Text{model_.parts[static_cast<size_t>(part)].name};
    }

    int64_t add_shell(const Shell &shell, const step::TopologyWriter &written) {
        std::vector<int64_t> faces;
        for (const size_t face : shell.faces) {
            faces.push_back(written.faces()[face]);
        }
        return text_.add(shell.closed ? "CLOSED_SHELL" : "OPEN_SHELL", step::no_name, Refs{faces});
    }

    // The normals of faces point out of the material already, in voids too.
    int64_t add_solid(int64_t outer, const std::vector<int64_t> &voids, Text name) {
        if (voids.empty()) {
            return text_.add("MANIFOLD_SOLID_BREP", name, Ref{outer});
        }
        std::vector<int64_t> oriented;
        oriented.reserve(voids.size());
        for (const int64_t shell : voids) {
            oriented.push_back(
                text_.add("ORIENTED_CLOSED_SHELL", step::no_name, step::derived, Ref{shell}, true));
        }
        return text_.add("BREP_WITH_VOIDS", name, Ref{outer}, Refs{oriented});
    }

    void add_shells(const step::TopologyWriter &written, const Topology &topology) {
        const std::vector<Shell> shells = shells_of(model_, topology);
        for (const Shell &shell : shells) {
            if (shell.inner) {
                continue;
            }
            const int64_t made[] = {add_shell(shell, written)};
            std::vector<int64_t> voids;
            for (const size_t index : shell.voids) {
                voids.push_back(add_shell(shells[index], written));
            }
            PartItems &part = parts_[static_cast<size_t>(shell.part)];
            const Text name = name_of_part(shell.part);
            if (shell.closed) {
                part.solids.push_back(add_solid(made[0], voids, name));
            } else {
                part.surfaces.push_back(text_.add("SHELL_BASED_SURFACE_MODEL", name, Refs{made}));
            }
        }
    }

    // Edges of which no face is made.
    void add_wires(const step::TopologyWriter &written, const Topology &topology) {
        std::vector<std::vector<int64_t>> edges(parts_.size());
        for (size_t i = 0; i < model_.edges.size(); ++i) {
            if (topology.edges[i].uses.empty()) {
                edges[static_cast<size_t>(topology.edges[i].part)].push_back(written.edges()[i]);
            }
        }
        for (size_t i = 0; i < parts_.size(); ++i) {
            if (!edges[i].empty()) {
                const int64_t sets[] = {text_.add("CONNECTED_EDGE_SET", step::no_name, Refs{edges[i]})};
                parts_[i].others.push_back(
                    text_.add("EDGE_BASED_WIREFRAME_MODEL", step::no_name, Refs{sets}));
            }
        }
    }

    // Their numbers. Those of space belong to the first part, those of dimension 2 to a parameter plane that is that of no surface.
    std::vector<int64_t> add_splines() {
        std::vector<int64_t> all, numbers, flat;
        bool surfaces = false;
        Steps steps(std::ssize(model_.splines));
        for (size_t i = 0; i < model_.splines.size(); ++i) {
            const model::NamedSpline &one = model_.splines[i];
            all.push_back(named("splines", i, [&] { return geometry_.spline(*one.spline, one.name); }));
            (one.spline->dim() == 2 ? flat : numbers).push_back(all.back());
            surfaces = surfaces || one.spline->axes() == 2;
            steps.next();
        }
        if (!numbers.empty()) {
            parts_.front().others.push_back(
                text_.add(surfaces ? "GEOMETRIC_SET" : "GEOMETRIC_CURVE_SET", step::no_name, Refs{numbers}));
        }
        if (!flat.empty()) {
            geometry_.in_parameters(text_.add("GEOMETRIC_CURVE_SET", step::no_name, Refs{flat}));
        }
        return all;
    }

    const model::Model &model_;
    Lengths lengths_;
    ExchangeText text_{header};
    step::GeometryWriter geometry_;
    step::ContextWriter contexts_;
    std::vector<PartItems> parts_;
    std::vector<double> tolerances_; // of the parts, in units of the model
};

} // namespace

std::string write_step(const model::Model &model, const WriteSettings &settings) {
    return StepWriter(model, settings).run();
}

} // namespace nrb::io
