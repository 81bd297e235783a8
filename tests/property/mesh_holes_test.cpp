// Where a surface folds at singular places angles take triangles as small as the grid of a strip: still none is missing.
#include "property/mesh_samples.h"

#include <gtest/gtest.h>

namespace mesh_holes_test {

using namespace support;
using namespace support::meshes;

namespace {

// Over the unit square, with control points far out of their order.
Handle crumpled(Random &random) {
    const std::array<int32_t, 2> degrees{random.whole(1, 5), random.whole(1, 5)};
    std::array<int64_t, 2> counts{};
    Vec knots, points, weights;
    for (size_t k = 0; k < 2; ++k) {
        const int more = random.whole(0, 4);
        counts[k] = degrees[k] + 1 + more;
        Vec inner;
        for (int i = 0; i < more; ++i) {
            inner.push_back(random.unit());
        }
        std::ranges::sort(inner);
        knots.insert(knots.end(), static_cast<size_t>(degrees[k] + 1), 0);
        knots.insert(knots.end(), inner.begin(), inner.end());
        knots.insert(knots.end(), static_cast<size_t>(degrees[k] + 1), 1);
    }
    for (int64_t i = 0; i < counts[0]; ++i) {
        for (int64_t j = 0; j < counts[1]; ++j) {
            const std::array<double, 3> place{static_cast<double>(i) / static_cast<double>(counts[0] - 1),
                                              static_cast<double>(j) / static_cast<double>(counts[1] - 1), 0};
            for (const double x : place) {
                points.push_back(x + random.between(-0.6, 0.6));
            }
            weights.push_back(std::exp(random.between(-3, 3)));
        }
    }
    return made([&](nurbs **out) {
        return nurbs_create(2, degrees.data(), counts.data(), knots.data(),
                            static_cast<int64_t>(knots.size()), 3, points.data(), 0, 0, weights.data(), 0, 0,
                            out);
    });
}

Handle star(Random &random) {
    std::vector<faces::Place> corners;
    const int n = random.whole(5, 12);
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * faces::pi * i / n, radius = random.between(0.2, 0.45);
        corners.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    }
    return faces::polygon(corners);
}

} // namespace

TEST(MeshHoles, small_triangles_leave_none) {
    for (const uint64_t seed : {28U, 121U, 122U, 126U, 129U}) {
        Random random(seed);
        const Handle ground = crumpled(random), border = star(random);
        const faces::Face face = faces::face_of(ground.get(), {{border.get()}});
        SCOPED_TRACE(seed);
        expect_whole(mesh_of(face.get(), 0.2, 0.2));
    }
}

} // namespace mesh_holes_test
