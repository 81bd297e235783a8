// SPDX-License-Identifier: MIT
// Linear least squares with banded rows, as functions with local support have them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// Minimises |A x - b| for many right-hand sides at once by Givens rotations, row by row (Lawson & Hanson,
// "Solving Least Squares Problems", chapter 27). Normal equations, which would square the condition number,
// are not formed. The last `border` columns may have entries in every row besides its band: periodic axes use
// them for the functions that wrap around. Memory: (bandwidth + border + width) doubles per column. Cost of a
// row: as many operations for each column, from its first one on, that its rotations reach, most often
// `bandwidth` columns.
class BandedLeastSquares {
public:
    // width: number of right-hand sides.
    BandedLeastSquares(int64_t columns, int bandwidth, int border, int64_t width);

    // Adds the row with the entries `band` at columns first, ..., none of them in the border, and the entries
    // `border` in the border columns (empty: zeros). Preconditions: band.size() <= bandwidth, border.size()
    // is 0 or border.
    void add_row(int64_t first, std::span<const double> band, std::span<const double> border,
                 const double *right);

    // Adds a row entry by entry: consecutive columns in increasing order, those of the border last; then its
    // right-hand sides.
    void enter(int64_t column, double value);
    void add_entered(const double *right);

    // x[column][width]; false if the rows added do not determine it.
    [[nodiscard]] bool solve(double *x) const;

private:
    // Row i of the triangular factor: the band from the diagonal on, the border, the right-hand sides.
    [[nodiscard]] double *row(int64_t i) noexcept { return rows_.data() + i * stride_; }
    [[nodiscard]] const double *row(int64_t i) const noexcept { return rows_.data() + i * stride_; }
    void rotate(double *pivot, int64_t at, int64_t from) noexcept;

    int64_t banded_; // number of columns that are not in the border
    int bandwidth_;
    int border_;
    int64_t width_;
    int64_t stride_;
    std::vector<double> rows_;
    std::vector<double> fresh_; // the row being added
    int64_t entered_ = 0;       // first column of the row being entered
    std::vector<double> entered_band_, entered_border_;
};

} // namespace nrb::inline numeric
