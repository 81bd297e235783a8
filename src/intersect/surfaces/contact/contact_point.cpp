// SPDX-License-Identifier: MIT
#include "intersect/surfaces/contact/contact_point.h"

#include "base/limits.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr int steps_to_a_ridge = 24;
// A height that bends less has no ridge: ridge() then finds the foot alone.
constexpr double least_bend = 0x1p-14;

// p . form . q for a symmetric form (00, 01, 11).
double form_of(const std::array<double, 3> &form, const std::array<double, 2> &p,
               const std::array<double, 2> &q) noexcept {
    return form[0] * p[0] * q[0] + form[1] * (p[0] * q[1] + p[1] * q[0]) + form[2] * p[1] * q[1];
}

std::array<double, 3> dots(const std::array<Vector3, 3> &second, const Vector3 &normal) noexcept {
    return {dot(second[0], normal), dot(second[1], normal), dot(second[2], normal)};
}

} // namespace

std::array<double, 2> parameters_along(const std::array<Vector3, 2> &slope, const Vector3 &vector) noexcept {
    const double uu = dot(slope[0], slope[0]), uv = dot(slope[0], slope[1]), vv = dot(slope[1], slope[1]),
                 determinant = uu * vv - uv * uv, x = dot(slope[0], vector), y = dot(slope[1], vector);
    return {(x * vv - y * uv) / determinant, (y * uu - x * uv) / determinant};
}

const CrossPiece *ContactSolver::piece_at(size_t surface, const double *at) const {
    CrossGround &ground = *grounds_[surface];
    pieces::PieceGrid::Index index{};
    for (size_t k = 0; k < 2; ++k) {
        const int axis = static_cast<int>(k);
        const double start = ground.grid.break_at(axis, 0), period = ground.borders.period(k);
        const double turns = ground.borders.wraps(k) ? std::floor((at[k] - start) / period) : 0;
        index[k] = ground.grid.find(axis, at[k] - turns * period);
    }
    return ground.piece(index);
}

std::array<double, 2> ContactSolver::place_in(size_t surface, const CrossPiece &piece,
                                              const double *at) const {
    const CrossGround &ground = *grounds_[surface];
    std::array<double, 2> place{};
    for (size_t k = 0; k < 2; ++k) {
        const Interval &range = piece.range[k];
        const double length = range.upper - range.lower, middle = range.lower / 2 + range.upper / 2,
                     period = ground.borders.period(k);
        const double turns = ground.borders.wraps(k) ? std::round((at[k] - middle) / period) : 0;
        place[k] = (at[k] - turns * period - range.lower) / length;
    }
    return place;
}

// The second derivatives of a quotient A / w: (A_kl - w_kl S - w_k S_l - w_l S_k) / w.
std::optional<ContactSolver::Jet> ContactSolver::jet(size_t surface, const double *at) const {
    constexpr size_t stride = max_degree + 1, width = 4, orders = 6;
    constexpr std::array<std::array<size_t, 2>, orders> derivatives{
        {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    const CrossPiece *const piece = piece_at(surface, at);
    if (piece == nullptr || piece->degrees[0] == 0 || piece->degrees[1] == 0) {
        return std::nullopt;
    }
    errors_[surface] = std::max(errors_[surface], piece->error);
    const std::array<double, 2> place = place_in(surface, *piece, at);
    count_work(20 * piece->piece.coefficients());
    std::array<std::array<double, 3 * stride>, 2> b;
    for (size_t k = 0; k < 2; ++k) {
        if (!(std::abs(place[k] - 0.5) <= 1)) {
            return std::nullopt;
        }
        bernstein_functions(piece->degrees[k], place[k], 2, stride, b[k].data());
    }
    std::array<std::array<double, width>, orders> sums{};
    const double *record = piece->piece.record(0);
    for (size_t i = 0; i <= static_cast<size_t>(piece->degrees[0]); ++i) {
        for (size_t j = 0; j <= static_cast<size_t>(piece->degrees[1]); ++j, record += width) {
            for (size_t d = 0; d < orders; ++d) {
                const double f = b[0][derivatives[d][0] * stride + i] * b[1][derivatives[d][1] * stride + j];
                for (size_t c = 0; c < width; ++c) {
                    sums[d][c] += f * record[c];
                }
            }
        }
    }
    const auto vector = [&](size_t d) { return Vector3{sums[d][0], sums[d][1], sums[d][2]}; };
    const double inverse = 1 / sums[0][3];
    const std::array<double, 2> scale{1 / (piece->range[0].upper - piece->range[0].lower),
                                      1 / (piece->range[1].upper - piece->range[1].lower)};
    Jet jet;
    jet.at = inverse * vector(0);
    std::array<Vector3, 2> by{};
    for (size_t k = 0; k < 2; ++k) {
        by[k] = inverse * (vector(1 + k) - sums[1 + k][3] * jet.at);
        jet.first[k] = scale[k] * by[k];
    }
    for (size_t d = 0; d < 3; ++d) {
        const size_t k = d == 2 ? 1 : 0, l = d == 0 ? 0 : 1;
        jet.second[d] = (scale[k] * scale[l] * inverse) * (vector(3 + d) - sums[3 + d][3] * jet.at -
                                                           sums[1 + k][3] * by[l] - sums[1 + l][3] * by[k]);
    }
    return jet;
}

// Sets all but `at` from the jets of both surfaces; false: a derivative vanishes.
bool ContactSolver::set(const Jet &a, const Jet &b, ContactPoint &point) noexcept {
    const Vector3 of_b = cross(b.first[0], b.first[1]);
    const double size = length(of_b), first = length(a.first[0]);
    if (!(size > 0 && first > 0)) {
        return false;
    }
    const Vector3 n = (1 / size) * of_b, x = (1 / first) * (a.first[0] - dot(a.first[0], n) * n),
                  y = cross(n, x);
    const std::array<double, 3> form_a = dots(a.second, n), form_b = dots(b.second, n);
    const std::array<Vector3, 2> axes{x, y};
    std::array<std::array<double, 2>, 2> on_a, on_b;
    for (size_t i = 0; i < 2; ++i) {
        on_a[i] = parameters_along(a.first, axes[i]);
        on_b[i] = parameters_along(b.first, axes[i]);
    }
    const auto bend = [&](size_t i, size_t j) {
        return form_of(form_a, on_a[i], on_a[j]) - form_of(form_b, on_b[i], on_b[j]);
    };
    const double xx = bend(0, 0), xy = bend(0, 1), yy = bend(1, 1), angle = std::atan2(2 * xy, xx - yy) / 2;
    const double cosine = std::cos(angle), sine = std::sin(angle),
                 one = xx * cosine * cosine + 2 * xy * cosine * sine + yy * sine * sine,
                 other = xx + yy - one;
    const Vector3 first_way = cosine * x + sine * y, second_way = cosine * y - sine * x;
    const bool is_first = std::abs(one) >= std::abs(other);
    point.a = a.at;
    point.b = b.at;
    point.normal = n;
    point.height = dot(a.at - b.at, n);
    point.across = is_first ? first_way : second_way;
    point.along = is_first ? second_way : first_way;
    point.most = is_first ? one : other;
    point.least = is_first ? other : one;
    for (size_t s = 0; s < 2; ++s) {
        const auto along = parameters_along(s == 0 ? a.first : b.first, point.along),
                   across = parameters_along(s == 0 ? a.first : b.first, point.across);
        for (size_t k = 0; k < 2; ++k) {
            point.along_on[2 * s + k] = along[k];
            point.across_on[2 * s + k] = across[k];
        }
    }
    point.slope = point.across_on[0] * dot(a.first[0], n) + point.across_on[1] * dot(a.first[1], n);
    return std::isfinite(point.most) && std::isfinite(point.slope);
}

std::optional<ContactPoint> ContactSolver::in_domain(const ContactPoint &point) const {
    std::optional<ContactPoint> result = point;
    for (size_t i = 0; i < 4 && result; ++i) {
        const CrossGround &ground = *grounds_[i / 2];
        const int axis = static_cast<int>(i % 2);
        const double at = result->at[i], first = ground.grid.break_at(axis, 0),
                     last = ground.grid.break_at(axis, ground.grid.count(axis)),
                     room = 0x1p-26 * (last - first), off = std::clamp(at, first - room, last + room) - at;
        if (ground.borders.wraps(i % 2) || off == 0) {
            continue;
        }
        CrossPlace next = result->at;
        for (size_t c = 0; c < 4; ++c) {
            next[c] += off / result->along_on[i] * result->along_on[c];
        }
        result = ridge(next);
    }
    return result;
}

std::optional<CrossPlace> ContactSolver::from_middle(const CrossCell &part, size_t surface,
                                                     const CrossCell &other) const {
    CrossPlace at{};
    const std::array<const CrossCell *, 2> cells{surface == 0 ? &part : &other,
                                                 surface == 0 ? &other : &part};
    for (size_t i = 0; i < 4; ++i) {
        const CrossCell &cell = *cells[i / 2];
        const Interval &range = cell.piece().range[i % 2];
        at[i] = range.lower + (range.upper - range.lower) * (cell.lower(i % 2) + cell.length(i % 2) / 2);
    }
    constexpr double near = 0x1p-20; // the rest is left to ridge()
    const size_t first = 2 * (1 - surface);
    for (int i = 0; i < steps_to_a_ridge; ++i) {
        const std::optional<Jet> own = jet(1 - surface, &at[first]);
        if (!own) {
            return std::nullopt;
        }
        const std::array<double, 2> by = parameters_along(own->first, part.centre() - own->at);
        at[first] += by[0];
        at[first + 1] += by[1];
        if (length(by[0] * own->first[0] + by[1] * own->first[1]) <= near) {
            return at;
        }
    }
    return std::nullopt;
}

std::optional<ContactPoint> ContactSolver::ridge(CrossPlace at) const {
    constexpr double least_step = 0x1p-44, far = 0x1p-3;
    double last = infinity;
    for (int i = 0; i < steps_to_a_ridge; ++i) {
        const std::optional<Jet> a = jet(0, at.data()), b = jet(1, at.data() + 2);
        ContactPoint point;
        point.at = at;
        if (!a || !b || !set(*a, *b, point)) {
            return std::nullopt;
        }
        const std::array<double, 2> foot = parameters_along(b->first, a->at - b->at);
        const double beside = length(foot[0] * b->first[0] + foot[1] * b->first[1]),
                     by = std::abs(point.most) < least_bend ? 0 : -point.slope / point.most,
                     step = std::abs(by) + beside;
        if (step <= least_step || (step >= last && step <= 0x1p-30)) {
            return point;
        }
        if (!(step <= far) || (i > 4 && !(step < last))) {
            return std::nullopt;
        }
        last = step;
        for (size_t k = 0; k < 2; ++k) {
            at[k] += by * point.across_on[k];
            at[2 + k] += foot[k] + by * point.across_on[2 + k];
        }
    }
    return std::nullopt;
}

} // namespace nrb::intersect
