// SPDX-License-Identifier: MIT
#include "io/binary/shape_reader.h"

#include "base/error.h"
#include "io/binary/checked_numbers.h"
#include "io/binary/shape_fields.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::io {

namespace {

using model::CurveShape;
using model::SurfaceShape;

// The deepest nesting of shapes. It bounds the depth of recursion of all functions that follow shapes.
constexpr int deepest = 64;
// How far the axes of a frame may be from unit vectors at right angles: rounding.
constexpr double frame_error = 1e-12;

Vector3 vector_from(ByteReader &reader, const char *what) {
    double x[3];
    finite_from(reader, x, what);
    return {x[0], x[1], x[2]};
}

void check_frame(const build::Placement &place) {
    const double off[] = {dot(place.x, place.x) - 1, dot(place.y, place.y) - 1, dot(place.z, place.z) - 1,
                          dot(place.x, place.y),     dot(place.x, place.z),     dot(place.y, place.z)};
    for (const double error : off) {
        if (!(std::abs(error) <= frame_error)) {
            fail(Status::direction, "the axes of a shape are no unit vectors at right angles, by %s",
                 Number(error).text);
        }
    }
    for (const Vector3 &rest : {place.x_rest, place.y_rest, place.z_rest}) {
        if (!(largest(rest) <= frame_error)) {
            fail(Status::direction, "what rounding left out of an axis of a shape is %s",
                 Number(largest(rest)).text);
        }
    }
}

// Checks the directions of which the frame was made; a direction that is 0 was not given. The third axis is
// along given_axis. The first axis is along the part of given_x that is perpendicular to the third axis.
void check_given(const build::Placement &place) {
    const Vector3 &axis = place.given_axis, &way = place.given_x;
    const double tilt = largest(axis) > 0 ? largest(unit(axis) - place.z) : 0;
    const double turned =
        largest(way) > 0 ? std::max(std::abs(dot(unit(way), place.y)), -dot(unit(way), place.x)) : 0;
    if (!(std::max(tilt, turned) <= frame_error)) {
        fail(Status::direction, "a direction given for an axis of a shape is off that by %s",
             Number(std::max(tilt, turned)).text);
    }
}

build::Placement place_from(ByteReader &reader, bool given, int dim) {
    build::Placement place{};
    for (Vector3 *v : {&place.origin, &place.x, &place.y, &place.z, &place.x_rest, &place.y_rest,
                       &place.z_rest, &place.given_axis, &place.given_x}) {
        *v = vector_from(reader, "a coordinate of the place of a shape");
    }
    if (given) {
        check_frame(place);
        check_given(place);
    } else {
        place = {};
    }
    place.dim = dim;
    return place;
}

Interval range_from(ByteReader &reader, bool given) {
    double ends[2];
    finite_from(reader, ends, "the end of a range");
    if (given && !(ends[0] < ends[1])) {
        fail(Status::empty_domain, "the range from %s to %s of a shape is empty", Number(ends[0]).text,
             Number(ends[1]).text);
    }
    return given ? Interval{ends[0], ends[1]} : Interval{};
}

void check_size(double size, bool zero) {
    if (!(size > 0) && !(zero && size == 0)) {
        fail(Status::length, "the size %s of a shape, expected one above 0", Number(size).text);
    }
}

int depth_of(int below) {
    if (below >= deepest) {
        fail(Status::syntax, "more than %d shapes lie in one another", deepest);
    }
    return below + 1;
}

SplinePtr spline_from(ByteReader &reader, const std::vector<SplinePtr> &splines, bool given, int axes,
                      int dim) {
    const int64_t index =
        index_from(reader, given ? 0 : -1, given ? std::ssize(splines) : 0, "the spline of a shape");
    if (!given) {
        return nullptr;
    }
    const SplinePtr &spline = splines[static_cast<size_t>(index)];
    check_kind(*spline, axes, "the spline of a shape");
    check_dimension(*spline, dim, dim, "the spline of a shape");
    return spline;
}

template <class Kind>
Kind kind_from(ByteReader &reader, Kind last) {
    return static_cast<Kind>(index_from(reader, 0, static_cast<int64_t>(last) + 1, "the kind of a shape"));
}

void check_sizes(const SurfaceShape &shape) {
    const bool cone = shape.kind == SurfaceKind::cone;
    if (sizes_of(shape.kind) > 0) {
        check_size(shape.sizes[0], cone);
    }
    if (cone && !(std::abs(shape.sizes[1]) < std::numbers::pi / 2)) {
        fail(Status::angle, "half of the angle at the apex is %s, expected less than a quarter turn",
             Number(shape.sizes[1]).text);
    } else if (shape.kind == SurfaceKind::torus) {
        check_size(shape.sizes[1], false);
    }
}

} // namespace

ShapeReader::ShapeReader(ByteReader &reader, const ShapeSizes &sizes)
    : piece_reader_(reader.part(sizes.pieces, words_of_piece)),
      curve_reader_(reader.part(sizes.curves, words_of_curve)),
      surface_reader_(reader.part(sizes.surfaces, words_of_surface)), sizes_(sizes),
      pieces_left_(sizes.pieces) {}

void ShapeReader::make(const std::vector<SplinePtr> &splines) {
    for (int64_t i = 0; i < sizes_.curves; ++i) {
        curves_.push_back(next_curve(splines));
    }
    if (pieces_left_ > 0) {
        fail(Status::syntax, "%lld pieces belong to no curve", static_cast<long long>(pieces_left_));
    }
    for (int64_t i = 0; i < sizes_.surfaces; ++i) {
        surfaces_.push_back(next_surface(splines));
    }
}

model::CurveShapePtr ShapeReader::curve(int64_t index) const {
    return index < 0 ? nullptr : curves_[static_cast<size_t>(index)];
}

model::SurfaceShapePtr ShapeReader::surface(int64_t index) const {
    return index < 0 ? nullptr : surfaces_[static_cast<size_t>(index)];
}

model::CurveShapePtr ShapeReader::next_curve(const std::vector<SplinePtr> &splines) {
    ByteReader &reader = curve_reader_;
    CurveShape shape{kind_from(reader, CurveKind::composite), {}, {0, 0}, nullptr, {}};
    const auto dim = static_cast<int>(index_from(reader, 2, 4, "the dimension of a shape"));
    shape.spline = spline_from(reader, splines, has_spline(shape.kind), 1, dim);
    const bool one = shape.kind == CurveKind::trimmed, some = shape.kind == CurveKind::composite;
    const int64_t least = one || some ? 1 : 0, most = some ? pieces_left_ : least;
    const int64_t count = index_from(reader, least, most + 1, "the number of pieces of a shape");
    int depth = 0;
    shape.pieces = next_pieces(count, dim, depth);
    shape.place = place_from(reader, has_place(shape.kind), dim);
    finite_from(reader, shape.sizes, "the size of a shape");
    for (int k = 0; k < sizes_of(shape.kind); ++k) {
        check_size(shape.sizes[k], false);
    }
    curve_depths_.push_back(depth_of(depth));
    return std::make_shared<const CurveShape>(std::move(shape));
}

std::vector<model::CurvePiece> ShapeReader::next_pieces(int64_t count, int dim, int &depth) {
    if (count > pieces_left_) {
        fail(Status::syntax, "%lld pieces of a curve, of %lld that are left", static_cast<long long>(count),
             static_cast<long long>(pieces_left_));
    }
    pieces_left_ -= count;
    std::vector<model::CurvePiece> pieces;
    for (int64_t i = 0; i < count; ++i) {
        const int64_t index = index_from(piece_reader_, 0, std::ssize(curves_), "the curve of a piece");
        const model::CurveShapePtr &basis = curves_[static_cast<size_t>(index)];
        const Interval range = range_from(piece_reader_, true);
        if (basis->place.dim != dim) {
            fail(Status::dimension, "a piece of dimension %d of a curve of dimension %d", basis->place.dim,
                 dim);
        }
        depth = std::max(depth, curve_depths_[static_cast<size_t>(index)]);
        pieces.push_back({basis, range, flags_from(piece_reader_, 1, "the direction of a piece") != 0});
    }
    return pieces;
}

model::SurfaceShapePtr ShapeReader::next_surface(const std::vector<SplinePtr> &splines) {
    ByteReader &reader = surface_reader_;
    SurfaceShape shape{kind_from(reader, SurfaceKind::trimmed),
                       {},
                       {0, 0},
                       {},
                       nullptr,
                       {},
                       nullptr,
                       0,
                       true,
                       true,
                       nullptr};
    const bool swept = has_curve(shape.kind), based = has_basis(shape.kind);
    const bool trimmed = shape.kind == SurfaceKind::trimmed;
    const int64_t curve =
        index_from(reader, swept ? 0 : -1, swept ? std::ssize(curves_) : 0, "the curve of a shape");
    const int64_t basis =
        index_from(reader, based ? 0 : -1, based ? std::ssize(surfaces_) : 0, "the basis of a shape");
    shape.spline = spline_from(reader, splines, shape.kind == SurfaceKind::spline, 2, 3);
    const uint64_t flags = flags_from(reader, forward_u | forward_v, "flags of a shape");
    shape.place = place_from(reader, has_place(shape.kind), 3);
    finite_from(reader, shape.sizes, "the size of a shape");
    check_sizes(shape);
    shape.range.u = range_from(reader, trimmed);
    shape.range.v = range_from(reader, trimmed || shape.kind == SurfaceKind::torus);
    shape.vector = vector_from(reader, "a coordinate of the vector of a shape");
    shape.distance = finite_from(reader, "the distance of a shape");
    shape.curve = this->curve(curve);
    shape.basis = surface(basis);
    if (swept && shape.curve->place.dim != 3) {
        fail(Status::dimension, "a curve in the plane that is swept");
    }
    if (trimmed) {
        shape.u_forward = (flags & forward_u) != 0;
        shape.v_forward = (flags & forward_v) != 0;
    }
    surface_depths_.push_back(depth_of(swept   ? curve_depths_[static_cast<size_t>(curve)]
                                       : based ? surface_depths_[static_cast<size_t>(basis)]
                                               : 0));
    return std::make_shared<const SurfaceShape>(std::move(shape));
}

} // namespace nrb::io
