// SPDX-License-Identifier: MIT
#include "mesh/cells/place_table.h"

#include "base/watch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace nrb::mesh {

namespace {

uint64_t key_of(int32_t u, int32_t v) noexcept {
    return static_cast<uint64_t>(u) << 32 | static_cast<uint32_t>(v);
}

// Sorts keys by u and then by v, by counting, in linear time. `lines`: the numbers of lines.
void sort_keys(const std::array<size_t, 2> &lines, std::vector<uint64_t> &keys) {
    std::vector<uint64_t> sorted(keys.size());
    for (const size_t axis : {size_t{1}, size_t{0}}) {
        const auto line = [axis](uint64_t key) {
            return static_cast<size_t>(axis == 0 ? key >> 32 : key & 0xffffffffU);
        };
        std::vector<size_t> next(lines[axis] + 1, 0);
        for (const uint64_t key : keys) {
            ++next[line(key) + 1];
        }
        std::partial_sum(next.begin(), next.end(), next.begin());
        for (const uint64_t key : keys) {
            sorted[next[line(key)]++] = key;
        }
        keys.swap(sorted);
    }
}

} // namespace

LineTwins::LineTwins(const CellTree &tree, const pieces::PieceGrid &grid) {
    for (size_t k = 0; k < 2; ++k) {
        const auto &lines = tree.lines(k);
        first[k].resize(lines.size());
        std::iota(first[k].begin(), first[k].end(), 0);
        collapsed[k].assign(lines.size(), 0);
        for (size_t i = 1; i < lines.size(); ++i) {
            const auto axis = static_cast<int>(k);
            if (lines[i].t == lines[i - 1].t && !grid.jumps(axis, grid.find(axis, lines[i].t))) {
                first[k][i] = static_cast<int32_t>(i - 1);
            }
        }
    }
}

void LineTwins::close(size_t k) {
    first[k].back() = 0;
}

PlaceTable::PlaceTable(const CellTree &tree, const LineTwins &twins) : twins_(twins) {
    set_others();
    keys_.reserve(4 * tree.cells().size());
    for (const Cell &cell : tree.cells()) {
        add_corners(cell, keys_);
    }
    sort_keys({tree.lines(0).size(), tree.lines(1).size()}, keys_);
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    keys_ = std::vector(std::as_const(keys_)); // without spare capacity
    index(tree);
}

PlaceTable::PlaceTable(const CellTree &tree, const LineTwins &twins, const PlaceTable &old,
                       const std::array<std::vector<int32_t>, 2> &lines, const std::vector<int32_t> &cells)
    : twins_(twins) {
    set_others();
    std::vector<uint64_t> known, fresh;
    known.reserve(old.keys_.size());
    for (int32_t i = 0; i < old.count(); ++i) {
        const auto place = old.place(i).lines;
        known.push_back(
            key_of(lines[0][static_cast<size_t>(place[0])], lines[1][static_cast<size_t>(place[1])]));
    }
    for (const int32_t cell : cells) {
        add_corners(tree.cells()[static_cast<size_t>(cell)], fresh);
    }
    std::ranges::sort(fresh);
    keys_.resize(known.size() + fresh.size());
    std::ranges::merge(known, fresh, keys_.begin());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    index(tree);
}

void PlaceTable::set_others() {
    for (size_t k = 0; k < 2; ++k) {
        others_[k] = twins_.first[k];
        for (size_t i = 0; i < others_[k].size(); ++i) {
            others_[k][static_cast<size_t>(twins_.first[k][i])] = static_cast<int32_t>(i);
        }
    }
}

void PlaceTable::add_corners(const Cell &cell, std::vector<uint64_t> &keys) const {
    if (cell.side == Side::outside) {
        return;
    }
    for (size_t c = 0; c < 4; ++c) {
        const int32_t u = c % 2 == 0 ? cell.lower[0] : cell.upper[0],
                      v = c < 2 ? cell.lower[1] : cell.upper[1];
        const int32_t u2 = others_[0][static_cast<size_t>(u)], v2 = others_[1][static_cast<size_t>(v)];
        keys.push_back(key_of(u, v));
        if (u2 != u) {
            keys.push_back(key_of(u2, v));
        }
        if (v2 != v) {
            keys.push_back(key_of(u, v2));
        }
        if (u2 != u && v2 != v) {
            keys.push_back(key_of(u2, v2));
        }
    }
    count_work(100);
}

// Indexes the places by lines of both axes. Keys are sorted, so that on each line places come in order.
void PlaceTable::index(const CellTree &tree) {
    first_on_u_.resize(tree.lines(0).size() + 1);
    int32_t at = 0;
    for (size_t u = 0; u < first_on_u_.size(); ++u) {
        for (; at < count() && (keys_[static_cast<size_t>(at)] >> 32) < u; ++at) {
        }
        first_on_u_[u] = at;
    }
    std::vector<int32_t> starts(tree.lines(1).size() + 1, 0);
    for (const uint64_t key : keys_) {
        ++starts[(key & 0xffffffffU) + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    first_on_v_ = starts;
    across_.resize(keys_.size());
    where_.resize(keys_.size());
    for (int32_t i = 0; i < count(); ++i) {
        int32_t &next = starts[keys_[static_cast<size_t>(i)] & 0xffffffffU];
        across_[static_cast<size_t>(next)] = i;
        where_[static_cast<size_t>(i)] = next++;
    }
}

int32_t PlaceTable::find(int32_t u, int32_t v) const noexcept {
    const auto first = keys_.begin() + first_on_u_[static_cast<size_t>(u)],
               last = keys_.begin() + first_on_u_[static_cast<size_t>(u) + 1];
    return static_cast<int32_t>(std::lower_bound(first, last, key_of(u, v)) - keys_.begin());
}

int32_t PlaceTable::point_of(int32_t i) const {
    const auto [u, v] = place(i).lines;
    const int32_t first_u = twins_.first[0][static_cast<size_t>(u)],
                  first_v = twins_.first[1][static_cast<size_t>(v)];
    if (twins_.collapsed[0][static_cast<size_t>(first_u)] != 0) {
        return first_on_u_[static_cast<size_t>(first_u)];
    }
    if (twins_.collapsed[1][static_cast<size_t>(first_v)] != 0) {
        return across_[static_cast<size_t>(first_on_v_[static_cast<size_t>(first_v)])];
    }
    return first_u == u && first_v == v ? i : find(first_u, first_v);
}

std::vector<int32_t> PlaceTable::on_line(size_t k, int32_t line) const {
    const auto &starts = k == 0 ? first_on_u_ : first_on_v_;
    std::vector<int32_t> result;
    for (int32_t i = starts[static_cast<size_t>(line)]; i < starts[static_cast<size_t>(line) + 1]; ++i) {
        result.push_back(k == 0 ? i : across_[static_cast<size_t>(i)]);
    }
    return result;
}

int32_t PlaceTable::border_count(const std::array<int32_t, 4> &corners) const noexcept {
    const auto where = [&](int32_t i) { return where_[static_cast<size_t>(i)]; };
    const auto [a, b, c, d] = corners;
    return where(b) - where(a) + (c - b) + where(c) - where(d) + (d - a);
}

void PlaceTable::border(const std::array<int32_t, 4> &corners, std::vector<int32_t> &places) const {
    const auto [a, b, c, d] = corners;
    places.clear();
    for (int32_t i = where_[static_cast<size_t>(a)]; i < where_[static_cast<size_t>(b)]; ++i) {
        places.push_back(across_[static_cast<size_t>(i)]);
    }
    for (int32_t i = b; i < c; ++i) {
        places.push_back(i);
    }
    for (int32_t i = where_[static_cast<size_t>(c)]; i > where_[static_cast<size_t>(d)]; --i) {
        places.push_back(across_[static_cast<size_t>(i)]);
    }
    for (int32_t i = d; i > a; --i) {
        places.push_back(i);
    }
}

} // namespace nrb::mesh
