// SPDX-License-Identifier: MIT
// Whether a surface or volume folds over.
#pragma once

#include "pieces/derivative_pieces.h"

#include <array>
#include <memory>
#include <optional>

namespace nrb::analysis {

enum Fold : int32_t {
    fold_none = 0,  // proven: there is none
    fold_found,     // proven: there is one
    fold_undecided, // neither
};

struct FoldTest {
    int32_t result = 0; // one of the fold_ constants
    std::optional<std::array<double, max_axes>> positive;
    std::optional<std::array<double, max_axes>> negative;
};

// Examines the signs of Bernstein coefficients of the determinant J; where they differ, of its halves.
// Factors of J that vanish to rounding on boundaries of pieces are divided out. The reference is for a
// surface in space; null: its vector area. Throws Status::direction, not_representable.
FoldTest fold_test(const Spline &spline, const double *reference);

// The same of polynomial pieces and parts of them, all of which have one reference.
class FoldTests {
public:
    FoldTests(const Spline &spline, const double *reference);
    ~FoldTests();
    FoldTests(const FoldTests &) = delete;
    FoldTests &operator=(const FoldTests &) = delete;

    // Of pieces in the order of refine::bezier_pieces().
    void set_piece(int64_t index);
    // Of the piece that was set, or of a part of it, to rounding of its ends. Undecided is what so many halvings do not decide.
    [[nodiscard]] FoldTest test(int64_t halvings) const;
    [[nodiscard]] FoldTest test(const Part &part, int64_t halvings) const;

private:
    const Spline &spline_;
    pieces::PieceMaker maker_;
    std::array<double, 3> reference_;
    std::unique_ptr<const class FoldSearch> piece_; // whose J is known
};

constexpr int64_t halvings_of_piece = 2000;

// Of all polynomial pieces, in the order of refine::bezier_pieces().
std::vector<FoldTest> fold_tests(const Spline &spline, const double *reference);

// The sign of J wherever it is not 0, if there is no fold: 0 if it is 0 everywhere.
inline int sign_of(const FoldTest &test) noexcept {
    return test.result != fold_none ? 0 : (test.positive ? 1 : 0) - (test.negative ? 1 : 0);
}

} // namespace nrb::analysis
