// SPDX-License-Identifier: MIT
// Builds a tree of cells by adaptive subdivision, and divides its cells further.
#pragma once

#include "mesh/cells/cell_shape.h"
#include "mesh/cells/cell_tree.h"

#include <optional>
#include <set>

namespace nrb::mesh {

// Works depth first, so that control nets of cells are needed along one path of the tree only. They form a
// stack in one array.
class CellTree::Builder {
public:
    Builder(const pieces::PieceGrid &grid, const CellRule &rule, CellTree &tree)
        : grid_(grid), rule_(rule), tree_(tree), nets_(grid), one_(nets_.values()) {
        for (size_t k = 0; k < 2; ++k) {
            for (const CellLine &line : tree.lines(k)) {
                known_[k].insert(known_[k].end(), line.t);
            }
        }
    }

    // Returns the share of the area of the domain in which cells are as small as they have to be.
    [[nodiscard]] double build();
    // Cuts a cell in two. Lines are then no longer sorted, until sort_lines().
    void cut(int32_t number);
    void sort_lines();

private:
    // A part of the domain that becomes a cell, or is divided.
    struct Item {
        std::array<int32_t, 2> lower, upper; // numbers of lines
        Rectangle part;
        PieceRange pieces;
        int64_t nets = -1;   // where its control nets begin in the stack, -1: it has none
        int32_t parent = -1; // the node whose upper child it is, -1: none
        int32_t cell = -1;   // the cell that it replaces, -1: none
        int divisions = 0;
        Side side = Side::outside;   // inside: known, since it is part of an item inside
        std::optional<size_t> cut{}; // the axis along which it is cut without looking at it
    };

    void set_blocks();
    void add_block(const std::array<int64_t, 2> &block);
    int32_t add_line(size_t k, double t, bool from_left);
    void look_at(Item item);
    [[nodiscard]] int ends_at(const Item &item, size_t k) const noexcept;
    [[nodiscard]] std::optional<size_t> wide_axis(const Rectangle &part) const noexcept;
    [[nodiscard]] bool is_turned(const HessianBox &box) const noexcept {
        return rule_.angle > 0 && turn_of(box, rule_.least).both > rule_.angle;
    }
    [[nodiscard]] Cut cut_of_flat(const Rectangle &part, const HessianBox &box) const noexcept;
    [[nodiscard]] size_t axis_of_flat(const Rectangle &part, const HessianBox &box) const noexcept;
    [[nodiscard]] Side side_of(const Item &item) const;
    void make_nets(Item &item);
    struct Found {
        HessianBox box;
        bool whole = true; // whether all pieces were looked at
    };
    [[nodiscard]] Found box_of(const Item &item, bool all);
    [[nodiscard]] const double *net_of(const Item &item, int64_t u, int64_t v);
    [[nodiscard]] std::array<double, 2> factors(const Item &item, int64_t u, int64_t v) const noexcept;
    void keep_box(int32_t cell, const Rectangle &part, const HessianBox &box);
    void add_cell(const Item &item, const HessianBox &box, Side side);
    bool divide(Item &item, Cut cut);
    [[nodiscard]] double on_raster(const Item &item, size_t k, double t) const;
    [[nodiscard]] double place_to_cut(const Item &item, size_t k, double share) const;
    void divide_nets(const Item &item, size_t k, double at, Item &low, Item &high);
    [[nodiscard]] Item item_of(const Cell &cell);

    const pieces::PieceGrid &grid_;
    const CellRule &rule_;
    CellTree &tree_;
    CellNets nets_;
    std::vector<double> one_;  // a single net
    std::vector<double> pool_; // the stack of nets
    std::vector<Item> open_;
    std::array<std::set<double>, 2> known_; // parameters of lines
    int32_t block_ = 0;
    double left_ = 0; // area of cells that are still too large
};

} // namespace nrb::mesh
