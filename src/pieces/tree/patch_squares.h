// SPDX-License-Identifier: MIT
// The tables for squaring patches of one shape.
#pragma once

#include "pieces/tree/patch_kernel.h"

#include <vector>

namespace nrb::pieces {

class PatchSquares {
public:
    explicit PatchSquares(const PatchShape &shape);

    [[nodiscard]] SquareTables tables() const noexcept {
        return {binomials_.data(), inverses_.data(), offsets_.data()};
    }
    // Error of a coefficient of |Q|^2, relative to the sum of the magnitudes of its terms.
    [[nodiscard]] double error() const noexcept { return error_; }

private:
    std::vector<double> binomials_, inverses_;
    std::vector<int32_t> offsets_;
    double error_ = 0;
};

} // namespace nrb::pieces
