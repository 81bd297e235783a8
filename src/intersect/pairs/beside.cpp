// SPDX-License-Identifier: MIT
#include "intersect/pairs/beside.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/norm.h"

#include <cmath>

namespace nrb::intersect {

namespace {

// 1 or -1: the sign of a derivative that has no zero and nowhere is much smaller than elsewhere; else 0.
int sign_of(Interval slopes) noexcept {
    constexpr double most = 16;
    return slopes.lower > 0 && slopes.upper < most * slopes.lower   ? 1
           : slopes.upper < 0 && slopes.lower > most * slopes.upper ? -1
                                                                    : 0;
}

// The range of the values between those at both ends.
Interval rising(double start, double end) noexcept {
    return {std::min(start, end), std::max(start, end)};
}

} // namespace

void Beside::set(const pieces::BezierPiece &a, const pieces::Slopes &slopes_a, const pieces::BezierPiece &b,
                 const pieces::Slopes &slopes_b) {
    a_ = &a;
    b_ = &b;
    of_a_ = &slopes_a;
    of_b_ = &slopes_b;
    direction_ = 0;
    const int dim = a.dim();
    d_.assign(slopes_a.mean(), slopes_a.mean() + dim);
    const double length = norm(d_.data(), dim);
    if (!(length > 0)) {
        return;
    }
    for (double &x : d_) {
        x /= length;
    }
    const Interval along_a = slopes_a.along(d_.data());
    if (sign_of(along_a) == 1) {
        const Interval along_b = slopes_b.along(d_.data());
        direction_ = sign_of(along_b);
        least_a_ = along_a.lower;
        least_b_ = direction_ > 0 ? along_b.lower : -along_b.upper;
        const auto value = [&](const pieces::BezierPiece &piece, int64_t i) {
            return dot(d_.data(), piece.point(i), dim);
        };
        values_a_ = {value(a, 0), value(a, a.coefficients() - 1)};
        values_b_ = rising(value(b, 0), value(b, b.coefficients() - 1));
    }
}

// Slopes are quotients of linear functions of the derivative, so over its hull they are extreme at the
// vertices.
Interval Beside::slopes(const pieces::Slopes &of, double least) const noexcept {
    Interval slopes{infinity, -infinity};
    double steepest = 0;
    for (size_t i = 0; i < of.count(); ++i) {
        const double *v = of.vector(i);
        const double slope = (d_[0] * v[1] - d_[1] * v[0]) / (d_[0] * v[0] + d_[1] * v[1]);
        slopes = {std::min(slopes.lower, slope), std::max(slopes.upper, slope)};
        steepest = std::max(steepest, std::abs(slope));
    }
    const double room = 1.01 * (1 + steepest) * of.error() / least + 8 * eps * (1 + steepest);
    return {slopes.lower - room, slopes.upper + room};
}

Interval Beside::common() const noexcept {
    return {std::max(values_a_.lower, values_b_.lower), std::min(values_a_.upper, values_b_.upper)};
}

double Beside::rounding() const noexcept {
    return a_->moved() + b_->moved() + 8 * (a_->dim() + 2) * eps * (a_->reach() + b_->reach());
}

// Newton's method from the secant, safeguarded by bisection: values only rise, or only fall, along the piece.
double Beside::place(const pieces::BezierPiece &piece, int direction, double value) {
    const int p = piece.degree(0), dim = piece.dim();
    given_.clear(); // (x . d - value) w
    for (int i = 0; i <= p; ++i) {
        const double *record = piece.record(i);
        given_.push_back(direction * (dot(d_.data(), record, dim) - value * record[dim]));
    }
    // A value within rounding of that at an end means the end.
    if (given_.front() >= -rounding() * piece.weight(0)) {
        return 0;
    }
    if (given_.back() <= rounding() * piece.weight(p)) {
        return 1;
    }
    constexpr int most_steps = 100;
    Interval room{0, 1};
    double at = given_.front() / (given_.front() - given_.back());
    for (int i = 0; i < most_steps && room.upper - room.lower > 2 * eps; ++i) {
        f_ = given_;
        count_work(2 * (p + 1) * (p + 1));
        for (int level = p; level > 1; --level) {
            casteljau_step(level, 1, at, f_.data());
        }
        const double here = (1 - at) * f_[0] + at * f_[1], slope = p * (f_[1] - f_[0]);
        (here < 0 ? room.lower : room.upper) = at;
        const double next = at - here / slope;
        if (std::abs(next - at) <= eps) {
            break;
        }
        at = next > room.lower && next < room.upper ? next : room.lower / 2 + room.upper / 2;
    }
    return at;
}

Beside::Places Beside::at(Interval values) {
    const double first = place(*b_, direction_, values.lower), last = place(*b_, direction_, values.upper);
    return {{place(*a_, 1, values.lower), place(*a_, 1, values.upper)}, {first, last}};
}

std::optional<Beside::Places> Beside::near(double near) {
    const Interval both = common();
    const double reach = 1.0001 * near + 2 * rounding();
    if (both.lower - reach > both.upper) {
        return {};
    }
    // Beyond the end of one piece the other one may be near for as long as that.
    return at({std::min(both.lower, both.upper) - reach, std::max(both.lower, both.upper) + reach});
}

Beside::Match Beside::match() {
    const Interval both = common();
    const double middle = both.lower / 2 + both.upper / 2;
    return {at(both), place(*a_, 1, middle), place(*b_, direction_, middle)};
}

} // namespace nrb::intersect
