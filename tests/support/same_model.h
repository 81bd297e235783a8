// How two models differ: nothing but notes may be another, to the last bit.
#pragma once

#include "io/step/write/edge_curves.h"
#include "io/written/shells.h"
#include "model/model.h"
#include "spline/same_numbers.h"

#include <map>
#include <string>
#include <vector>

namespace step_test {

class ModelDifferences {
public:
    ModelDifferences(const nrb::model::Model &a, const nrb::model::Model &b) : a_(a), b_(b) {
        expect("unit", a.metres_per_unit == b.metres_per_unit);
        expect("layers", a.layers == b.layers);
        if (sizes()) {
            splines();
            parts();
            find_closed();
            for (size_t i = 0; i < a.faces.size(); ++i) {
                face("face " + std::to_string(i), a.faces[i], b.faces[i]);
            }
            edges();
        }
    }
    [[nodiscard]] std::vector<std::string> found() const { return found_; }

private:
    void expect(const std::string &what, bool same) {
        constexpr size_t most = 12;
        if (!same && found_.size() < most) {
            found_.push_back(what);
        }
    }
    bool sizes() {
        const auto same = [this](const char *what, size_t a, size_t b) {
            expect(std::string("number of ") + what + " " + std::to_string(a) + " " + std::to_string(b),
                   a == b);
        };
        same("splines", a_.splines.size(), b_.splines.size());
        same("parts", a_.parts.size(), b_.parts.size());
        same("uses", a_.uses.size(), b_.uses.size());
        same("faces", a_.faces.size(), b_.faces.size());
        same("edges", a_.edges.size(), b_.edges.size());
        same("vertices", a_.vertices.size(), b_.vertices.size());
        return found_.empty();
    }
    void splines() {
        for (size_t i = 0; i < a_.splines.size(); ++i) {
            const std::string what = "spline " + std::to_string(i);
            expect(what + ": name", a_.splines[i].name == b_.splines[i].name);
            expect(what + ": layers", a_.splines[i].layers == b_.splines[i].layers);
            expect(what, nrb::same_numbers(*a_.splines[i].spline, *b_.splines[i].spline));
        }
    }
    void parts() {
        for (size_t i = 0; i < a_.parts.size(); ++i) {
            expect("name of part " + std::to_string(i), a_.parts[i].name == b_.parts[i].name);
        }
        for (size_t i = 0; i < a_.uses.size(); ++i) {
            const std::string what = "use " + std::to_string(i);
            expect(what, a_.uses[i].part == b_.uses[i].part && a_.uses[i].parent == b_.uses[i].parent);
            expect(what + ": placement", a_.uses[i].placement == b_.uses[i].placement);
        }
    }
    void face(const std::string &what, const nrb::model::ModelFace &a, const nrb::model::ModelFace &b) {
        expect(what + ": name " + a.name + " " + b.name, a.name == b.name);
        expect(what + ": part, side or colour",
               a.part == b.part && a.against == b.against && a.colour == b.colour);
        expect(what + ": layers", a.layers == b.layers);
        expect(what + ": solid", same_solid(a, b));
        expect(what + ": kind", (a.shape == nullptr ? nrb::model::SurfaceKind::spline : a.shape->kind) ==
                                    (b.shape == nullptr ? nrb::model::SurfaceKind::spline : b.shape->kind));
        expect(what + ": tolerance", a.face->tolerance() == b.face->tolerance());
        expect(what + ": surface", nrb::same_numbers(*a.face->surface(), *b.face->surface()));
        expect(what + ": number of loops", a.face->loops().size() == b.face->loops().size());
        for (size_t i = 0; i < std::min(a.face->loops().size(), b.face->loops().size()); ++i) {
            loop(what + " loop " + std::to_string(i), a.face->loops()[i], b.face->loops()[i]);
        }
    }
    // What does not enclose anything is written as an open shell, which is no solid; what does and was none becomes one.
    bool same_solid(const nrb::model::ModelFace &a, const nrb::model::ModelFace &b) {
        if (!closed_[static_cast<size_t>(&a - a_.faces.data())]) {
            return b.solid < 0;
        }
        return a.solid < 0 || (b.solid >= 0 && a.in_void == b.in_void &&
                               solids_.try_emplace(a.solid, b.solid).first->second == b.solid);
    }
    void find_closed() {
        closed_.assign(a_.faces.size(), false);
        for (const nrb::io::Shell &shell : nrb::io::shells_of(a_, nrb::io::topology_of(a_))) {
            for (const size_t face : shell.faces) {
                closed_[face] = shell.closed;
            }
        }
    }
    void loop(const std::string &what, const nrb::face::Loop &a, const nrb::face::Loop &b) {
        expect(what + ": size", a.size() == b.size());
        for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            const std::string at = what + " curve " + std::to_string(i);
            expect(at, nrb::same_numbers(*a[i].curve, *b[i].curve));
            expect(at + ": key or direction", a[i].key == b[i].key && a[i].against == b[i].against);
        }
    }
    void edges() {
        for (size_t i = 0; i < a_.edges.size(); ++i) {
            const nrb::model::Edge &a = a_.edges[i], &b = b_.edges[i];
            const std::string what = "edge " + std::to_string(i);
            expect(what, nrb::same_numbers(*a.curve, *b.curve));
            expect(what + ": ends or part", a.vertices == b.vertices && a.part == b.part);
            expect(what + ": kind", (a.shape == nullptr ? nrb::model::CurveKind::spline : a.shape->kind) ==
                                        (b.shape == nullptr ? nrb::model::CurveKind::spline : b.shape->kind));
            expect(what + ": uses", a.uses.size() == b.uses.size());
        }
        for (size_t i = 0; i < a_.vertices.size(); ++i) {
            const nrb::Vector3 &a = a_.vertices[i], &b = b_.vertices[i];
            expect("vertex " + std::to_string(i), a.x == b.x && a.y == b.y && a.z == b.z);
        }
    }

    const nrb::model::Model &a_;
    const nrb::model::Model &b_;
    std::vector<bool> closed_;          // of the faces of the first: whether their shell is
    std::map<int64_t, int64_t> solids_; // of the second by those of the first
    std::vector<std::string> found_;
};

} // namespace step_test
