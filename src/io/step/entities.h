// SPDX-License-Identifier: MIT
// Instances that are read when they are needed: what they name is followed with a guard against cycles and depth,
// and within a limit of what may be made of a file.
#pragma once

#include "io/step/structure/attributes.h"

#include <array>

namespace nrb::io::step {

// The measures of a context, as factors to the units that are wanted.
struct Units {
    double length = 1;    // to the unit of the model
    double angle = 1;     // to radians
    double tolerance = 0; // distances below it count as none; 0: not stated. In the unit of the model
};

class Entities {
public:
    explicit Entities(const Instances &instances) : instances_(instances) {
        const auto size = static_cast<int64_t>(instances.text().size());
        left_ = limit_ = size * most_for_a_byte + most_at_least;
        patches_ = size / bytes_of_a_patch + patches_at_least;
    }

    [[nodiscard]] const Instances &instances() const noexcept { return instances_; }

    // The instance that an attribute names. Throws Status::syntax if the file has none.
    const Instance &at(int64_t number, const Attributes &owner, const char *attribute) const;
    // The same, which has to be of a kind; `expected` says of which.
    const Instance &at(int64_t number, Kind kind, const Attributes &owner, const char *attribute,
                       const char *expected) const;
    [[noreturn]] void fail_kind(const Instance &found, const Attributes &owner, const char *attribute,
                                const char *expected) const;

    // What a curve, a surface or a spline takes besides its numbers, in doubles.
    static constexpr int64_t size_of_a_shape = 160;

    // Numbers that are made from the file. Instances that name each other often could make any amount of them from a
    // small file; throws Status::too_large before that.
    void spend(int64_t doubles);

    // How many of them are left.
    [[nodiscard]] int64_t left() const noexcept { return left_; }
    // Patches of offset surfaces that may still be looked at, for the same reason.
    [[nodiscard]] int64_t &patches() noexcept { return patches_; }

    // While one exists, its instance is being read. Throws Status::syntax if it is being read already, or lies too deep.
    class Visit {
    public:
        Visit(Entities &entities, const Instance &instance);
        ~Visit() { --entities_.depth_; }
        Visit(const Visit &) = delete;
        Visit &operator=(const Visit &) = delete;

    private:
        Entities &entities_;
    };

private:
    static constexpr int deepest = 24;
    static constexpr int64_t most_for_a_byte = 6; // doubles
    static constexpr int64_t most_at_least = 1 << 16;
    static constexpr int64_t bytes_of_a_patch = 256; // each takes some tenths of a millisecond
    static constexpr int64_t patches_at_least = 1 << 13;

    const Instances &instances_;
    int64_t limit_;
    int64_t left_;
    int64_t patches_;
    int depth_ = 0;
    std::array<int64_t, deepest> path_{};
};

} // namespace nrb::io::step
