// SPDX-License-Identifier: MIT
// Angles in which the multiples of 15 degrees are exact.
#pragma once

#include <cstdint>

namespace nrb::build {

struct Direction {
    double cos;
    double sin;
};

// An angle as a whole number of steps of 15 degrees (24ths of a turn) and a remainder of at most half a step.
class Angle {
public:
    // From radians. An angle that differs from a multiple of 15 degrees by at most 4 roundings (2^-53 of the
    // angle each) becomes that multiple. Precondition: |radians| is at most 2^22.
    static Angle from_radians(double radians) noexcept;
    static Angle quarters(int64_t quarters) noexcept { return {6 * quarters, 0}; }

    // this + (numerator / denominator) other. Precondition: 0 < denominator, |numerator| < 2^50.
    [[nodiscard]] Angle plus(const Angle &other, int64_t numerator, int64_t denominator) const noexcept;
    // (numerator / denominator) times this one.
    [[nodiscard]] Angle part(int64_t numerator, int64_t denominator) const noexcept {
        return Angle{0, 0}.plus(*this, numerator, denominator);
    }

    // Cosine and sine, each within eps of the true value for this angle. The values 0, +-1/2 and +-1 are
    // exact.
    [[nodiscard]] Direction direction() const noexcept;
    [[nodiscard]] double radians() const noexcept;
    [[nodiscard]] bool full_turn() const noexcept { return rest_ == 0 && (steps_ == 24 || steps_ == -24); }

private:
    Angle(int64_t steps, double rest) noexcept : steps_(steps), rest_(rest) {}

    int64_t steps_; // of 15 degrees
    double rest_;   // radians
};

// A range of angles: |sweep| is more than 0 and at most a full turn.
struct Turn {
    Angle start;
    Angle sweep;
};

inline Turn full_turn() noexcept {
    return {Angle::quarters(0), Angle::quarters(4)};
}

// Both throw Status::angle, naming the argument, for an angle that is not finite or whose magnitude exceeds
// 2^22; make_turn() also for a sweep that is 0 or more than a full turn.
Turn make_turn(double start, double sweep, const char *start_name = "start",
               const char *sweep_name = "sweep");
Angle make_angle(double radians, const char *name);

} // namespace nrb::build
