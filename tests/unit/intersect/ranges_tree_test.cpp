// Parts of two surfaces that others meet, against all of them.
#include "intersect/levels/trace/ranges_tree.h"
#include "unit/face/face_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace ranges_tree_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

using Ranges = RangesTree::Ranges;

class Parts {
public:
    Parts(const Spline &a, const Spline &b) : grids_{&pieces::piece_grid_of(a), &pieces::piece_grid_of(b)} {}

    // Most are small; along what closes some run beyond the upper end.
    Ranges random(std::mt19937 &engine) const {
        std::uniform_real_distribution<double> unit(0, 1);
        Ranges ranges;
        for (size_t i = 0; i < 4; ++i) {
            const int axis = static_cast<int>(i % 2);
            const pieces::PieceGrid &grid = *grids_[i / 2];
            const double first = grid.break_at(axis, 0),
                         length = grid.break_at(axis, grid.count(axis)) - first;
            const double lower = first + length * unit(engine), size = unit(engine) < 0.1 ? 1 : 0.2;
            ranges[i] = {lower, lower + length * size * unit(engine)};
            if (!borders_[i / 2].wraps(i % 2)) {
                ranges[i].upper = std::min(ranges[i].upper, first + length);
            }
        }
        return ranges;
    }
    bool meet(const Ranges &a, const Ranges &b) const {
        for (size_t i = 0; i < 4; ++i) {
            const double period = borders_[i / 2].wraps(i % 2) ? borders_[i / 2].period(i % 2) : 0;
            bool any = false;
            for (const double by : {0.0, period, -period}) {
                any = any || (a[i].lower + by <= b[i].upper && b[i].lower <= a[i].upper + by);
            }
            if (!any) {
                return false;
            }
        }
        return true;
    }
    const SurfaceBorders &borders(size_t surface) const { return borders_[surface]; }

private:
    std::array<const pieces::PieceGrid *, 2> grids_;
    std::array<SurfaceBorders, 2> borders_{SurfaceBorders(*grids_[0]), SurfaceBorders(*grids_[1])};
};

} // namespace

TEST(RangesTree, finds_all_that_meet_and_few_others) {
    std::mt19937 engine(8);
    const SplinePtr plane = face_shapes::plane(),
                    ring = build::torus(build::make_placement(3, nullptr, nullptr, nullptr, "centre"), 3, 1,
                                        build::full_turn(), build::full_turn(), 0);
    for (const auto &[a, b] : std::vector<std::pair<SplinePtr, SplinePtr>>{{plane, ring}, {ring, ring}}) {
        const Parts parts(*a, *b);
        std::vector<Ranges> all(1000);
        std::ranges::generate(all, [&] { return parts.random(engine); });
        const RangesTree tree(parts.borders(0), parts.borders(1), all);
        size_t visits = 0, hits = 0;
        for (int trial = 0; trial < 200; ++trial) {
            const Ranges others = parts.random(engine);
            std::vector<bool> found(all.size(), false);
            tree.visit(others, [&](size_t i) {
                found[i] = true;
                ++visits;
            });
            for (size_t i = 0; i < all.size(); ++i) {
                const bool meets = parts.meet(all[i], others);
                hits += meets ? 1 : 0;
                EXPECT_TRUE(found[i] || !meets);
            }
        }
        EXPECT_GT(hits, 100U);
        EXPECT_LT(visits, 200 * all.size() / 10);
    }
    const Parts parts(*plane, *ring);
    RangesTree(parts.borders(0), parts.borders(1), {}).visit(parts.random(engine), [](size_t) { FAIL(); });
}

} // namespace ranges_tree_unit_test
