#include "bench/operations/task.h"
#include "support/handle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bench {

namespace {

using support::SplineData;
using Point = std::array<double, 3>;
constexpr double rounding = 1e-11; // far above what rounding can do, far below any mistake
constexpr int samples = 33;

void require_near(double found, double expected, const char *what) {
    if (!(std::abs(found - expected) <= rounding)) {
        throw std::runtime_error(std::string(what) + " is " + std::to_string(found) + ", expected " +
                                 std::to_string(expected));
    }
}

void require_near(const Point &found, const Point &expected) {
    for (size_t c = 0; c < 3; ++c) {
        require_near(found[c], expected[c], "a coordinate");
    }
}

// A spline over the unit square, or the unit interval.
class Shape {
public:
    explicit Shape(const SplineData &data) : data_(data), handle_(support::create(data)) {}

    [[nodiscard]] Point at(double s, double t = 0) const {
        std::vector<double> params = {in_domain(0, s)};
        if (data_.axes() == 2) {
            params.push_back(in_domain(1, t));
        }
        const std::vector<double> p = support::eval(handle_.get(), params);
        return {p[0], p[1], p[2]};
    }

private:
    [[nodiscard]] double in_domain(int axis, double s) const {
        return (1 - s) * data_.lower(axis) + s * data_.upper(axis);
    }

    SplineData data_;
    support::Handle handle_;
};

// f(s, t) on a grid of the unit square.
template <class F>
void on_grid(F &&f) {
    for (int i = 0; i < samples; ++i) {
        for (int j = 0; j < samples; ++j) {
            f(static_cast<double>(i) / (samples - 1), static_cast<double>(j) / (samples - 1));
        }
    }
}

// On the circle, and once around it.
void check_circle(const Shape &circle) {
    double turned = 0;
    Point last = circle.at(0);
    require_near(last, {circle_center[0] + circle_radius, circle_center[1], circle_center[2]});
    for (int i = 1; i < samples; ++i) {
        const Point p = circle.at(static_cast<double>(i) / (samples - 1));
        require_near(std::hypot(p[0] - circle_center[0], p[1] - circle_center[1]), circle_radius,
                     "the radius");
        require_near(p[2], circle_center[2], "the height");
        const double chord = std::hypot(p[0] - last[0], p[1] - last[1]);
        turned += 2 * std::asin(std::min(1.0, chord / (2 * circle_radius)));
        last = p;
    }
    require_near(turned, 2 * std::numbers::pi, "the angle turned");
}

// At the distance and height of the profile; half a turn in the middle.
void check_revolved(const Shape &surface, const Shape &profile) {
    on_grid([&](double s, double t) {
        const Point p = surface.at(s, t), q = profile.at(t);
        require_near(std::hypot(p[0], p[1]), std::hypot(q[0], q[1]), "the distance from the axis");
        require_near(p[2], q[2], "the height");
        require_near(surface.at(0, t), q);
        require_near(surface.at(0.5, t), {-q[0], -q[1], q[2]});
    });
}

// On the segment between the points of both curves, from the first to the second. How it is divided is free:
// Open CASCADE gives the weights of both curves the same mean.
void check_ruled(const Shape &surface, const Shape &a, const Shape &b) {
    on_grid([&](double s, double t) {
        const Point p = surface.at(s, t), from = a.at(s), to = b.at(s);
        double along = 0, length2 = 0;
        for (size_t c = 0; c < 3; ++c) {
            along += (p[c] - from[c]) * (to[c] - from[c]);
            length2 += (to[c] - from[c]) * (to[c] - from[c]);
        }
        const double part = along / length2;
        Point expected{};
        for (size_t c = 0; c < 3; ++c) {
            expected[c] = (1 - part) * from[c] + part * to[c];
        }
        require_near(p, expected);
        require_near(std::clamp(part, 0.0, 1.0), part, "the place on the ruling");
        if (t == 0 || t == 1) {
            require_near(part, t, "an end of the ruling");
        }
    });
}

void check_coons(const Shape &surface, const std::vector<SplineData> &boundaries) {
    const Shape left(boundaries[0]), right(boundaries[1]), low(boundaries[2]), high(boundaries[3]);
    on_grid([&](double s, double t) {
        const Point c0 = left.at(t), c1 = right.at(t), d0 = low.at(s), d1 = high.at(s);
        const Point p00 = left.at(0), p01 = left.at(1), p10 = right.at(0), p11 = right.at(1);
        Point expected{};
        for (size_t c = 0; c < 3; ++c) {
            expected[c] = (1 - s) * c0[c] + s * c1[c] + (1 - t) * d0[c] + t * d1[c] -
                          ((1 - s) * ((1 - t) * p00[c] + t * p01[c]) + s * ((1 - t) * p10[c] + t * p11[c]));
        }
        require_near(surface.at(s, t), expected);
    });
}

} // namespace

void check_made(const Task &task, const SplineData &result) {
    const Shape shape(result);
    switch (task.operation) {
    case Operation::circle:
        return check_circle(shape);
    case Operation::revolve:
        return check_revolved(shape, Shape(task.inputs[0]));
    case Operation::ruled:
        return check_ruled(shape, Shape(task.inputs[0]), Shape(task.inputs[1]));
    case Operation::coons:
        return check_coons(shape, task.inputs);
    default:
        throw std::runtime_error("not something new");
    }
}

} // namespace bench
