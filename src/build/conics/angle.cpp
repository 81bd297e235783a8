// SPDX-License-Identifier: MIT
#include "build/conics/angle.h"

#include "base/error.h"

#include <array>
#include <cmath>
#include <numbers>

namespace nrb::build {

namespace {

// pi / 12 as a sum of three doubles. The first two have at most 29 bits, so their products with a number of
// steps below 2^24 are exact.
constexpr double step = 0x1.0c152382d7366p-2; // pi / 12, rounded
constexpr double step_high = 0x1.0c15238p-2;
constexpr double step_low = step - step_high;
constexpr double step_rest = -0x1.ee6913347c2a6p-56; // pi / 12 - step

constexpr double largest_angle = 0x1p22; // less than 2^24 steps

constexpr std::array<Direction, 4> first_steps = {{{1, 0},
                                                   {0.96592582628906828675, 0.25881904510252076235},
                                                   {0.86602540378443864676, 0.5},
                                                   {0.70710678118654752440, 0.70710678118654752440}}};

// A direction rotated by quarter turns, without rounding.
Direction turned(Direction d, int64_t quarters) noexcept {
    switch (((quarters % 4) + 4) % 4) {
    case 1:
        return {0 - d.sin, d.cos};
    case 2:
        return {0 - d.cos, 0 - d.sin};
    case 3:
        return {d.sin, 0 - d.cos};
    default:
        return d;
    }
}

// The quarter turn (6 steps) nearest to a number of steps; halves are rounded up.
int64_t nearest_quarter(int64_t steps) noexcept {
    const int64_t shifted = steps + 3;
    return shifted >= 0 ? shifted / 6 : -((5 - shifted) / 6);
}

// The direction of -3, ..., 2 steps.
Direction exact_direction(int64_t steps) noexcept {
    const Direction d = first_steps[static_cast<size_t>(steps < 0 ? -steps : steps)];
    return steps < 0 ? Direction{d.cos, -d.sin} : d;
}

double rest_of(double radians, double steps) noexcept {
    return std::fma(-steps, step_high, radians) - steps * step_low - steps * step_rest;
}

} // namespace

Angle Angle::from_radians(double radians) noexcept {
    const double steps = std::nearbyint(radians / step);
    const double rest = rest_of(radians, steps);
    const double rounding = 4 * 0x1p-53 * std::fabs(radians);
    return {static_cast<int64_t>(steps), std::fabs(rest) <= rounding ? 0 : rest};
}

Angle Angle::plus(const Angle &other, int64_t numerator, int64_t denominator) const noexcept {
    const int64_t product = other.steps_ * numerator;
    const int64_t whole = product / denominator;
    if (whole * denominator == product && other.rest_ == 0) { // whole steps
        return {steps_ + whole, rest_};
    }
    const double fraction = static_cast<double>(product % denominator) / static_cast<double>(denominator);
    const double share = other.rest_ * static_cast<double>(numerator) / static_cast<double>(denominator);
    const double rest = fraction * step + (rest_ + share);
    const double more = std::nearbyint(rest / step);
    if (more == 0) {
        return {steps_ + whole, rest};
    }
    return {steps_ + whole + static_cast<int64_t>(more), rest_of(rest, more)};
}

Direction Angle::direction() const noexcept {
    const int64_t quarter = nearest_quarter(steps_);
    const int64_t steps = steps_ - 6 * quarter;
    if (rest_ == 0) {
        return turned(exact_direction(steps), quarter);
    }
    const double near = static_cast<double>(steps) * step + rest_;
    return turned({std::cos(near), std::sin(near)}, quarter);
}

double Angle::radians() const noexcept {
    return static_cast<double>(steps_) * step + rest_;
}

Angle make_angle(double radians, const char *name) {
    if (!std::isfinite(radians) || std::fabs(radians) > largest_angle) {
        fail(Status::angle, "%s = %s, expected a finite angle of at most 2^22", name, Number(radians).text);
    }
    return Angle::from_radians(radians);
}

Turn make_turn(double start, double sweep, const char *start_name, const char *sweep_name) {
    const Angle begin = make_angle(start, start_name);
    const Angle turn = make_angle(sweep, sweep_name);
    if (sweep == 0 || (std::fabs(sweep) > 2 * std::numbers::pi && !turn.full_turn())) {
        fail(Status::angle, "%s = %s, expected an angle that is not 0 and at most a full turn, %s",
             sweep_name, Number(sweep).text, Number(2 * std::numbers::pi).text);
    }
    return {begin, turn};
}

} // namespace nrb::build
