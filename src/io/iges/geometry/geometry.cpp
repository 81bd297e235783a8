// SPDX-License-Identifier: MIT
#include "io/iges/geometry/geometry.h"

#include "io/iges/geometry/polylines.h"
#include "model/shapes/curve_spline.h"
#include "refine/forms/transform.h"

#include <algorithm>

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

void expect(const Entry &entry, int type) {
    if (entry.type != type) {
        fail(Status::syntax, "where a %s (%d) was expected", type_name(type), type);
    }
}

bool ParameterMap::identity() const noexcept {
    return !swapped && scale == std::array<double, 2>{1, 1} && shift == std::array<double, 2>{0, 0};
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

Vector3 Geometry::point(int64_t pointer, const Transform *outer) {
    return read(pointer, "point", outer, false, [](Reading &reading) {
        expect(reading.entry, point_type);
        const auto [x, y, z] = reading.place.point(read_point(reading.record, "point"));
        return Vector3{x, y, z};
    });
}

void Geometry::keep_parts(int64_t pointer, std::vector<int64_t> parts) {
    if (!parts.empty()) {
        is_part_.insert(parts.begin(), parts.end());
        if (std::ranges::any_of(parts, [this](int64_t part) { return approximated_.contains(part); })) {
            approximated_.insert(pointer);
        }
        parts_[pointer] = std::move(parts);
    }
}

std::span<const int64_t> Geometry::parts(int64_t pointer) const noexcept {
    const auto found = parts_.find(pointer);
    return found == parts_.end() ? std::span<const int64_t>() : found->second;
}

std::string Geometry::name(int64_t pointer) const {
    const auto found = names_.find(pointer);
    return found == names_.end() ? std::string() : found->second;
}

} // namespace nrb::io::iges
