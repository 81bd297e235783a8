// SPDX-License-Identifier: MIT
// Square systems whose rows have few entries, beside each other, for many right-hand sides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// L U without an exchange of rows. That is stable for totally positive matrices, such as those of B-splines at sites
// in their supports, and keeps the places of entries (C. de Boor, A. Pinkus, "Backward error analysis for totally positive
// linear systems", Numer. Math. 27 (1977)). Cost: for each entry before the diagonal as much as there are entries after that of
// its column; for each right-hand side, and for memory, the entries.
class BandedLu {
public:
    // All rows have `width` entries side by side, which never begin before those of the row above.
    BandedLu(int64_t rows, int width);

    // Those of row i, to be filled, of which the first one is in a column. Rows follow each other. Null if none of them can be
    // on the diagonal, so that the matrix is singular.
    [[nodiscard]] double *next_row(int64_t i, int64_t first_column) noexcept;
    // Row i of the factors, after those before it; a processor then reads the next row while it waits for this pivot. False if
    // the pivot is 0 or not finite.
    [[nodiscard]] bool factor_row(int64_t i) noexcept;
    // For a matrix that is not totally positive, whose rows have a largest entry of 1, of all rows: false if |L| |U| has an
    // entry above `most`, which tells how much larger the backward error is than that of rounding the matrix.
    [[nodiscard]] bool grows_little(double most) const;
    // values: [rows][width], the right-hand sides, replaced by the solutions.
    void solve(double *values, int64_t width) const;
    // The same of the transposed matrix.
    void solve_transposed(double *values, int64_t width) const;

private:
    // How many entries a row has before and after its diagonal, without zeros at its ends that stay zeros.
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
    std::vector<double> entries_; // afterwards: L, the inverses of the pivots, and U
    std::vector<int8_t> places_;  // of the diagonals in their rows
    std::vector<Reach> reaches_;
};

} // namespace nrb::inline numeric
