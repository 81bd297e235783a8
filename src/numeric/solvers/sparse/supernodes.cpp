// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/supernodes.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::inline numeric {

namespace {

using sparse::at;

// Neighbouring columns on a path of the elimination tree, before their rows are known.
struct ColumnRange {
    int32_t first, end;
    int64_t below;   // number of rows below
    double elements; // nonzeros of the factor

    [[nodiscard]] double size() const noexcept {
        const double columns = end - first;
        return columns * (columns + 1) / 2 + columns * static_cast<double>(below);
    }
};

// The relaxed amalgamation of CHOLMOD (Y. Chen, T. Davis, W. Hager, S. Rajamanickam, ACM TOMS 35 (2008)).
bool worth_joining(const ColumnRange &joined) noexcept {
    const int32_t columns = joined.end - joined.first;
    const double zeros = 1 - joined.elements / joined.size();
    return columns <= 4 || zeros < (columns <= 16 ? 0.8 : columns <= 48 ? 0.1 : 0.05);
}

std::vector<ColumnRange> ranges(std::span<const int32_t> parent, std::span<const int64_t> counts) {
    std::vector<ColumnRange> found;
    for (int32_t j = 0; j < std::ssize(parent); ++j) {
        ColumnRange next{j, j + 1, counts[at(j)], static_cast<double>(counts[at(j)] + 1)};
        while (!found.empty()) {
            const ColumnRange &before = found.back();
            const int32_t above = parent[at(before.end - 1)];
            const ColumnRange joined{before.first, next.end, next.below, before.elements + next.elements};
            if (above < next.first || above >= next.end || !worth_joining(joined)) {
                break;
            }
            next = joined;
            found.pop_back();
        }
        found.push_back(next);
    }
    return found;
}

} // namespace

// The rows of a supernode are those of its columns in the matrix, and those of its children in the
// elimination tree.
template <class Number>
Supernodes find_supernodes(const ColumnsOf<Number> &matrix, std::span<const int32_t> parent,
                           std::span<const int64_t> counts) {
    const std::vector<ColumnRange> found = ranges(parent, counts);
    Supernodes result;
    std::vector<int32_t> owner(parent.size()), seen(parent.size(), -1);
    std::vector<std::vector<int32_t>> children(found.size());
    result.starts.push_back(0);
    for (const ColumnRange &range : found) {
        std::fill(owner.begin() + range.first, owner.begin() + range.end,
                  static_cast<int32_t>(result.first.size()));
        result.first.push_back(range.first);
    }
    result.first.push_back(static_cast<int32_t>(parent.size()));
    for (int32_t s = 0; s < std::ssize(found); ++s) {
        const auto start = std::ssize(result.rows);
        const int32_t end = result.first[at(s) + 1];
        const auto add = [&](int32_t row) {
            if (row >= end && seen[at(row)] != s) {
                seen[at(row)] = s;
                result.rows.push_back(row);
            }
        };
        for (int64_t p = matrix.starts[at(result.first[at(s)])]; p < matrix.starts[at(end)]; ++p) {
            add(matrix.rows[at(p)]);
        }
        for (const int32_t child : children[at(s)]) {
            for (int64_t p = result.starts[at(child)]; p < result.starts[at(child) + 1]; ++p) {
                add(result.rows[at(p)]);
            }
        }
        std::sort(result.rows.begin() + start, result.rows.end());
        count_work(8 * (std::ssize(result.rows) - start));
        result.starts.push_back(std::ssize(result.rows));
        result.parent.push_back(std::ssize(result.rows) > start ? owner[at(result.rows[at(start)])] : -1);
        if (result.parent.back() >= 0) {
            children[at(result.parent.back())].push_back(s);
        }
        children[at(s)] = std::vector<int32_t>();
    }
    return result;
}

template Supernodes find_supernodes(const ColumnsOf<double> &, std::span<const int32_t>,
                                    std::span<const int64_t>);

} // namespace nrb::inline numeric
