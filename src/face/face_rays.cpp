// SPDX-License-Identifier: MIT
#include "face/face_rays.h"

namespace nrb::face {

intersect::PlaceFilter trim_filter(const Face &face) {
    return [&face](const std::array<Interval, 2> &box) {
        const TrimMap &trims = face.trims();
        const Point2 &room = trims.room();
        const Point2 lower{box[0].lower - room[0], box[1].lower - room[1]},
            upper{box[0].upper + room[0], box[1].upper + room[1]},
            middle{box[0].lower / 2 + box[0].upper / 2, box[1].lower / 2 + box[1].upper / 2};
        const bool cut = face.covering().any_move(lower, upper, [&](const Point2 &move) {
            return trims.cuts(moved(lower, move), moved(upper, move));
        });
        return cut ? 0 : trims.side(middle);
    };
}

} // namespace nrb::face
