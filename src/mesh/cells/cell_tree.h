// SPDX-License-Identifier: MIT
// The domain of a surface, divided into rectangular cells that are so flat that two triangles each are within
// the chord error of it.
#pragma once

#include "mesh/cells/box_table.h"

#include <functional>
#include <memory>
#include <vector>

namespace nrb::mesh {

// Where a part of the domain is, relative to the face: `border`, if its border comes into the part.
enum class Side { outside, border, inside };

// Relative to the size of the shape: what is no longer than this is not divided for the sake of an angle,
// since near some places no division reaches the angle.
inline constexpr double least_for_angles = 1e-5;

// Lengths are in the units of the grid.
struct CellRule {
    double chord = infinity; // largest deviation
    double inner = 1;        // the share of it for cells that are not at an end of the domain
    double longest = 0;      // longest diagonal of a cell; 0: no limit
    double angle = 0;        // by which the normal may turn over a cell; 0: no limit
    double least = 0;        // what is no longer than this is not cut for the sake of an angle
    // The longest sides of cells in the domain: around a closed axis there are three cells or more, and along
    // an axis that ends at a pole two or more, so that no triangle has two corners at one point but those at
    // a pole.
    std::array<double, 2> most_sides{infinity, infinity};
    std::function<Side(const Rectangle &)> side{}; // empty: everything is inside
    int64_t work_behind = 0; // the work that a cell inside takes later, after it is found

    // Whether cells depend on how far the surface moves on steps in them.
    [[nodiscard]] bool wants_steps() const noexcept { return side || longest > 0 || angle > 0; }
};

// Lines that are closer than this share of a block are one: no cell is that small.
inline constexpr double same_line = 0x1p-36;

// A line u = t or v = t along which cells end. Where the surface may have a kink or a jump, the cells on the
// left and those on the right have a line each, the left one first.
struct CellLine {
    double t;
    bool from_left;
};

// Second derivatives in the middle of a cell, of the coordinates in the axes of its box. They decide how the
// cell is divided into triangles.
struct CellBends {
    std::array<float, 3> uu{}, uv{}, vv{};

    static CellBends of(const HessianBox &box) noexcept;
    // The second derivative of coordinate c along (u, v).
    [[nodiscard]] double along(size_t c, double u, double v) const noexcept {
        return static_cast<double>(uu[c]) * u * u + 2.0 * static_cast<double>(uv[c]) * u * v +
               static_cast<double>(vv[c]) * v * v;
    }
};

struct Cell {
    std::array<int32_t, 2> lower, upper; // numbers of the lines of each axis on which it ends
    int32_t block;
    int32_t node;
    Side side;
    CellBends bends;
};

// Cells lie in blocks between the lines along which the surface may have a kink, so that homogeneous
// coordinates have continuous first derivatives in each. A cell may cover many pieces.
class CellTree {
public:
    // Where work is limited, cells take no more than half of it, because triangles take as much. If that is
    // not enough, the rule is coarsened for all cells alike.
    CellTree(const pieces::PieceGrid &grid, const CellRule &rule);

    // The factor by which the chord error exceeds that of the rule; lengths and angles exceed theirs by its
    // square root.
    [[nodiscard]] double coarsening() const noexcept { return coarsening_; }
    // Cuts each of these cells in two, along the axis where that helps more. Cells that cannot be cut stay.
    void cut(const std::vector<int32_t> &cells);
    // These cells are no longer inside, but at the border.
    void leave_to_border(const std::vector<int32_t> &cells) noexcept;
    // Frees the memory of cells. Blocks and lines stay.
    void clear() noexcept;
    [[nodiscard]] const std::vector<Cell> &cells() const noexcept { return cells_; }
    // The lines of axis k, rising.
    [[nodiscard]] const std::vector<CellLine> &lines(size_t k) const noexcept { return lines_[k]; }
    [[nodiscard]] Rectangle rectangle(const Cell &cell) const noexcept;
    // The bound of second derivatives over a cell. The reference is valid until the next call.
    [[nodiscard]] const HessianBox &box(int32_t cell) const {
        return boxes_->box(cell, rectangle(cells_[static_cast<size_t>(cell)]));
    }
    // Over all cells that there ever were: the most that the surface moves for a step of 1 of the parameter
    // along axis k, if the rule has a function `side`, else 0; and the least weight.
    [[nodiscard]] double speed(size_t k) const noexcept { return speeds_[k]; }
    [[nodiscard]] double least_weight() const noexcept { return least_weight_; }
    // The number of the block that holds a place; the part of the domain that a block is.
    [[nodiscard]] int32_t block_at(const std::array<double, 2> &x) const noexcept;
    [[nodiscard]] Rectangle block(int32_t number) const noexcept;
    // Where blocks end along an axis.
    [[nodiscard]] const std::vector<double> &block_ends(size_t k) const noexcept { return block_ends_[k]; }
    // Calls visit(number of a cell) for all cells that meet a rectangle.
    template <class Visit>
    void for_each_in(const Rectangle &part, Visit &&visit) const;

private:
    class Builder;
    friend class Builder;
    void coarsen(double factor);
    struct Node {
        int32_t axis = -1; // that is split; -1: a leaf; 2: a former leaf, which leads on to another node
        // The cell of a leaf, the other node, or the upper child; the lower child is the node after this one.
        int32_t next = 0;
        double split = 0;
    };

    const pieces::PieceGrid &grid_;
    CellRule rule_;
    std::vector<Cell> cells_;
    std::vector<Node> nodes_;
    std::array<std::vector<CellLine>, 2> lines_;
    std::array<std::vector<int64_t>, 2> blocks_; // numbers of the breaks at which blocks begin, and the last
    std::vector<int32_t> roots_;                 // the node of each block
    std::array<std::vector<double>, 2> block_ends_;
    std::unique_ptr<BoxTable> boxes_;
    std::array<double, 2> speeds_{};
    double least_weight_ = 1;
    double coarsening_ = 1;
};

template <class Visit>
void CellTree::for_each_in(const Rectangle &part, Visit &&visit) const {
    std::vector<int32_t> open;
    const auto first = [&](size_t k) {
        const auto &ends = block_ends_[k];
        const auto at = std::upper_bound(ends.begin() + 1, ends.end() - 1, part.lower[k]) - ends.begin() - 1;
        return at > 0 && ends[static_cast<size_t>(at)] >= part.lower[k] ? at - 1 : at;
    };
    const int64_t across = std::ssize(block_ends_[1]) - 1;
    for (int64_t i = first(0);
         i + 1 < std::ssize(block_ends_[0]) && block_ends_[0][static_cast<size_t>(i)] <= part.upper[0]; ++i) {
        for (int64_t j = first(1); j < across && block_ends_[1][static_cast<size_t>(j)] <= part.upper[1];
             ++j) {
            open.push_back(roots_[static_cast<size_t>(i * across + j)]);
        }
    }
    while (!open.empty()) {
        const int32_t at = open.back();
        open.pop_back();
        const Node &node = nodes_[static_cast<size_t>(at)];
        if (node.axis < 0) {
            visit(node.next);
            continue;
        }
        if (node.axis == 2) {
            open.push_back(node.next);
            continue;
        }
        const auto k = static_cast<size_t>(node.axis);
        if (part.lower[k] <= node.split) {
            open.push_back(at + 1);
        }
        if (part.upper[k] >= node.split) {
            open.push_back(node.next);
        }
    }
}

} // namespace nrb::mesh
