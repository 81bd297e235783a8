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
            farthest = std::max({farthest, sides_[i][1] - z0[i], z0[i] - sides_[i][0]});
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
            keep_where_positive(at + room - sides_[i][0], h == 1 ? high : low, z0[k], halves[h]);
            keep_where_positive(sides_[i][1] - at + room, h == 1 ? -low : -high, z0[k], halves[h]);
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
    Interval range{sides_[k][0], sides_[k][1]};
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
        if (found) {
            near_ = z;
            is_near_ = true;
        }
        if (found && is_between_sides(z)) {
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
        const double time = (sides_[i][side] - inside_[i]) / speed;
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
            const double by = (side == 1 ? 1 : -1) * (end.at[i] - sides_[i][side]);
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
        end.at[end.coordinate] = sides_[end.coordinate][end.side];
        if (!box_->solve(end.coordinate, end.at)) {
            return false;
        }
        if (!is_beyond(end)) {
            return way * (end.at[k] - inside_[k]) >= 0;
        }
    }
    return false;
}

// Between zeros a coordinate rises as D says.
bool ArcFinder::stays(size_t coordinate) const {
    const Interval &rise = box_->chart.rise(coordinate);
    const size_t k = box_->chart.axis();
    for (size_t i = 0; i + 1 < zeros_.size(); ++i) {
        const double from = zeros_[i][coordinate], to = zeros_[i + 1][coordinate],
                     far = zeros_[i + 1][k] - zeros_[i][k], wide = rise.upper - rise.lower;
        const double up = std::max((to - from - rise.lower * far) / wide, 0.0),
                     down = std::max((rise.upper * far - (to - from)) / wide, 0.0);
        if (!(from + std::max(rise.upper, 0.0) * up <= sides_[coordinate][1]) ||
            !(from + std::min(rise.lower, 0.0) * down >= sides_[coordinate][0])) {
            return false;
        }
    }
    return true;
}

// Both ends, and inside_ or what divides the way between them.
void ArcFinder::set_zeros(int parts) {
    const size_t k = box_->chart.axis();
    zeros_ = {arc_.ends[0].at, arc_.ends[1].at};
    if (zeros_[0][k] > zeros_[1][k]) {
        std::swap(zeros_[0], zeros_[1]);
    }
    const CrossPlace first = zeros_[0], last = zeros_[1];
    zeros_.pop_back();
    for (int i = 1; i < parts; ++i) {
        const double share = static_cast<double>(i) / parts;
        CrossPlace z{};
        for (size_t c = 0; c < 4; ++c) {
            z[c] = (1 - share) * first[c] + share * last[c];
        }
        if (box_->solve(k, z)) {
            zeros_.push_back(z);
        }
    }
    if (parts <= 1) {
        zeros_.push_back(inside_);
    }
    zeros_.push_back(last);
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

bool ArcFinder::is_between_sides(const CrossPlace &z) const noexcept {
    for (size_t i = 0; i < 4; ++i) {
        if (!(z[i] >= sides_[i][0] && z[i] <= sides_[i][1])) {
            return false;
        }
    }
    return true;
}

bool ArcFinder::changes(size_t coordinate) const noexcept {
    const Interval &rise = box_->chart.rise(coordinate);
    return rise.lower <= 0 && rise.upper >= 0;
}

ArcFinder::Verdict ArcFinder::look(const CrossBox &box) {
    box_ = &box;
    is_near_ = false;
    arc_.ends = {};
    arc_.along = false;
    arc_.far = 0;
    for (size_t i = 0; i < 4; ++i) {
        sides_[i] = {box.side(i, 0), box.side(i, 1)};
    }
    Verdict verdict = look_between_sides(1);
    if (verdict == Verdict::open && move_sides()) {
        verdict = look_along_borders();
    }
    if (verdict == Verdict::arc) {
        arc_.box = box;
    }
    for (CrossEnd &end : arc_.ends) {
        if (verdict == Verdict::arc) {
            end.open = box.cell(end.coordinate).is_open(end.coordinate % 2, end.side);
            move_to_border(end);
        }
    }
    return verdict;
}

// parts: of the way between both ends, in as many places of which zeros are found.
ArcFinder::Verdict ArcFinder::look_between_sides(int parts) {
    if (const std::optional<Verdict> known = find_inside()) {
        return *known;
    }
    const double forward = box_->chart.direction();
    if (!find_end(-forward, arc_.ends[0]) || !find_end(forward, arc_.ends[1])) {
        return Verdict::open;
    }
    set_zeros(parts);
    for (size_t i = 0; i < 4; ++i) {
        const bool ends = arc_.ends[0].coordinate == i || arc_.ends[1].coordinate == i;
        if (changes(i) && (ends || !stays(i))) {
            return Verdict::open;
        }
    }
    return Verdict::arc;
}

// Farther out along borders that are near; false: there is none.
bool ArcFinder::move_sides() {
    bool any = false;
    for (size_t i = 0; i < 4 && is_near_; ++i) {
        if (i == box_->chart.axis() || !changes(i)) {
            continue;
        }
        for (size_t side = 0; side < 2; ++side) {
            const double room = box_->cell(i).room(i % 2, side);
            if (std::abs(near_[i] - sides_[i][side]) < room) {
                sides_[i][side] += side == 1 ? room : -room;
                any = true;
            }
        }
    }
    return any;
}

// Polynomials of a piece are those of the surface as far as borders, so that nothing is said of what is between there and zeros.
ArcFinder::Verdict ArcFinder::look_along_borders() {
    constexpr int parts = 8;
    const Verdict verdict = look_between_sides(parts);
    if (verdict != Verdict::arc) {
        return verdict;
    }
    for (size_t i = 0; i < 4; ++i) {
        for (size_t side = 0; side < 2; ++side) {
            if (sides_[i][side] != box_->side(i, side) && !set_along(i, side)) {
                return Verdict::open;
            }
        }
    }
    return goes_on() ? Verdict::arc : Verdict::open;
}

// Where a surface ends nothing is beyond. An arc that is partly beyond a border is divided, until what is there is little.
bool ArcFinder::set_along(size_t coordinate, size_t side) {
    constexpr double little = 0x1p-26, least = 4 * shift_of_sides;
    const CrossCell &cell = box_->cell(coordinate);
    double most = -infinity, fewest = infinity;
    for (const CrossPlace &z : zeros_) {
        const double beyond = (side == 1 ? z[coordinate] - 1 : -z[coordinate]) * cell.length(coordinate % 2);
        most = std::max(most, beyond);
        fewest = std::min(fewest, beyond);
    }
    arc_.along = true;
    arc_.far = std::max(arc_.far, most);
    return cell.is_open(coordinate % 2, side) ? most <= least : most <= little || fewest >= -little;
}

// Whether the chart is one of the surface beyond the borders, too, so that neighbours have the same arc.
bool ArcFinder::goes_on() const {
    std::array<std::vector<CrossCell::Beyond>, 2> beyond;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t side = 0; side < 2; ++side) {
            const CrossCell &cell = box_->cell(i);
            if (sides_[i][side] == box_->side(i, side) || cell.is_open(i % 2, side)) {
                continue;
            }
            std::optional<CrossCell::Beyond> part = cell.beyond(i % 2, side);
            if (!part || !beyond[i / 2].empty()) {
                return false;
            }
            beyond[i / 2].push_back(std::move(*part));
        }
    }
    return (beyond[0].empty() && beyond[1].empty()) ||
           box_->chart.goes_on(*box_->a, *box_->b, beyond[0], beyond[1]);
}

} // namespace nrb::intersect
