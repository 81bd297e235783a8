// SPDX-License-Identifier: MIT
// Reads the curves and surfaces of a file as shapes.
#pragma once

#include "base/error.h"
#include "io/iges/geometry/entities.h"
#include "io/iges/geometry/placed_splines.h"
#include "io/iges/types.h"
#include "model/shapes/surface_shape.h"

#include <map>
#include <set>
#include <span>
#include <vector>

namespace nrb::io::iges {

// Maps the parameters that the standard defines for a surface to those of its shape: (scale[0] p + shift[0],
// scale[1] q + shift[1]) with (p, q) = (u, v), or (v, u) if swapped.
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
        true; // false: the standard defines no parameters, so curves in its parameter plane mean nothing
    // For a plane (108): the closed curve that bounds it, 0 if it is unbounded, and whether the curve bounds
    // a hole.
    int64_t boundary = 0;
    bool hole = false;
};

// A shape that could not be made exactly, with an explanation.
struct Remark {
    int64_t pointer; // to the entity
    std::string text;
    Status reason = Status::unsupported;
};

struct Units {
    double factor = 1; // from the unit of the file to the wanted unit
    double resolution =
        0; // smallest distance that the file distinguishes from 0, in the wanted unit; 0: not stated
    bool all_digits = false; // the file has all digits of its numbers
};

// Pointers are directory lines. Shapes are placed by the matrices of their entities and then by `outer`, the
// matrix of the entity they are part of, if any; lengths are in the wanted unit. Errors name the entity in
// which they occur: Status::syntax, unsupported for entities that are not read, too_large, and what the
// builders throw.
class Geometry {
public:
    Geometry(Entities &entities, const Units &units) noexcept : entities_(entities), units_(units) {}

    // A curve in space: entities 100, 102, 104, 106, 110, 112, 126, 130. Its range is that of the parameters
    // of the standard, infinite where the curve is unbounded.
    model::CurvePiece curve(int64_t pointer, const Transform *outer = nullptr);
    // The same entities as curves in the parameter plane of a surface, in the parameters of its shape; not
    // scaled.
    model::CurvePiece parameter_curve(int64_t pointer, const ParameterMap &map = {});
    // The curves that a composite curve (102) consists of, in order, with nested ones expanded; any other
    // curve alone.
    std::vector<model::CurvePiece> curve_pieces(int64_t pointer, const Transform *outer = nullptr);
    std::vector<model::CurvePiece> parameter_pieces(int64_t pointer, const ParameterMap &map = {});

    // Entities 108, 114, 118, 120, 122, 128, 140, 190, 192, 194, 196, 198.
    Surface surface(int64_t pointer, const Transform *outer = nullptr);

    // Entity 116.
    Vector3 point(int64_t pointer, const Transform *outer = nullptr);

    // The name of an entity that has been read.
    [[nodiscard]] std::string name(int64_t pointer) const;
    // Whether an entity became part of the shape of another one.
    [[nodiscard]] bool is_part(int64_t pointer) const noexcept { return is_part_.contains(pointer); }
    // What the shape of an entity that has been read consists of: curves, points, directions, surfaces.
    [[nodiscard]] std::span<const int64_t> parts(int64_t pointer) const noexcept;
    [[nodiscard]] const std::vector<Remark> &remarks() const noexcept { return remarks_; }

    [[nodiscard]] const Units &units() const noexcept { return units_; }
    [[nodiscard]] Entities &entities() const noexcept { return entities_; }

private:
    // An entity while it is being read.
    struct Reading {
        const Entry &entry;
        Record record;
        Placement place;
        std::vector<int64_t> parts{}; // pointers to what its shape consists of

        // The matrix that is applied to its parts after their own.
        [[nodiscard]] const Transform *outer() const noexcept {
            return place.transform ? &*place.transform : nullptr;
        }
    };
    using Key = std::pair<int64_t, bool>; // pointer, and whether the curve is in a parameter plane

    template <class Read>
    auto read(int64_t pointer, const char *what, const Transform *outer, bool parameter_plane, Read &&read);
    void keep_parts(int64_t pointer, std::vector<int64_t> parts);
    model::CurvePiece any_curve(int64_t pointer, const Transform *outer, bool parameter_plane);
    std::vector<model::CurvePiece> pieces(int64_t pointer, const Transform *outer, bool parameter_plane);
    model::CurvePiece read_curve(Reading &reading);
    std::vector<int64_t> constituents(Reading &reading);
    model::CurvePiece composite(Reading &reading);
    model::CurvePiece offset_curve(Reading &reading);
    void remark(int64_t pointer, bool approximated, std::string text);
    model::CurvePiece part_curve(Reading &reading, const char *what);
    Vector3 part_point(Reading &reading, const char *what);
    Vector3 part_direction(Reading &reading, const char *what);

    Surface read_surface(Reading &reading);
    static Surface plane(Reading &reading);
    Surface elementary(Reading &reading);
    Surface ruled(Reading &reading);
    struct Rail {
        model::CurvePiece piece;
        SplinePtr spline;
        bool is_point = false;
    };
    Rail rail(Reading &reading, const char *what);
    Surface revolution(Reading &reading);
    Surface tabulated(Reading &reading);
    Surface offset(Reading &reading);

    Entities &entities_;
    Units units_;
    std::map<Key, model::CurvePiece> curves_; // those read already, with no matrix but their own
    std::map<int64_t, Surface> surfaces_;
    std::map<int64_t, std::string> names_;
    std::map<int64_t, std::vector<int64_t>> parts_; // of entities that have parts
    std::set<int64_t> is_part_;
    std::vector<Remark> remarks_;
    // Entities that are not exactly as stated, or have parts that are not; and those for which a remark was
    // made.
    std::set<int64_t> approximated_, told_;
};

// Returns what read(reading) returns. Name and parts are stored only after the entity has been read
// completely.
template <class Read>
auto Geometry::read(int64_t pointer, const char *what, const Transform *outer, bool parameter_plane,
                    Read &&read) {
    const Entry &entry = entities_.at(pointer, what);
    return labelling(entry, [&] {
        const Entities::Visit visit(entities_, pointer);
        entities_.spend(Entities::size_of_a_shape);
        Reading reading{entry, entities_.record(entry), {}};
        reading.place =
            entities_.placement(entry, outer, parameter_plane ? 1 : units_.factor, parameter_plane);
        auto result = read(reading);
        names_[pointer] = entities_.name(entry, reading.record);
        keep_parts(pointer, std::move(reading.parts));
        return result;
    });
}

// Throws Status::syntax unless an entity is of this type.
void expect(const Entry &entry, int type);

// Whether an entity of this type is read as a curve, or as a surface.
bool is_curve(int type) noexcept;
bool is_surface(int type) noexcept;

} // namespace nrb::io::iges
