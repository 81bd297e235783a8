// SPDX-License-Identifier: MIT
#include "model/sections/shared_borders.h"

#include "base/disjoint_sets.h"
#include "base/watch.h"

#include <map>

namespace nrb::model {

SharedBorders::SharedBorders(const Model &model) {
    add_faces(model);
    for (const Edge &edge : model.edges) {
        add_edge(model, edge);
    }
    join_corners();
    turn_faces(model);
}

void SharedBorders::add_faces(const Model &model) {
    for (size_t face = 0; face < model.faces.size(); ++face) {
        first_.emplace_back();
        const std::vector<face::Loop> &loops = model.faces[face].face->loops();
        for (size_t loop = 0; loop < loops.size(); ++loop) {
            const int64_t first = std::ssize(coedges_), size = std::ssize(loops[loop]);
            first_.back().push_back(first);
            for (int64_t i = 0; i < size; ++i) {
                SharedCoedge coedge{static_cast<int64_t>(face), static_cast<int32_t>(loop),
                                    static_cast<int32_t>(i)};
                coedge.against = loops[loop][static_cast<size_t>(i)].against;
                coedge.start = first + i;
                coedge.end = i + 1 < size ? first + i + 1 : first;
                coedges_.push_back(coedge);
            }
            count_work(16 * size);
        }
    }
}

// Pairs the uses of an edge if the faces of a solid, or those of none, use it exactly twice.
void SharedBorders::add_edge(const Model &model, const Edge &edge) {
    std::map<int64_t, std::vector<int64_t>> uses;
    int64_t before = -1;
    for (const EdgeUse &use : edge.uses) {
        const int64_t own = number(use.face, static_cast<int32_t>(use.loop), static_cast<int32_t>(use.index));
        uses[model.faces[static_cast<size_t>(use.face)].solid].push_back(own);
        if (before >= 0) {
            same_.push_back({before, own});
        }
        before = own;
    }
    for (const auto &[solid, all] : uses) {
        if (all.size() == 2) {
            for (size_t side = 0; side < 2; ++side) {
                coedges_[static_cast<size_t>(all[side])].pair = std::ssize(pairs_);
                coedges_[static_cast<size_t>(all[side])].side = static_cast<int32_t>(side);
            }
            pairs_.push_back({all[0], all[1]});
        }
    }
}

void SharedBorders::join_corners() {
    DisjointSets classes(coedges_.size());
    const auto join = [&classes](int64_t a, int64_t b) {
        classes.join(static_cast<size_t>(a), static_cast<size_t>(b));
    };
    for (const auto &[one, other] : same_) {
        const SharedCoedge &a = coedge(one), &b = coedge(other);
        const bool alike = a.against == b.against;
        join(a.start, alike ? b.start : b.end);
        join(a.end, alike ? b.end : b.start);
    }
    for (SharedCoedge &coedge : coedges_) {
        for (int64_t *corner : {&coedge.start, &coedge.end}) {
            *corner = static_cast<int64_t>(classes.find(static_cast<size_t>(*corner)));
        }
    }
}

// Propagates the orientation from the first face of each shell to its neighbours.
void SharedBorders::turn_faces(const Model &model) {
    std::vector<std::vector<std::pair<int64_t, bool>>> beside(model.faces.size());
    const auto runs_against = [&](const SharedCoedge &coedge) {
        return coedge.against != model.faces[static_cast<size_t>(coedge.face)].against;
    };
    for (const auto &[one, other] : pairs_) {
        const SharedCoedge &a = coedge(one), &b = coedge(other);
        if (model.faces[static_cast<size_t>(a.face)].solid < 0) {
            const bool turned = runs_against(a) == runs_against(b);
            beside[static_cast<size_t>(a.face)].emplace_back(b.face, turned);
            beside[static_cast<size_t>(b.face)].emplace_back(a.face, turned);
        }
    }
    turned_.assign(model.faces.size(), false);
    std::vector<bool> seen(model.faces.size(), false);
    std::vector<size_t> waiting;
    for (size_t first = 0; first < beside.size(); ++first) {
        if (!seen[first]) {
            seen[first] = true;
            waiting.push_back(first);
        }
        while (!waiting.empty()) {
            const size_t face = waiting.back();
            waiting.pop_back();
            for (const auto &[neighbour, turned] : beside[face]) {
                const auto next = static_cast<size_t>(neighbour);
                if (!seen[next]) {
                    seen[next] = true;
                    turned_[next] = turned_[face] != turned;
                    waiting.push_back(next);
                }
            }
        }
    }
}

} // namespace nrb::model
