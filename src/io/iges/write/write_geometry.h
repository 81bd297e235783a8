// SPDX-License-Identifier: MIT
// Writes curves and surfaces.
#pragma once

#include "io/iges/write/file_text.h"
#include "model/shapes/surface_shape.h"

#include <map>

namespace nrb::io::iges {

class GeometryWriter {
public:
    // Lengths are multiplied by `length`.
    GeometryWriter(FileText &text, double length) noexcept : text_(text), length_(length) {}

    [[nodiscard]] FileText &text() noexcept { return text_; }
    [[nodiscard]] double length() const noexcept { return length_; }

    // Returns the pointer of the entity, as the functions below do. Precondition: check_writable().
    int64_t spline(const Spline &spline);
    // A spline that is not part of anything else, with a name; a curve of dimension 2 lies in a parameter
    // plane, which has no unit.
    int64_t named_spline(const Spline &spline, std::string_view name, int64_t level);
    int64_t parameter_curve(const Spline &curve);
    // Writes the shape as its own kind, if statable(); shared parts of shapes are written once.
    int64_t curve(const model::CurvePiece &piece);
    int64_t surface(const model::SurfaceShape &surface);
    // Any affine map: form 0 for a rotation, form 1 for a reflection.
    int64_t matrix(const std::array<double, 12> &rows);

private:
    int64_t point(const Vector3 &at);
    int64_t direction(const Vector3 &way);
    int64_t line(const Vector3 &from, const Vector3 &to);
    int64_t frame(const build::Placement &place);
    int64_t arc(const model::CurvePiece &piece);
    int64_t conic(const model::CurvePiece &piece);
    int64_t elementary(const model::SurfaceShape &surface);
    int64_t revolution(const model::SurfaceShape &surface, Interval angles);
    int64_t extrusion(const model::SurfaceShape &surface);

    FileText &text_;
    double length_;
    std::map<std::array<double, 12>, int64_t> matrices_;
};

// A straight line, from which readers make a spline over [0, 1].
bool is_line(const model::CurvePiece &piece) noexcept;
// Whether there is an entity for the shape. What is read back may differ by rounding.
bool statable(const model::CurvePiece &piece);
bool statable(const model::SurfaceShape &surface);

} // namespace nrb::io::iges
