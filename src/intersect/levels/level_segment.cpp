// SPDX-License-Identifier: MIT
#include "intersect/levels/level_segment.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "intersect/levels/level_trace.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::intersect {

namespace {

constexpr int most_depth = 20;

template <size_t N>
std::array<double, N> moved(const std::array<double, N> &from, double by,
                            const std::array<double, N> &along) noexcept {
    std::array<double, N> to = from;
    for (size_t c = 0; c < N; ++c) {
        to[c] += by * along[c];
    }
    return to;
}

template <size_t N>
std::array<double, N> combined(const std::array<std::array<double, N>, 4> &points,
                               const std::array<double, 4> &factors) noexcept {
    std::array<double, N> sum{};
    for (size_t i = 0; i < 4; ++i) {
        sum = moved(sum, factors[i], points[i]);
    }
    return sum;
}

} // namespace

ArcFitter::ArcFitter(LevelField &field, double tolerance)
    : field_(field), grid_(field.grid()), tolerance_(tolerance) {
    for (int k = 0; k < grid_.shape().axes; ++k) {
        degrees_[static_cast<size_t>(grid_.spline_axis(k))] = grid_.shape().degree(k);
    }
    const std::array<int, 2> of_field = field.degrees();
    const int n = 3 * std::max(degrees_[0] + degrees_[1] + 1, of_field[0] + of_field[1]);
    factor_ = 1.01 * (1 + 2 / std::numbers::pi * std::log(n + 1.0));
    for (int i = 0; i <= n; ++i) {
        std::array<double, 4> functions{};
        bernstein_functions(3, 0.5 - 0.5 * std::cos(std::numbers::pi * i / n), functions.data());
        samples_.push_back(functions);
    }
    const auto values = static_cast<size_t>(grid_.shape().values());
    patch_.resize(values);
    work_.resize(std::max(values, static_cast<size_t>(pieces::evaluation_work(grid_.shape()))));
    const auto order = static_cast<size_t>(std::max(degrees_[0], degrees_[1])) + 1;
    matrix_.resize(order * order);
    record_.resize(3 * static_cast<size_t>(grid_.shape().lanes));
}

void ArcFitter::set_piece(int64_t piece) {
    if (piece == piece_) {
        return;
    }
    piece_ = piece;
    domain_ = domain_of(grid_, piece);
    net_ = field_.net(piece);
    grid_.patch(piece, work_.data(), patch_.data());
}

// Of coefficients w_i (P_i, 1) over the box around the arc. The derivative is a mean of degree (w_(i+1) (P_(i+1) - S) -
// w_i (P_i - S)) / w.
double ArcFitter::largest_move(size_t axis, double length) const noexcept {
    const auto rows = static_cast<size_t>(degrees_[0]) + 1, columns = static_cast<size_t>(degrees_[1]) + 1;
    const size_t step = axis == 0 ? columns : 1;
    const auto lanes = static_cast<size_t>(grid_.shape().lanes);
    const auto point = [&](size_t i) {
        const double *record = part_.data() + i * lanes;
        return Vector3{record[0] / record[3], record[1] / record[3], record[2] / record[3]};
    };
    double most = 0, most_of_weight = 0, size = 0;
    for (size_t i = 0; i < rows * columns; ++i) {
        size = std::max(size, nrb::length(point(i) - point(0)));
        if ((axis == 0 ? i / columns : i % columns) < static_cast<size_t>(degrees_[axis])) {
            const double w = part_[i * lanes + 3], next = part_[(i + step) * lanes + 3];
            most = std::max(most, next * nrb::length(point(i + step) - point(i)));
            most_of_weight = std::max(most_of_weight, std::abs(next - w));
        }
    }
    return degrees_[axis] * (most + 2 * size * most_of_weight) / (room_.least_weight * length);
}

// The records of the present piece over a box.
void ArcFitter::set_part(const std::array<double, 2> &lower, const std::array<double, 2> &upper) {
    part_ = patch_;
    for (int k = 0; k < grid_.shape().axes; ++k) {
        const auto on = static_cast<size_t>(grid_.spline_axis(k));
        pieces::part_matrix(grid_.shape().degree(k), lower[on], upper[on], matrix_.data());
        pieces::apply_matrix(grid_.shape(), k, matrix_.data(), part_.data(), work_.data());
        std::copy_n(work_.data(), part_.size(), part_.data());
    }
    room_.least_weight = infinity;
    for (size_t i = 3; i < part_.size(); i += static_cast<size_t>(grid_.shape().lanes)) {
        room_.least_weight = std::min(room_.least_weight, part_[i]);
    }
}

void ArcFitter::set_arc(const LevelArc &arc) {
    set_piece(arc.part.piece);
    axis_ = arc.axis;
    const size_t other = 1 - axis_;
    std::array<double, 2> lower = arc.part.lower, upper = arc.part.lower;
    for (size_t k = 0; k < 2; ++k) {
        lower[k] -= arc_room * arc.part.length[k];
        upper[k] += (1 + arc_room) * arc.part.length[k];
        room_.box[k] = {arc.part.lower[k] - arc_room / 2 * arc.part.length[k],
                        arc.part.lower[k] + (1 + arc_room / 2) * arc.part.length[k]};
    }
    const LevelNet near = net_.part(lower, upper);
    const LevelNet::Slope slope = near.slope(other);
    room_.least_slope =
        slope.sign == 0 ? 0 : slope.least * near.degrees[other] / (upper[other] - lower[other]);
    set_part(lower, upper);
    room_.largest_move = largest_move(other, upper[other] - lower[other]);
    room_.margin = arc_room / 2 * arc.part.length[other];
}

void ArcFitter::evaluate(const std::array<double, 2> &place, int order) {
    pieces::AxisValues at{};
    for (int k = 0; k < grid_.shape().axes; ++k) {
        at[static_cast<size_t>(k)] = place[static_cast<size_t>(grid_.spline_axis(k))];
    }
    pieces::evaluate_patch(grid_.shape(), patch_.data(), at, order, work_.data(), record_.data());
}

// Where the surface stands still along the level, the tangent has length 1 in the parameter domain.
ArcFitter::Node ArcFitter::node(const std::array<double, 2> &place) {
    const std::array<double, 2> slope = net_.at(place).slope;
    evaluate(place, 1);
    const auto lanes = static_cast<size_t>(grid_.shape().lanes);
    Node node{place, {slope[1], -slope[0]}, {}, {}};
    const double w = record_[3];
    for (size_t c = 0; c < 3; ++c) {
        node.point[c] = record_[c] / w;
    }
    double largest = 0;
    for (int k = 0; k < grid_.shape().axes; ++k) {
        const double *by = record_.data() + (static_cast<size_t>(k) + 1) * lanes;
        const double along = node.tangent_on[static_cast<size_t>(grid_.spline_axis(k))];
        for (size_t c = 0; c < 3; ++c) {
            const double term = along * (by[c] - node.point[c] * by[3]) / w;
            node.tangent[c] += term;
            largest = std::max(largest, std::abs(term));
        }
    }
    const double speed = norm(node.tangent.data(), 3);
    if (speed > 1e-9 * largest && speed > 0) {
        for (double &x : node.tangent) {
            x /= speed;
        }
        node.tangent_on = {node.tangent_on[0] / speed, node.tangent_on[1] / speed};
    } else {
        const double length = std::hypot(slope[0], slope[1]);
        node.tangent = {};
        node.tangent_on = {node.tangent_on[0] / length, node.tangent_on[1] / length};
    }
    return node;
}

// On the level, by Newton's method in an interval that closes in.
ArcFitter::Node ArcFitter::node_between(const Node &a, const Node &b, double share) {
    const size_t other = 1 - axis_;
    std::array<double, 2> place = moved(moved({}, 1 - share, a.place), share, b.place);
    Interval range{std::max(room_.box[other].lower, 0.0), std::min(room_.box[other].upper, 1.0)};
    for (int i = 0; i < 60 && range.upper - range.lower > 2 * eps; ++i) {
        const LevelNet::Point point = net_.at(place);
        const double slope = point.slope[other];
        ((point.value > 0) == (slope > 0) ? range.upper : range.lower) = place[other];
        const double next = place[other] - point.value / slope;
        const double last = place[other];
        place[other] = next >= range.lower && next <= range.upper ? next : range.lower / 2 + range.upper / 2;
        if (std::abs(place[other] - last) <= 4 * eps) {
            break;
        }
    }
    return node(place);
}

void ArcFitter::fit(const LevelArc &arc, std::vector<LevelSegment> &segments) {
    if (arc.is_point()) {
        return;
    }
    set_arc(arc);
    fit_between(node(arc.first), node(arc.last), 0, segments);
}

// Errors fall with the fourth power of the length.
void ArcFitter::fit_between(const Node &a, const Node &b, int depth, std::vector<LevelSegment> &segments) {
    LevelSegment segment = hermite(a, b);
    set_deviation(segment);
    count_work(std::ssize(samples_) * 8 * std::ssize(net_.values));
    if (segment.deviation <= tolerance_ || depth >= most_depth || work_ended()) {
        for (std::array<double, 2> &place : segment.on) {
            place = {domain_.parameter(0, place[0]), domain_.parameter(1, place[1])};
        }
        segments.push_back(segment);
        return;
    }
    const double wanted = std::ceil(1.05 * std::sqrt(std::sqrt(segment.deviation / tolerance_)));
    const int parts = wanted < 16 ? std::max(static_cast<int>(wanted), 2) : std::isfinite(wanted) ? 16 : 2;
    Node from = a;
    for (int i = 1; i <= parts; ++i) {
        const Node to = i == parts ? b : node_between(a, b, static_cast<double>(i) / parts);
        fit_between(from, to, depth + (parts > 8 ? 4 : parts > 4 ? 3 : parts > 2 ? 2 : 1), segments);
        from = to;
    }
}

// As long as an arc of a circle with that chord and these tangents.
LevelSegment ArcFitter::hermite(const Node &a, const Node &b) const noexcept {
    const double chord = distance(a.point.data(), b.point.data(), 3),
                 cosine = dot(a.tangent.data(), b.tangent.data(), 3);
    const bool still = norm(a.tangent.data(), 3) == 0 || norm(b.tangent.data(), 3) == 0;
    LevelSegment segment;
    segment.length = still ? std::hypot(a.place[0] - b.place[0], a.place[1] - b.place[1])
                           : chord * (1 + (1 - cosine) / 12);
    const double third = segment.length / 3;
    segment.on = {a.place, moved(a.place, third, a.tangent_on), moved(b.place, -third, b.tangent_on),
                  b.place};
    segment.space = {a.point, moved(a.point, third, a.tangent), moved(b.point, -third, b.tangent), b.point};
    for (std::array<double, 2> &place : segment.on) {
        place = {std::clamp(place[0], 0.0, 1.0), std::clamp(place[1], 0.0, 1.0)};
    }
    return segment;
}

bool ArcFitter::has_room(const LevelSegment &segment) const noexcept {
    return std::ranges::all_of(segment.on, [this](const std::array<double, 2> &place) {
        return place[0] >= room_.box[0].lower && place[0] <= room_.box[0].upper &&
               place[1] >= room_.box[1].lower && place[1] <= room_.box[1].upper;
    });
}

void ArcFitter::set_deviation(LevelSegment &segment) {
    segment.deviation = infinity;
    if (!(room_.least_slope > 0) || !(room_.least_weight > 0) || !has_room(segment)) {
        return;
    }
    double most = 0, most_apart = 0;
    for (const std::array<double, 4> &functions : samples_) {
        const std::array<double, 2> place = combined(segment.on, functions);
        const std::array<double, 3> point = combined(segment.space, functions);
        most = std::max(most, std::abs(net_.at(place).value));
        evaluate(place, 0);
        double apart[3];
        for (size_t c = 0; c < 3; ++c) {
            apart[c] = record_[3] * point[c] - record_[c];
        }
        most_apart = std::max(most_apart, norm(apart, 3));
    }
    const double away = factor_ * most / room_.least_slope;
    if (away <= room_.margin) {
        segment.deviation = factor_ * most_apart / room_.least_weight + room_.largest_move * away;
    }
}

} // namespace nrb::intersect
