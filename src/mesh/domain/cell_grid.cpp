// SPDX-License-Identifier: MIT
#include "mesh/domain/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

CellGrid::CellGrid(const MeshDomain &domain, const pieces::PieceGrid &grid, const CellRule &rule)
    : domain_(domain), grid_(grid), tree_(grid, rule) {
    make_twins();
    table_ = std::make_unique<const PlaceTable>(tree_, *twins_);
}

void CellGrid::make_twins() {
    auto twins = std::make_unique<LineTwins>(tree_, grid_);
    for (size_t k = 0; k < 2; ++k) {
        if (domain_.closed[k]) {
            twins->close(k);
        }
        twins->collapsed[k].front() = domain_.collapsed[k][0] ? 1 : 0;
        twins->collapsed[k].back() = domain_.collapsed[k][1] ? 1 : 0;
    }
    twins_ = std::move(twins);
}

int32_t CellGrid::in_block(int32_t place, const Rectangle &block) const noexcept {
    auto lines = table_->place(place).lines;
    for (size_t k = 0; k < 2; ++k) {
        const auto &all = tree_.lines(k);
        const auto at = static_cast<size_t>(lines[k]);
        if (all[at].t == block.upper[k] && !all[at].from_left && at > 0 && all[at - 1].t == all[at].t) {
            --lines[k];
        } else if (all[at].t == block.lower[k] && all[at].from_left && at + 1 < all.size() &&
                   all[at + 1].t == all[at].t) {
            ++lines[k];
        }
    }
    return table_->find(lines[0], lines[1]);
}

std::array<double, 2> CellGrid::at_lines(std::array<double, 2> place) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const auto &all = tree_.lines(k);
        const double room = same_line * (all.back().t - all.front().t), t = place[k];
        auto at = std::ranges::lower_bound(all, t - room, {}, &CellLine::t);
        for (double distance = room; at != all.end() && at->t <= t + room; ++at) {
            if (std::abs(at->t - t) < distance) {
                distance = std::abs(at->t - t);
                place[k] = at->t;
            }
        }
    }
    return place;
}

int32_t CellGrid::pole_at(const std::array<double, 2> &param) const {
    for (size_t k = 0; k < 2; ++k) {
        for (const size_t end : {size_t{0}, size_t{1}}) {
            const int32_t line = end == 0 ? 0 : static_cast<int32_t>(tree_.lines(k).size()) - 1;
            if (domain_.collapsed[k][end] && param[k] == t_of(k, line)) {
                const std::vector<int32_t> places = table_->on_line(k, line);
                return places.empty() ? -1 : places.front();
            }
        }
    }
    return -1;
}

bool CellGrid::is_at_end(int32_t place) const noexcept {
    const auto lines = table_->place(place).lines;
    return lines[0] == 0 || lines[1] == 0 || lines[0] + 1 == std::ssize(tree_.lines(0)) ||
           lines[1] + 1 == std::ssize(tree_.lines(1));
}

bool CellGrid::ends_line(int32_t place) const noexcept {
    const std::array<double, 2> x = param(place);
    bool result = false;
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = tree_.block_ends(k);
        const bool closes = (x[k] == ends.front() && (domain_.closed[k] || domain_.collapsed[k][0])) ||
                            (x[k] == ends.back() && (domain_.closed[k] || domain_.collapsed[k][1]));
        result = result || (closes && std::ranges::binary_search(tree_.block_ends(1 - k), x[1 - k]));
    }
    return result;
}

bool CellGrid::is_crossing(int32_t place) const noexcept {
    const std::array<double, 2> x = param(place);
    bool result = !is_at_end(place);
    for (size_t k = 0; k < 2; ++k) {
        result = result && std::ranges::binary_search(tree_.block_ends(k), x[k]);
    }
    return result;
}

double CellGrid::share(const std::array<double, 2> &a, const std::array<double, 2> &b) const noexcept {
    double most = 0;
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = tree_.block_ends(k);
        most = std::max(most, std::abs(a[k] - b[k]) / (ends.back() - ends.front()));
    }
    return most;
}

void CellGrid::clear() noexcept {
    table_.reset();
    twins_.reset();
    tree_.clear();
}

namespace {

// The numbers that the old lines have among all, which contain them; both rise.
std::vector<int32_t> numbers_among(const std::vector<CellLine> &old, const std::vector<CellLine> &all) {
    std::vector<int32_t> result;
    size_t at = 0;
    for (const CellLine &line : old) {
        while (all[at].t != line.t || all[at].from_left != line.from_left) {
            ++at;
        }
        result.push_back(static_cast<int32_t>(at));
    }
    return result;
}

} // namespace

// Places keep their order, so that one pass over both tables finds all new numbers.
std::vector<int32_t> CellGrid::cut(const std::vector<int32_t> &cells) {
    const std::array<std::vector<CellLine>, 2> lines{tree_.lines(0), tree_.lines(1)};
    const auto old_twins = std::move(twins_);
    const auto old = std::move(table_);
    const auto first = static_cast<int32_t>(tree_.cells().size());
    tree_.cut(cells);
    make_twins();
    std::vector<int32_t> changed = cells;
    for (int32_t i = first; i < static_cast<int32_t>(tree_.cells().size()); ++i) {
        changed.push_back(i);
    }
    const std::array<std::vector<int32_t>, 2> numbers{numbers_among(lines[0], tree_.lines(0)),
                                                      numbers_among(lines[1], tree_.lines(1))};
    table_ = std::make_unique<const PlaceTable>(tree_, *twins_, *old, numbers, changed);
    std::vector<int32_t> result;
    int32_t at = 0;
    for (int32_t i = 0; i < old->count(); ++i) {
        const auto place = old->place(i).lines;
        const std::array<int32_t, 2> wanted{numbers[0][static_cast<size_t>(place[0])],
                                            numbers[1][static_cast<size_t>(place[1])]};
        while (at < table_->count() && table_->place(at).lines < wanted) {
            ++at;
        }
        result.push_back(at);
    }
    return result;
}

} // namespace nrb::mesh
