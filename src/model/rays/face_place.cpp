// SPDX-License-Identifier: MIT
#include "model/rays/face_place.h"

#include "face/face_box.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

intersect::Box3 box3_of(const bounds::Box &box) noexcept {
    constexpr double most = 1e300;
    intersect::Box3 result;
    for (size_t c = 0; c < 3; ++c) {
        result.lower[c] = std::max(box.lower[c], -most);
        result.upper[c] = std::min(box.upper[c], most);
    }
    return result;
}

// Boundary curves may leave the domain by a tolerance; they are clamped to its ends. No range is empty.
intersect::Box3 box_between(const face::Face &face, const face::Point2 &a, const face::Point2 &b) {
    Part part{};
    for (size_t k = 0; k < 2; ++k) {
        const Interval domain = face.covering().domain(static_cast<int>(k));
        const double room = face.trims().room()[k];
        const double low = std::clamp(std::min(a[k], b[k]), domain.lower, domain.upper) - room,
                     high = std::clamp(std::max(a[k], b[k]), domain.lower, domain.upper) + room;
        part[k] = {std::max(std::nextafter(low, -infinity), domain.lower),
                   std::min(std::nextafter(high, infinity), domain.upper)};
    }
    return box3_of(bounds::bounding_box(*face.surface(), part, infinity));
}

// On an axis that does not close, the parameter takes its extreme values over the face on the boundary, so
// that the smallest rectangle around the boundary contains the face.
intersect::Box3 face_box(const face::Face &face) {
    const auto &[u, v] = face::smallest_rectangle(face);
    return box_between(face, {u.lower, v.lower}, {u.upper, v.upper});
}

} // namespace nrb::model
