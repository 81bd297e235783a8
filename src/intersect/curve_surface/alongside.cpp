// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/alongside.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double most_sine = 0.05; // between a curve and a surface that run side by side

Vector3 vector_at(const double *x) noexcept {
    return {x[0], x[1], x[2]};
}

// The piece over a larger part of its axes. In extrapolation one of the factors of each mean is negative, so
// that errors grow, and weights may shrink.
pieces::BezierPiece extended(const pieces::BezierPiece &piece, const Box<2> &part) {
    std::vector<double> values(piece.record(0), piece.record(piece.coefficients())), other(values.size());
    const auto width = static_cast<size_t>(piece.shape().width);
    double growth = 1, most = 0, least = infinity;
    for (int k = 0; k < 2; ++k) {
        const double lower = std::min(part[static_cast<size_t>(k)].lower, 0.0),
                     upper = (part[static_cast<size_t>(k)].upper - lower) / (1 - lower);
        const AxisLayers layers = piece.shape().along(max_axes - 2 + k);
        if (lower < 0) {
            subdivide(layers, lower, values.data(), other.data());
        }
        if (upper > 1) {
            subdivide(layers, upper, values.data(), other.data());
            values.swap(other);
        }
        growth *= std::pow((1 - 2 * lower) * std::max(2 * upper - 1, 1.0), layers.degree);
    }
    for (size_t i = 0; i < values.size(); i += width) {
        most = std::max(most, std::abs(piece.record(0)[i + width - 1]));
        least = std::min(least, std::abs(values[i + width - 1]));
    }
    pieces::Rounding rounding = piece.rounding();
    const double ratio = growth * most / least,
                 steps = 2 * eps * (piece.degree(0) + piece.degree(1)) * ratio * piece.reach();
    if (rounding.relative()) {
        rounding.apart = 2 * ratio * (rounding.apart + steps);
    } else {
        rounding.record = growth * (rounding.record + steps * most);
        rounding.weight = growth * (rounding.weight + steps * most);
    }
    return {2, piece.shape(), std::move(values), {}, rounding};
}

// Estimates from the mean derivatives.
struct Run {
    double length; // about how far p runs on S, in local parameters
    double sine;   // of the angle between the axes of S
};
Run run_of(const pieces::SlopedPiece &arc, const SlopedPatch &patch) noexcept {
    const double *c = arc.slopes->mean(), *u = patch.mean(0), *v = patch.mean(1);
    const double uu = dot(u, u, 3), uv = dot(u, v, 3), vv = dot(v, v, 3), cu = dot(c, u, 3),
                 cv = dot(c, v, 3), determinant = uu * vv - uv * uv;
    return {std::max(std::abs(cu * vv - cv * uv), std::abs(cv * uu - cu * uv)) / determinant,
            std::sqrt(std::max(determinant, 0.0) / (uu * vv))};
}

// The largest possible |vector . slope|.
double steepest(const pieces::Slopes &slopes, const double *vector) noexcept {
    const Interval range = slopes.along(vector);
    return std::max(std::abs(range.lower), std::abs(range.upper));
}

} // namespace

// Whether C is nearly parallel to the tangent plane in the middle of S.
bool Alongside::is_level(const pieces::SlopedPiece &arc, const SlopedPatch &patch) noexcept {
    const Vector3 normal = cross(vector_at(patch.mean(0)), vector_at(patch.mean(1))),
                  c = vector_at(arc.slopes->mean());
    return std::abs(dot(normal, c)) <= most_sine * length(normal) * length(c) && length(normal) > 0;
}

// Sets the chart over a box around [0, 1]^2 and p; false if there is none.
bool Alongside::set_region(const SlopedPatch &patch) {
    bool beyond = false;
    for (size_t k = 0; k < 2; ++k) {
        const Interval hull = feet_.hull(static_cast<int>(k));
        constexpr double farthest = 1.5;
        if (!(hull.lower >= -farthest && hull.upper <= 1 + farthest)) {
            return false;
        }
        constexpr double little = 1e-9;
        region_[k] = {std::min(hull.lower, 0.0), std::max(hull.upper, 1.0)};
        beyond = beyond || region_[k].lower < -little || region_[k].upper > 1 + little;
    }
    over_region_ = patch;
    if (beyond) {
        extended_ = extended(*patch.piece, region_);
        if (!extended_.positive()) {
            return false;
        }
        extended_slopes_.emplace(extended_);
        over_region_ = {&extended_, &*extended_slopes_};
    }
    chart_.set(over_region_.along(0), over_region_.along(1), 3);
    return chart_.proven();
}

// Let S(x) be near C(t). Then |M C(t) - M S(x)| is at most what `near` allows, and |M S(p) - M S(x)| at most
// that plus M times the difference at p. By the contraction this bounds |p - x|.
void Alongside::measure(double rounding, double near) {
    const Vector3 normal = unit(cross(vector_at(over_region_.mean(0)), vector_at(over_region_.mean(1))));
    normal_ = {normal.x, normal.y, normal.z};
    largest_ = tangential_ = 0;
    along_normal_ = {infinity, -infinity};
    for (size_t i = 0; i < feet_.count(); ++i) {
        const double *difference = feet_.difference(i), x = dot(normal_.data(), difference, 3);
        largest_ = std::max(largest_, norm(difference, 3));
        tangential_ = std::max(tangential_, largest(chart_.step(difference)));
        along_normal_ = {std::min(along_normal_.lower, x), std::max(along_normal_.upper, x)};
    }
    largest_ += rounding;
    const auto &[rho, norm_of_m] = chart_.contraction();
    constexpr double little = 1e-6; // effect on rho where the region exceeds the piece by rounding
    off_ = 1.001 * (tangential_ + norm_of_m * (near + rounding)) / (1 - rho - little) + 64 * eps;
    for (size_t k = 0; k < 2; ++k) {
        rooms_[k] = off_ * (region_[k].upper - region_[k].lower);
    }
}

bool Alongside::is_apart(double near) const noexcept {
    const double slope =
        steepest(over_region_.along(0), normal_.data()) + steepest(over_region_.along(1), normal_.data());
    const double least = std::max(along_normal_.lower, -along_normal_.upper);
    return least > 1.001 * (near + slope * off_);
}

Alongside::Verdict Alongside::look(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near,
                                   double slack) {
    is_long_ = false;
    if (!is_level(arc, patch)) {
        return Verdict::open;
    }
    const auto [length, sine] = run_of(arc, patch);
    constexpr double most_length = 2, least_sine = 0x1p-8;
    is_long_ = length > 0.5 && 8 * arc.piece->size() >= std::max(sine, least_sine) * patch.piece->size();
    if (!(length <= most_length) || !feet_.interpolate(arc, patch, near, near + slack) ||
        !set_region(patch)) {
        return Verdict::open;
    }
    const double rounding = feet_.compare(arc, patch);
    if (!(rounding < infinity)) {
        return Verdict::open;
    }
    measure(rounding, near);
    if (is_apart(near + rounding)) {
        return Verdict::apart;
    }
    const Verdict verdict = cut();
    if (verdict == Verdict::along && !(largest_ <= near + slack)) {
        return Verdict::open;
    }
    return verdict;
}

Alongside::Verdict Alongside::cut() {
    core_ = reach_ = {0, 1};
    lines_ = {-1, -1};
    for (int line = 0; line < 4; ++line) {
        const Verdict verdict = cut_at(line);
        if (verdict != Verdict::along) {
            return verdict;
        }
    }
    if (!(reach_.lower <= reach_.upper)) {
        return Verdict::apart;
    }
    set_room();
    return core_.lower < core_.upper ? Verdict::along : Verdict::ends;
}

// Where p leaves S, if it crosses the line in one direction. Going beyond the line by no more than rooms_ is
// not leaving.
Alongside::Verdict Alongside::cut_at(int line) {
    const int axis = line / 2;
    std::vector<double> inside = feet_.coefficients(axis);
    if (line % 2 == 1) {
        std::ranges::for_each(inside, [](double &x) { x = 1 - x; });
    }
    const auto [low, high] = std::ranges::minmax_element(inside);
    const double room = rooms_[static_cast<size_t>(axis)];
    if (*low >= -room) {
        const pieces::Slopes &along = over_region_.along(axis);
        largest_ += std::max(-*low, 0.0) * along.largest();
        set_line_at_ends(inside, room, line);
        return Verdict::along;
    }
    if (*high < -room) {
        return Verdict::apart;
    }
    const bool rises = std::is_sorted(inside.begin(), inside.end()),
               falls = std::is_sorted(inside.rbegin(), inside.rend());
    if (!rises && !falls) {
        return Verdict::open;
    }
    cut_monotone(inside, room, line);
    return Verdict::along;
}

// Sets the line at an end of the core, if p begins or ends on it and does not run along it.
void Alongside::set_line_at_ends(const std::vector<double> &inside, double room, int line) noexcept {
    constexpr double much = 16;
    if (*std::ranges::max_element(inside) <= much * room) {
        return;
    }
    if (inside.front() <= room && core_.lower == 0) {
        lines_[0] = line;
    }
    if (inside.back() <= room && core_.upper == 1) {
        lines_[1] = line;
    }
}

void Alongside::cut_monotone(const std::vector<double> &inside, double room, int line) {
    const bool rises = inside.front() < inside.back();
    const int degree = static_cast<int>(inside.size()) - 1;
    constexpr int most_steps = 100;
    std::vector<double> values;
    const auto value = [&](double at) {
        values = inside;
        nrb::evaluate(degree, 1, at, values.data());
        return values.front();
    };
    // Where the value is `level`, from the side where it is less; an end if it is more, or less, everywhere.
    const auto place = [&](double level) {
        double less = rises ? 0 : 1, more = 1 - less;
        if ((rises ? inside.front() : inside.back()) >= level) {
            return less;
        }
        if ((rises ? inside.back() : inside.front()) <= level) {
            return more;
        }
        // False position with the Illinois rule: the value at the end that stays is halved.
        double below = value(less) - level, above = value(more) - level;
        for (int i = 0, last = 0; i < most_steps && std::abs(more - less) > 2 * eps; ++i) {
            const double at = less + (more - less) * below / (below - above), here = value(at) - level;
            if (std::abs(here) <= eps) {
                return at;
            }
            const int side = here < 0 ? -1 : 1;
            if (side < 0) {
                less = at;
                below = here;
                above /= last < 0 ? 2 : 1;
            } else {
                more = at;
                above = here;
                below /= last > 0 ? 2 : 1;
            }
            last = side;
        }
        return less;
    };
    count_work(200 * (degree + 1) * (degree + 1));
    const double at_line = place(0), outside = place(-room);
    if (rises) {
        lines_[0] = at_line > core_.lower ? line : lines_[0];
        core_.lower = std::max(core_.lower, at_line);
        reach_.lower = std::max(reach_.lower, outside);
    } else {
        lines_[1] = at_line < core_.upper ? line : lines_[1];
        core_.upper = std::min(core_.upper, at_line);
        reach_.upper = std::min(reach_.upper, outside);
    }
}

void Alongside::set_room() {
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k);
        std::vector<double> values = feet_.coefficients(k);
        restrict_to(static_cast<int>(values.size()) - 1, reach_.lower, std::max(reach_.upper, 0x1p-60),
                    values.data());
        const auto [low, high] = std::ranges::minmax(values);
        const Interval hull{low, high};
        room_[at] = {std::clamp(hull.lower - rooms_[at], 0.0, 1.0),
                     std::clamp(hull.upper + rooms_[at], 0.0, 1.0)};
    }
}

} // namespace nrb::intersect
