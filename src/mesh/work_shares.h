// SPDX-License-Identifier: MIT
// Divides the work that is left among faces that are meshed one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nrb::mesh {

class WorkShares {
public:
    // `expected`: the work that each face is expected to take. Empty: every face may take all that is left.
    explicit WorkShares(std::vector<double> expected) : expected_(std::move(expected)) {}

    // Begins a round over the faces that are marked.
    void begin(const std::vector<bool> &faces) noexcept;
    // Runs mesh(), which meshes the next of these faces. It may take what the faces after it are not expected
    // to need, and in any case somewhat more than its own share of what is left. Returns whether that was
    // enough.
    [[nodiscard]] bool run(size_t face, const std::function<void()> &mesh);
    // The expected work of all faces of the round, extrapolated from what the ones so far took.
    [[nodiscard]] double expected() const noexcept { return taken_ + needed(); }
    // The same as a multiple of the work that was left when the round began.
    [[nodiscard]] double pressure() const noexcept { return expected_.empty() ? 0 : expected() / had_; }

private:
    [[nodiscard]] double needed() const noexcept; // by the faces that follow

    std::vector<double> expected_;
    double had_ = 1;              // work left when the round began
    double rest_ = 0;             // expected work of the faces that follow
    double done_ = 0, taken_ = 0; // expected work of the faces so far, and what they took
};

} // namespace nrb::mesh
