// SPDX-License-Identifier: MIT
#include "face/face_rays.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

struct PlaceBox {
    Point2 lower, upper;
};

// Whether a piece of the boundary comes into a box of the domain.
bool is_cut(const TrimMap &trims, const PlaceBox &box) {
    return trims.any_in(box.lower, box.upper, [&](const TrimPiece &piece) {
        return trims.pieces().meets(piece, box.lower, box.upper);
    });
}

// The same, across the seams of closed axes: what lies at one end of the domain lies at the other one, too.
bool is_cut(const Face &face, const PlaceBox &box) {
    const Covering &covering = face.covering();
    for (const double i : {0.0, -1.0, 1.0}) {
        for (const double j : {0.0, -1.0, 1.0}) {
            const Point2 copy{i, j};
            PlaceBox moved = box;
            bool there = true;
            for (size_t k = 0; k < 2; ++k) {
                const int axis = static_cast<int>(k);
                moved.lower[k] += copy[k] * covering.period(axis);
                moved.upper[k] += copy[k] * covering.period(axis);
                there = there && (copy[k] == 0 || covering.closed(axis)) &&
                        moved.lower[k] <= covering.domain(axis).upper &&
                        moved.upper[k] >= covering.domain(axis).lower;
            }
            if (there && is_cut(face.trims(), moved)) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

intersect::PlaceFilter trim_filter(const Face &face) {
    return [&face](const std::array<Interval, 2> &given) {
        PlaceBox box;
        Point2 middle{};
        for (size_t k = 0; k < 2; ++k) {
            const double room = face.trims().room()[k];
            box.lower[k] = given[k].lower - room;
            box.upper[k] = given[k].upper + room;
            middle[k] = given[k].lower / 2 + given[k].upper / 2;
        }
        return is_cut(face, box) ? 0 : face.trims().side(middle);
    };
}

} // namespace nrb::face
