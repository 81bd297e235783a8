// SPDX-License-Identifier: MIT
#include "io/binary/shape_table.h"

#include "io/binary/shape_fields.h"

namespace nrb::io {

namespace {

void put(ByteWriter &writer, const Vector3 &v) noexcept {
    writer.put(v.x);
    writer.put(v.y);
    writer.put(v.z);
}

void put(ByteWriter &writer, Interval range) noexcept {
    writer.put(range.lower);
    writer.put(range.upper);
}

void put_place(ByteWriter &writer, const build::Placement &place, bool given) noexcept {
    for (const Vector3 &v : {place.origin, place.x, place.y, place.z, place.x_rest, place.y_rest,
                             place.z_rest, place.given_axis, place.given_x}) {
        put(writer, given ? v : Vector3{});
    }
}

// `given`: how many sizes the kind uses. The others are written as 0.
void put_sizes(ByteWriter &writer, const double (&sizes)[2], int given) noexcept {
    writer.put(given > 0 ? sizes[0] : 0);
    writer.put(given > 1 ? sizes[1] : 0);
}

uint64_t flags_of(const model::SurfaceShape &shape) noexcept {
    return shape.kind != SurfaceKind::trimmed
               ? 0
               : (shape.u_forward ? forward_u : 0) | (shape.v_forward ? forward_v : 0);
}

} // namespace

int64_t ShapeTable::add(const model::CurveShapePtr &shape, SplineTable &splines) {
    if (shape == nullptr) {
        return -1;
    }
    if (const auto known = known_.find(shape.get()); known != known_.end()) {
        return known->second;
    }
    std::vector<PieceEntry> pieces;
    for (const model::CurvePiece &piece : shape->pieces) {
        pieces.push_back({add(piece.curve, splines), piece.range, piece.forward});
    }
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
    curves_.push_back({shape, has_spline(shape->kind) ? splines.add(shape->spline) : -1});
    return known_[shape.get()] = std::ssize(curves_) - 1;
}

int64_t ShapeTable::add(const model::SurfaceShapePtr &shape, SplineTable &splines) {
    if (shape == nullptr) {
        return -1;
    }
    if (const auto known = known_.find(shape.get()); known != known_.end()) {
        return known->second;
    }
    const int64_t curve = has_curve(shape->kind) ? add(shape->curve, splines) : -1;
    const int64_t basis = has_basis(shape->kind) ? add(shape->basis, splines) : -1;
    surfaces_.push_back(
        {shape, curve, basis, shape->kind == SurfaceKind::spline ? splines.add(shape->spline) : -1});
    return known_[shape.get()] = std::ssize(surfaces_) - 1;
}

size_t ShapeTable::size_in_bytes() const noexcept {
    return aligned(8 * words_of_piece * pieces_.size()) + aligned(8 * words_of_curve * curves_.size()) +
           aligned(8 * words_of_surface * surfaces_.size());
}

void ShapeTable::write(ByteWriter &writer) const noexcept {
    for (const PieceEntry &piece : pieces_) {
        writer.put(piece.curve);
        put(writer, piece.range);
        writer.put(uint64_t{piece.forward});
    }
    writer.align();
    write_curves(writer);
    write_surfaces(writer);
}

void ShapeTable::write_curves(ByteWriter &writer) const noexcept {
    for (const CurveEntry &entry : curves_) {
        const model::CurveShape &shape = *entry.shape;
        writer.put(static_cast<int64_t>(shape.kind));
        writer.put(int64_t{shape.place.dim});
        writer.put(entry.spline);
        writer.put(std::ssize(shape.pieces));
        put_place(writer, shape.place, has_place(shape.kind));
        put_sizes(writer, shape.sizes, sizes_of(shape.kind));
    }
    writer.align();
}

void ShapeTable::write_surfaces(ByteWriter &writer) const noexcept {
    for (const SurfaceEntry &entry : surfaces_) {
        const model::SurfaceShape &shape = *entry.shape;
        const bool trimmed = shape.kind == SurfaceKind::trimmed;
        writer.put(static_cast<int64_t>(shape.kind));
        writer.put(entry.curve);
        writer.put(entry.basis);
        writer.put(entry.spline);
        writer.put(flags_of(shape));
        put_place(writer, shape.place, has_place(shape.kind));
        put_sizes(writer, shape.sizes, sizes_of(shape.kind));
        put(writer, trimmed ? shape.range.u : Interval{});
        put(writer, trimmed || shape.kind == SurfaceKind::torus ? shape.range.v : Interval{});
        put(writer, shape.kind == SurfaceKind::extrusion ? shape.vector : Vector3{});
        writer.put(shape.kind == SurfaceKind::offset ? shape.distance : 0);
    }
    writer.align();
}

} // namespace nrb::io
