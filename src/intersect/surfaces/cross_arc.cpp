// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_arc.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

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

bool CrossBox::solve(size_t fixed, CrossPlace &z) const {
    return newton_on_side(fixed, chart.noise(), z, [&](const CrossPlace &place, CrossPlace &step) {
        count_work(600);
        const Value value = at(place);
        return solve_columns(value.columns, fixed, value.difference, step);
    });
}

CrossPlace CrossBox::tangent_at(const CrossPlace &z) const noexcept {
    const Value value = at(z);
    return common_direction({value.a.slope[0], value.a.slope[1]}, {value.b.slope[0], value.b.slope[1]});
}

// Moves an end on an open side, where the surface ends, from the shifted side of the box onto the border
// itself, unless that moves it much farther than sides are shifted.
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
    graph_.forget();
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

ArcFinder::Verdict ArcFinder::look_between_sides(int parts) {
    constexpr int probes = 3;
    const Verdict verdict = graph_.look(*box_, sides_, parts, 4 * shift_of_sides, probes);
    arc_.ends = graph_.ends();
    return verdict;
}

// Moves sides on borders of the piece outwards by their room, where a known zero is near them and the
// coordinate may both rise and fall. False: there are none.
bool ArcFinder::move_sides() {
    bool any = false;
    for (size_t i = 0; i < 4 && graph_.near(); ++i) {
        if (i == box_->chart.axis() || !Graph::changes(*box_, i)) {
            continue;
        }
        for (size_t side = 0; side < 2; ++side) {
            const double room = box_->cell(i).room(i % 2, side);
            if (std::abs((*graph_.near())[i] - sides_[i][side]) < room) {
                sides_[i][side] += side == 1 ? room : -room;
                any = true;
            }
        }
    }
    return any;
}

// The polynomials of a piece are those of the surface only as far as its border; zeros beyond say nothing of
// the surface. So an arc all of which is beyond a border is no arc of this piece.
ArcFinder::Verdict ArcFinder::look_along_borders() {
    constexpr int parts = 8;
    const Verdict verdict = look_between_sides(parts);
    if (verdict != Verdict::arc) {
        return verdict;
    }
    for (size_t i = 0; i < 4; ++i) {
        for (size_t side = 0; side < 2; ++side) {
            const double place = box_->side(i, side);
            if (sides_[i][side] != place && graph_.lies_beyond(i, side, place)) {
                return Verdict::nothing;
            }
        }
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

// Whether an arc along a border is accepted, by how far its known zeros are beyond it. Where the surface
// ends, they may be beyond by the shift of sides only. Elsewhere they may be beyond by no more than `little`,
// in lengths of the piece, or all of them are beyond, up to the shift of sides: then it is the neighbour's
// arc, if the neighbour has it. Any other arc is left open, so that the box is divided until the part beyond
// is little.
bool ArcFinder::set_along(size_t coordinate, size_t side) {
    constexpr double little = 0x1p-26, least = 4 * shift_of_sides;
    const CrossCell &cell = box_->cell(coordinate);
    double most = -infinity, fewest = infinity;
    for (const CrossPlace &z : graph_.zeros()) {
        const double beyond = (side == 1 ? z[coordinate] - 1 : -z[coordinate]) * cell.length(coordinate % 2);
        most = std::max(most, beyond);
        fewest = std::min(fewest, beyond);
    }
    arc_.along = true;
    arc_.far = std::max(arc_.far, most);
    return cell.is_open(coordinate % 2, side) ? most <= least : most <= little || fewest >= -least;
}

// Whether the chart holds for the surface beyond those borders too, so that the neighbouring pieces have the
// same arc.
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
