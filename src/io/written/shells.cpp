// SPDX-License-Identifier: MIT
#include "io/written/shells.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace nrb::io {
namespace {

// Calls visit(face, oriented edge) for each use of an edge in a loop.
template <class Visit>
void for_each_use(const Topology &topology, const Visit &visit) {
    for (size_t f = 0; f < topology.loops.size(); ++f) {
        for (const std::vector<OrientedEdge> &loop : topology.loops[f]) {
            for (const OrientedEdge &edge : loop) {
                visit(f, edge);
            }
        }
    }
}

// Disjoint sets (union-find).
class Groups {
public:
    explicit Groups(size_t count) : leaders_(count) {
        std::iota(leaders_.begin(), leaders_.end(), size_t{0});
    }

    size_t leader(size_t i) noexcept {
        while (leaders_[i] != i) {
            leaders_[i] = leaders_[leaders_[i]];
            i = leaders_[i];
        }
        return i;
    }
    // The smallest member of each group is its leader.
    void join(size_t a, size_t b) noexcept {
        a = leader(a);
        b = leader(b);
        leaders_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<size_t> leaders_;
};

// Joins faces that share an edge and belong to one part, one solid, and one side of it (outer or void).
Groups groups_of(const model::Model &model, const Topology &topology) {
    Groups groups(model.faces.size());
    std::map<std::tuple<size_t, int64_t, int64_t, bool>, size_t> first;
    for_each_use(topology, [&](size_t f, const OrientedEdge &edge) {
        const model::ModelFace &face = model.faces[f];
        const auto [known, fresh] = first.try_emplace({edge.edge, face.part, face.solid, face.in_void}, f);
        if (!fresh) {
            groups.join(known->second, f);
        }
    });
    return groups;
}

// Assigns the closed shells of voids to the first closed outer shell of their solid and part.
void hand_out_voids(std::vector<Shell> &shells) {
    std::map<std::pair<int64_t, int64_t>, size_t> outer; // by solid and part
    for (size_t i = 0; i < shells.size(); ++i) {
        if (shells[i].closed && shells[i].solid >= 0 && !shells[i].in_void) {
            outer.try_emplace({shells[i].solid, shells[i].part}, i);
        }
    }
    for (size_t i = 0; i < shells.size(); ++i) {
        const auto around = outer.find({shells[i].solid, shells[i].part});
        if (shells[i].closed && shells[i].in_void && around != outer.end()) {
            shells[around->second].voids.push_back(i);
            shells[i].inner = true;
        }
    }
}

} // namespace

std::vector<Shell> shells_of(const model::Model &model, const Topology &topology) {
    Groups groups = groups_of(model, topology);
    std::vector<Shell> shells;
    std::vector<size_t> shell_of(model.faces.size());
    for (size_t f = 0; f < model.faces.size(); ++f) {
        if (groups.leader(f) == f) {
            shell_of[f] = shells.size();
            const model::ModelFace &face = model.faces[f];
            shells.push_back({face.part, {}, true, face.solid, face.in_void});
        } else {
            shell_of[f] = shell_of[groups.leader(f)];
        }
        shells[shell_of[f]].faces.push_back(f);
    }
    struct Uses {
        int along = 0, against = 0;
    };
    std::map<std::pair<size_t, size_t>, Uses> uses; // by shell and edge
    for_each_use(topology, [&](size_t face, const OrientedEdge &edge) {
        Uses &all = uses[{shell_of[face], edge.edge}];
        ++(edge.along != model.faces[face].against ? all.along : all.against);
    });
    for (const auto &[place, all] : uses) {
        if (all.along != 1 || all.against != 1) {
            shells[place.first].closed = false;
        }
    }
    hand_out_voids(shells);
    return shells;
}

} // namespace nrb::io
