// SPDX-License-Identifier: MIT
// The work that is left, divided among faces that are meshed one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nrb::mesh {

class WorkShares {
public:
    // What is expected of each face. Empty: every face may take all that is left.
    explicit WorkShares(std::vector<double> expected) : expected_(std::move(expected)) {}

    // A round over some faces.
    void begin(const std::vector<bool> &faces) noexcept;
    // One of these, as the next one, with what others are not expected to need, somewhat more than its share at least. Returns whether
    // that was enough.
    [[nodiscard]] bool run(size_t face, const std::function<void()> &mesh);
    // What the faces of the round take together, by what some took so far.
    [[nodiscard]] double expected() const noexcept { return taken_ + needed(); }
    // That as a multiple of what there was for them.
    [[nodiscard]] double pressure() const noexcept { return expected_.empty() ? 0 : expected() / had_; }

private:
    [[nodiscard]] double needed() const noexcept; // by those that follow

    std::vector<double> expected_;
    double had_ = 1;              // before this round
    double rest_ = 0;             // of what is expected in it
    double done_ = 0, taken_ = 0; // what was expected of faces so far, and what they took
};

} // namespace nrb::mesh
