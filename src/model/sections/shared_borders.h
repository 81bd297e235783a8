// SPDX-License-Identifier: MIT
// Which faces go on beyond the curves that bound a face, and where these curves meet.
#pragma once

#include "model/model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::model {

// A curve of a loop of a face.
struct SharedCoedge {
    int64_t face;
    int32_t loop, index;
    int64_t pair = -1;    // of two uses of an edge by faces of one solid, or of none; -1: there are not two
    int32_t side = 0;     // which of the two it is
    bool against = false; // whether the edge runs against the curve
    int64_t start = 0, end = 0; // corners: one number where curves meet, whatever their faces
};

// Cost: linear in the number of curves.
class SharedBorders {
public:
    explicit SharedBorders(const Model &model);

    [[nodiscard]] int64_t number(int64_t face, int32_t loop, int32_t index) const noexcept {
        return first_[static_cast<size_t>(face)][static_cast<size_t>(loop)] + index;
    }
    [[nodiscard]] const SharedCoedge &coedge(int64_t number) const noexcept {
        return coedges_[static_cast<size_t>(number)];
    }
    // Whether a face has to be seen from its other side to run as the first one of those that hang together does. Faces of solids
    // are never turned.
    [[nodiscard]] bool is_turned(int64_t face) const noexcept { return turned_[static_cast<size_t>(face)]; }

private:
    void add_faces(const Model &model);
    void add_edge(const Model &model, const Edge &edge);
    void join_corners();
    void turn_faces(const Model &model);

    std::vector<std::vector<int64_t>> first_; // of each face and loop
    std::vector<SharedCoedge> coedges_;
    std::vector<std::array<int64_t, 2>> pairs_;
    std::vector<std::array<int64_t, 2>> same_; // uses of one edge
    std::vector<bool> turned_;
};

} // namespace nrb::model
