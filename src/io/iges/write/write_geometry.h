// SPDX-License-Identifier: MIT
// Curves and surfaces as they are written.
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

    // The pointers of the entities. Preconditions: check_writable().
    int64_t spline(const Spline &spline);
    // One that nothing else consists of, with a name; curves of dimension 2 are in a parameter plane, which has no unit.
    int64_t named_spline(const Spline &spline, std::string_view name, int64_t level);
    int64_t parameter_curve(const Spline &curve);
    // As what it is, if statable(); the parts of shapes are written once.
    int64_t curve(const model::CurvePiece &piece);
    int64_t surface(const model::SurfaceShape &surface);
    // Any affine map: of a rotation, form 0; of a mirror image, form 1.
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

// A straight line, of which readers make a spline over [0, 1].
bool is_line(const model::CurvePiece &piece) noexcept;
// Whether there is an entity for what these are. What is read of it may differ by rounding.
bool statable(const model::CurvePiece &piece);
bool statable(const model::SurfaceShape &surface);

} // namespace nrb::io::iges
