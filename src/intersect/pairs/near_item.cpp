// SPDX-License-Identifier: MIT
#include "intersect/pairs/near_item.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

void extend(Interval &range, Interval part) noexcept {
    range = {std::min(range.lower, part.lower), std::max(range.upper, part.upper)};
}

NearCell moved_by(NearCell cell, Turns turns, double period_a, double period_b) noexcept {
    for (Interval *part : {&cell.a, &cell.core_a}) {
        *part = turned(*part, turns.a, period_a);
    }
    for (Interval *part : {&cell.b, &cell.core_b}) {
        *part = turned(*part, turns.b, period_b);
    }
    cell.at_a += turns.a * period_a;
    cell.at_b += turns.b * period_b;
    return cell;
}

bool is_control_point(const Spline &curve, double t) noexcept {
    const KnotVector &axis = curve.axis(0);
    return multiplicity(axis.knots(), in_domain(curve, t)) >= axis.degree();
}

// Whether some limits of both curves, from one side or the other, are exactly the same point.
bool share_point(const Spline &a, double at_a, const Spline &b, double at_b) {
    for (const bool left : {false, true}) {
        const std::vector<double> point = eval::curve_point(a, in_domain(a, at_a), left);
        for (const bool left_of_b : {false, true}) {
            if (point == eval::curve_point(b, in_domain(b, at_b), left_of_b)) {
                return true;
            }
        }
    }
    return false;
}

// The larger distance of the two ends of a range from a place in it.
double width_of(const Spline &curve, Interval range, double at) {
    const std::vector<double> middle = eval::curve_point(curve, in_domain(curve, at), false);
    const auto away = [&](double t, bool left) {
        const std::vector<double> end = eval::curve_point(curve, in_domain(curve, t), left);
        return distance(middle.data(), end.data(), curve.dim());
    };
    return std::max(away(range.lower, false), away(range.upper, true));
}

} // namespace

NearItem::NearItem(const Spline &on_a, const Spline &on_b, std::span<const NearCell> all,
                   const NearGroup &group)
    : a{}, b{} {
    for (const auto &[index, turns] : group.members) {
        cells.push_back(moved_by(all[index], turns, period_of(on_a), period_of(on_b)));
        cells.back().index = index;
    }
    fit();
    std::ranges::sort(cells, {}, [](const NearCell &cell) { return std::pair(cell.a.lower, cell.b.lower); });
}

void NearItem::fit() noexcept {
    a = b = {infinity, -infinity};
    for (const NearCell &cell : cells) {
        extend(a, cell.a);
        extend(b, cell.b);
    }
}

const NearCell &NearItem::nearest() const noexcept {
    return *std::ranges::min_element(cells, {}, &NearCell::gap);
}

bool NearItem::has(NearCell::Kind kind) const noexcept {
    return std::ranges::any_of(cells, [kind](const NearCell &cell) { return cell.kind == kind; });
}

bool NearItem::is_still() const noexcept {
    return std::ranges::all_of(cells, &NearCell::still);
}

bool holds_common_point(const Spline &a, const Spline &b, const NearItem &item, double narrow) {
    return std::ranges::any_of(item.cells, [&](const NearCell &cell) {
        return is_control_point(a, cell.at_a) && is_control_point(b, cell.at_b) &&
               share_point(a, cell.at_a, b, cell.at_b) && width_of(a, item.a, cell.at_a) <= narrow &&
               width_of(b, item.b, cell.at_b) <= narrow;
    });
}

bool at_end(const Spline &curve, Interval part) noexcept {
    const Interval domain = curve.axis(0).domain();
    return !curve.axis(0).periodic() && (part.lower <= domain.lower || part.upper >= domain.upper);
}

} // namespace nrb::intersect
