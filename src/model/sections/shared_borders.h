// SPDX-License-Identifier: MIT
// Adjacency of faces: which face continues beyond each curve that bounds a face, and at which corners these
// curves meet.
#pragma once

#include "model/model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::model {

// A coedge (a curve of a loop of a face) with its neighbours.
struct SharedCoedge {
    int64_t face;
    int32_t loop, index;
    // The number of the pair that two uses of an edge by faces of one solid, or of none, form; -1: there are
    // not exactly two.
    int64_t pair = -1;
    int32_t side = 0;           // which of the two it is
    bool against = false;       // whether the edge runs against the curve
    int64_t start = 0, end = 0; // corners; curves that meet have a common number, whatever their faces
};

// Construction is linear in the number of curves.
class SharedBorders {
public:
    explicit SharedBorders(const Model &model);

    [[nodiscard]] int64_t number(int64_t face, int32_t loop, int32_t index) const noexcept {
        return first_[static_cast<size_t>(face)][static_cast<size_t>(loop)] + index;
    }
    [[nodiscard]] const SharedCoedge &coedge(int64_t number) const noexcept {
        return coedges_[static_cast<size_t>(number)];
    }
    // Whether a face has to be turned to be oriented like the first face of its shell, the faces connected by
    // edges. Faces of solids are never turned.
    [[nodiscard]] bool is_turned(int64_t face) const noexcept { return turned_[static_cast<size_t>(face)]; }

private:
    void add_faces(const Model &model);
    void add_edge(const Model &model, const Edge &edge);
    void join_corners();
    void turn_faces(const Model &model);

    std::vector<std::vector<int64_t>> first_; // indexed by face and loop
    std::vector<SharedCoedge> coedges_;
    std::vector<std::array<int64_t, 2>> pairs_;
    std::vector<std::array<int64_t, 2>> same_; // consecutive uses of an edge
    std::vector<bool> turned_;
};

} // namespace nrb::model
