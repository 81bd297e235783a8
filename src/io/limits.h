// SPDX-License-Identifier: MIT
// What may be made of a file whose entities name each other, however often and however deep they do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace nrb::io {

class Limits {
public:
    // `bytes`: the size of the file; `label`: what stands before the number of an entity in messages.
    Limits(size_t bytes, const char *label) noexcept
        : label_(label), limit_(static_cast<int64_t>(bytes) * most_for_a_byte + most_at_least), left_(limit_),
          patches_(static_cast<int64_t>(bytes) / bytes_of_a_patch + patches_at_least) {}

    // What a curve, a surface or a spline takes besides its numbers, in doubles.
    static constexpr int64_t size_of_a_shape = 160;

    // Numbers that are made from the file. Entities that name each other often could make any amount of them from a
    // small file; throws Status::too_large before that.
    void spend(int64_t doubles);
    // How many of them are left.
    [[nodiscard]] int64_t left() const noexcept { return left_; }
    // Patches of offset surfaces that may still be looked at, for the same reason.
    [[nodiscard]] int64_t &patches() noexcept { return patches_; }

    // So many offset surfaces are in the file.
    void share_among(int64_t offsets) noexcept { offsets_ = offsets; }
    // How many patches the next one may have, so that something is left for the others.
    [[nodiscard]] int64_t patches_of_next() noexcept;

    // While one exists, its entity is being read. Throws Status::syntax if it is being read already, or lies too deep.
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
    static constexpr int64_t bytes_of_a_patch = 16; // each takes some hundredths of a millisecond
    static constexpr int64_t patches_at_least = 1 << 15;
    static constexpr int64_t least_patches = 64;      // rather than fewer for each of many
    static constexpr int64_t doubles_of_a_patch = 27; // nine control points
    static constexpr int64_t doubles_of_a_patch_meanwhile =
        80; // with the patches before it was cut, and the proof

    const char *label_;
    int64_t limit_;
    int64_t left_;
    int64_t patches_;
    int64_t offsets_ = 1; // that are to come
    int depth_ = 0;
    std::array<int64_t, deepest> path_{};
};

} // namespace nrb::io
