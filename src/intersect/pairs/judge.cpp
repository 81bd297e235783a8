// SPDX-License-Identifier: MIT
#include "intersect/pairs/judge.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/extent.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::intersect {

namespace {

using pieces::BezierPiece;

constexpr int64_t work_of_a_pair = 3000;

Interval parameters(const BezierPiece &piece, Interval places) noexcept {
    return {piece.parameter({std::clamp(places.lower, 0.0, 1.0)})[0],
            piece.parameter({std::clamp(places.upper, 0.0, 1.0)})[0]};
}

// Moves a place within rounding of an end to that end.
double settled(double place) noexcept {
    return place < eps ? 0 : place > 1 - eps ? 1 : place;
}

} // namespace

void Judge::set(const pieces::SlopedPiece &a, const pieces::SlopedPiece &b, double near, double noise) {
    a_ = a;
    b_ = b;
    near_ = near;
    noise_ = noise;
    dim_ = piece_a().dim();
    difference_.resize(static_cast<size_t>(dim_));
    count_work(work_of_a_pair);
}

Judge::Verdict Judge::look(const pieces::SlopedPiece &a, const pieces::SlopedPiece &b, double near,
                           double noise) {
    set(a, b, near, noise);
    chart_.set(*a.slopes, *b.slopes, dim_);
    if (chart_.proven()) {
        return by_chart();
    }
    if (separated()) {
        return Verdict::nothing;
    }
    return by_tangents();
}

// If near places may extend all along the pieces, by_tangents() is tried first: they may run side by side.
Judge::Verdict Judge::by_chart() {
    if (chart_.excludes(piece_a(), piece_b(), near_)) {
        return Verdict::nothing;
    }
    approach();
    const double most = near_ + slack(near_, noise_);
    if (place_.distance > most) {
        std::ranges::transform(difference_, difference_.begin(), std::negate<>());
        return separated_by(difference_.data(), place_.distance) ? Verdict::nothing : by_tangents();
    }
    const Place<2> z0{place_.a[0], place_.b[0]}, step = chart_.step(difference_.data());
    const double reach = chart_.contraction().radius(step, near_);
    const Box<2> exact = chart_.contraction().solutions(z0, step, noise_);
    const bool meets = dim_ == 2 && strictly_inside(exact);
    bool apart = outside(exact);
    if (reach > 0.5 && (near_ > noise_ || !meets)) {
        const closest::PairPlace place = place_;
        compared_ = false;
        if (by_tangents() == Verdict::cell) {
            return Verdict::cell;
        }
        apart = apart || (compared_ && dim_ == 2 && matched_.separates(beside_, noise_));
        place_ = place;
    }
    if (place_.distance > noise_ && !apart) {
        return Verdict::open;
    }
    set_cell(meets ? NearCell::Kind::meets : NearCell::Kind::touches, {z0[0] - reach, z0[0] + reach},
             {z0[1] - reach, z0[1] + reach});
    cell_.turn = chart_.turn();
    cell_.meetable = !apart;
    if (!apart) {
        set_core(exact[0], exact[1]);
    }
    return Verdict::cell;
}

// Near places of pieces that run side by side are near their matched parts. If one piece ends where the other
// begins, they are around that place only. For other pieces charts of their halves do better.
Judge::Verdict Judge::by_tangents() {
    const double nearly_parallel = dim_ == 2 ? 0.03 : 1e-3;
    beside_.set(piece_a(), *a_.slopes, piece_b(), *b_.slopes);
    if (!beside_.proven()) {
        return Verdict::open;
    }
    const double length = beside_.length();
    const bool follow = length <= near_ / 64, runs_beside = chart_.square_of_sine() < nearly_parallel;
    const bool meets_ends = follow || std::max(piece_a().size(), piece_b().size()) <= near_;
    if (!meets_ends && !runs_beside) {
        return Verdict::open;
    }
    const std::optional<Beside::Places> room = beside_.near(near_);
    if (!room) {
        return Verdict::nothing;
    }
    const Verdict verdict = runs_beside && !follow ? side_by_side(*room) : Verdict::open;
    if (verdict != Verdict::open || !meets_ends) {
        return verdict;
    }
    return at_ends(*room);
}

Judge::Verdict Judge::at_ends(const Beside::Places &room) {
    descend_from(room);
    if (is_apart()) {
        return Verdict::nothing;
    }
    if (!(place_.distance <= near_ + slack(near_, noise_))) {
        return Verdict::open;
    }
    set_cell(NearCell::Kind::tiny, room.a, room.rising_b());
    return Verdict::cell;
}

Judge::Verdict Judge::side_by_side(const Beside::Places &room) {
    const Beside::Match match = beside_.match();
    matched_.set(piece_a(), piece_b(), match);
    compared_ = true;
    if (dim_ == 2 && matched_.separates(beside_, near_)) {
        return Verdict::nothing;
    }
    if (!(matched_.upper() <= near_ + slack(near_, noise_))) {
        if (dim_ != 2) {
            descend_from(room);
        }
        return dim_ != 2 && is_apart() ? Verdict::nothing : Verdict::open;
    }
    descend_from(room);
    set_cell(NearCell::Kind::along, room.a, room.rising_b());
    cell_.turn = beside_.direction();
    set_core(match.ends.a, match.ends.b);
    const Interval all_a = parameters(piece_a(), {0, 1}), all_b = parameters(piece_b(), {0, 1});
    cell_.reach_a = beside_.reach_a(near_) * (all_a.upper - all_a.lower);
    cell_.reach_b = beside_.reach_b(near_) * (all_b.upper - all_b.lower);
    return Verdict::cell;
}

void Judge::descend_from(const Beside::Places &room) {
    place_.a[0] = room.a.lower / 2 + room.a.upper / 2;
    place_.b[0] = room.b.lower / 2 + room.b.upper / 2;
    descend();
}

// Whether the distance certainly exceeds `near`.
bool Judge::is_apart() {
    return place_.distance > near_ && bound_.lower(piece_a(), piece_b(), place_, near_) > near_;
}

// In the plane: whether a line along one of the chords separates the pieces.
bool Judge::separated() const noexcept {
    if (dim_ != 2) {
        return false;
    }
    for (const pieces::SlopedPiece &one : {a_, b_}) {
        const double *from = one.piece->point(0), *to = one.piece->point(one.piece->coefficients() - 1);
        const double normal[] = {from[1] - to[1], to[0] - from[0]}, other[] = {-normal[0], -normal[1]};
        const double length = norm(normal, 2);
        if (separated_by(normal, length) || separated_by(other, length)) {
            return true;
        }
    }
    return false;
}

// Whether a plane separates the pieces, with b farther along the normal.
bool Judge::separated_by(const double *normal, double length) const noexcept {
    const Interval of_a = extent_along(piece_a(), normal), of_b = extent_along(piece_b(), normal);
    return of_b.lower - of_a.upper >
           1.0001 * length * (near_ + piece_a().moved() + piece_b().moved() + 16 * (dim_ + 4) * eps);
}

void Judge::approach() {
    const Place<2> z = approached<2>(
        [this](const Place<2> &at) {
            point_a_.evaluate(piece_a(), at[0]);
            point_b_.evaluate(piece_b(), at[1]);
            for (size_t c = 0; c < difference_.size(); ++c) {
                difference_[c] = point_a_.value()[c] - point_b_.value()[c];
            }
            return chart_.step(difference_.data());
        },
        [this] { return newton_step(); });
    place_.a[0] = z[0];
    place_.b[0] = z[1];
    place_.distance = norm(difference_.data(), dim_);
    if (place_.distance > noise_ && place_.distance < 16 * near_) { // not an intersection
        descend();
    }
}

// The Gauss-Newton step.
Place<2> Judge::newton_step() const noexcept {
    const double *u = point_a_.derivative(), *v = point_b_.derivative(), *f = difference_.data();
    const double uu = dot(u, u, dim_), vv = dot(v, v, dim_), uv = dot(u, v, dim_), uf = dot(u, f, dim_),
                 vf = dot(v, f, dim_), determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-14 * uu * vv)) {
        return chart_.step(f);
    }
    return {(vv * uf - uv * vf) / determinant, (uv * uf - uu * vf) / determinant};
}

void Judge::descend() {
    descent_.run(piece_a(), piece_b(), place_);
    place_.a[0] = settled(place_.a[0]);
    place_.b[0] = settled(place_.b[0]);
    if (!std::isfinite(place_.distance)) {
        place_.distance = infinity;
    }
    for (size_t c = 0; c < difference_.size(); ++c) {
        difference_[c] = place_.from[c] - place_.to[c];
    }
}

void Judge::set_cell(NearCell::Kind kind, Interval a, Interval b) {
    constexpr double room = 16 * eps; // for the rounding of places
    cell_ = {};
    cell_.kind = kind;
    cell_.a = parameters(piece_a(), {a.lower - room, a.upper + room});
    cell_.b = parameters(piece_b(), {b.lower - room, b.upper + room});
    cell_.at_a = piece_a().parameter(place_.a)[0];
    cell_.at_b = piece_b().parameter(place_.b)[0];
    cell_.gap = place_.distance;
    cell_.core_a = cell_.a;
    cell_.core_b = cell_.b;
}

void Judge::set_core(Interval a, Interval b) {
    cell_.core_a = parameters(piece_a(), a);
    cell_.core_b = parameters(piece_b(), b);
}

Judge::Verdict Judge::look_at_tiny(const pieces::SlopedPiece &a, const pieces::SlopedPiece &b, double near,
                                   double noise) {
    set(a, b, near, noise);
    place_.a[0] = place_.b[0] = 0.5;
    descend();
    if (is_apart()) {
        return Verdict::nothing;
    }
    set_cell(NearCell::Kind::tiny, {0, 1}, {0, 1});
    cell_.still = piece_a().size() == 0 || piece_b().size() == 0;
    return Verdict::cell;
}

} // namespace nrb::intersect
