// SPDX-License-Identifier: MIT
// Square systems whose rows have few neighbouring entries, for many right-hand sides.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// L U without an exchange of rows. That is stable for totally positive matrices, such as those of B-splines at sites
// in their supports, and keeps the band (C. de Boor, A. Pinkus, "Backward error analysis for totally positive
// linear systems", Numer. Math. 27 (1977)). Memory: the band; cost: `below` times `above` for each row, `below +
// above` for each of its right-hand sides.
class BandedLu {
public:
    // Row i has its entries at columns i - below, ..., i + above; those outside the matrix are 0.
    BandedLu(int64_t rows, int below, int above);

    // Its first entry, and the next ones; 0 at first.
    [[nodiscard]] double *row(int64_t i) noexcept { return band_.data() + i * stride(); }
    // Row i of the factors, after those before it; a processor then reads the next row while it waits for this pivot. False if
    // the pivot is 0 or not finite.
    [[nodiscard]] bool factor_row(int64_t i) noexcept;
    // The same for a matrix that is not totally positive, whose rows have a largest entry of 1: false too if |L| |U| has an
    // entry above `most`, which tells how much larger the backward error is than that of rounding the matrix.
    [[nodiscard]] bool factor_checked(double most);
    // values: [rows][width], the right-hand sides, replaced by the solutions.
    void solve(double *values, int64_t width) const;
    // The same of the transposed matrix.
    void solve_transposed(double *values, int64_t width) const;

private:
    [[nodiscard]] int64_t stride() const noexcept { return below_ + above_ + 1; }
    template <class Below, class Above>
    [[nodiscard]] bool eliminate_within(int64_t i, Below below, Above above) noexcept;
    [[nodiscard]] bool eliminate(int64_t i) noexcept;
    [[nodiscard]] double largest_of_upper(int64_t i) const noexcept;
    template <class Size>
    void solve_some(double *values, int64_t width, Size some) const noexcept;
    template <class Below, class Above, class Size>
    void solve_band(double *values, int64_t width, Size some, Below below, Above above) const noexcept;

    int64_t rows_;
    int below_;
    int above_;
    std::vector<double> band_; // afterwards: L, the inverses of the pivots, and U
};

} // namespace nrb::inline numeric
