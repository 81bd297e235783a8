// SPDX-License-Identifier: MIT
// How far cubic curves are from a level and a surface, at many places at once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace nrb::intersect {

// Cubic Bernstein functions at samples, a multiple of 8 of them: [4][count].
class CubicSamples {
public:
    CubicSamples() = default;
    // Those at the n + 1 Chebyshev points (1 - cos(pi i / n)) / 2 of [0, 1]; the last one is repeated.
    explicit CubicSamples(int n);

    [[nodiscard]] size_t count() const noexcept { return functions_.size() / 4; }
    [[nodiscard]] const double *functions() const noexcept { return functions_.data(); }

private:
    std::vector<double> functions_;
};

// A function on [0, 1]^2 with `width` values: Bernstein coefficients [degrees[0] + 1][degrees[1] + 1][width].
struct SampledNet {
    std::array<int, 2> degrees{};
    const double *values = nullptr;
};

// A surface as records (w x, w y, w z, w), and f w: a form of the records, or a net of its own if there is none.
struct SampledPiece {
    SampledNet records;
    const double *form = nullptr; // [4]
    SampledNet net;
};

// Of two curves, in the parameter domain and in space: the largest |f w| on the first, and the largest |w (C - S)|.
struct LargestDifferences {
    double value = 0, gap = 0;
};

// work: 16 (p + 1) values for the largest degree p.
LargestDifferences largest_differences(const SampledPiece &piece, const CubicSamples &samples,
                                       const std::array<std::array<double, 2>, 4> &on,
                                       const std::array<std::array<double, 3>, 4> &space,
                                       double *work) noexcept;

} // namespace nrb::intersect
