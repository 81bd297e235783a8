// SPDX-License-Identifier: MIT
#include "io/iges/geometry/polylines.h"

#include "base/checked.h"
#include "base/error.h"
#include "build/polylines.h"
#include "io/iges/geometry/placed_splines.h"

#include "base/numbers.h"
#include <numeric>

namespace nrb::io::iges {
namespace {

using model::CurveKind;
using model::CurvePiece;
using model::CurveShape;

CurvePiece polyline(const std::vector<std::array<double, 3>> &corners, int dim) {
    std::vector<double> points, params(corners.size());
    for (const std::array<double, 3> &x : corners) {
        points.insert(points.end(), x.begin(), x.begin() + dim);
    }
    std::iota(params.begin(), params.end(), 0.0);
    return whole(model::curve_of_spline(build::polyline(dim, std::move(points), std::move(params))));
}

// A ray or an unbounded line.
CurvePiece long_line(const LineEnds &ends, int dim, bool half) {
    const auto &[a, b] = ends;
    const Vector3 way = {b[0] - a[0], b[1] - a[1], dim == 3 ? b[2] - a[2] : 0};
    CurveShape line{CurveKind::line, {}, {length(way), 0}, nullptr, {}};
    line.place = direction_frame(a, way, dim);
    return {std::make_shared<const CurveShape>(std::move(line)), {half ? 0 : -infinity, infinity}, true};
}

// The number of values of a point of copious data, by the interpretation flag: x and y, with one z for all;
// x, y and z; or x, y, z and a vector.
int64_t numbers_of_a_point(int64_t flag) {
    if (flag < 1 || flag > 3) {
        fail(Status::syntax, "interpretation flag %lld, expected 1, 2 or 3", static_cast<long long>(flag));
    }
    return flag == 1 ? 2 : 3 * (flag - 1);
}

void check_polygon_form(int64_t form) {
    constexpr int64_t paths = 11, last_path = 13, closed = 63;
    if (form >= 1 && form <= 3) {
        fail(Status::unsupported, "points without lines between them do not become a spline");
    }
    if (!(form >= paths && form <= last_path) && form != closed) {
        fail(Status::unsupported, "form %lld does not become a spline", static_cast<long long>(form));
    }
}

} // namespace

std::array<double, 3> read_point(Record &record, const char *name) {
    std::array<double, 3> x{};
    for (size_t i = 0; i < 3; ++i) {
        x[i] = record.real(name, static_cast<int64_t>(i));
    }
    return x;
}

LineEnds read_line_ends(Record &record, const Placement &place) {
    const std::array<double, 3> first = place.point(read_point(record, "P1"));
    return {first, place.point(read_point(record, "P2"))};
}

CurvePiece read_line(Record &record, const Placement &place, int64_t form) {
    const LineEnds ends = read_line_ends(record, place);
    if (form < 0 || form > 2) {
        fail(Status::unsupported, "form %lld, expected 0, 1 or 2", static_cast<long long>(form));
    }
    return form == 0 ? polyline({ends.first, ends.second}, place.dim())
                     : long_line(ends, place.dim(), form == 1);
}

CurvePiece read_polygon(Record &record, const Placement &place, int64_t form) {
    check_polygon_form(form);
    const int64_t flag = record.integer("interpretation flag"), numbers = numbers_of_a_point(flag);
    const int64_t count = record.integer("N");
    const double z = flag == 1 ? record.real("ZT") : 0;
    if (count < 2 || checked_product(count, numbers, "points") > record.remaining()) {
        fail(count < 2 ? Status::too_few_points : Status::count,
             "N = %lld points where the record has %lld more parameters", static_cast<long long>(count),
             static_cast<long long>(record.remaining()));
    }
    std::vector<std::array<double, 3>> corners;
    for (int64_t i = 0; i < count; ++i) {
        std::array<double, 3> x = {record.real("x", i), record.real("y", i), z};
        x[2] = flag == 1 ? z : record.real("z", i);
        record.skip(flag == 3 ? 3 : 0);
        corners.push_back(place.point(x));
    }
    return polyline(corners, place.dim());
}

} // namespace nrb::io::iges
