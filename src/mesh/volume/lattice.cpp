// SPDX-License-Identifier: MIT
#include "mesh/volume/lattice.h"

#include "base/checked.h"
#include "base/disjoint_sets.h"
#include "base/watch.h"

namespace nrb::mesh {

LatticeAxis::LatticeAxis(int degree, const std::vector<bool> &apart, bool closed)
    : degree_(degree), closed_(closed) {
    const int64_t cells = std::ssize(apart) + 1;
    for (int64_t e = 0; e < cells; ++e) {
        const bool shares = e > 0 && !apart[static_cast<size_t>(e - 1)];
        first_.push_back(shares ? layers() - 1 : layers());
        for (int i = shares ? 1 : 0; i <= degree; ++i) {
            source_.push_back(e * (degree + 1) + i);
        }
    }
    if (closed) {
        source_.pop_back();
    }
}

namespace {

std::vector<int> degrees_of_cells(const std::vector<LatticeAxis> &axes) {
    std::vector<int> degrees;
    degrees.reserve(axes.size());
    for (const LatticeAxis &axis : axes) {
        degrees.push_back(axis.degree());
    }
    return degrees;
}

bool any_of(const Collapses &collapses) noexcept {
    return collapses != Collapses{};
}

} // namespace

Lattice::Lattice(std::vector<LatticeAxis> axes, const Collapses &collapses)
    : axes_(std::move(axes)), places_(vtk_places(degrees_of_cells(axes_))) {
    for (const LatticeAxis &axis : axes_) {
        cells_ = checked_product(cells_, axis.cells(), "cells");
        nodes_ = checked_product(nodes_, axis.layers(), "points");
    }
    points_ = nodes_;
    if (any_of(collapses)) {
        collapse(collapses);
    }
}

std::array<int64_t, max_axes> Lattice::layers(int64_t node) const noexcept {
    std::array<int64_t, max_axes> at{};
    for (size_t k = axes_.size(); k-- > 0; node /= axes_[k].layers()) {
        at[k] = node % axes_[k].layers();
    }
    return at;
}

std::array<int64_t, max_axes> Lattice::cell(int64_t index) const noexcept {
    std::array<int64_t, max_axes> at{};
    for (size_t k = axes_.size(); k-- > 0; index /= axes_[k].cells()) {
        at[k] = index % axes_[k].cells();
    }
    return at;
}

// Joins each node of a collapsed side with the node in the first layer along the collapsed axis.
void Lattice::collapse(const Collapses &collapses) {
    DisjointSets sets(static_cast<size_t>(nodes_));
    for (int64_t node = 0; node < nodes_; ++node) {
        count_work(8);
        const std::array<int64_t, max_axes> at = layers(node);
        for (size_t k = 0; k < axes_.size(); ++k) {
            for (const size_t end : {size_t{0}, size_t{1}}) {
                const bool is_side =
                    end == 0 ? at[k] == 0 : !axes_[k].closed() && at[k] == axes_[k].layers() - 1;
                if (!is_side) {
                    continue;
                }
                int64_t step = 1;
                for (size_t l = axes_.size(); l-- > 0; step *= axes_[l].layers()) {
                    if (collapses[k][end][l]) {
                        sets.join(static_cast<size_t>(node), static_cast<size_t>(node - at[l] * step));
                    }
                }
            }
        }
    }
    points_of_.resize(static_cast<size_t>(nodes_));
    for (int64_t node = 0; node < nodes_; ++node) {
        const auto at = static_cast<size_t>(node);
        const size_t first = sets.find(at);
        if (first == at) {
            points_of_[at] = std::ssize(first_nodes_);
            first_nodes_.push_back(node);
        } else {
            points_of_[at] = points_of_[first];
        }
    }
    points_ = std::ssize(first_nodes_);
}

} // namespace nrb::mesh
