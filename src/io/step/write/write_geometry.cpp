// SPDX-License-Identifier: MIT
#include "io/step/write/write_geometry.h"

#include "io/step/write/write_spline.h"
#include "model/shapes/curve_spline.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::io::step {

using model::CurveKind;
using model::CurvePiece;
using model::CurveShape;
using model::SurfaceKind;
using model::SurfaceShape;

namespace {

bool given(const Vector3 &way) noexcept {
    return way.x != 0 || way.y != 0 || way.z != 0;
}

// As it is stored.
bool writable(const Spline &spline) noexcept {
    return spline.dim() == 3 && spline.form() != Form::homogeneous && spline.axis(0).degree() > 0;
}

// Whether the ends of a part of a curve name it again.
bool named_by_ends(const CurvePiece &piece) {
    const auto [curve, range, forward] = piece;
    if (!model::bounded(*curve) && range.lower < range.upper) {
        return true;
    }
    const CurvePiece again = model::piece_between(curve, forward ? range.lower : range.upper,
                                                  forward ? range.upper : range.lower, forward, 0);
    return same(again.range, range) && again.forward == forward;
}

// Around an axis, where a part may go on behind the seam: whether its ends name it again.
bool named_by_ends(Interval part, bool whole_turns) noexcept {
    const double sweep = part.upper - part.lower;
    return sweep > 0 && (!whole_turns || sweep <= model::turn);
}

} // namespace

bool restatable(const CurveShape &curve) {
    switch (curve.kind) {
    case CurveKind::spline:
        return writable(*curve.spline);
    case CurveKind::trimmed:
        return restatable(*curve.pieces.front().curve) && named_by_ends(curve.pieces.front());
    case CurveKind::composite:
        return std::ranges::all_of(curve.pieces, [](const CurvePiece &piece) {
            return restatable(*piece.curve) &&
                   (same(piece.range, model::natural_range(*piece.curve)) || named_by_ends(piece));
        });
    default:
        return true;
    }
}

bool restatable(const SurfaceShape &surface) {
    switch (surface.kind) {
    case SurfaceKind::offset:
        return false;
    case SurfaceKind::revolution:
    case SurfaceKind::extrusion:
        return restatable(*surface.curve);
    case SurfaceKind::trimmed: {
        const model::Rectangle all = model::natural_range(*surface.basis);
        return restatable(*surface.basis) && named_by_ends(surface.range.u, all.u.upper - all.u.lower > 6) &&
               named_by_ends(surface.range.v, all.v.upper - all.v.lower > 6);
    }
    default:
        return true;
    }
}

int64_t GeometryWriter::point(const Vector3 &at) {
    const double x[] = {length_ * at.x, length_ * at.y, length_ * at.z};
    return text_.add("CARTESIAN_POINT", no_name, Reals{x});
}

int64_t GeometryWriter::direction(const Vector3 &way) {
    const double x[] = {way.x, way.y, way.z};
    return text_.add("DIRECTION", no_name, Reals{x});
}

int64_t GeometryWriter::vector(const Vector3 &way, double magnitude) {
    const int64_t along = direction(way);
    return text_.add("VECTOR", no_name, Ref{along}, length_ * magnitude);
}

int64_t GeometryWriter::placement(const build::Placement &place) {
    const int64_t origin = point(place.origin),
                  axis = direction(given(place.given_axis) ? place.given_axis : place.z),
                  x = direction(given(place.given_x) ? place.given_x : place.x);
    return text_.add("AXIS2_PLACEMENT_3D", no_name, Ref{origin}, Ref{axis}, Ref{x});
}

int64_t GeometryWriter::spline(const Spline &spline, std::string_view name) {
    return write_spline(text_, spline, name, spline.dim() == 2 ? 1 : length_);
}

int64_t GeometryWriter::trimmed(const CurvePiece &piece) {
    const int64_t basis = curve(*piece.curve);
    const double from = piece.forward ? piece.range.lower : piece.range.upper,
                 to = piece.forward ? piece.range.upper : piece.range.lower;
    const auto at = [this](double t) {
        return [this, t] { text_.attribute(Measure{"PARAMETER_VALUE", t}); };
    };
    return text_.add("TRIMMED_CURVE", no_name, Ref{basis}, at(from), at(to), piece.forward,
                     Word{".PARAMETER."});
}

int64_t GeometryWriter::composite(const CurveShape &curve) {
    std::vector<int64_t> segments;
    for (const CurvePiece &piece : curve.pieces) {
        const bool whole = same(piece.range, model::natural_range(*piece.curve));
        const int64_t parent = whole ? this->curve(*piece.curve) : trimmed(piece);
        segments.push_back(
            text_.add("COMPOSITE_CURVE_SEGMENT", Word{".CONTINUOUS."}, !whole || piece.forward, Ref{parent}));
    }
    return text_.add("COMPOSITE_CURVE", no_name, Refs{segments}, not_told);
}

int64_t GeometryWriter::curve(const CurveShape &curve) {
    switch (curve.kind) {
    case CurveKind::line: {
        const int64_t start = point(curve.place.origin),
                      way = vector(given(curve.place.given_x) ? curve.place.given_x : curve.place.x,
                                   curve.sizes[0]);
        return text_.add("LINE", no_name, Ref{start}, Ref{way});
    }
    case CurveKind::circle:
        return text_.add("CIRCLE", no_name, Ref{placement(curve.place)}, length_ * curve.sizes[0]);
    case CurveKind::ellipse:
        return text_.add("ELLIPSE", no_name, Ref{placement(curve.place)}, length_ * curve.sizes[0],
                         length_ * curve.sizes[1]);
    case CurveKind::parabola:
        return text_.add("PARABOLA", no_name, Ref{placement(curve.place)}, length_ * curve.sizes[0]);
    case CurveKind::hyperbola:
        return text_.add("HYPERBOLA", no_name, Ref{placement(curve.place)}, length_ * curve.sizes[0],
                         length_ * curve.sizes[1]);
    case CurveKind::trimmed:
        return trimmed(curve.pieces.front());
    case CurveKind::composite:
        return composite(curve);
    default:
        return spline(*curve.spline);
    }
}

// A degenerate one has a part of v only, around 0 outside of the axis.
int64_t GeometryWriter::torus(const SurfaceShape &surface) {
    const int64_t place = placement(surface.place);
    const double radii[] = {length_ * surface.sizes[0], length_ * surface.sizes[1]};
    if (same(surface.range.v, {0, model::turn})) {
        return text_.add("TOROIDAL_SURFACE", no_name, Ref{place}, radii[0], radii[1]);
    }
    return text_.add("DEGENERATE_TOROIDAL_SURFACE", no_name, Ref{place}, radii[0], radii[1],
                     surface.range.v.lower < 0);
}

int64_t GeometryWriter::trimmed(const SurfaceShape &surface) {
    const int64_t basis = this->surface(*surface.basis);
    const auto unit = [&](int axis) {
        return model::measure_of(*surface.basis, axis) == model::Measure::length ? length_ : 1;
    };
    const auto ends = [](Interval range, bool forward, double factor) {
        return forward ? std::array{factor * range.lower, factor * range.upper}
                       : std::array{factor * range.upper, factor * range.lower};
    };
    const auto u = ends(surface.range.u, surface.u_forward, unit(0)),
               v = ends(surface.range.v, surface.v_forward, unit(1));
    return text_.add("RECTANGULAR_TRIMMED_SURFACE", no_name, Ref{basis}, u[0], u[1], v[0], v[1],
                     surface.u_forward, surface.v_forward);
}

int64_t GeometryWriter::surface(const SurfaceShape &surface) {
    const build::Placement &place = surface.place;
    switch (surface.kind) {
    case SurfaceKind::plane:
        return text_.add("PLANE", no_name, Ref{placement(place)});
    case SurfaceKind::cylinder:
        return text_.add("CYLINDRICAL_SURFACE", no_name, Ref{placement(place)}, length_ * surface.sizes[0]);
    case SurfaceKind::cone:
        return text_.add("CONICAL_SURFACE", no_name, Ref{placement(place)}, length_ * surface.sizes[0],
                         surface.sizes[1]);
    case SurfaceKind::sphere:
        return text_.add("SPHERICAL_SURFACE", no_name, Ref{placement(place)}, length_ * surface.sizes[0]);
    case SurfaceKind::torus:
        return torus(surface);
    case SurfaceKind::revolution: {
        const int64_t profile = curve(*surface.curve), origin = point(place.origin),
                      along = direction(given(place.given_axis) ? place.given_axis : place.z),
                      axis = text_.add("AXIS1_PLACEMENT", no_name, Ref{origin}, Ref{along});
        return text_.add("SURFACE_OF_REVOLUTION", no_name, Ref{profile}, Ref{axis});
    }
    case SurfaceKind::extrusion: {
        const int64_t profile = curve(*surface.curve),
                      way = vector(surface.vector, nrb::length(surface.vector));
        return text_.add("SURFACE_OF_LINEAR_EXTRUSION", no_name, Ref{profile}, Ref{way});
    }
    case SurfaceKind::trimmed:
        return trimmed(surface);
    default:
        return spline(*surface.spline);
    }
}

// Without units.
int64_t GeometryWriter::in_parameters(int64_t item) {
    if (parameter_context_ == 0) {
        parameter_context_ = text_.begin_complex();
        text_.part("GEOMETRIC_REPRESENTATION_CONTEXT", 2);
        text_.part("PARAMETRIC_REPRESENTATION_CONTEXT");
        text_.part("REPRESENTATION_CONTEXT", Text{"2D SPACE"}, no_name);
        text_.end_complex();
    }
    const int64_t items[] = {item};
    return text_.add("DEFINITIONAL_REPRESENTATION", no_name, Refs{items}, Ref{parameter_context_});
}

int64_t GeometryWriter::parameter_curve(const Spline &curve, int64_t surface) {
    const int64_t plane = in_parameters(write_spline(text_, curve, {}, 1));
    return text_.add("PCURVE", no_name, Ref{surface}, Ref{plane});
}

} // namespace nrb::io::step
