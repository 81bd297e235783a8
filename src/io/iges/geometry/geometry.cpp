// SPDX-License-Identifier: MIT
#include "io/iges/geometry/geometry.h"

#include "io/iges/geometry/spline.h"
#include "model/shapes/curve_spline.h"
#include "refine/forms/transform.h"

namespace nrb::io::iges {
namespace {

using model::CurvePiece;

SplinePtr mapped_spline(const Spline &spline, const ParameterMap &map) {
    const auto [a, b] = map.scale;
    const double straight[4] = {a, 0, 0, b}, swapped[4] = {0, a, b, 0};
    return refine::transform(spline, {2, 2, map.swapped ? swapped : straight}, map.shift.data());
}

CurvePiece mapped(CurvePiece piece, const ParameterMap &map) {
    return map.identity() ? std::move(piece)
                          : whole(model::curve_of_spline(mapped_spline(*spline_of(piece), map)));
}

} // namespace

bool ParameterMap::identity() const noexcept {
    return !swapped && scale == std::array<double, 2>{1, 1} && shift == std::array<double, 2>{0, 0};
}

CurvePiece whole(model::CurveShapePtr curve) {
    const Interval range = model::natural_range(*curve);
    return {std::move(curve), range, true};
}

SplinePtr spline_of(const CurvePiece &piece) {
    const bool all = piece.curve->kind == model::CurveKind::spline && piece.forward &&
                     piece.range.lower == model::natural_range(*piece.curve).lower &&
                     piece.range.upper == model::natural_range(*piece.curve).upper;
    return all ? piece.curve->spline : model::piece_spline(piece);
}

// What read(reading) returns; its name and its parts count once it has been read to its end.
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
        parts_.insert(reading.parts.begin(), reading.parts.end());
        return result;
    });
}

CurvePiece Geometry::any_curve(int64_t pointer, const Transform *outer, bool parameter_plane) {
    const Key key{pointer, parameter_plane};
    if (const auto known = curves_.find(key); outer == nullptr && known != curves_.end()) {
        return known->second;
    }
    CurvePiece piece = read(pointer, "curve", outer, parameter_plane,
                            [this](Reading &reading) { return read_curve(reading); });
    return outer == nullptr ? curves_[key] = std::move(piece) : piece;
}

CurvePiece Geometry::curve(int64_t pointer, const Transform *outer) {
    return any_curve(pointer, outer, false);
}

CurvePiece Geometry::parameter_curve(int64_t pointer, const ParameterMap &map) {
    return mapped(any_curve(pointer, nullptr, true), map);
}

Surface Geometry::surface(int64_t pointer, const Transform *outer) {
    if (const auto known = surfaces_.find(pointer); outer == nullptr && known != surfaces_.end()) {
        return known->second;
    }
    Surface surface =
        read(pointer, "surface", outer, false, [this](Reading &reading) { return read_surface(reading); });
    return outer == nullptr ? surfaces_[pointer] = std::move(surface) : surface;
}

std::vector<CurvePiece> Geometry::pieces(int64_t pointer, const Transform *outer, bool parameter_plane) {
    return {any_curve(pointer, outer, parameter_plane)};
}

std::vector<CurvePiece> Geometry::curve_pieces(int64_t pointer, const Transform *outer) {
    return pieces(pointer, outer, false);
}

std::vector<CurvePiece> Geometry::parameter_pieces(int64_t pointer, const ParameterMap &map) {
    std::vector<CurvePiece> result = pieces(pointer, nullptr, true);
    for (CurvePiece &piece : result) {
        piece = mapped(std::move(piece), map);
    }
    return result;
}

std::string Geometry::name(int64_t pointer) const {
    const auto found = names_.find(pointer);
    return found == names_.end() ? std::string() : found->second;
}

} // namespace nrb::io::iges
