// SPDX-License-Identifier: MIT
// A Krawczyk test for pairs of curve pieces that are near each other in at most one place.
#pragma once

#include "intersect/contraction.h"
#include "pieces/slopes.h"

namespace nrb::intersect {

// The contraction of F(x, y) = A(x) - B(y), by a matrix M of two rows.
class Chart {
public:
    void set(const pieces::Slopes &a, const pieces::Slopes &b, int dim);

    [[nodiscard]] bool proven() const noexcept { return contraction_.proven(); }
    [[nodiscard]] const Contraction &contraction() const noexcept { return contraction_; }
    // Whether some row of M F is everywhere larger than |F| <= near allows, as the control points show.
    // Precondition: proven().
    [[nodiscard]] bool excludes(const pieces::BezierPiece &a, const pieces::BezierPiece &b,
                                double near) const noexcept;
    // The simplified Newton step M F, for a difference F.
    [[nodiscard]] Place<2> step(const double *difference) const noexcept;
    // The squared sine of the angle between the mean derivatives.
    [[nodiscard]] double square_of_sine() const noexcept { return sine_; }
    // In the plane: the sign of A' x B', 1 or -1.
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
