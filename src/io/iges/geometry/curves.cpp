// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/iges/geometry/conics.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/polylines.h"
#include "io/iges/geometry/power_pieces.h"
#include "io/iges/geometry/spline.h"
#include "model/shapes/curve_spline.h"

namespace nrb::io::iges {

using model::CurvePiece;

constexpr int64_t size_of_a_piece = sizeof(CurvePiece) / sizeof(double);

bool is_curve(int type) noexcept {
    switch (type) {
    case circular_arc_type:
    case composite_type:
    case conic_arc_type:
    case copious_data_type:
    case line_type:
    case spline_pieces_type:
    case spline_curve_type:
    case offset_curve_type:
        return true;
    default:
        return false;
    }
}

CurvePiece Geometry::read_curve(Reading &reading) {
    auto &[entry, record, place, parts] = reading;
    const double tolerance = place.parameter_plane ? 0 : units_.resolution;
    switch (entry.type) {
    case circular_arc_type:
        return read_circular_arc(record, place);
    case composite_type:
        return composite(reading);
    case conic_arc_type:
        return read_conic_arc(record, place, entry.form);
    case copious_data_type:
        return read_polygon(record, place, entry.form);
    case line_type:
        return read_line(record, place, entry.form);
    case spline_pieces_type:
        return whole(model::curve_of_spline(read_spline_pieces(record, place, tolerance)));
    case spline_curve_type:
        return whole(model::curve_of_spline(build_spline(read_curve_data(record), place)));
    case offset_curve_type:
        return offset_curve(reading);
    default:
        fail(Status::unsupported, "does not become a curve in this version");
    }
}

// The curves of a composite curve. Its list may contain points as well, which are skipped.
std::vector<int64_t> Geometry::constituents(Reading &reading) {
    Record &record = reading.record;
    const int64_t count = record.integer("N");
    if (count < 1 || count > record.remaining()) {
        fail(Status::count, "N = %lld curves where the record has %lld more parameters",
             static_cast<long long>(count), static_cast<long long>(record.remaining()));
    }
    std::vector<int64_t> pointers;
    for (int64_t i = 0; i < count; ++i) {
        const int64_t pointer = record.integer("curve", i);
        const int type = entities_.at(pointer, "curve").type;
        reading.parts.push_back(pointer);
        if (type != point_type && type != connect_point_type) {
            pointers.push_back(pointer);
        }
    }
    if (pointers.empty()) {
        fail(Status::count, "N = %lld points, but no curve", static_cast<long long>(count));
    }
    return pointers;
}

CurvePiece Geometry::composite(Reading &reading) {
    std::vector<CurvePiece> pieces;
    for (const int64_t pointer : constituents(reading)) {
        pieces.push_back(any_curve(pointer, reading.outer(), reading.place.parameter_plane));
        entities_.spend(size_of(pieces.back()) + Entities::size_of_a_shape);
    }
    const double tolerance = reading.place.parameter_plane ? 0 : units_.resolution;
    return whole(model::composite_curve(std::move(pieces), tolerance));
}

std::vector<CurvePiece> Geometry::pieces(int64_t pointer, const Transform *outer, bool parameter_plane) {
    if (entities_.at(pointer, "curve").type != composite_type) {
        return {any_curve(pointer, outer, parameter_plane)};
    }
    return read(pointer, "curve", outer, parameter_plane, [&](Reading &reading) {
        std::vector<CurvePiece> all;
        for (const int64_t part : constituents(reading)) {
            std::vector<CurvePiece> more = pieces(part, reading.outer(), parameter_plane);
            entities_.spend(static_cast<int64_t>(more.size()) * size_of_a_piece);
            all.insert(all.end(), more.begin(), more.end());
        }
        return all;
    });
}

} // namespace nrb::io::iges
