// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_builder.h"

#include "base/watch.h"
#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nrb::mesh {

namespace {

// Cells of at most this many pieces keep the control nets of all of them; larger ones extract them one by
// one.
constexpr int64_t most_nets = 32;
// Multiply-adds, estimated, of looking at a net, for each of its numbers.
constexpr int64_t work_for_a_number = 8;

// The share of the chord for cells at an end of the domain, unless there is a single row of them. Those that turn out
// too coarse are divided, but sides at the border are not divided for the sake of angles.
constexpr double share_at_border = 0.85;

// Work of the estimates that decide whether a cell is cut, and of everything else that is done for it.
constexpr int64_t work_of_a_cell = 800;

// Cells end at multiples of 1 / raster of their block. These hold all places that cutting into two to eight
// parts leads to, with up to 22 halvings and up to 6, 3 and 2 cuts into thirds, fifths and sevenths.
constexpr double raster = 0x1p22 * 729 * 125 * 49;
// Limit on the depth where weights may be 0 or negative: the surface may be unbounded there.
constexpr int most_divisions = 16;

// The line nearest to t, if it is closer than `room`; else t.
double nearest_line(const std::set<double> &lines, double t, double room) {
    const auto above = lines.lower_bound(t);
    double best = t, distance = room;
    const auto look_at = [&](double line) {
        if (std::abs(line - t) < distance) {
            distance = std::abs(line - t);
            best = line;
        }
    };
    if (above != lines.end()) {
        look_at(*above);
    }
    if (above != lines.begin()) {
        look_at(*std::prev(above));
    }
    return best;
}

// An estimate of how far, in the plane of the cell, the surface is from one that runs at constant speed along
// axis k.
double uneven(const HessianBox &box, size_t k) noexcept {
    const auto along = [&](size_t c) { return (k == 0 ? box.of(c).uu : box.of(c).vv).most(); };
    return diagonal(along(0), along(1)) / (8 * box.least_weight());
}

} // namespace

// Blocks end where the homogeneous coordinates may have a kink.
void CellTree::Builder::set_blocks() {
    for (size_t k = 0; k < 2; ++k) {
        const auto axis = static_cast<int>(k);
        for (int64_t i = 0; i <= grid_.count(axis); ++i) {
            if (i == 0 || i == grid_.count(axis) || grid_.kinks(axis, i)) {
                tree_.blocks_[k].push_back(i);
                tree_.block_ends_[k].push_back(grid_.break_at(axis, i));
            }
        }
    }
}

int32_t CellTree::Builder::add_line(size_t k, double t, bool from_left) {
    auto &lines = tree_.lines_[k];
    lines.push_back({t, from_left});
    known_[k].insert(t);
    return static_cast<int32_t>(lines.size() - 1);
}

double CellTree::Builder::build() {
    const PartOfWork half;
    set_blocks();
    const int64_t across = std::ssize(tree_.blocks_[1]) - 1,
                  count = (std::ssize(tree_.blocks_[0]) - 1) * across;
    Steps steps(count);
    for (int64_t i = 0; i < count; ++i, steps.next()) {
        block_ = static_cast<int32_t>(i);
        add_block({i / across, i % across});
    }
    tree_.cells_ = std::vector(std::as_const(tree_.cells_)); // without spare capacity
    tree_.nodes_ = std::vector(std::as_const(tree_.nodes_));
    sort_lines();
    const auto &u = tree_.block_ends_[0], &v = tree_.block_ends_[1];
    return left_ > 0 ? std::max(0.0, 1 - left_ / ((u.back() - u.front()) * (v.back() - v.front()))) : 1;
}

void CellTree::Builder::add_block(const std::array<int64_t, 2> &block) {
    Item item;
    for (size_t k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(block[k]);
        item.pieces.lower[k] = tree_.blocks_[k][at];
        item.pieces.upper[k] = tree_.blocks_[k][at + 1];
        item.part.lower[k] = tree_.block_ends_[k][at];
        item.part.upper[k] = tree_.block_ends_[k][at + 1];
        item.lower[k] = add_line(k, item.part.lower[k], false);
        item.upper[k] = add_line(k, item.part.upper[k], true);
    }
    tree_.roots_.push_back(static_cast<int32_t>(tree_.nodes_.size()));
    for (open_.assign(1, item); !open_.empty();) {
        const Item next = open_.back();
        open_.pop_back();
        look_at(next);
    }
}

void CellTree::Builder::look_at(Item item) {
    if (item.parent >= 0) {
        tree_.nodes_[static_cast<size_t>(item.parent)].next = static_cast<int32_t>(tree_.nodes_.size());
    }
    count_work(work_of_a_cell);
    const Side side = item.side = side_of(item);
    make_nets(item);
    if (item.cut && side != Side::outside && item.nets >= 0) {
        const size_t axis = *std::exchange(item.cut, std::nullopt);
        if (divide(item, {axis, 0.5})) {
            return;
        }
    }
    const Found found = box_of(item, side == Side::outside);
    CellBend bend = bend_of(found.box);
    // Elsewhere there are other triangles where the surface comes out over a side of a triangle.
    const int ends = std::max(ends_at(item, 0), ends_at(item, 1));
    bend.alone = ends > 0;
    const double chord = rule_.chord * (ends == 0 ? rule_.inner : ends == 1 ? share_at_border : 1);
    const bool bent = !(bend.in_parts(1, 1) <= chord);
    const bool small = !(rule_.longest > 0) || found.box.move(1, 1) <= rule_.longest;
    const bool flat = found.whole && found.box.certain() && !bent && small && !is_turned(found.box);
    const bool hopeless = !grid_.positive() && item.divisions >= most_divisions;
    const bool wide = side != Side::outside && wide_axis(item.part).has_value(); // cut whatever it costs
    const bool enough = flat || side == Side::outside || hopeless || work_ended();
    const auto cut = [&] {
        return bent && !wide ? best_cut(bend, chord) : cut_of_flat(item.part, found.box);
    };
    if ((enough && !wide) || !divide(item, cut())) {
        const bool done = flat || side == Side::outside || hopeless || !work_ended();
        left_ += done ? 0 : item.part.side(0) * item.part.side(1);
        add_cell(item, found.whole ? found.box : box_of(item, true).box, side);
    }
}

// Parts of an item inside are inside.
Side CellTree::Builder::side_of(const Item &item) const {
    return !rule_.side || item.side == Side::inside ? Side::inside : rule_.side(item.part);
}

// How many ends of the domain along axis k an item is at.
int CellTree::Builder::ends_at(const Item &item, size_t k) const noexcept {
    const auto &ends = tree_.block_ends_[k];
    return (item.part.lower[k] == ends.front() ? 1 : 0) + (item.part.upper[k] == ends.back() ? 1 : 0);
}

// An axis along which a part is longer than cells may be, if there is one.
std::optional<size_t> CellTree::Builder::wide_axis(const Rectangle &part) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        if (part.side(k) > rule_.most_sides[k]) {
            return k;
        }
    }
    return std::nullopt;
}

// The cut of a part whose surface is flat enough: for the sake of its width in the domain, or of the angle,
// or else of its longer side.
Cut CellTree::Builder::cut_of_flat(const Rectangle &part, const HessianBox &box) const noexcept {
    if (const std::optional<size_t> wide = wide_axis(part)) {
        return {*wide, 0.5};
    }
    if (is_turned(box)) {
        return cut_for_angle(box, turn_of(box, rule_.least), rule_.angle);
    }
    return {box.move(1, 0) >= box.move(0, 1) ? size_t{0} : size_t{1}, 0.5};
}

// Pushes the control nets of an item of few pieces on the stack, unless it has them.
void CellTree::Builder::make_nets(Item &item) {
    if (item.nets >= 0 || item.pieces.count() > most_nets) {
        return;
    }
    item.nets = std::ssize(pool_);
    pool_.resize(pool_.size() + static_cast<size_t>(item.pieces.count()) * nets_.values());
    double *out = pool_.data() + item.nets;
    for (int64_t i = item.pieces.lower[0]; i < item.pieces.upper[0]; ++i) {
        for (int64_t j = item.pieces.lower[1]; j < item.pieces.upper[1]; ++j, out += nets_.values()) {
            nets_.extract(i, j, item.part, out);
        }
    }
}

const double *CellTree::Builder::net_of(const Item &item, int64_t u, int64_t v) {
    if (item.nets < 0) {
        nets_.extract(u, v, item.part, one_.data());
        return one_.data();
    }
    const int64_t at = (u - item.pieces.lower[0]) * item.pieces.count(1) + v - item.pieces.lower[1];
    return pool_.data() + item.nets + at * static_cast<int64_t>(nets_.values());
}

std::array<double, 2> CellTree::Builder::factors(const Item &item, int64_t u, int64_t v) const noexcept {
    const Interval a = nets_.part_of(item.part, 0, u), b = nets_.part_of(item.part, 1, v);
    return {item.part.side(0) / (a.upper - a.lower), item.part.side(1) / (b.upper - b.lower)};
}

// The bound of second derivatives over an item. Unless `all` are wanted, only as many of many pieces are
// looked at as it takes to see that they are not flat.
CellTree::Builder::Found CellTree::Builder::box_of(const Item &item, bool all) {
    std::array<std::array<double, HessianBox::coordinates>, 4> points;
    CellCorners corners;
    for (size_t c = 0; c < 4; ++c) {
        const bool right = c == 1 || c == 2, top = c >= 2;
        const double *net = net_of(item, right ? item.pieces.upper[0] - 1 : item.pieces.lower[0],
                                   top ? item.pieces.upper[1] - 1 : item.pieces.lower[1]);
        std::copy_n(corners_of(nets_, net)[c], points[c].size(), points[c].begin());
        corners[c] = points[c].data();
    }
    Found found{box_about(corners)};
    const double noise = nets_.noise(item.divisions);
    const bool steps = rule_.wants_steps();
    for (int64_t i = item.pieces.lower[0]; i < item.pieces.upper[0]; ++i) {
        for (int64_t j = item.pieces.lower[1]; j < item.pieces.upper[1]; ++j) {
            found.box.add(nets_.degree(0), nets_.degree(1), net_of(item, i, j), factors(item, i, j), noise,
                          steps);
            count_work(work_for_a_number * static_cast<int64_t>(nets_.values()));
        }
        if (!all && item.nets < 0 && !(bend_of(found.box).in_parts(1, 1) <= 4 * rule_.chord)) {
            found.whole = i + 1 == item.pieces.upper[0];
            break;
        }
    }
    return found;
}

void CellTree::Builder::keep_box(int32_t cell, const Rectangle &part, const HessianBox &box) {
    tree_.boxes_->keep(cell, box);
    for (size_t k = 0; k < 2 && rule_.side; ++k) {
        const double speed = box.move(k == 0 ? 1 : 0, k == 0 ? 0 : 1) / part.side(k);
        tree_.speeds_[k] = std::isfinite(speed) ? std::max(tree_.speeds_[k], speed) : tree_.speeds_[k];
    }
    tree_.least_weight_ =
        box.certain() ? std::min(tree_.least_weight_, box.least_weight()) : tree_.least_weight_;
}

void CellTree::Builder::add_cell(const Item &item, const HessianBox &box, Side side) {
    const auto node = static_cast<int32_t>(tree_.nodes_.size());
    const Cell cell{item.lower, item.upper, block_, node, side, CellBends::of(box)};
    const bool instead = item.cell >= 0;
    const int32_t number = instead ? item.cell : static_cast<int32_t>(tree_.cells_.size());
    tree_.nodes_.push_back({-1, number, 0});
    keep_box(number, item.part, box);
    count_work(side == Side::inside ? rule_.work_behind : 0);
    if (instead) {
        tree_.cells_[static_cast<size_t>(item.cell)] = cell;
    } else {
        tree_.cells_.push_back(cell);
    }
    if (item.nets >= 0) {
        pool_.resize(static_cast<size_t>(item.nets));
    }
}

// Rounds a place, so that cuts of neighbours at the same place get the same number, however that was
// computed. Places that are not on the raster may be rounded to it more than once: an existing line that is
// close enough takes precedence.
double CellTree::Builder::on_raster(const Item &item, size_t k, double t) const {
    const Rectangle block = tree_.block(block_);
    const double place = std::round((t - block.lower[k]) / block.side(k) * raster) / raster;
    const double result =
        nearest_line(known_[k], block.lower[k] + place * block.side(k), same_line * block.side(k));
    return result > item.part.lower[k] && result < item.part.upper[k] ? result : t;
}

// Where to cut an item: between two pieces if there are several along the axis.
double CellTree::Builder::place_to_cut(const Item &item, size_t k, double share) const {
    const double wanted = on_raster(item, k, item.part.lower[k] + share * item.part.side(k));
    if (item.pieces.count(k) == 1) {
        return wanted;
    }
    double best = wanted, distance = infinity;
    for (int64_t i = item.pieces.lower[k] + 1; i < item.pieces.upper[k]; ++i) {
        const double t = grid_.break_at(static_cast<int>(k), i);
        if (std::abs(t - wanted) < distance) {
            distance = std::abs(t - wanted);
            best = t;
        }
    }
    return best;
}

bool CellTree::Builder::divide(Item &item, Cut cut) {
    size_t k = cut.axis;
    if (item.nets < 0 && item.pieces.count(k) == 1) {
        k = 1 - k;
    }
    const double at = place_to_cut(item, k, cut.share);
    if (!(at > item.part.lower[k] && at < item.part.upper[k])) {
        return false;
    }
    Item low = item, high = item;
    low.part.upper[k] = high.part.lower[k] = at;
    low.upper[k] = high.lower[k] = add_line(k, at, false);
    low.divisions = high.divisions = item.divisions + 1;
    low.cut = high.cut = cut.next;
    const int64_t piece = grid_.find(static_cast<int>(k), at); // the one to the right
    high.pieces.lower[k] = piece;
    low.pieces.upper[k] = at > grid_.break_at(static_cast<int>(k), piece) ? piece + 1 : piece;
    divide_nets(item, k, at, low, high);
    high.parent = static_cast<int32_t>(tree_.nodes_.size());
    low.parent = -1;
    high.cell = -1;
    tree_.nodes_.push_back({static_cast<int32_t>(k), 0, at});
    open_.push_back(high);
    open_.push_back(low);
    return true;
}

// Divides control nets. On the stack, those of the lower part are above those of the upper one, because it is
// looked at first.
void CellTree::Builder::divide_nets(const Item &item, size_t k, double at, Item &low, Item &high) {
    if (item.nets < 0) {
        return;
    }
    const auto values = static_cast<int64_t>(nets_.values());
    const std::vector<double> all(pool_.begin() + item.nets, pool_.end());
    pool_.resize(static_cast<size_t>(item.nets + (low.pieces.count() + high.pieces.count()) * values));
    high.nets = item.nets;
    low.nets = item.nets + high.pieces.count() * values;
    const AxisLayers layers = k == 0 ? AxisLayers{1, nets_.degree(0), (nets_.degree(1) + 1) * 4}
                                     : AxisLayers{nets_.degree(0) + 1, nets_.degree(1), 4};
    const double *net = all.data();
    const auto place = [&](const Item &part, int64_t i, int64_t j) {
        return pool_.data() + part.nets +
               ((i - part.pieces.lower[0]) * part.pieces.count(1) + j - part.pieces.lower[1]) * values;
    };
    for (int64_t i = item.pieces.lower[0]; i < item.pieces.upper[0]; ++i) {
        for (int64_t j = item.pieces.lower[1]; j < item.pieces.upper[1]; ++j, net += values) {
            const int64_t along = k == 0 ? i : j;
            const bool in_low = along < low.pieces.upper[k], in_high = along >= high.pieces.lower[k];
            if (in_low && in_high) {
                const Interval part = nets_.part_of(item.part, k, along);
                std::copy_n(net, values, place(high, i, j));
                subdivide(layers, (at - part.lower) / (part.upper - part.lower), place(high, i, j),
                          place(low, i, j));
            } else {
                std::copy_n(net, values, place(in_low ? low : high, i, j));
            }
        }
    }
}

// Numbers the lines in rising order, equal ones with one number.
void CellTree::Builder::sort_lines() {
    for (size_t k = 0; k < 2; ++k) {
        auto &lines = tree_.lines_[k];
        const auto key = [&](int32_t i) {
            const CellLine &line = lines[static_cast<size_t>(i)];
            return std::pair(line.t, !line.from_left);
        };
        std::vector<int32_t> order(lines.size()), number(lines.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order, {}, key);
        std::vector<CellLine> sorted;
        for (const int32_t i : order) {
            const CellLine &line = lines[static_cast<size_t>(i)];
            if (sorted.empty() || sorted.back().t != line.t || sorted.back().from_left != line.from_left) {
                sorted.push_back(line);
            }
            number[static_cast<size_t>(i)] = static_cast<int32_t>(sorted.size() - 1);
        }
        lines = std::move(sorted);
        for (Cell &cell : tree_.cells_) {
            cell.lower[k] = number[static_cast<size_t>(cell.lower[k])];
            cell.upper[k] = number[static_cast<size_t>(cell.upper[k])];
        }
    }
}

// The item of a cell that is to be divided further.
CellTree::Builder::Item CellTree::Builder::item_of(const Cell &cell) {
    Item item;
    item.lower = cell.lower;
    item.upper = cell.upper;
    item.part = tree_.rectangle(cell);
    item.divisions = 4;
    item.pieces = nets_.pieces_in(item.part);
    make_nets(item);
    return item;
}

// The axis to cut a cell along where the surface is flat enough, and yet no proof was found: the one along
// which it turns most; else the one along which it runs least evenly, because the bound of what comes out
// over sides depends on second derivatives in the plane; else the longer one.
size_t CellTree::Builder::axis_of_flat(const Rectangle &part, const HessianBox &box) const noexcept {
    if (const CellTurn turn = turn_of(box, rule_.least); rule_.angle > 0 && turn.both > rule_.angle / 2) {
        return turn.along[0] >= turn.along[1] ? 0 : 1;
    }
    const double u = uneven(box, 0), v = uneven(box, 1);
    return std::max(u, v) > rule_.chord ? (u >= v ? 0 : 1) : cut_of_flat(part, box).axis;
}

void CellTree::Builder::cut(int32_t number) {
    const Cell cell = tree_.cells_[static_cast<size_t>(number)];
    block_ = cell.block;
    Item item = item_of(cell);
    const HessianBox box = tree_.box(number);
    CellBend bend = bend_of(box);
    bend.alone = true; // the help of neighbours was not enough, but small triangles do without
    const bool bent = !(bend.in_parts(1, 1) <= rule_.chord);
    const size_t axis =
        bent ? (bend.in_parts(2, 1) <= bend.in_parts(1, 2) ? 0 : 1) : axis_of_flat(item.part, box);
    const auto node = static_cast<int32_t>(tree_.nodes_.size());
    item.cell = number;
    open_.clear();
    if (!divide(item, {axis, 0.5})) {
        pool_.clear();
        return;
    }
    // The former leaf leads on to the new node.
    tree_.nodes_[static_cast<size_t>(cell.node)] = {2, node, 0};
    while (!open_.empty()) {
        const Item next = open_.back();
        open_.pop_back();
        if (next.parent >= 0) {
            tree_.nodes_[static_cast<size_t>(next.parent)].next = static_cast<int32_t>(tree_.nodes_.size());
        }
        const Side side = rule_.side ? rule_.side(next.part) : Side::inside;
        add_cell(next, box_of(next, true).box, side);
    }
}

} // namespace nrb::mesh
