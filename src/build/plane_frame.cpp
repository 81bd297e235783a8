// SPDX-License-Identifier: MIT
#include "build/plane_frame.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::build {

namespace {

double length(std::span<const double> v) noexcept {
    return norm(v.data(), static_cast<int>(v.size()));
}

std::vector<double> scaled(std::vector<double> v, double factor) {
    for (double &x : v) {
        x *= factor;
    }
    return v;
}

// The component of v perpendicular to a unit vector. The second pass removes what cancellation leaves of the
// other component.
std::vector<double> across(std::vector<double> v, std::span<const double> unit) {
    for (int pass = 0; pass < 2; ++pass) {
        const double part = numeric::dot(v, unit);
        for (size_t i = 0; i < v.size(); ++i) {
            v[i] -= part * unit[i];
        }
    }
    return v;
}

// The power of two that brings a size near 1, but at most 2^1000; 1 for the size 0.
double power_of_two(double size) noexcept {
    return size > 0 ? std::ldexp(1.0, std::min(-std::ilogb(size), 1000)) : 1;
}

} // namespace

PlaneFrame::PlaneFrame(Coordinates first, Coordinates second, Coordinates third, const char *what)
    : origin_(first.begin(), first.end()), scale_(1) {
    const double size =
        std::max({largest_magnitude(first), largest_magnitude(second), largest_magnitude(third)});
    scale_ = power_of_two(std::max(largest_magnitude(offset(second)), largest_magnitude(offset(third))));
    rounding_ = 8 * eps * size * scale_;
    const std::vector<double> chord = offset(second), leg = offset(third);
    const double width = length(chord);
    u_ = width > 0 ? scaled(chord, 1 / width) : chord;
    const std::vector<double> high = across(leg, u_);
    const double height = length(high);
    if (!(std::min({width, height, length(leg)}) > rounding_)) {
        fail(Status::collinear,
             "%s are on a line, or two of them are equal, to within rounding: height %s over a chord of %s",
             what, Number(height / scale_).text, Number(width / scale_).text);
    }
    tilt_ = rounding_ / std::min(width, height);
    v_ = scaled(high, 1 / height);
    if (origin_.size() == 2) {
        u_ = {1, 0};
        v_ = {0, 1};
    }
}

std::vector<double> PlaneFrame::offset(Coordinates x) const {
    std::vector<double> v(x.begin(), x.end());
    for (size_t i = 0; i < v.size(); ++i) {
        v[i] = (v[i] - origin_[i]) * scale_;
    }
    return v;
}

double PlaneFrame::distance(std::span<const double> v) const {
    return length(across(across(std::vector<double>(v.begin(), v.end()), u_), v_));
}

Point2 PlaneFrame::point(Coordinates x) const {
    Point2 p;
    for (size_t i = 0; i < x.size(); ++i) {
        const DoubleDouble way = DoubleDouble::sum(x[i], -origin_[i]) * DoubleDouble(scale_);
        p = {p.x + way * DoubleDouble(u_[i]), p.y + way * DoubleDouble(v_[i])};
    }
    return p;
}

Point2 PlaneFrame::direction(Coordinates v) const {
    const double scale = power_of_two(largest_magnitude(v));
    Point2 p;
    for (size_t i = 0; i < v.size(); ++i) {
        const DoubleDouble part = v[i] * scale;
        p = {p.x + part * DoubleDouble(u_[i]), p.y + part * DoubleDouble(v_[i])};
    }
    return p;
}

void PlaneFrame::check_point(Coordinates x, const char *name) const {
    const std::vector<double> v = offset(x);
    const double out = distance(v);
    if (out > rounding_ + 4 * tilt_ * length(v)) {
        fail(Status::conic, "%s is %s away from the plane of the other points", name,
             Number(out / scale_).text);
    }
}

void PlaneFrame::check_direction(Coordinates v, const char *name) const {
    const std::vector<double> unit =
        scaled(std::vector<double>(v.begin(), v.end()), power_of_two(largest_magnitude(v)));
    const double out = distance(unit) / length(unit);
    if (out > 8 * eps + 4 * tilt_) {
        fail(Status::conic, "%s leaves the plane of the points: the sine of the angle is %s", name,
             Number(out).text);
    }
}

std::vector<double> PlaneFrame::vector(const Point2 &v) const {
    std::vector<double> out(origin_.size());
    for (size_t i = 0; i < out.size(); ++i) {
        out[i] = (v.x * DoubleDouble(u_[i]) + v.y * DoubleDouble(v_[i])).value() / scale_;
    }
    return out;
}

} // namespace nrb::build
