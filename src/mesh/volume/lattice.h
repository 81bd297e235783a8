// SPDX-License-Identifier: MIT
// Cells side by side along one to three axes, and the points that they share.
#pragma once

#include "base/limits.h"
#include "mesh/volume/vtk_order.h"

#include <cstdint>
#include <vector>

namespace nrb::mesh {

// Cells along an axis, each with degree + 1 layers of points. Neighbouring cells share a layer.
class LatticeAxis {
public:
    // apart[i]: cells i and i + 1 do not share a layer. On a closed axis the last layer of the last cell is
    // the first layer of the first cell.
    LatticeAxis(int degree, const std::vector<bool> &apart, bool closed);

    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] bool closed() const noexcept { return closed_; }
    [[nodiscard]] int64_t cells() const noexcept { return static_cast<int64_t>(first_.size()); }
    [[nodiscard]] int64_t layers() const noexcept { return static_cast<int64_t>(source_.size()); }
    // Layer i of a cell. On a closed axis layers() stands for layer 0.
    [[nodiscard]] int64_t layer(int64_t cell, int i) const noexcept {
        return first_[static_cast<size_t>(cell)] + i;
    }
    // The first occurrence of a layer in a cell: cell * (degree + 1) + i.
    [[nodiscard]] int64_t source(int64_t layer) const noexcept { return source_[static_cast<size_t>(layer)]; }

private:
    int degree_;
    bool closed_;
    std::vector<int64_t> first_, source_;
};

// Degenerate sides of the lattice: [k][e][l] says that at end e (0 or 1) of axis k all points along axis l
// are one.
using Collapses = std::array<std::array<std::array<bool, max_axes>, 2>, max_axes>;

// A node is a combination of layers. Nodes that fall together on collapsed sides are one point. Last axis
// fastest.
class Lattice {
public:
    // Throws Status::overflow.
    explicit Lattice(std::vector<LatticeAxis> axes, const Collapses &collapses = {});

    [[nodiscard]] const LatticeAxis &axis(size_t k) const noexcept { return axes_[k]; }
    [[nodiscard]] size_t axes() const noexcept { return axes_.size(); }
    [[nodiscard]] int64_t cells() const noexcept { return cells_; }
    [[nodiscard]] int64_t points() const noexcept { return points_; }
    [[nodiscard]] int64_t nodes() const noexcept { return nodes_; }
    [[nodiscard]] int64_t corners() const noexcept { return static_cast<int64_t>(places_.size()); }
    // The first node of a point, and the point of a node.
    [[nodiscard]] int64_t node(int64_t point) const noexcept {
        return first_nodes_.empty() ? point : first_nodes_[static_cast<size_t>(point)];
    }
    [[nodiscard]] int64_t point(int64_t node) const noexcept {
        return points_of_.empty() ? node : points_of_[static_cast<size_t>(node)];
    }
    // The point at some layers; on a closed axis layers() stands for layer 0.
    [[nodiscard]] int64_t point_at(const std::array<int64_t, max_axes> &layers) const noexcept {
        int64_t node = 0;
        for (size_t k = 0; k < axes_.size(); ++k) {
            node = node * axes_[k].layers() + (layers[k] < axes_[k].layers() ? layers[k] : 0);
        }
        return point(node);
    }
    // The layers of a node, and the indices of a cell along the axes.
    [[nodiscard]] std::array<int64_t, max_axes> layers(int64_t node) const noexcept;
    [[nodiscard]] std::array<int64_t, max_axes> cell(int64_t index) const noexcept;

    [[nodiscard]] size_t cell_index(const std::array<size_t, max_axes> &at) const noexcept {
        size_t index = 0;
        for (size_t k = 0; k < axes_.size(); ++k) {
            index = index * static_cast<size_t>(axes_[k].cells()) + at[k];
        }
        return index;
    }

    // The points of a cell in the order of VTK.
    template <class Integer>
    void copy_cell(int64_t index, Integer *out) const noexcept {
        const std::array<int64_t, max_axes> at = cell(index);
        for (const CellPlace &place : places_) {
            std::array<int64_t, max_axes> layers{};
            for (size_t k = 0; k < axes_.size(); ++k) {
                layers[k] = axes_[k].layer(at[k], place[k]);
            }
            *out++ = static_cast<Integer>(point_at(layers));
        }
    }

private:
    void collapse(const Collapses &collapses);

    std::vector<LatticeAxis> axes_;
    std::vector<CellPlace> places_; // of the points of a cell
    int64_t cells_ = 1, nodes_ = 1, points_ = 1;
    std::vector<int64_t> first_nodes_, points_of_; // empty: each node is a point of its own
};

} // namespace nrb::mesh
