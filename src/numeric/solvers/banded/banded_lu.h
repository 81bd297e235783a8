// SPDX-License-Identifier: MIT
// Square banded systems with many right-hand sides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// LU factorisation without pivoting. It is stable for totally positive matrices, such as those of B-splines
// at sites in their supports, and preserves the band (C. de Boor, A. Pinkus, "Backward error analysis for
// totally positive linear systems", Numer. Math. 27 (1977)). Cost: each entry before the diagonal costs as
// much as there are entries after the diagonal in the row of its column; solving costs, for each right-hand
// side, as much as there are entries. Memory: the entries.
class BandedLu {
public:
    // Each row has `width` consecutive entries, which never begin before those of the row above.
    BandedLu(int64_t rows, int width);

    // The entries of row i, to be filled, the first of which is in column first_column. Rows are requested in
    // order. Null if none of the entries can be on the diagonal, so that the matrix is singular.
    [[nodiscard]] double *next_row(int64_t i, int64_t first_column) noexcept;
    // Computes row i of the factors, after those before it. Called after each row, this lets the processor
    // read the next row while it waits for this pivot. False if the pivot is 0 or not finite.
    [[nodiscard]] bool factor_row(int64_t i) noexcept;
    // For matrices that are not totally positive and whose rows have a largest entry of 1, after all rows:
    // whether all entries of the product of magnitudes |L| |U| are shown to be at most `most`. The largest
    // entry says how much the backward error exceeds that of rounding the matrix.
    [[nodiscard]] bool grows_little(double most) const;
    // values: [rows][width], the right-hand sides, replaced by the solutions.
    void solve(double *values, int64_t width) const;
    // The same for the transposed matrix.
    void solve_transposed(double *values, int64_t width) const;

private:
    // How many entries a row has before and after its diagonal, without zeros at its ends that remain zero.
    struct Reach {
        int8_t before, after;
    };
    [[nodiscard]] const double *diagonal(int64_t i) const noexcept {
        return entries_.data() + i * width_ + places_[static_cast<size_t>(i)];
    }
    [[nodiscard]] double *diagonal(int64_t i) noexcept {
        return entries_.data() + i * width_ + places_[static_cast<size_t>(i)];
    }
    [[nodiscard]] Reach reach(int64_t i) const noexcept { return reaches_[static_cast<size_t>(i)]; }
    void set_reach(int64_t i) noexcept;
    [[nodiscard]] double largest_of_upper(int64_t i) const noexcept;
    template <class Size>
    void solve_some(double *values, int64_t width, Size some) const noexcept;

    int64_t rows_;
    int width_;
    std::vector<double> entries_; // finally L, the inverses of the pivots, and U
    std::vector<int8_t> places_;  // of the diagonals within their rows
    std::vector<Reach> reaches_;
};

} // namespace nrb::inline numeric
