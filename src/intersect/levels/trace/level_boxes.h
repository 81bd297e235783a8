// SPDX-License-Identifier: MIT
// The zeros of a function on one piece, in boxes on which they are graphs.
#pragma once

#include "intersect/levels/trace/level_net.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace nrb::intersect {

// A place where a level passes from one box into another, or ends.
struct LevelRoot {
    std::array<double, 2> at; // parameters of the surface
    bool is_end = false;      // f jumps there
};

// Part of a piece: from lower to lower + length, in [0, 1]^2.
struct LevelPart {
    int64_t piece = 0;
    std::array<double, 2> lower{0, 0}, length{1, 1};
};

// Between two roots, in a box in which f changes strictly along the other axis: there is one zero for each value of
// the coordinate `axis` between those of the roots, and f > 0 on the left of the way.
struct LevelArc {
    LevelPart part;
    size_t axis = 0;
    int32_t from = 0, to = 0;
    std::array<double, 2> first{}, last{}; // their places in [0, 1]^2 of the piece

    // In the corner of a box.
    [[nodiscard]] bool is_point() const noexcept;
};

// A part in which the zeros are not told apart: |f| is near 0 all over it, or it is as small as parts become.
struct LevelCluster {
    LevelPart part;
    std::vector<int32_t> roots; // on its border
    bool near = true;           // within the tolerance of 0 all over
    bool beside = false;        // on a side of a piece: it is one only if no arc begins or ends there
};

struct LevelPieces {
    std::vector<LevelRoot> roots;
    std::vector<LevelArc> arcs;
    std::vector<LevelCluster> clusters;
    std::map<std::array<double, 2>, int32_t>
        corners;                                   // roots at corners of boxes, on the border of the surface
    std::array<std::optional<Interval>, 2> closed; // domains whose ends are one line

    int32_t add_root(const std::array<double, 2> &at);
    int32_t corner(const std::array<double, 2> &at);
};

// A root on an edge, by its place along it.
struct EdgeRoot {
    int32_t root;
    double place; // in [0, 1] of the piece
};

// What a side of a box is to the surface.
enum class LevelSide : unsigned char {
    inside, // of a piece
    joined, // to the next piece
    open    // the surface ends there
};

// The signs at the corners and the roots on the edges of a box: what its neighbours have there too. Edge 2 k + e is
// where coordinate k has its lower or upper end.
struct LevelBorder {
    std::array<std::array<bool, 2>, 2> above{};
    std::array<std::vector<EdgeRoot>, 4> edges;
    std::array<LevelSide, 4> sides{};
    std::array<bool, 4> collapsed{}; // in one point
};

// Parameters of a piece.
struct PieceDomain {
    std::array<double, 2> lower, upper;
    [[nodiscard]] double parameter(size_t axis, double place) const noexcept {
        const double between = lower[axis] * (1 - place) + upper[axis] * place;
        return place == 1 ? upper[axis] : std::clamp(between, lower[axis], upper[axis]);
    }
};

// Halves a piece until f changes strictly along an axis, so that zeros are graphs over the other one, which neither
// close nor end inside: sorted along that axis, the first two roots on the border are the ends of an arc, and so on.
//
// Where f is 0 to rounding on the border of the surface it counts as above. So arcs run along such an edge if f is below
// inside; if it is above, the edge is an arc of its own, and a place on it, or a pole, a cluster. Where pieces are
// joined and f is above on both sides, both are clusters.
class BoxSearch {
public:
    // near: |f| up to which zeros need not be told apart.
    BoxSearch(LevelPieces &found, double near) : found_(found), near_(near) {}

    void run(int64_t piece, const PieceDomain &domain, LevelNet net, LevelBorder border);

private:
    struct Box {
        LevelPart part;
        LevelNet net;
        LevelBorder border;
        int depth = 0;
    };
    void look(Box &box);
    bool take_arcs(const Box &box, size_t axis, int sign);
    static std::optional<LevelPart> pole_of(const Box &box, const std::array<double, 2> &first,
                                            const std::array<double, 2> &last);
    void take_sides(const Box &box, const std::array<LevelNet::Slope, 2> &slopes);
    void take_edge(const Box &box, size_t axis, size_t end);
    void take_touches(const Box &box, size_t axis, size_t end, LevelNet::Edge edge);
    void take_touch(const Box &box, size_t axis, size_t end, Interval range, bool near);
    void take_cluster(const Box &box, bool near);
    [[nodiscard]] std::array<double, 2> parameters(const std::array<double, 2> &place) const noexcept;
    void halve(Box &box);
    void set_middle(LevelBorder &whole, Box &lower, Box &upper, size_t axis, double middle);
    std::vector<EdgeRoot> middle_roots(const Box &box, size_t axis, bool start, bool end);

    LevelPieces &found_;
    double near_;
    PieceDomain domain_{};
    std::vector<Box> stack_;
};

} // namespace nrb::intersect
