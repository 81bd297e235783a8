// SPDX-License-Identifier: MIT
#include "model/edge_gaps.h"

#include "base/watch.h"
#include "face/deviation.h"

#include <algorithm>

namespace nrb::model {

face::Deviation edge_gap(const Model &model, const Edge &edge) {
    face::Deviation gap{0, true};
    for (const EdgeUse &use : edge.uses) {
        const face::Face &face = *model.faces[static_cast<size_t>(use.face)].face;
        const face::Coedge &coedge =
            face.loops()[static_cast<size_t>(use.loop)][static_cast<size_t>(use.index)];
        const face::Deviation own = face::deviation_of(face, coedge);
        gap.distance = std::max(gap.distance, own.distance);
        gap.proven = gap.proven && own.proven;
    }
    return gap;
}

std::vector<face::Deviation> edge_gaps(const Model &model, int64_t count) {
    std::vector<face::Deviation> gaps;
    Steps steps(count);
    for (int64_t i = 0; i < count; ++i, steps.next()) {
        gaps.push_back(edge_gap(model, model.edges[static_cast<size_t>(i)]));
    }
    return gaps;
}

} // namespace nrb::model
