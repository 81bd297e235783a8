// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/meet_judge.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/extent.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::intersect {

namespace {

constexpr int64_t work_of_a_meet = 3000;
constexpr MeetBox all_places{{{0, 1}, {0, 1}, {0, 1}}};

MeetBox around(const MeetPlace &place, double reach) noexcept {
    MeetBox box{};
    for (size_t k = 0; k < 3; ++k) {
        box[k] = {place[k] - reach, place[k] + reach};
    }
    return box;
}

} // namespace

void MeetJudge::set(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near, double noise) {
    arc_ = arc;
    patch_ = patch;
    near_ = near;
    noise_ = noise;
    curve_is_long_ = false;
    count_work(work_of_a_meet + 10 * surface().coefficients());
}

MeetJudge::Verdict MeetJudge::look(const pieces::SlopedPiece &arc, const SlopedPatch &patch, double near,
                                   double noise) {
    set(arc, patch, near, noise);
    chart_.set(arc, patch);
    if (chart_.turn() != 0 ? chart_.excludes(arc, patch, near) : separated()) {
        return Verdict::nothing;
    }
    chart_.prove(arc, patch);
    return chart_.proven() ? by_chart() : by_tangents();
}

// If near places may extend all along the pieces, by_tangents() is tried first: they may run side by side.
MeetJudge::Verdict MeetJudge::by_chart() {
    approach();
    if (place_.distance > near_ + slack(near_, noise_)) {
        std::ranges::transform(difference_, difference_.begin(), std::negate<>());
        return separated_by(difference_.data(), place_.distance) ? Verdict::nothing : by_tangents();
    }
    const MeetPlace z0 = place(), step = chart_.step(difference_.data());
    const double reach = chart_.contraction().radius(step, near_);
    const MeetBox exact = chart_.contraction().solutions(z0, step, noise_);
    const bool meets = strictly_inside(exact), apart = outside(exact);
    if (reach > 0.5 && (near_ > noise_ || !meets)) {
        const closest::PairPlace nearest = place_;
        if (by_tangents() == Verdict::cell) {
            return Verdict::cell;
        }
        place_ = nearest;
    }
    if (place_.distance > noise_ && !apart) {
        return Verdict::open;
    }
    set_cell(meets ? MeetCell::Kind::meets : MeetCell::Kind::touches, around(z0, reach));
    cell_.turn = chart_.turn();
    cell_.meetable = !apart;
    if (!apart) {
        cell_.core = parameters(exact);
    }
    return Verdict::cell;
}

MeetJudge::Verdict MeetJudge::by_tangents() {
    switch (alongside_.look(arc_, patch_, near_, slack(near_, noise_))) {
    case Alongside::Verdict::apart:
        return Verdict::nothing;
    case Alongside::Verdict::along:
        return along();
    case Alongside::Verdict::ends:
        return at_ends({alongside_.reach(), alongside_.room()[0], alongside_.room()[1]});
    case Alongside::Verdict::open:
        curve_is_long_ = alongside_.is_long();
        break;
    }
    constexpr double few = 64; // below that size charts cannot be proven because of rounding
    const bool small = std::max(curve().size(), surface().size()) <= std::max(near_, few * noise_);
    return small ? at_ends(all_places) : Verdict::open;
}

// Open if what remains is not small in comparison with the distance that counts as near.
MeetJudge::Verdict MeetJudge::at_ends(const MeetBox &room) {
    const double length = arc_.slopes->largest() * (room[0].upper - room[0].lower);
    descend_from(room);
    if (is_apart()) {
        return Verdict::nothing;
    }
    if (!(place_.distance <= near_ + slack(near_, noise_)) || length > std::max(16 * near_, 128 * noise_)) {
        return Verdict::open;
    }
    set_cell(MeetCell::Kind::tiny, room);
    return Verdict::cell;
}

MeetJudge::Verdict MeetJudge::along() {
    const Interval core = alongside_.core();
    const double middle = core.lower / 2 + core.upper / 2;
    const MeetBox room{alongside_.reach(), alongside_.room()[0], alongside_.room()[1]};
    descend_from({Interval{middle, middle},
                  {alongside_.foot(middle)[0], alongside_.foot(middle)[0]},
                  {alongside_.foot(middle)[1], alongside_.foot(middle)[1]}});
    set_cell(MeetCell::Kind::along, room);
    cell_.core[0] = parameters({core, room[1], room[2]})[0];
    cell_.first = line(alongside_.line_at(false));
    cell_.last = line(alongside_.line_at(true));
    return Verdict::cell;
}

void MeetJudge::set_place(const MeetPlace &z) noexcept {
    place_.a[0] = z[0];
    place_.b[0] = z[1];
    place_.b[1] = z[2];
}

void MeetJudge::descend_from(const MeetBox &room) {
    MeetPlace z{};
    for (size_t k = 0; k < 3; ++k) {
        z[k] = std::clamp(room[k].lower / 2 + room[k].upper / 2, 0.0, 1.0);
    }
    set_place(z);
    descend();
}

// Whether the distance certainly exceeds `near`.
bool MeetJudge::is_apart() {
    return place_.distance > near_ && bound_.lower(curve(), surface(), place_, near_) > near_;
}

// Whether a plane parallel to the mean tangent plane separates the pieces.
bool MeetJudge::separated() const noexcept {
    const double *u = patch_.mean(0), *v = patch_.mean(1);
    const Vector3 normal = cross({u[0], u[1], u[2]}, {v[0], v[1], v[2]});
    const double size = length(normal), up[] = {normal.x, normal.y, normal.z},
                 down[] = {-normal.x, -normal.y, -normal.z};
    return size > 0 && (separated_by(up, size) || separated_by(down, size));
}

// Whether a plane separates the pieces, with the surface farther along the normal.
bool MeetJudge::separated_by(const double *normal, double length) const noexcept {
    const Interval of_curve = extent_along(curve(), normal), of_surface = extent_along(surface(), normal);
    return of_surface.lower - of_curve.upper >
           1.0001 * length * (near_ + curve().moved() + surface().moved() + 112 * eps);
}

void MeetJudge::approach() {
    const MeetPlace z = approached<3>(
        [this](const MeetPlace &at) {
            arc_point_.evaluate(curve(), at[0]);
            patch_point_.evaluate(surface(), {at[1], at[2]});
            std::transform(arc_point_.value(), arc_point_.value() + 3, patch_point_.value(),
                           difference_.begin(), std::minus<>());
            return chart_.step(difference_.data());
        },
        [this] {
            MeetPlace step{};
            const bool regular = newton_step(arc_point_.derivative(), patch_point_.derivative(0),
                                             patch_point_.derivative(1), difference_.data(), step);
            return regular ? step : chart_.step(difference_.data());
        });
    set_place(z);
    place_.distance = norm(difference_.data(), 3);
    if (place_.distance > noise_ && place_.distance < 16 * near_) { // not an intersection
        descend();
    }
}

void MeetJudge::descend() {
    descent_.run(curve(), surface(), place_);
    const auto settle = [](double &x) { x = x < eps ? 0 : x > 1 - eps ? 1 : x; };
    settle(place_.a[0]);
    settle(place_.b[0]);
    settle(place_.b[1]);
    if (!std::isfinite(place_.distance)) {
        place_.distance = infinity;
    }
    std::ranges::transform(place_.from, place_.to, difference_.begin(), std::minus<>());
}

// A box of parameters, enlarged by the rounding of parameters.
MeetBox MeetJudge::parameters(const MeetBox &places) const noexcept {
    const auto parameter = [&](double t, double u, double v) {
        const pieces::LocalParam on_surface = surface().parameter({u, v});
        return MeetPlace{curve().parameter({t})[0], on_surface[0], on_surface[1]};
    };
    const MeetPlace first = parameter(0, 0, 0), last = parameter(1, 1, 1);
    MeetPlace lower{}, upper{};
    for (size_t k = 0; k < 3; ++k) {
        lower[k] = std::clamp(places[k].lower, 0.0, 1.0);
        upper[k] = std::clamp(places[k].upper, 0.0, 1.0);
    }
    lower = parameter(lower[0], lower[1], lower[2]);
    upper = parameter(upper[0], upper[1], upper[2]);
    MeetBox box{};
    for (size_t k = 0; k < 3; ++k) {
        const double room = 2 * eps * std::max(std::abs(first[k]), std::abs(last[k]));
        box[k] = {std::max(lower[k] - room, first[k]), std::min(upper[k] + room, last[k])};
    }
    return box;
}

MeetCell::Line MeetJudge::line(int number) const noexcept {
    if (number < 0) {
        return {};
    }
    const double place = number % 2;
    return {number / 2, surface().parameter({place, place})[static_cast<size_t>(number / 2)]};
}

void MeetJudge::set_cell(MeetCell::Kind kind, const MeetBox &box) {
    constexpr double room = 16 * eps; // for the rounding of places
    MeetBox wide = box;
    for (Interval &part : wide) {
        part = {part.lower - room, part.upper + room};
    }
    cell_ = {};
    cell_.kind = kind;
    cell_.box = cell_.core = parameters(wide);
    const pieces::LocalParam on_surface = surface().parameter({place_.b[0], place_.b[1]});
    cell_.at = {curve().parameter({place_.a[0]})[0], on_surface[0], on_surface[1]};
    cell_.gap = place_.distance;
    cell_.still = curve().size() == 0;
}

MeetJudge::Verdict MeetJudge::look_at_tiny(const pieces::SlopedPiece &arc, const SlopedPatch &patch,
                                           double near, double noise) {
    set(arc, patch, near, noise);
    descend_from(all_places);
    if (is_apart()) {
        return Verdict::nothing;
    }
    set_cell(MeetCell::Kind::tiny, all_places);
    return Verdict::cell;
}

} // namespace nrb::intersect
