// SPDX-License-Identifier: MIT
// Curves and surfaces as they are written: what they were in a file, they are again.
#pragma once

#include "io/step/write/exchange_text.h"
#include "model/shapes/surface_shape.h"

#include <optional>

namespace nrb::io::step {

class GeometryWriter {
public:
    // Lengths are multiplied by `length`.
    GeometryWriter(ExchangeText &text, double length) noexcept : text_(text), length_(length) {}

    [[nodiscard]] ExchangeText &text() noexcept { return text_; }
    [[nodiscard]] double length() const noexcept { return length_; }

    int64_t point(const Vector3 &at);
    // With directions as they were given, so that the same frame is made of them.
    int64_t placement(const build::Placement &place);
    // Preconditions: check_writable() for splines. Curves of dimension 2 are in parameters, which have no unit.
    int64_t spline(const Spline &spline, std::string_view name = {});
    int64_t curve(const model::CurveShape &curve);
    int64_t surface(const model::SurfaceShape &surface);
    // A representation of an item that has no unit.
    int64_t in_parameters(int64_t item);
    // In the parameter plane of a surface.
    int64_t parameter_curve(const Spline &curve, int64_t surface);

private:
    int64_t direction(const Vector3 &way);
    int64_t vector(const Vector3 &way, double magnitude);
    int64_t trimmed(const model::CurvePiece &piece);
    int64_t composite(const model::CurveShape &curve);
    int64_t trimmed(const model::SurfaceShape &surface);
    int64_t torus(const model::SurfaceShape &surface);

    ExchangeText &text_;
    double length_;
    int64_t parameter_context_ = 0;
};

// Whether these can be written as what they are, so that they read back as the same: not offset surfaces, which are not read, and
// not parts of closed curves and surfaces whose ends do not name the same part again. Others have splines.
bool restatable(const model::CurveShape &curve);
bool restatable(const model::SurfaceShape &surface);

} // namespace nrb::io::step
