// SPDX-License-Identifier: MIT
// Limits on what is made of a file whose entities refer to each other, however often and however deeply they
// do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace nrb::io {

class Limits {
public:
    // `bytes`: the size of the file. `label`: the text before the number of an entity in messages.
    Limits(size_t bytes, const char *label) noexcept
        : label_(label), limit_(static_cast<int64_t>(bytes) * most_for_a_byte + most_at_least), left_(limit_),
          patches_(static_cast<int64_t>(bytes) / bytes_of_a_patch + patches_at_least) {}

    // The memory of a curve, a surface or a spline besides its numbers, in doubles.
    static constexpr int64_t size_of_a_shape = 160;

    // Counts numbers that are made from the file. Throws Status::too_large beyond the limit: entities that
    // refer to each other often could turn a small file into any amount of numbers.
    void spend(int64_t doubles);
    // How many more numbers may be made.
    [[nodiscard]] int64_t left() const noexcept { return left_; }
    // How many more patches of offset surfaces may be examined; limited for the same reason.
    [[nodiscard]] int64_t &patches() noexcept { return patches_; }

    // Sets the number of offset surfaces in the file.
    void share_among(int64_t offsets) noexcept { offsets_ = offsets; }
    // How many patches the next offset surface may have, so that some are left for the others.
    [[nodiscard]] int64_t patches_of_next() noexcept;

    // A guard that exists while an entity is being read. The constructor throws Status::syntax if that entity
    // is being read already, which means a cycle of references, or if references are nested too deeply.
    class Visit {
    public:
        Visit(Limits &limits, int64_t number);
        ~Visit() { --limits_.depth_; }
        Visit(const Visit &) = delete;
        Visit &operator=(const Visit &) = delete;

    private:
        Limits &limits_;
    };

private:
    static constexpr int deepest = 24;
    static constexpr int64_t most_for_a_byte = 6; // doubles
    static constexpr int64_t most_at_least = 1 << 16;
    static constexpr int64_t bytes_of_a_patch = 16; // a patch takes some hundredths of a millisecond
    static constexpr int64_t patches_at_least = 1 << 15;
    static constexpr int64_t least_patches = 64;      // for each surface, even if there are many
    static constexpr int64_t doubles_of_a_patch = 27; // nine control points
    static constexpr int64_t doubles_of_a_patch_meanwhile =
        80; // while it is made: with the patches from which it was cut, and the proof

    const char *label_;
    int64_t limit_;
    int64_t left_;
    int64_t patches_;
    int64_t offsets_ = 1; // offset surfaces that are still to come
    int depth_ = 0;
    std::array<int64_t, deepest> path_{};
};

} // namespace nrb::io
