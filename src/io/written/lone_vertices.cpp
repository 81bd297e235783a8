// SPDX-License-Identifier: MIT
#include "io/written/lone_vertices.h"

#include "face/deviation.h"

#include <algorithm>

namespace nrb::io {

std::vector<Vector3> lone_vertices(const model::ModelFace &face, bool on_shape) {
    const face::Covering &covering = face.face->covering();
    const bool bare = face.face->loops().empty();
    if (!bare && (!on_shape || model::bounded(*face.shape))) {
        return {};
    }
    std::vector<Vector3> places;
    const auto add = [&](const face::Point2 &place) {
        const std::vector<double> x = face::point_at(*face.face->surface(), place);
        places.push_back({x[0], x[1], x[2]});
    };
    for (const int k : {0, 1}) {
        for (const int end : {0, 1}) {
            const Interval across = covering.domain(k), way = covering.domain(1 - k);
            face::Point2 place;
            place[static_cast<size_t>(k)] = end == 0 ? across.lower : across.upper;
            place[static_cast<size_t>(1 - k)] = way.lower + (way.upper - way.lower) / 3;
            if (covering.collapsed(k, end) && face.face->trims().side(place) == 1) {
                add(place);
            }
        }
    }
    if (bare) {
        places.resize(std::min<size_t>(places.size(), 1));
        if (places.empty()) {
            add({covering.domain(0).lower, covering.domain(1).lower});
        }
    }
    return places;
}

} // namespace nrb::io
