// Parts that hang together, against all pairs of them.
#include "intersect/levels/trace/cluster_groups.h"
#include "unit/face/face_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>

namespace cluster_groups_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

// Places of a grid, so that many parts touch just so, some parts are points, and some are long.
std::vector<ParameterRanges> random_parts(std::mt19937 &engine, const pieces::PieceGrid &grid, int count) {
    const auto whole = [&](int most) { return std::uniform_int_distribution<int>(0, most)(engine); };
    std::vector<ParameterRanges> parts;
    constexpr int steps = 64;
    for (int i = 0; i < count; ++i) {
        ParameterRanges part;
        for (size_t k = 0; k < 2; ++k) {
            const Interval domain = domain_along(grid, k);
            const int lower = whole(steps), most = whole(40) == 0 ? steps : 2;
            const int upper = std::min(steps, lower + whole(most));
            const auto at = [&](int step) {
                return step == steps ? domain.upper
                                     : domain.lower + (domain.upper - domain.lower) * step / steps;
            };
            part[k] = {at(lower), at(upper)};
        }
        parts.push_back(part);
    }
    return parts;
}

bool touch(const Interval &a, const Interval &b, double share) {
    const double by = share * (a.upper - a.lower) + share * (b.upper - b.lower);
    return a.lower - by <= b.upper && b.lower - by <= a.upper;
}

// The least number of each group, by which it is named.
std::vector<size_t> names_by_pairs(const std::vector<ParameterRanges> &parts, const pieces::PieceGrid &grid,
                                   const SurfaceBorders &borders) {
    std::vector<size_t> name(parts.size());
    std::iota(name.begin(), name.end(), size_t{0});
    const auto join = [&](size_t i, size_t j) {
        const size_t least = std::min(name[i], name[j]), other = std::max(name[i], name[j]);
        std::ranges::replace(name, other, least);
    };
    for (size_t i = 0; i < parts.size(); ++i) {
        for (size_t j = 0; j < parts.size(); ++j) {
            if (touch(parts[i][0], parts[j][0], 1) && touch(parts[i][1], parts[j][1], 1)) {
                join(i, j);
            }
            for (size_t k = 0; k < 2; ++k) {
                const Interval domain = domain_along(grid, k);
                const bool across = parts[i][k].lower == domain.lower && parts[j][k].upper == domain.upper;
                if (borders.wraps(k) && across && touch(parts[i][1 - k], parts[j][1 - k], 0)) {
                    join(i, j);
                }
            }
        }
    }
    return name;
}

void expect_groups(const std::vector<ParameterRanges> &parts, const Spline &surface) {
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    const SurfaceBorders borders(grid);
    const std::vector<size_t> names = names_by_pairs(parts, grid, borders);
    size_t seen = 0;
    std::map<size_t, size_t> group_of_name;
    const std::vector<std::vector<size_t>> groups = touching_groups(parts, grid, borders);
    for (size_t g = 0; g < groups.size(); ++g) {
        for (const size_t i : groups[g]) {
            ++seen;
            ASSERT_EQ(group_of_name.try_emplace(names[i], g).first->second, g);
        }
    }
    ASSERT_EQ(seen, parts.size());
    ASSERT_EQ(group_of_name.size(), groups.size());
}

} // namespace

TEST(ClusterGroups, are_those_of_all_pairs) {
    std::mt19937 engine(7);
    const SplinePtr plane = face_shapes::plane(),
                    ring = build::torus(build::make_placement(3, nullptr, nullptr, nullptr, "centre"), 3, 1,
                                        build::full_turn(), build::full_turn(), 0);
    for (int trial = 0; trial < 400; ++trial) {
        SCOPED_TRACE(trial);
        const SplinePtr &surface = trial % 2 == 0 ? plane : ring;
        expect_groups(random_parts(engine, pieces::piece_grid_of(*surface), 2 + trial % 150), *surface);
    }
}

} // namespace cluster_groups_unit_test
