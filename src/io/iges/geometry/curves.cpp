// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "build/polylines.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/spline.h"
#include "model/shapes/curve_spline.h"

#include <limits>

namespace nrb::io::iges {
namespace {

using model::CurveKind;
using model::CurvePiece;
using model::CurveShape;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<double, 3> read_point(Record &record, const char *name) {
    std::array<double, 3> x{};
    for (size_t i = 0; i < 3; ++i) {
        x[i] = record.real(name, static_cast<int64_t>(i));
    }
    return x;
}

// Through points of the coordinates [3].
SplinePtr segment(const std::array<double, 3> &a, const std::array<double, 3> &b, int dim) {
    std::vector<double> points(a.begin(), a.begin() + dim);
    points.insert(points.end(), b.begin(), b.begin() + dim);
    return build::polyline(dim, std::move(points), {0, 1});
}

// Without ends: the line is P + t s0 X.
CurvePiece long_line(const std::array<double, 3> &a, const std::array<double, 3> &b, const Placement &place,
                     bool half) {
    const Vector3 way = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    CurveShape line{CurveKind::line, {}, {length(way), 0}, nullptr, {}};
    line.place = direction_frame(a, way, place.dim());
    return {std::make_shared<const CurveShape>(std::move(line)), {half ? 0 : -infinity, infinity}, true};
}

// P1 + t (P2 - P1): form 0 from 0 to 1, form 1 from 0 on, form 2 without ends.
CurvePiece read_line(Record &record, const Placement &place, int64_t form) {
    const std::array<double, 3> a = place.point(read_point(record, "P1")),
                                b = place.point(read_point(record, "P2"));
    if (form < 0 || form > 2) {
        fail(Status::unsupported, "form %lld, expected 0, 1 or 2", static_cast<long long>(form));
    }
    return form == 0 ? whole(model::curve_of_spline(segment(a, b, place.dim())))
                     : long_line(a, b, place, form == 1);
}

} // namespace

bool is_curve(int type) noexcept {
    switch (type) {
    case line_type:
    case spline_curve_type:
        return true;
    default:
        return false;
    }
}

CurvePiece Geometry::read_curve(Reading &reading) {
    auto &[entry, record, place, parts] = reading;
    switch (entry.type) {
    case line_type:
        return read_line(record, place, entry.form);
    case spline_curve_type:
        return whole(model::curve_of_spline(build_spline(read_curve_data(record), place)));
    default:
        fail(Status::unsupported, "is not read as a curve in this version");
    }
}

} // namespace nrb::io::iges
