// SPDX-License-Identifier: MIT
// The cells of a domain and the places where they have corners, kept up to date while cells are divided.
#pragma once

#include "mesh/cells/place_table.h"
#include "mesh/domain/domain_mesh.h"

#include <memory>
#include <vector>

namespace nrb::mesh {

class CellGrid {
public:
    CellGrid(const MeshDomain &domain, const pieces::PieceGrid &grid, const CellRule &rule);

    [[nodiscard]] const CellTree &tree() const noexcept { return tree_; }
    [[nodiscard]] const PlaceTable &table() const noexcept { return *table_; }
    [[nodiscard]] double t_of(size_t k, int32_t line) const noexcept {
        return tree_.lines(k)[static_cast<size_t>(line)].t;
    }
    [[nodiscard]] std::array<double, 2> param(int32_t place) const noexcept {
        const auto lines = table_->place(place).lines;
        return {t_of(0, lines[0]), t_of(1, lines[1])};
    }
    // The same place by the lines of a block at whose border it is: along a kink, cells on either side have
    // lines of their own.
    [[nodiscard]] int32_t in_block(int32_t place, const Rectangle &block) const noexcept;
    // If the parameters lie on an end of the domain that is a single point (a pole): a place on this end; -1:
    // none.
    [[nodiscard]] int32_t pole_at(const std::array<double, 2> &param) const;
    [[nodiscard]] bool is_at_end(int32_t place) const noexcept;
    // Whether a place lies inside the domain on two lines at which the surface may have kinks.
    [[nodiscard]] bool is_crossing(int32_t place) const noexcept;
    // Whether a line ends there at a pole or at a seam: a seam, a line at which the surface may have a kink,
    // or a side of the domain.
    [[nodiscard]] bool ends_line(int32_t place) const noexcept;

    // A place, moved to the lines from which it differs by no more than rounding.
    [[nodiscard]] std::array<double, 2> at_lines(std::array<double, 2> place) const noexcept;
    // How far apart two places are, as a share of the extent of the domain: the larger one of both axes.
    [[nodiscard]] double share(const std::array<double, 2> &a, const std::array<double, 2> &b) const noexcept;

    // Marks cells as being at the border, no longer inside.
    void leave_to_border(const std::vector<int32_t> &cells) noexcept { tree_.leave_to_border(cells); }
    // Divides cells in two. Returns the new number of each place.
    std::vector<int32_t> cut(const std::vector<int32_t> &cells);
    // Frees the memory. Nothing can be asked for afterwards.
    void clear() noexcept;

private:
    void make_twins();

    const MeshDomain &domain_;
    const pieces::PieceGrid &grid_;
    CellTree tree_;
    std::unique_ptr<const LineTwins> twins_;
    std::unique_ptr<const PlaceTable> table_;
};

} // namespace nrb::mesh
