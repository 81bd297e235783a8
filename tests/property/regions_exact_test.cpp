// Regions of polygons with integer coordinates against Boost.Polygon, which computes with integers: the areas of unions, intersections
// and differences, where corners, sides and parts of sides coincide.
#include "property/regions.h"

#include <boost/polygon/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace regions_exact_test {

using namespace support;
using namespace support::regions;

namespace {

namespace bp = boost::polygon;
using Set = bp::polygon_set_data<int>;
using Corner = std::array<int, 2>;
using Corners = std::vector<Corner>;

// Crossings are rounded to integers there: coordinates are that many times as large.
struct Grid {
    int times = 1;

    [[nodiscard]] Set set(const std::vector<Corners> &polygons) const {
        using namespace bp::operators;
        Set result;
        for (const Corners &corners : polygons) {
            std::vector<bp::point_data<int>> points;
            for (const Corner &x : corners) {
                points.emplace_back(x[0] * times, x[1] * times);
            }
            bp::polygon_data<int> polygon;
            bp::set_points(polygon, points.begin(), points.end());
            result ^= polygon;
        }
        return result;
    }
    [[nodiscard]] double area(const Set &set) const {
        return static_cast<double>(bp::area(set)) / (1.0 * times * times);
    }
};

Model region_of(const std::vector<Corners> &polygons) {
    Curves curves;
    for (const Corners &corners : polygons) {
        std::vector<Point> points;
        for (const Corner &x : corners) {
            points.push_back({1.0 * x[0], 1.0 * x[1]});
        }
        curves.push_back(polygon(points));
    }
    return region(curves, NURBS_FILL_EVEN_ODD);
}

struct Areas {
    double a, b, either, both, difference, one;

    // Sides of any direction make the other library lose parts at times, though rarely: then its areas do not add up.
    [[nodiscard]] bool add_up(double within) const {
        return std::abs(a + b - either - both) <= within && std::abs(a - both - difference) <= within &&
               std::abs(either - both - one) <= within;
    }
};

// Whatever is inside of an odd number of polygons, of both. Whether that could be told.
bool expect_areas(const Grid &grid, const std::vector<Corners> &a, const std::vector<Corners> &b,
                  double within) {
    using namespace bp::operators;
    const Set of_a = grid.set(a), of_b = grid.set(b);
    const Areas areas{grid.area(of_a),
                      grid.area(of_b),
                      grid.area(Set(of_a | of_b)),
                      grid.area(Set(of_a & of_b)),
                      grid.area(Set(of_a - of_b)),
                      grid.area(Set(of_a ^ of_b))};
    const Model in_a = region_of(a), in_b = region_of(b);
    if (!areas.add_up(within)) {
        return false;
    }
    EXPECT_NEAR(area_of(in_a), areas.a, within);
    EXPECT_NEAR(area_of(in_b), areas.b, within);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_UNION, in_a, in_b)), areas.either, within);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_INTERSECTION, in_a, in_b)), areas.both, within);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_DIFFERENCE, in_a, in_b)), areas.difference, within);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_EITHER, in_a, in_b)), areas.one, within);
    return true;
}

// By the angles of the corners around a place between them: none of its sides crosses another one.
Corners random_star(Random &random, int low, int high) {
    const double x = (low + high) / 2 + 0.37, y = (low + high) / 2 + 0.41;
    const auto angle = [&](const Corner &c) { return std::atan2(c[1] - y, c[0] - x); };
    for (;;) {
        Corners corners;
        for (int i = random.whole(3, 9); i > 0; --i) {
            corners.push_back({random.whole(low, high), random.whole(low, high)});
        }
        std::ranges::sort(corners, {}, angle);
        double widest = angle(corners.front()) + 2 * std::numbers::pi - angle(corners.back());
        for (size_t i = 1; i < corners.size(); ++i) {
            widest = std::max(widest, angle(corners[i]) - angle(corners[i - 1]));
        }
        if (widest < 3) {
            return corners;
        }
    }
}

// Along the axes; with `oblique` also along the diagonals between them, on even coordinates, so that sides meet in integers.
Corners random_block(Random &random, int size, bool oblique) {
    const int left = 2 * random.whole(0, size), low = 2 * random.whole(0, size);
    const int right = left + 2 * random.whole(1, 4), high = low + 2 * random.whole(1, 4);
    if (!oblique || random.chance(40)) {
        return {{left, low}, {right, low}, {right, high}, {left, high}};
    }
    const int side = 2 * random.whole(1, 4);
    return random.chance(50) ? Corners{{left, low}, {left + side, low}, {left, low + side}}
                             : Corners{{left, low},
                                       {left + side, low + side},
                                       {left, low + 2 * side},
                                       {left - side, low + side}};
}

template <class Make>
std::vector<Corners> some(Random &random, int most, Make &&make) {
    std::vector<Corners> result;
    for (int i = random.whole(1, most); i > 0; --i) {
        result.push_back(make());
    }
    return result;
}

} // namespace

TEST(RegionsExact, BlocksOnALattice) {
    for_each_case(9500, 100, [](Random &random, uint64_t) {
        const auto block = [&] { return random_block(random, 4, false); };
        EXPECT_TRUE(expect_areas({1}, some(random, 5, block), some(random, 5, block), 1e-9));
    });
}

TEST(RegionsExact, ObliqueBlocksOnALattice) {
    for_each_case(9800, 100, [](Random &random, uint64_t) {
        const auto block = [&] { return random_block(random, 3, true); };
        EXPECT_TRUE(expect_areas({1}, some(random, 4, block), some(random, 4, block), 1e-9));
    });
}

// Sides of all directions between few places, many of which they pass.
TEST(RegionsExact, StarsOnALattice) {
    int told = 0, all = 0;
    for_each_case(10100, 60, [&](Random &random, uint64_t) {
        const auto star = [&] { return random_star(random, 0, 6); };
        told += expect_areas({1 << 24}, some(random, 3, star), some(random, 3, star), 1e-5) ? 1 : 0;
        ++all;
    });
    EXPECT_GE(told, 0.9 * all);
}

TEST(RegionsExact, StarsAnywhere) {
    int told = 0, all = 0;
    for_each_case(10400, 30, [&](Random &random, uint64_t) {
        const auto star = [&] { return random_star(random, 0, 10000); };
        told += expect_areas({1 << 14}, some(random, 4, star), some(random, 4, star), 20) ? 1 : 0;
        ++all;
    });
    EXPECT_GE(told, 0.9 * all);
}

} // namespace regions_exact_test
