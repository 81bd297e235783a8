// SPDX-License-Identifier: MIT
// Least squares with rows of few neighbouring columns, as functions with local supports have them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// Minimises |A x - b| for many right-hand sides at once by Givens rotations, row by row (Lawson & Hanson,
// "Solving Least Squares Problems", chapter 27), without normal equations, whose condition would be the
// square. The last `border` columns may occur in every row beside its band, for wrapped functions of periodic
// axes. Memory: (bandwidth + border + width) doubles for each column; cost of a row: as much for each of the
// columns from its first on that its rotations reach, most often `bandwidth`.
class BandedLeastSquares {
public:
    // `width` right-hand sides.
    BandedLeastSquares(int64_t columns, int bandwidth, int border, int64_t width);

    // Adds the row with entries at columns first, ..., none of them in the border, and at those of the border
    // (empty: zeros). Preconditions: band.size() <= bandwidth, border.size() is 0 or border.
    void add_row(int64_t first, std::span<const double> band, std::span<const double> border,
                 const double *right);

    // A row put together: entries at columns, neighbours one after the other, the first after the last; then
    // its right-hand sides.
    void enter(int64_t column, double value);
    void add_entered(const double *right);

    // x[column][width]; false if the columns added do not determine it.
    [[nodiscard]] bool solve(double *x) const;

private:
    // Of the triangular factor: the band from the diagonal on, the border, the right-hand sides.
    [[nodiscard]] double *row(int64_t i) noexcept { return rows_.data() + i * stride_; }
    [[nodiscard]] const double *row(int64_t i) const noexcept { return rows_.data() + i * stride_; }
    void rotate(double *pivot, int64_t at, int64_t from) noexcept;

    int64_t banded_; // columns that are not in the border
    int bandwidth_;
    int border_;
    int64_t width_;
    int64_t stride_;
    std::vector<double> rows_;
    std::vector<double> fresh_; // the row that is being added
    int64_t entered_ = 0;       // first column of the row that is put together
    std::vector<double> entered_band_, entered_border_;
};

} // namespace nrb::inline numeric
