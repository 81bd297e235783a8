#include "build/revolve.h"

#include "base/checked.h"
#include "base/representable.h"
#include "base/wide.h"
#include "build/arc.h"

#include <algorithm>
#include <array>

namespace nrb {

namespace {

using Point = std::array<Wide, 3>;

Wide dot(const Point &a, const Point &b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A line, and where points are seen from it.
struct Line {
    Point origin;
    Point along;  // of any length
    Wide squared; // its square
    Wide length;
};

// A control point's parts across the axis: d from its foot, and Z x d.
struct Radius {
    Point d;
    Point across;
};

Line make_line(const double *point, const double *axis) {
    Line line{};
    if (point != nullptr) {
        check_point(point, 3, "point");
        std::copy_n(point, 3, line.origin.begin());
    }
    Vector3 along{0, 0, 1};
    if (axis != nullptr) {
        check_direction(axis, 3, "axis");
        along = scaled_to_one({axis[0], axis[1], axis[2]});
    }
    line.along = {along.x, along.y, along.z};
    line.squared = dot(line.along, line.along);
    line.length = square_root(line.squared);
    return line;
}

// Of a point of weight w, multiplied by it; w may be 0.
Radius radius_of(const Line &line, const double *point, double w) noexcept {
    Point seen;
    for (size_t c = 0; c < 3; ++c) {
        seen[c] = Wide(point[c]) - Wide(w) * line.origin[c];
    }
    const Wide part = dot(seen, line.along) / line.squared;
    Radius radius;
    for (size_t c = 0; c < 3; ++c) {
        const size_t next = (c + 1) % 3, last = (c + 2) % 3;
        radius.d[c] = seen[c] - part * line.along[c];
        radius.across[c] = (line.along[next] * seen[last] - line.along[last] * seen[next]) / line.length;
    }
    return radius;
}

class Turning {
public:
    Turning(const Spline &spline, const Line &line)
        : spline_(spline), line_(line), homogeneous_(spline.form() == Form::homogeneous) {
        radii_.reserve(static_cast<size_t>(spline.point_count()));
        for (int64_t i = 0; i < spline.point_count(); ++i) {
            radii_.push_back(radius_of(line_, point(i), homogeneous_ ? spline.weight(i) : 1));
        }
    }

    // Appends the control points at one of the arc.
    void add_layer(const ArcPoint &at, std::vector<double> &points) const {
        const double factor = homogeneous_ ? at.weight : 1;
        for (int64_t i = 0; i < spline_.point_count(); ++i) {
            const Radius &radius = radii_[static_cast<size_t>(i)];
            for (size_t c = 0; c < 3; ++c) {
                const Wide foot = Wide(point(i)[c]) - radius.d[c];
                const Wide turned = foot + (Wide(at.x) * radius.d[c] + Wide(at.y) * radius.across[c]);
                points.push_back((Wide(factor) * turned).value());
            }
            if (homogeneous_) {
                points.push_back(factor * spline_.weight(i));
            }
        }
    }
    void add_weights(double factor, std::vector<double> &weights) const {
        for (int64_t i = 0; i < spline_.point_count(); ++i) {
            weights.push_back(factor * spline_.weight(i));
        }
    }

private:
    [[nodiscard]] const double *point(int64_t i) const noexcept {
        return spline_.points().data() + i * spline_.stored_width();
    }

    const Spline &spline_;
    const Line &line_;
    bool homogeneous_;
    std::vector<Radius> radii_;
};

void check_turned(const Spline &spline) {
    if (spline.axes() == max_axes) {
        fail(NURBS_ERROR_AXES, "g has %d axes, expected 1 or 2", spline.axes());
    }
    if (spline.dim() != 3) {
        fail(NURBS_ERROR_DIMENSION, "dimension %d of g, expected 3", spline.dim());
    }
}

std::vector<double> turned_points(const Spline &spline, const Line &line, const Arc &arc, bool closed) {
    const std::span<const double> start = spline.points();
    std::vector<double> points(start.begin(), start.end());
    points.reserve(static_cast<size_t>(checked_product(std::ssize(start), std::ssize(arc.points), "points") +
                                       Spline::padding));
    const Turning turning(spline, line);
    for (size_t j = 1; j < arc.points.size() - (closed ? 1 : 0); ++j) {
        turning.add_layer(arc.points[j], points);
    }
    if (closed) {
        points.insert(points.end(), start.begin(), start.end());
    }
    require_representable(points, "control points");
    return points;
}

} // namespace

SplinePtr revolve(const Spline &spline, const double *point, const double *axis, double sweep, int32_t form) {
    check_turned(spline);
    const Line line = make_line(point, axis);
    const Turn turn = make_turn(0, sweep);
    const Arc arc = unit_arc(turn, form);
    std::vector<double> points = turned_points(spline, line, arc, turn.sweep.full_turn()), weights;
    if (spline.form() != Form::homogeneous) {
        for (const ArcPoint &at : arc.points) {
            for (int64_t i = 0; i < spline.point_count(); ++i) {
                weights.push_back(at.weight * spline.weight(i));
            }
        }
    }
    Spline::Axes axes = spline.knot_vectors();
    axes.insert(axes.begin(), arc.axis);
    return make_spline(std::move(axes), 3, std::max(spline.form(), Form::rational), std::move(points),
                       std::move(weights));
}

} // namespace nrb
