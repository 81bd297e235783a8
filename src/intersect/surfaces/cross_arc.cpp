// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_arc.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr int most_steps = 16, most_probes = 3, most_sides = 6;
constexpr double most_place = 1 + widening;

// x of [first, last] where a + b (x - x0) >= 0.
void keep_where_positive(double a, double b, double x0, Interval &range) noexcept {
    if (b == 0) {
        range = a >= 0 ? range : Interval{1, 0};
        return;
    }
    const double zero = x0 - a / b, room = 1e-14 * (1 + std::abs(zero));
    if (b > 0) {
        range.lower = std::max(range.lower, zero - room);
    } else {
        range.upper = std::min(range.upper, zero + room);
    }
}

bool is_empty(const Interval &range) noexcept {
    return !(range.lower <= range.upper);
}

} // namespace

bool CrossBox::is_inside(const CrossPlace &z) const noexcept {
    for (size_t i = 0; i < 4; ++i) {
        if (!(z[i] >= side(i, 0) && z[i] <= side(i, 1))) {
            return false;
        }
    }
    return true;
}

CrossBox::Value CrossBox::at(const CrossPlace &z) const noexcept {
    Value value;
    value.a = a->piece().evaluate(a->in_piece(z.data()));
    value.b = b->piece().evaluate(b->in_piece(z.data() + 2));
    value.difference = value.a.at - value.b.at;
    for (size_t k = 0; k < 2; ++k) {
        value.a.slope[k] = a->length(k) * value.a.slope[k];
        value.b.slope[k] = b->length(k) * value.b.slope[k];
        value.columns[k] = value.a.slope[k];
        value.columns[2 + k] = -1 * value.b.slope[k];
    }
    return value;
}

// What is left after a step is about its square, or what rounding leaves.
bool CrossBox::solve(size_t fixed, CrossPlace &z) const {
    double last = infinity;
    int clamped = 0;
    for (int i = 0; i < most_steps; ++i) {
        count_work(600);
        const Value value = at(z);
        CrossPlace step{};
        if (!solve_columns(value.columns, fixed, value.difference, step)) {
            return false;
        }
        const double size = largest(step);
        bool is_clamped = false;
        for (size_t k = 0; k < 4; ++k) {
            const double next = z[k] - step[k], inside = std::clamp(next, -widening, most_place);
            is_clamped = is_clamped || inside != next;
            z[k] = k == fixed ? z[k] : inside;
        }
        if (!is_clamped &&
            (size <= 0x1p-27 || (size >= last / 2 && size <= chart.norm() * chart.near() / 4))) {
            return true;
        }
        clamped += is_clamped ? 1 : 0;
        if (clamped == 3 || (size >= last && i > 1)) {
            return false;
        }
        last = size;
    }
    return false;
}

void ArcFinder::clip(const CrossPlace &z0, const CrossPlace &step, double near, Interval &range) const {
    const CrossChart &chart = box_->chart;
    const size_t k = chart.axis();
    double fastest = 0, farthest = 0;
    for (size_t i = 0; i < 4; ++i) {
        if (i != k) {
            fastest = std::max({fastest, std::abs(chart.shift(i).lower), std::abs(chart.shift(i).upper)});
            farthest = std::max({farthest, box_->side(i, 1) - z0[i], z0[i] - box_->side(i, 0)});
        }
    }
    const double far = std::max(std::abs(range.lower - z0[k]), std::abs(range.upper - z0[k]));
    const double reach = std::min(farthest, 1.0001 * (largest(step) + chart.norm() * near + fastest * far) /
                                                (1 - chart.rho()));
    std::array<Interval, 2> halves{Interval{range.lower, std::min(range.upper, z0[k])},
                                   Interval{std::max(range.lower, z0[k]), range.upper}};
    for (size_t h = 0; h < 2; ++h) {
        for (size_t i = 0; i < 4; ++i) {
            if (i == k) {
                continue;
            }
            const double room = chart.rho(i) * reach + chart.norm(i) * near + 8 * eps;
            const double at = z0[i] - step[i];
            const double low = -chart.shift(i).upper, high = -chart.shift(i).lower;
            keep_where_positive(at + room - box_->side(i, 0), h == 1 ? high : low, z0[k], halves[h]);
            keep_where_positive(box_->side(i, 1) - at + room, h == 1 ? -low : -high, z0[k], halves[h]);
        }
    }
    if (is_empty(halves[0]) || is_empty(halves[1])) {
        range = is_empty(halves[0]) ? halves[1] : halves[0];
    } else {
        range = {halves[0].lower, halves[1].upper};
    }
}

// A zero of the box at inside_, or what else is known. What is in a corner, and no longer than sides are shifted by, is
// nothing: arcs of the neighbours go on in each other there. So is what is in the box by rounding alone of a curve that is known
// beside it: bounds of rounding are far larger than what it makes of places, and boxes near touches have many sides that are no
// farther away than these.
std::optional<ArcFinder::Verdict> ArcFinder::find_inside() {
    const CrossChart &chart = box_->chart;
    const size_t k = chart.axis();
    CrossPlace z{0.5, 0.5, 0.5, 0.5};
    Interval range{box_->side(k, 0), box_->side(k, 1)};
    CrossPlace step = chart.step(box_->a->centre() - box_->b->centre());
    clip(z, step, chart.near(), range);
    const double little = 4 * shift_of_sides / box_->cell(k).length(k % 2);
    for (int probe = 0; probe < most_probes; ++probe) {
        if (is_empty(range)) {
            return Verdict::nothing;
        }
        const double next = range.lower / 2 + range.upper / 2;
        for (size_t i = 0; i < 4; ++i) {
            const double along = -(chart.shift(i).lower / 2 + chart.shift(i).upper / 2) * (next - z[k]);
            z[i] = i == k ? z[k] : std::clamp(z[i] - step[i] + along, -widening, most_place);
        }
        z[k] = next;
        const bool found = box_->solve(k, z);
        step = chart.step(box_->at(z).difference);
        if (found && box_->is_inside(z)) {
            inside_ = z;
            return std::nullopt;
        }
        clip(z, step, found ? 0 : chart.near(), range);
    }
    return range.upper - range.lower > little ? Verdict::open : Verdict::nothing;
}

// Where the tangent at inside_ leaves the box; end is on that side. way: 1 or -1, of coordinate k.
CrossPlace ArcFinder::leave(double way, CrossEnd &end) const {
    const CrossBox::Value value = box_->at(inside_);
    const CrossPlace along =
        common_direction({value.a.slope[0], value.a.slope[1]}, {value.b.slope[0], value.b.slope[1]});
    const double unit = way / along[box_->chart.axis()];
    double first = infinity;
    for (size_t i = 0; i < 4; ++i) {
        const double speed = unit * along[i];
        const size_t side = speed > 0 ? 1 : 0;
        const double time = (box_->side(i, side) - inside_[i]) / speed;
        if (speed != 0 && time < first) {
            first = time;
            end.coordinate = i;
            end.side = side;
        }
    }
    CrossPlace place{};
    for (size_t i = 0; i < 4; ++i) {
        place[i] = std::clamp(inside_[i] + first * unit * along[i], -widening, most_place);
    }
    return place;
}

// Moves an end to the other side beyond which it is farthest, if it is beyond any by more than rounding: sides meet in corners.
bool ArcFinder::is_beyond(CrossEnd &end) const {
    double beyond = box_->chart.norm() * box_->chart.near() + 8 * eps;
    const size_t own = end.coordinate;
    bool any = false;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t side = 0; side < 2; ++side) {
            const double by = (side == 1 ? 1 : -1) * (end.at[i] - box_->side(i, side));
            if (i != own && by > beyond) {
                beyond = by;
                end.coordinate = i;
                end.side = side;
                any = true;
            }
        }
    }
    return any;
}

// Along the tangent to the side that it meets first, and on that side to the curve; then to any other side beyond which that
// is.
bool ArcFinder::find_end(double way, CrossEnd &end) const {
    const size_t k = box_->chart.axis();
    end.at = leave(way, end);
    for (int tries = 0; tries < most_sides; ++tries) {
        end.at[end.coordinate] = box_->side(end.coordinate, end.side);
        if (!box_->solve(end.coordinate, end.at)) {
            return false;
        }
        if (!is_beyond(end)) {
            return way * (end.at[k] - inside_[k]) >= 0;
        }
    }
    return false;
}

// Between three zeros, of which the ends and inside_ are, a coordinate rises as D says.
bool ArcFinder::stays(size_t coordinate) const {
    const Interval &rise = box_->chart.rise(coordinate);
    const size_t k = box_->chart.axis();
    std::array<const CrossPlace *, 3> zeros{&arc_.ends[0].at, &inside_, &arc_.ends[1].at};
    if ((*zeros[0])[k] > (*zeros[2])[k]) {
        std::swap(zeros[0], zeros[2]);
    }
    for (size_t i = 0; i < 2; ++i) {
        const double from = (*zeros[i])[coordinate], to = (*zeros[i + 1])[coordinate],
                     far = (*zeros[i + 1])[k] - (*zeros[i])[k], wide = rise.upper - rise.lower;
        const double up = std::max((to - from - rise.lower * far) / wide, 0.0),
                     down = std::max((rise.upper * far - (to - from)) / wide, 0.0);
        if (!(from + std::max(rise.upper, 0.0) * up <= box_->side(coordinate, 1)) ||
            !(from + std::min(rise.lower, 0.0) * down >= box_->side(coordinate, 0))) {
            return false;
        }
    }
    return true;
}

// From beside it.
void ArcFinder::move_to_border(CrossEnd &end) const {
    CrossPlace at = end.at;
    at[end.coordinate] = static_cast<double>(end.side);
    const double near = 64 * std::abs(box_->side(end.coordinate, end.side) - at[end.coordinate]);
    if (!end.open || !box_->solve(end.coordinate, at)) {
        return;
    }
    for (size_t i = 0; i < 4; ++i) {
        if (std::abs(at[i] - end.at[i]) > near) {
            return;
        }
    }
    end.at = at;
}

ArcFinder::Verdict ArcFinder::look(const CrossBox &box) {
    box_ = &box;
    if (const std::optional<Verdict> known = find_inside()) {
        return *known;
    }
    const double forward = box.chart.direction();
    if (!find_end(-forward, arc_.ends[0]) || !find_end(forward, arc_.ends[1])) {
        return Verdict::open;
    }
    for (size_t i = 0; i < 4; ++i) {
        const Interval &rise = box.chart.rise(i);
        const bool changes = rise.lower <= 0 && rise.upper >= 0;
        const bool ends = arc_.ends[0].coordinate == i || arc_.ends[1].coordinate == i;
        if (changes && (ends || !stays(i))) {
            return Verdict::open;
        }
    }
    for (CrossEnd &end : arc_.ends) {
        end.open = box.cell(end.coordinate).is_open(end.coordinate % 2, end.side);
        move_to_border(end);
    }
    arc_.box = box;
    return Verdict::arc;
}

} // namespace nrb::intersect
