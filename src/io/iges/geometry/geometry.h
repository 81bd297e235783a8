// SPDX-License-Identifier: MIT
// Curves and surfaces of a file as shapes.
#pragma once

#include "io/iges/geometry/entities.h"
#include "model/shapes/surface_shape.h"

#include <map>
#include <set>
#include <vector>

namespace nrb::io::iges {

// From the parameters that the standard gives a surface to those of its shape: (scale[0] p + shift[0], scale[1] q +
// shift[1]) with (p, q) = (u, v), or (v, u) if they are swapped.
struct ParameterMap {
    bool swapped = false;
    std::array<double, 2> scale = {1, 1};
    std::array<double, 2> shift = {0, 0};

    [[nodiscard]] bool identity() const noexcept;
};

struct Surface {
    model::SurfaceShapePtr shape;
    ParameterMap map{};
    bool parametrized =
        true; // false: the standard gives it no parameters, and curves in its parameter plane mean nothing
    // Of a plane (108): the closed curve that bounds it, 0 if it goes on without end, and whether that bounds a hole.
    int64_t boundary = 0;
    bool hole = false;
};

// What a shape could not be made exactly of, and what is meant.
struct Remark {
    int64_t pointer; // of the entity
    std::string text;
};

struct Units {
    double factor = 1; // from the unit of the file to the one that is wanted
    double resolution =
        0; // the least distance that the file tells from none, in the wanted unit; 0: not stated
};

// Pointers are directory lines. Shapes lie where the matrices of their entities put them, and then that of the entity
// which they are a part of, if `outer` is one; lengths are in the unit that is wanted. What goes wrong throws Error,
// which names the entity in which it does: Status::syntax, unsupported for entities that are not read, too_large, and
// what the builders throw.
class Geometry {
public:
    Geometry(Entities &entities, const Units &units) noexcept : entities_(entities), units_(units) {}

    // A curve of space: entities 100, 102, 104, 106, 110, 112, 126. Its range is that of the standard's parameters, and
    // infinite where it has no ends.
    model::CurvePiece curve(int64_t pointer, const Transform *outer = nullptr);
    // The same entities as curves in the parameter plane of a surface, in the parameters of its shape; not scaled.
    model::CurvePiece parameter_curve(int64_t pointer, const ParameterMap &map = {});
    // The curves that composite curves (102), and those in them, consist of one after the other; any other curve alone.
    std::vector<model::CurvePiece> curve_pieces(int64_t pointer, const Transform *outer = nullptr);
    std::vector<model::CurvePiece> parameter_pieces(int64_t pointer, const ParameterMap &map = {});

    // Entities 108, 114, 118, 120, 122, 128, 140, 190, 192, 194, 196, 198.
    Surface surface(int64_t pointer, const Transform *outer = nullptr);

    // The name of an entity that has been read.
    [[nodiscard]] std::string name(int64_t pointer) const;
    // Whether an entity became part of another one's shape.
    [[nodiscard]] bool is_part(int64_t pointer) const noexcept { return parts_.contains(pointer); }
    [[nodiscard]] const std::vector<Remark> &remarks() const noexcept { return remarks_; }

    [[nodiscard]] const Units &units() const noexcept { return units_; }
    [[nodiscard]] Entities &entities() const noexcept { return entities_; }

private:
    // An entity while it is read.
    struct Reading {
        const Entry &entry;
        Record record;
        Placement place;
        std::vector<int64_t> parts{};
    };
    using Key = std::pair<int64_t, bool>; // whether in the parameter plane

    template <class Read>
    auto read(int64_t pointer, const char *what, const Transform *outer, bool parameter_plane, Read &&read);
    model::CurvePiece any_curve(int64_t pointer, const Transform *outer, bool parameter_plane);
    std::vector<model::CurvePiece> pieces(int64_t pointer, const Transform *outer, bool parameter_plane);
    model::CurvePiece read_curve(Reading &reading);
    Surface read_surface(Reading &reading);

    Entities &entities_;
    Units units_;
    std::map<Key, model::CurvePiece> curves_; // read already, with no matrix but their own
    std::map<int64_t, Surface> surfaces_;
    std::map<int64_t, std::string> names_;
    std::set<int64_t> parts_;
    std::vector<Remark> remarks_;
};

// Whether an entity of this type is read as a curve, or as a surface.
bool is_curve(int type) noexcept;
bool is_surface(int type) noexcept;

// All of a curve.
model::CurvePiece whole(model::CurveShapePtr curve);

// Exact, over the range of the piece. Throws what model::piece_spline() throws.
SplinePtr spline_of(const model::CurvePiece &piece);

} // namespace nrb::io::iges
