// SPDX-License-Identifier: MIT
#include "closest/pair/pair_descent.h"
#include "closest/pair/pair_regions.h"
#include "random_pieces.h"

#include <gtest/gtest.h>

namespace pair_regions_test {

using namespace nrb;
using random_pieces::random_piece;
using support::Random;

namespace {

// Its boundary is everywhere.
class Everywhere final : public closest::Region {
public:
    [[nodiscard]] int side(const pieces::LocalParam & /*params*/) const override { return 1; }
    [[nodiscard]] int side(const pieces::LocalParam & /*lower*/,
                           const pieces::LocalParam & /*upper*/) const override {
        return 0;
    }
    [[nodiscard]] closest::BoundedFoot nearest(const double * /*point*/, double /*tolerance*/) override {
        return {};
    }
};

// Whether the distance of two pieces, at random places, rises or falls along an axis of the first one all over.
bool has_one_sign(Random &random, const pieces::BezierPiece &a, const pieces::BezierPiece &b) {
    closest::PieceJet on_a, on_b;
    std::array<int, 2> rising{};
    constexpr int samples = 60;
    for (int i = 0; i < samples; ++i) {
        on_a.evaluate(a, {random.unit(), random.unit(), 0}, true);
        on_b.evaluate(b, {random.unit(), random.unit(), 0}, false);
        for (int k = 0; k < a.axes(); ++k) {
            double slope = 0;
            for (int c = 0; c < a.dim(); ++c) {
                slope += (on_a.value()[c] - on_b.value()[c]) * on_a.first(k)[c];
            }
            rising[static_cast<size_t>(k)] += slope > 0 ? 1 : 0;
        }
    }
    return rising[0] == 0 || rising[0] == samples ||
           (a.axes() > 1 && (rising[1] == 0 || rising[1] == samples));
}

// To the pieces of the halves of halves.
closest::PairCell &some_cell(Random &random, closest::PairCells &cells) {
    closest::PairCell *cell = &cells.root();
    for (int i = 0; i < 5; ++i) {
        if (!cells.split(*cell)) {
            break;
        }
        const int count = static_cast<int>(cell->children.size());
        cell = &cell->children[static_cast<size_t>(random.whole(0, count - 1))];
    }
    return *cell;
}

} // namespace

// What is left out has no critical distance, for the slope along an axis has one sign; pairs without a boundary are left in.
TEST(PairRegions, leave_out_pairs_without_a_critical_distance) {
    Random random(775);
    Everywhere region;
    int left_out = 0, all = 0;
    for (int i = 0; i < 400; ++i) {
        const bool rational = random.chance(50);
        const int axes = random.whole(1, 2);
        const double height = random.between(0.1, 2);
        const SplinePtr f = random_piece(random, 2, 0, 0.3, rational),
                        g = random_piece(random, axes, height, 0.3, rational);
        const pieces::Frame frame = pieces::frame_of({{f.get(), g.get()}});
        closest::PairCells on_f(*f, frame), on_g(*g, frame);
        closest::PairRegions regions(*f, *g, {&region, nullptr});
        closest::PairCell &a = some_cell(random, on_f), &b = some_cell(random, on_g);

        ASSERT_TRUE(a.piece && b.piece);
        ++all;
        if (regions.exclude(a, b)) {
            ++left_out;
            EXPECT_TRUE(has_one_sign(random, *a.piece, *b.piece) || has_one_sign(random, *b.piece, *a.piece));
        }
        closest::PairRegions with_boundaries(*f, *g, {&region, nullptr, true});
        a.mark = b.mark = 0;
        EXPECT_FALSE(with_boundaries.exclude(a, b));
    }
    EXPECT_GE(left_out, all / 4);
    EXPECT_LT(left_out, all);
}

} // namespace pair_regions_test
