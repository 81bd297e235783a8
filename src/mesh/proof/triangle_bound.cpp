// SPDX-License-Identifier: MIT
#include "mesh/proof/triangle_bound.h"

#include "mesh/proof/pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::mesh {

namespace {

// Covers the relative rounding errors of all sums here.
constexpr double rounding = 1 + 64 * eps;

// Side k, opposite corner k, leads from corner k + 1 to corner k + 2. Second derivatives along side k are in
// lane k of a Four; lane 3 holds a bound on those along any segment in the triangle.
class Triangle {
public:
    Triangle(const std::array<TriangleCorner, 3> &corners, std::span<const CellPart> cells) noexcept
        : corners_(corners), cells_(cells), unit_(cells.front().part.sides()) {
        std::array<std::array<double, 4>, 2> steps{}; // lane 3: the largest
        for (size_t k = 0; k < 3; ++k) {
            const TriangleCorner &from = corner(k + 1), &to = corner(k + 2);
            sides_[k] = to.point - from.point;
            lengths_[k] = length(sides_[k]);
            inverse_[k] = 1 / lengths_[k];
            longest_ = std::max(longest_, lengths_[k]);
            for (size_t c = 0; c < 2; ++c) {
                places_[k][c] = (corners[k].param[c] - cells.front().part.lower[c]) / unit_[c] - 0.5;
                steps[c][k] = steps_[k][c] = (to.param[c] - from.param[c]) / unit_[c];
                steps[c][3] = std::max(steps[c][3], std::abs(steps[c][k]));
            }
        }
        const Four u(steps[0]), v(steps[1]);
        uu_ = u * u;
        uv_ = u * v * 2;
        vv_ = v * v;
        for (const CellPart &cell : cells) {
            least_weight_ = std::min(least_weight_, cell.box->least_weight());
            largest_weight_ = std::max(largest_weight_, cell.box->largest_weight());
        }
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = (k + 1) % 3, j = (k + 2) % 3;
            cosines_[k] = -dot(sides_[i], sides_[j]) * (inverse_[i] * inverse_[j]);
        }
        bends_ =
            beside(over_cells([&](const HessianBox &box) { return box.sizes(corners[0].point, longest_); }));
    }

    [[nodiscard]] bool certain() const noexcept { return least_weight_ > 0; }
    [[nodiscard]] double weighed() const noexcept {
        return certain() ? largest_weight_ / least_weight_ * (1 + 4 * eps) : infinity;
    }
    [[nodiscard]] TriangleBound bound(bool alone) const noexcept;
    [[nodiscard]] double equal_parameters() const noexcept;

private:
    [[nodiscard]] const TriangleCorner &corner(size_t k) const noexcept { return corners_[k % 3]; }
    template <class Of>
    [[nodiscard]] Hessian over_cells(Of &&of) const noexcept;
    // What the radii contribute to second derivatives along the sides, and along any segment in the triangle.
    [[nodiscard]] Four beside(const Hessian &h) const noexcept {
        return (uu_ * h.uu.radius + abs(uv_) * h.uv.radius + vv_ * h.vv.radius) * rounding;
    }
    [[nodiscard]] InverseWeights inverse_weights() const noexcept;
    [[nodiscard]] bool at_corners() const noexcept;
    [[nodiscard]] Bend bend(const Vector3 &d, const Vector3 &p) const noexcept;
    [[nodiscard]] double beside_segment() const noexcept;
    [[nodiscard]] double from_a_side(const TriangleBound &bound) const noexcept;
    [[nodiscard]] bool runs_along(size_t k) const noexcept;
    [[nodiscard]] double sharpness() const noexcept;
    [[nodiscard]] bool is_cut(size_t k, double half_cosine_squared) const noexcept;
    [[nodiscard]] double off(const Vector3 &normal) const noexcept;
    [[nodiscard]] double angle_at(size_t k) const noexcept;
    [[nodiscard]] double sine(size_t k, double area) const noexcept;
    // The surface near the end P of a side PE, with barycentric coordinates l and distances times w (see
    // turning()): it comes out over the side by at most l_E out, and only where l_K <= share l_E for the
    // third corner K.
    struct Turning {
        double out, share, high; // l_E high: what heights add
        double in;               // l_E in: how far the image of the side comes inside, with heights
    };
    [[nodiscard]] Turning turning(size_t side, const Bend &across, double high, double area) const noexcept;
    [[nodiscard]] static double share_of(const Turning &over) noexcept;
    [[nodiscard]] double turn(size_t k, size_t side, const Turning &over, const Four &bends) const noexcept;
    [[nodiscard]] double lean(size_t side, const Turning &over, const Four &bends) const noexcept;
    [[nodiscard]] Four bends_about(size_t k) const noexcept;
    [[nodiscard]] Four bends_along(size_t side, double sign, size_t k) const noexcept;
    void set_turns(const std::array<Turning, 3> &over, TriangleBound &result) const noexcept;

    const std::array<TriangleCorner, 3> &corners_;
    std::span<const CellPart> cells_;
    std::array<double, 2> unit_;
    std::array<Vector3, 3> sides_;
    std::array<std::array<double, 2>, 3> steps_, places_; // in units of the first cell, and about its middle
    Four uu_, uv_, vv_;                                   // of steps; lane 3: of the largest ones
    Values lengths_, inverse_, cosines_;                  // cosines of the angles
    double longest_ = 0;
    double least_weight_ = infinity, largest_weight_ = 0;
    // Bounds on the second derivatives of A - w Q for all corners Q, in any direction: along the sides, and
    // along any segment in the triangle.
    Four bends_;
};

// Ranges over several cells are joined as constants.
template <class Of>
Hessian Triangle::over_cells(Of &&of) const noexcept {
    Hessian all = of(*cells_.front().box);
    if (cells_.size() > 1) {
        all = all.anywhere();
    }
    for (const CellPart &cell : cells_.subspan(1)) {
        const auto sides = cell.part.sides();
        all.add(of(*cell.box).anywhere().in_units(unit_[0] / sides[0], unit_[1] / sides[1]));
    }
    return all;
}

Bend Triangle::bend(const Vector3 &d, const Vector3 &p) const noexcept {
    const Hessian h = over_cells([&](const HessianBox &box) { return box.along(d, p); });
    const auto at = [&](size_t m) {
        const auto [x, y] = places_[m];
        return uu_ * h.uu.at(x, y) + uv_ * h.uv.at(x, y) + vv_ * h.vv.at(x, y);
    };
    // What is beside the polynomial is 0 at the corners of the cell; at others it is in the interpolant as well.
    return {{at(0), at(1), at(2)}, beside(h), (at_corners() ? 1 + 1e-6 : 2) * h.rest};
}

// By a linear function below the weights of a single cell, or by their least one, whichever is greater at the corners
// on the whole.
InverseWeights Triangle::inverse_weights() const noexcept {
    Values roots{};
    if (cells_.size() == 1) {
        for (size_t k = 0; k < 3; ++k) {
            roots[k] = std::sqrt(std::max(cells_.front().box->weight_from_below(places_[k]), 0.0));
        }
    }
    if (const double least = std::sqrt(least_weight_);
        !(roots[0] * roots[1] * roots[2] > least * least * least)) {
        roots.fill(least);
    }
    const auto pair = [&](size_t i, size_t j) { return 1 / (roots[i] * roots[j]); };
    return {{pair(1, 2), pair(2, 0), pair(0, 1)}, 1 / least_weight_};
}

// Whether all corners are corners of the cell, to rounding.
bool Triangle::at_corners() const noexcept {
    constexpr double room = 1e-9;
    return std::ranges::all_of(places_, [](const auto &place) {
        return std::abs(std::abs(place[0]) - 0.5) < room && std::abs(std::abs(place[1]) - 0.5) < room;
    });
}

// The distance of a point of S from the point of the triangle at equal parameters. With the vectors
// N = A - w P and N_i = N(v_i), and the weights w_i = w(v_i), their difference is
//
//     (N - sum l_i N_i) / w + sum l_i (N_i / w_i) (w_i / w - 1).
double Triangle::equal_parameters() const noexcept {
    return (bends_[3] / 8 + longest_ * (largest_weight_ - least_weight_)) / least_weight_ * rounding;
}

// Whether the image of side k, projected onto the line of the side, stays between its ends. At the place s of
// the side, counted from one end, the component N along the side is at least s w l - s (1 - s) / 2 |N''|,
// where l is the length of the side and w the weight at its other end; likewise from the other end.
bool Triangle::runs_along(size_t k) const noexcept {
    const double room = 2 * least_weight_ * lengths_[k] / rounding;
    if (bends_[k] <= room) {
        return true;
    }
    const Vector3 along = inverse_[k] * sides_[k];
    return bend(along, corner(k + 1).point).largest(k) <= room &&
           bend(along, corner(k + 2).point).largest(k) <= room;
}

// Bounds the distance from the triangle of points in its plane that come out by at most 1 over each side. At
// a corner with angle t, the region that both sides allow ends in a tip 1 / sin (t / 2) away from the corner.
// If the surface does not pass the corner in the direction of the outward bisector, the tip is cut off, and
// what is left is within 1 / cos (t / 2).
// To show that at corner k, let N be the component along the outward bisector. At each of the other corners i
// it is at most -t_i w, where t_i = cos (t / 2) times the length of the side from corner k to corner i. With
// Q_ki and Q_ij, the largest second derivatives (of -N) along that side and along the opposite one, N is at
// most sum l_i (-t_i w + 1/2 (Q_ki + Q_ij)), where the sum is over the other corners i. So N <= 0 if each of
// its terms is.
double Triangle::sharpness() const noexcept {
    double least = 1; // squared
    for (size_t k = 0; k < 3; ++k) {
        const double cosine = cosines_[k], half_sine = (1 - cosine - 16 * eps) / 2, // squared
            half_cosine = (1 + cosine - 16 * eps) / 2;
        const bool cut = half_cosine > half_sine && is_cut(k, half_cosine);
        least = std::min(least, cut ? half_cosine : half_sine);
    }
    return rounding / std::sqrt(std::max(least, 0.0));
}

bool Triangle::is_cut(size_t k, double half_cosine_squared) const noexcept {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3; // the sides at corner k
    const double room = 2 * least_weight_ * std::sqrt(half_cosine_squared) / rounding;
    const auto fits = [&](double at_i, double at_j, double opposite) {
        return at_i + opposite <= room * lengths_[i] && at_j + opposite <= room * lengths_[j];
    };
    if (fits(bends_[i], bends_[j], bends_[k])) {
        return true;
    }
    const Vector3 inwards = (1 / lengths_[j]) * sides_[j] - (1 / lengths_[i]) * sides_[i];
    const Bend outwards = bend(-1 / length(inwards) * inwards, corner(k).point);
    return fits(outwards.falling(i), outwards.falling(j), outwards.falling(k));
}

// What the corners add to heights above a plane with this normal that should contain them all: if they are
// no farther than e from it, then N there is at most w_i e, and N / w in between at most e times the ratio of
// the weights.
double Triangle::off(const Vector3 &normal) const noexcept {
    return (std::max(std::abs(dot(normal, sides_[1])), std::abs(dot(normal, sides_[2]))) +
            8 * eps * longest_) *
           weighed();
}

// Bounds the distance of S from a side. Where the opposite corner has its foot on the side, in the domain,
// every place of T is reached from a place of the side by a step that is no longer than the one from the foot
// to the corner. The surface is at most as far from the image of the side as it moves on that step.
double Triangle::from_a_side(const TriangleBound &bound) const noexcept {
    if (cells_.size() > 1) {
        return infinity;
    }
    double best = infinity;
    for (size_t k = 0; k < 3; ++k) {
        const auto &side = steps_[k], &other = steps_[(k + 1) % 3]; // `other` begins where the side ends
        const double squared = side[0] * side[0] + side[1] * side[1];
        const double along = -(other[0] * side[0] + other[1] * side[1]) / squared; // from its end
        if (along >= 0 && along <= 1) {
            best = std::min(best, bound.sides[k] + cells_.front().box->move(other[0] + along * side[0],
                                                                            other[1] + along * side[1]));
        }
    }
    return best;
}

// For a triangle that is a segment to rounding: bounds the distance of the surface from the segment, by its
// distances across it and beyond its ends.
double Triangle::beside_segment() const noexcept {
    const size_t k = lengths_[0] >= lengths_[1]   ? (lengths_[0] >= lengths_[2] ? 0 : 2)
                     : lengths_[1] >= lengths_[2] ? 1
                                                  : 2;
    const Vector3 along = inverse_[k] * sides_[k],
                  least = std::abs(along.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 across = unit(cross(along, least)), up = cross(along, across);
    const Vector3 &from = corner(k + 1).point, &to = corner(k + 2).point, &other = corner(k).point;
    const double slack = 8 * eps * longest_ * weighed(),
                 off = length(cross(other - from, along)) * weighed() + slack;
    const double beside =
        diagonal(bend(across, from).both(), bend(up, from).both()) / least_weight_ + 2 * off;
    const double beyond = std::max(bend(along, to).above(), bend(-1 * along, from).above()) / least_weight_;
    return lengths_[k] > 0 ? diagonal(beside, beyond + slack) * rounding : infinity;
}

// An upper bound on the angle, at most 2e-4 too large: formula 4.4.45 of Abramowitz and Stegun has an error
// of 6.8e-5, to which the rounding of the cosine adds.
double Triangle::angle_at(size_t k) const noexcept {
    const double cosine = cosines_[k], x = std::min(std::abs(cosine), 1.0);
    const double angle = std::sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x)));
    return (cosine < 0 ? std::numbers::pi - angle : angle) + 1e-4;
}

// As seen along a direction at an angle a from the normal, the scalar product of unit vectors along two sides
// changes by at most sin^2 a, before the foreshortening, which does not change its sign.
double Triangle::sine(size_t k, double area) const noexcept {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return cosines_[k] < -0.26 ? 1 : area * (inverse_[i] * inverse_[j]) * (1 - 16 * eps);
}

// Consider a side PE with the third corner K, and barycentric coordinates l. For the direction d in the
// plane, across the side and outwards,
//
//     N = d . (A - w P) <= l_P l_E q / 2 - l_K (w a - r / 2),
//
// where a is the altitude of K, and q and r are the largest values of -N'' along the side and along the other
// two. As seen along a direction up to 30 degrees off the normal, heights above the plane come on top, half
// of them at most. Times w, the height is at most (l_E + l_K) h, where h is half the largest second
// derivative of w times the height along the sides. So the surface comes out only where l_K <= p l_E, with
//
//     p = (q / 2 + h / 2) / (w a - r / 2 - h / 2);
//
// there N <= l_E q / 2, and the heights add at most (1 + p) l_E h / 2. Below, `high` is h / 2 and
// `share` is p.
// Along the side, with V = A - w P, the distance from P is at least l_E (w |PE| - |V''| / 2), less what K
// contributes with l_K <= p l_E, and less (1 + p) l_E h / 2 for the heights: see turn().
Triangle::Turning Triangle::turning(size_t side, const Bend &across, double high,
                                    double area) const noexcept {
    const double out = across.falling(side) / 2;
    const double in = least_weight_ * area * inverse_[side] -
                      std::max(across.falling((side + 1) % 3), across.falling((side + 2) % 3)) / 2;
    const double share = in > high ? (out + high) / (in - high) : infinity;
    return {out, share, (1 + share) * high, across.rising(side) / 2 + high};
}

// The surface comes out only where l_K <= p l_E, and as well l_K <= p l_P: where l_K <= p (1 - l_K) / 2.
double Triangle::share_of(const Turning &over) noexcept {
    return over.share < infinity ? over.share / (2 + over.share) : 1;
}

double Triangle::turn(size_t k, size_t side, const Turning &over, const Four &bends) const noexcept {
    const size_t opposite = 3 - k - side;
    const double along = least_weight_ * lengths_[side] - bends[side] / 2 -
                         over.share * (largest_weight_ * std::max(-cosines_[k] * lengths_[opposite], 0.0) +
                                       std::max(bends[k], bends[opposite]) / 2);
    return over.share < infinity && along > over.high
               ? (over.out + over.high) / (along - over.high) * rounding
               : infinity;
}

// Bounds on V'' with P at the corner itself are computed only where those for all corners do not suffice.
void Triangle::set_turns(const std::array<Turning, 3> &over, TriangleBound &result) const noexcept {
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        auto &turns = result.turns[k];
        const auto set = [&](const Four &along_i, const Four &along_j) {
            turns = {turn(k, i, over[i], along_i), turn(k, j, over[j], along_j)};
            result.leans[k] = {lean(i, over[i], along_i), lean(j, over[j], along_j)};
        };
        const auto wide = [&] { return !(std::max(turns[0], turns[1]) < result.sines[k] / 2); };
        set(bends_, bends_);
        if (wide()) {
            const Four bends = bends_about(k);
            set(bends, bends);
        }
        if (wide()) {
            set(bends_along(i, -1, k), bends_along(j, 1, k));
        }
    }
}

// The same for the image of the side itself, on which l_K = 0.
double Triangle::lean(size_t side, const Turning &over, const Four &bends) const noexcept {
    const double along = least_weight_ * lengths_[side] - bends[side] / 2 - over.in;
    return along > 0 ? over.in / along * rounding : infinity;
}

Four Triangle::bends_about(size_t k) const noexcept {
    return beside(over_cells([&](const HessianBox &box) { return box.size(corners_[k].point); }));
}

// The largest second derivatives of the component of V along a side, away from corner k.
Four Triangle::bends_along(size_t side, double sign, size_t k) const noexcept {
    const Bend along = bend(sign * inverse_[side] * sides_[side], corners_[k].point);
    return {along.rising(0), along.rising(1), along.rising(2), 0};
}

TriangleBound Triangle::bound(bool alone) const noexcept {
    const Vector3 product = cross(sides_[0], sides_[1]);
    const double area = length(product);
    if (!(area > 1e-12 * longest_ * longest_)) { // no well-defined plane
        const double whole = std::min(equal_parameters(), beside_segment());
        TriangleBound result;
        result.height = result.beside = result.whole = whole;
        result.weighed = weighed();
        result.sides.fill(whole);
        return result;
    }
    const Vector3 normal = (1 / area) * product;
    const Bend heights = bend(normal, corners_[0].point);
    const double flat = off(normal), slack = flat + 8 * eps * longest_ * weighed();
    TriangleBound result;
    result.normal = normal;
    result.flat = flat;
    result.weighed = weighed();
    const InverseWeights inverse = inverse_weights();
    result.height = (heights.both(inverse) + flat) * rounding;
    const double high = std::max({heights.largest(0), heights.largest(1), heights.largest(2)}) / 4;
    std::array<Turning, 3> over;
    for (size_t k = 0; k < 3; ++k) {
        const Bend across = bend(cross(inverse_[k] * sides_[k], normal), corner(k + 1).point);
        over[k] = turning(k, across, high, area);
        result.nears[k] = (heights.near_side(k, share_of(over[k]), inverse) + flat) * rounding;
        result.sines[k] = sine(k, area);
        result.altitudes[k] = area * inverse_[k] * (1 - 16 * eps);
        result.angles[k] = angle_at(k);
        const double below = least_weight_ * area * inverse_[k];
        result.outs[k] = across.above(k, below / rounding, inverse) + slack;
        result.out = std::max(result.out, result.outs[k]);
        const bool along = runs_along(k);
        const double beside = along
                                  ? diagonal(heights.on_side(k, inverse), across.on_side(k, inverse)) + slack
                                  : equal_parameters();
        result.sides[k] = beside * rounding;
        result.beside = std::max(result.beside, result.sides[k]);
        result.bends[k] = heights.largest(k) * inverse.most * rounding;
        if (along) {
            result.across[k] = (across.on_side(k, inverse) + slack) * rounding;
        }
    }
    result.out *= sharpness();
    if (result.out > result.height) {
        result.out = std::min(result.out, equal_parameters());
    }
    const bool needle =
        result.least_altitude() < diagonal(result.height, result.out); // else no side is near enough
    result.whole = needle ? from_a_side(result) : infinity;
    result.height = std::min(result.height, result.whole); // the sides are in the plane
    result.out = std::min(result.out, result.whole);
    for (double &out : result.outs) {
        out = std::min(out * rounding, result.out);
    }
    if (!alone) {
        set_turns(over, result);
    }
    return result;
}

} // namespace

TriangleBound triangle_bound(const std::array<TriangleCorner, 3> &corners, std::span<const CellPart> cells,
                             bool alone) noexcept {
    const Triangle triangle(corners, cells);
    if (triangle.certain()) {
        return triangle.bound(alone);
    }
    TriangleBound result;
    result.height = result.beside = infinity;
    result.sides.fill(infinity);
    return result;
}

double equal_parameter_bound(const std::array<TriangleCorner, 3> &corners,
                             std::span<const CellPart> cells) noexcept {
    const Triangle triangle(corners, cells);
    return triangle.certain() ? triangle.equal_parameters() : infinity;
}

} // namespace nrb::mesh
