// SPDX-License-Identifier: MIT
// Tests whether a surface or volume folds over: whether the Jacobian determinant of its map changes its sign.
#pragma once

#include "pieces/derivative_pieces.h"

#include <array>
#include <memory>
#include <optional>

namespace nrb::analysis {

enum Fold : int32_t {
    fold_none = 0,  // proven: it does not fold over
    fold_found,     // proven: it folds over
    fold_undecided, // neither is proven
};

struct FoldTest {
    int32_t result = 0; // a fold_ constant
    std::optional<std::array<double, max_axes>> positive;
    std::optional<std::array<double, max_axes>> negative;
};

// Examines the signs of the Bernstein coefficients of the determinant J and, where these differ, those of its
// halves. Factors of J that vanish to rounding on boundaries of pieces are divided out. For a surface in
// space, J is the component of the normal along `reference`; null: along its vector area. Throws
// Status::direction, not_representable.
FoldTest fold_test(const Spline &spline, const double *reference);

// The same test for single polynomial pieces and parts of them, with one reference for all.
class FoldTests {
public:
    FoldTests(const Spline &spline, const double *reference);
    ~FoldTests();
    FoldTests(const FoldTests &) = delete;
    FoldTests &operator=(const FoldTests &) = delete;

    // Selects a piece, in the order of refine::bezier_pieces().
    void set_piece(int64_t index);
    // Tests the selected piece, or a part of it whose ends are known to rounding. The result is undecided if
    // this number of halvings does not decide it.
    [[nodiscard]] FoldTest test(int64_t halvings) const;
    [[nodiscard]] FoldTest test(const Part &part, int64_t halvings) const;

private:
    const Spline &spline_;
    pieces::PieceMaker maker_;
    std::array<double, 3> reference_;
    std::unique_ptr<const class FoldSearch> piece_; // the piece with its J
};

constexpr int64_t halvings_of_piece = 2000;

// One result for each polynomial piece, in the order of refine::bezier_pieces().
std::vector<FoldTest> fold_tests(const Spline &spline, const double *reference);

// If there is no fold: the sign of J wherever J is not 0; 0 if J is 0 everywhere. 0 also if there may be a
// fold.
inline int sign_of(const FoldTest &test) noexcept {
    return test.result != fold_none ? 0 : (test.positive ? 1 : 0) - (test.negative ? 1 : 0);
}

} // namespace nrb::analysis
