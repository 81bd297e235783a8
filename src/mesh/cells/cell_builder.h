// SPDX-License-Identifier: MIT
// Makes the cells of a tree.
#pragma once

#include "mesh/cells/cell_shape.h"
#include "mesh/cells/cell_tree.h"

#include <optional>

namespace nrb::mesh {

// Goes into depth, so that nets of cells are needed along one way only; they lie on each other in one array.
class CellTree::Builder {
public:
    Builder(const pieces::PieceGrid &grid, const CellRule &rule, CellTree &tree)
        : grid_(grid), rule_(rule), tree_(tree), nets_(grid), one_(nets_.values()) {}

    void build();
    void cut(int32_t number);
    void sort_lines();

private:
    struct Item {
        std::array<int32_t, 2> lower, upper; // lines
        Rectangle part;
        PieceRange pieces;
        int64_t nets = -1;   // where they begin
        int32_t parent = -1; // whose upper child it is
        int32_t cell = -1;   // which it takes the place of
        int divisions = 0;
        int32_t known = CellMemo::unknown; // its number in the memo
    };

    void set_blocks();
    void add_block(const std::array<int64_t, 2> &block);
    int32_t add_line(size_t k, double t, bool from_left);
    void look_at(Item item);
    [[nodiscard]] bool at_border(const Item &item) const noexcept;
    [[nodiscard]] std::optional<size_t> wide_axis(const Rectangle &part) const noexcept;
    [[nodiscard]] bool is_turned(const HessianBox &box) const noexcept {
        return rule_.angle > 0 && turn_of(box, rule_.least).both > rule_.angle;
    }
    [[nodiscard]] Cut cut_of(const Rectangle &part, const LookedAt &found) const noexcept;
    void make_nets(Item &item);
    void number_halves(const Item &item, size_t k, double at, Item &low, Item &high) const;
    struct Found {
        HessianBox box;
        bool whole = true; // all pieces were looked at
    };
    [[nodiscard]] Found box_of(const Item &item, bool all);
    struct Looked : LookedAt {
        bool whole = true;
    };
    [[nodiscard]] Looked looked_at(const Item &item, bool all);
    void count_nets(int64_t nets) const;
    [[nodiscard]] const double *net_of(const Item &item, int64_t u, int64_t v);
    [[nodiscard]] std::array<double, 2> factors(const Item &item, int64_t u, int64_t v) const noexcept;
    void add_cell(const Item &item, const HessianBox &box, Side side);
    bool divide(Item &item, Cut cut);
    [[nodiscard]] double on_raster(const Item &item, size_t k, double t) const noexcept;
    [[nodiscard]] double place_to_cut(const Item &item, size_t k, double share) const noexcept;
    void divide_nets(const Item &item, size_t k, double at, Item &low, Item &high);
    [[nodiscard]] Item item_of(const Cell &cell);

    const pieces::PieceGrid &grid_;
    const CellRule &rule_;
    CellTree &tree_;
    CellNets nets_;
    std::vector<double> one_;
    std::vector<double> pool_;
    std::vector<Item> open_;
    int32_t block_ = 0;
};

} // namespace nrb::mesh
