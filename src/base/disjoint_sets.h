// SPDX-License-Identifier: MIT
// Disjoint sets (union-find): a partition of 0, ..., count - 1 whose sets are merged step by step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace nrb::inline base {

// The representative of a set is its smallest element. find() halves paths as it goes.
class DisjointSets {
public:
    explicit DisjointSets(size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), size_t{0});
    }

    size_t find(size_t i) noexcept {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    void join(size_t i, size_t j) noexcept {
        const auto [least, other] = std::minmax({find(i), find(j)});
        parent_[other] = least;
    }

private:
    std::vector<size_t> parent_; // each at most its own index
};

} // namespace nrb::inline base
