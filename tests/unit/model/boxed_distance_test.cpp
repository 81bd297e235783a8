// Bounds from boxes of the distance of loops from edges that are moved by a known distance.
#include "model/rays/boxed_distance.h"

#include "face/made/curve_under.h"
#include "model/rays/face_place.h"
#include "refine/forms/parametrization.h"
#include "refine/forms/transform.h"
#include "unit/face/face_shapes.h"

#include <gtest/gtest.h>

namespace boxed_distance_test {

using namespace nrb;
using namespace face_shapes;

namespace {

// With one loop of one curve, whose edge is off by a distance along z.
face::Face face_off(const SplinePtr &surface, const SplinePtr &curve, double off, bool against) {
    const face::Covering covering(*surface, 1e-9);
    constexpr double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double way[3] = {0, 0, off};
    const SplinePtr image = face::edge_over(surface, covering, curve, 1e-9).curve,
                    moved = refine::transform(*image, {3, 3, identity}, way);
    Loop loop{{curve, against ? refine::reverse(*moved, 0, false) : moved, 0, against}};
    return face::Face({surface, {loop}, 1e-9 + 2 * off}, nullptr);
}

} // namespace

TEST(BoxedDistance, is_a_bound_and_not_far_above) {
    const SplinePtr flat = plane(10), round = cylinder();
    const SplinePtr ring = circle({0.5, 0.5}, 0.25), around = segment(*round, {0, 0.5}, {1, 0.5}),
                    beyond = segment(*round, {0.25, 0.5}, {1.25, 0.5});
    for (const auto &[surface, curve] : {std::pair(flat, ring),
                                         {flat, refine::reverse(*ring, 0, false)},
                                         {round, around},
                                         {round, refine::reverse(*around, 0, false)},
                                         {round, beyond}}) {
        for (const bool against : {false, true}) {
            for (const double off : {0.0, 0.01, 0.3}) {
                const face::Face face = face_off(surface, curve, off, against);
                const double size = model::face_box(face).size(), found = model::boxed_distance(face, 0, 0);
                EXPECT_GE(found, off);
                EXPECT_LE(found, off + size / 64);
            }
        }
    }
}

} // namespace boxed_distance_test
