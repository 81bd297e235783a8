// SPDX-License-Identifier: MIT
// Pairs of pieces of curves that come near each other in one place at most.
#pragma once

#include "intersect/contraction.h"
#include "pieces/slopes.h"

namespace nrb::intersect {

// The contraction of F(x, y) = A(x) - B(y), with two rows of M.
class Chart {
public:
    void set(const pieces::Slopes &a, const pieces::Slopes &b, int dim);

    [[nodiscard]] bool proven() const noexcept { return contraction_.proven(); }
    [[nodiscard]] const Contraction &contraction() const noexcept { return contraction_; }
    // Whether a row of M F is nowhere as small as where |F| <= near, as control points tell. Precondition: proven().
    [[nodiscard]] bool excludes(const pieces::BezierPiece &a, const pieces::BezierPiece &b,
                                double near) const noexcept;
    // One step of Newton's method with M from a difference.
    [[nodiscard]] Place<2> step(const double *difference) const noexcept;
    // The square of the sine between the mean slopes.
    [[nodiscard]] double square_of_sine() const noexcept { return sine_; }
    // 1 or -1: A' x B' in the plane.
    [[nodiscard]] int turn() const noexcept { return turn_; }

private:
    bool set_rows(const double *u, const double *v);
    [[nodiscard]] const double *row(size_t k) const noexcept {
        return rows_.data() + k * static_cast<size_t>(dim_);
    }

    int dim_ = 0;
    std::vector<double> rows_; // of M
    Contraction contraction_;
    double sine_ = 0;
    int turn_ = 0;
};

} // namespace nrb::intersect
