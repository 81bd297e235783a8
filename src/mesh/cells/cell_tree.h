// SPDX-License-Identifier: MIT
// A surface in cells that are so flat that two triangles each are within a distance of it.
#pragma once

#include "mesh/cells/box_table.h"

#include <functional>
#include <memory>
#include <vector>

namespace nrb::mesh {

// Where a part of the domain is in relation to what is to be meshed.
enum class Side { outside, border, inside };

// Of the size of all: what is no longer is not divided for an angle, which may be reached nowhere near a place.
inline constexpr double least_for_angles = 1e-5;

struct CellRule {
    double chord = infinity; // in the units of the grid
    double longest = 0;      // diagonal of a cell; 0: no limit
    double angle = 0;        // by which the normal turns over a cell; 0: no limit
    double least = 0;        // what is no longer than that is not cut for an angle
    // Longest sides of cells: around a closed axis there are three or more, between two poles two or more, so that no triangle has two
    // corners in one point but those at a pole.
    std::array<double, 2> most_sides{infinity, infinity};
    std::function<Side(const Rectangle &)> side{}; // empty: everything is inside
    int64_t work_behind = 0; // what a cell that stays takes later, beyond what it takes to find it

    // Whether it depends on how far the surface moves on steps in cells.
    [[nodiscard]] bool wants_steps() const noexcept { return side || longest > 0 || angle > 0; }
};

// Lines that are nearer to each other than this share of a block are one: no cell is as small.
inline constexpr double same_line = 0x1p-36;

// A line u = t or v = t along which cells end. Where the surface may have a kink or a jump, cells to its left and to its right have
// lines of their own, the left one first.
struct CellLine {
    double t;
    bool from_left;
};

// Second derivatives in the middle of a cell, of its coordinates in the axes of its box: these choose where to divide it.
struct CellBends {
    std::array<float, 3> uu{}, uv{}, vv{};

    static CellBends of(const HessianBox &box) noexcept;
    // That of coordinate c along (u, v).
    [[nodiscard]] double along(size_t c, double u, double v) const noexcept {
        return static_cast<double>(uu[c]) * u * u + 2.0 * static_cast<double>(uv[c]) * u * v +
               static_cast<double>(vv[c]) * v * v;
    }
};

struct Cell {
    std::array<int32_t, 2> lower, upper; // numbers of lines of each axis
    int32_t block;
    int32_t node;
    Side side;
    CellBends bends;
};

// Cells lie in blocks between the lines along which the surface may have a kink, so that homogeneous coordinates have continuous
// first derivatives in each. A cell may cover many pieces.
class CellTree {
public:
    // With half of the work, where that is limited: triangles take as much as cells. What would take more is made for larger
    // distances, equally all over.
    CellTree(const pieces::PieceGrid &grid, const CellRule &rule);

    // By what distances are larger than those of the rule, and by the square of what lengths and angles are.
    [[nodiscard]] double coarsening() const noexcept { return coarsening_; }
    // Cuts cells in two, along which axis a function of each says. Cells that cannot be cut stay.
    void cut(const std::vector<int32_t> &cells);
    // Cells that are no longer inside, but at the border.
    void leave_to_border(const std::vector<int32_t> &cells) noexcept;
    // Frees the memory of cells. Blocks stay.
    void clear() noexcept;
    [[nodiscard]] const std::vector<Cell> &cells() const noexcept { return cells_; }
    // Rising.
    [[nodiscard]] const std::vector<CellLine> &lines(size_t k) const noexcept { return lines_[k]; }
    [[nodiscard]] Rectangle rectangle(const Cell &cell) const noexcept;
    // What second derivatives can be over a cell; until the next call.
    [[nodiscard]] const HessianBox &box(int32_t cell) const {
        return boxes_->box(cell, rectangle(cells_[static_cast<size_t>(cell)]));
    }
    // Of all cells that there ever were the most that the surface moves by on a step along an axis, where there is a rule for sides, and
    // the least weight.
    [[nodiscard]] double speed(size_t k) const noexcept { return speeds_[k]; }
    [[nodiscard]] double least_weight() const noexcept { return least_weight_; }
    // The block that holds a place; its part of the domain.
    [[nodiscard]] int32_t block_at(const std::array<double, 2> &x) const noexcept;
    [[nodiscard]] Rectangle block(int32_t number) const noexcept;
    // Where blocks end along an axis.
    [[nodiscard]] const std::vector<double> &block_ends(size_t k) const noexcept { return block_ends_[k]; }
    // Calls visit(number of a cell) for the cells that meet a rectangle.
    template <class Visit>
    void for_each_in(const Rectangle &part, Visit &&visit) const;

private:
    class Builder;
    friend class Builder;
    void coarsen(double factor);
    struct Node {
        int32_t axis = -1; // -1: a leaf; 2: it was one, and leads on
        int32_t next = 0;  // the cell, or the upper child; the lower one is the next node
        double split = 0;
    };

    const pieces::PieceGrid &grid_;
    CellRule rule_;
    std::vector<Cell> cells_;
    std::vector<Node> nodes_;
    std::array<std::vector<CellLine>, 2> lines_;
    std::array<std::vector<int64_t>, 2> blocks_; // breaks at which they begin, and the last break
    std::vector<int32_t> roots_;                 // nodes of the blocks
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
