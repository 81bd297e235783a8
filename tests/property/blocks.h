// Parallelepipeds whose sides share edges, for tests.
#pragma once

#include "solids.h"

namespace support::blocks {

using Point3 = std::array<double, 3>;

// The sides of a parallelepiped with random edges, told by the keys of solids::box(); neighbours end by the gap before their edges.
struct Block {
    Point3 origin{};
    std::array<Point3, 3> edges{};
    std::vector<models::Face> sides; // two across each edge in turn
};
inline Block with_sides(Block block, double gap = 0) {
    const auto key = [](size_t along, int64_t first, int64_t second) {
        return 1 + 4 * static_cast<int64_t>(along) + first + 2 * second;
    };
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
        for (const int64_t side : {0, 1}) {
            Point3 corner{}, u{}, v{};
            for (size_t c = 0; c < 3; ++c) {
                const double first = block.edges[a][c], second = block.edges[b][c];
                corner[c] = block.origin[c] + static_cast<double>(side) * block.edges[axis][c] +
                            gap * (first + second);
                u[c] = (1 - 2 * gap) * first;
                v[c] = (1 - 2 * gap) * second;
            }
            block.sides.push_back(
                solids::around_domain(solids::plane(corner, u, v),
                                      {key(a, 0, side), key(b, side, 1), -key(a, 1, side), -key(b, side, 0)},
                                      std::max(1e-9, 8 * gap)));
        }
    }
    return block;
}
inline Block random_block(Random &random, double gap = 0, double spread = 0) {
    Block block;
    for (size_t k = 0; k < 3; ++k) {
        block.origin[k] = random.between(-spread, spread);
        for (size_t c = 0; c < 3; ++c) {
            block.edges[k][c] = (k == c ? random.between(0.5, 2) : 0) + random.between(-0.4, 0.4);
        }
    }
    return with_sides(std::move(block), gap);
}

inline Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// Of the surfaces of both sides across an edge.
inline Point3 normal_of(const Block &block, size_t axis) {
    return cross(block.edges[(axis + 1) % 3], block.edges[(axis + 2) % 3]);
}

} // namespace support::blocks
