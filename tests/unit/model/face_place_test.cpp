// Boxes of parts of faces, whose boundaries may lie outside of the domain by a tolerance.
#include "model/rays/face_place.h"
#include "unit/face/face_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace face_place_unit_test {

using namespace nrb;
using face_shapes::Point2;

namespace {

face::Face square() {
    return face::Face({face_shapes::plane(), {}, 0.25}, nullptr);
}

} // namespace

// The parameters of the plane are its coordinates.
TEST(BoxBetween, has_places_outside_of_the_domain_at_its_ends) {
    const face::Face face = square();
    for (const double u : {-0.2, 0.0, 0.5, 1.0, 1.2}) {
        for (const double v : {-0.2, 0.0, 0.5, 1.0, 1.2}) {
            for (const double length : {0.0, 0.0625}) {
                const Point2 a{u, v}, b{u + length, v - length};
                const intersect::Box3 box = model::box_between(face, a, b);
                const double lower[] = {a[0], b[1]}, upper[] = {b[0], a[1]};
                for (size_t k = 0; k < 2; ++k) {
                    EXPECT_LE(box.lower[k], std::clamp(lower[k], 0.0, 1.0));
                    EXPECT_GE(box.lower[k], std::clamp(lower[k], 0.0, 1.0) - 1e-13);
                    EXPECT_GE(box.upper[k], std::clamp(upper[k], 0.0, 1.0));
                    EXPECT_LE(box.upper[k], std::clamp(upper[k], 0.0, 1.0) + 1e-13);
                }
            }
        }
    }
}

} // namespace face_place_unit_test
