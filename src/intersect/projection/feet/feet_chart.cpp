// SPDX-License-Identifier: MIT
#include "intersect/projection/feet/feet_chart.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// As in CrossChart.
constexpr double least_determinant = 1e-11, most_rho = 0.6, least_digits = 0x1p-4;

std::array<size_t, 2> others_of(size_t k) noexcept {
    return {k == 0 ? size_t{1} : 0, k <= 1 ? size_t{2} : 1};
}

// The null vector of F': the cross product of its rows.
FeetPlace null_vector(const FeetSlopes &s) noexcept {
    return {s[0][1] * s[1][2] - s[0][2] * s[1][1], s[0][2] * s[1][0] - s[0][0] * s[1][2],
            s[0][0] * s[1][1] - s[0][1] * s[1][0]};
}

} // namespace

void FeetNets::set(FeetCell &patch, FeetCell &span) {
    const FeetNet &net = patch.net();
    degrees_ = {net.degrees[0], net.degrees[1], span.net().degrees[0]};
    const std::vector<double> &of_patch = patch.wide(), &of_span = span.wide();
    const size_t n = net.coefficients(), layers = span.net().coefficients();
    const double amplified = patch.amplified() * span.amplified(),
                 steps = 3 * (degrees_[0] + degrees_[1] + degrees_[2]) + 16;
    const FeetNet::Size &own = span.net().sizes[0];
    for (size_t e = 0; e < 2; ++e) {
        std::vector<double> &to = nets_[e];
        to.resize(n * layers);
        const double *from = of_patch.data() + 4 * e * n;
        for (size_t k = 0; k < layers; ++k) {
            const double w = of_span[k], x = of_span[layers + k], y = of_span[2 * layers + k],
                         z = of_span[3 * layers + k];
            double *const out = to.data() + k * n;
            for (size_t i = 0; i < n; ++i) {
                out[i] = w * from[i] + x * from[n + i] + y * from[2 * n + i] + z * from[3 * n + i];
            }
        }
        const FeetNet::Size &size = net.sizes[e];
        near_[e] = 1.01 * amplified *
                   (own.first * size.first_error + own.others * size.others_error +
                    own.first_error * (size.first + size.first_error) +
                    own.others_error * (size.others + size.others_error) +
                    steps * eps * (own.first * size.first + own.others * size.others));
    }
    count_work(static_cast<int64_t>(4 * n * layers));
}

const std::vector<double> &FeetNets::combined(double a, double b) {
    combined_.resize(nets_[0].size());
    for (size_t i = 0; i < combined_.size(); ++i) {
        combined_[i] = a * nets_[0][i] + b * nets_[1][i];
    }
    return combined_;
}

Interval FeetNets::range_of(const std::vector<double> &net) noexcept {
    Interval range{infinity, -infinity};
    for (const double x : net) {
        range = {std::min(range.lower, x), std::max(range.upper, x)};
    }
    return range;
}

AxisLayers FeetNets::layers(size_t axis) const noexcept {
    const auto [p, q, n] = degrees_;
    return axis == 2   ? AxisLayers{1, n, int64_t{p + 1} * (q + 1)}
           : axis == 0 ? AxisLayers{n + 1, p, q + 1}
                       : AxisLayers{int64_t{n + 1} * (p + 1), q, 1};
}

double FeetNets::factor(size_t axis) const noexcept {
    return degrees_[axis] / (1 + 2 * widening);
}

Interval FeetNets::slopes_of(const std::vector<double> &net, size_t axis) const noexcept {
    const AxisLayers all = layers(axis);
    if (all.degree == 0) {
        return {0, 0};
    }
    Interval range{infinity, -infinity};
    for (int64_t o = 0; o < all.outer; ++o) {
        const double *layer = net.data() + all.at(o, 0, 0);
        for (int64_t i = 0; i < all.degree * all.inner; ++i) {
            const double x = layer[i + all.inner] - layer[i];
            range = {std::min(range.lower, x), std::max(range.upper, x)};
        }
    }
    return {factor(axis) * range.lower, factor(axis) * range.upper};
}

FeetSlopes FeetNets::mean_slopes() const noexcept {
    FeetSlopes slopes{};
    for (size_t e = 0; e < 2; ++e) {
        for (size_t axis = 0; axis < 3; ++axis) {
            const AxisLayers all = layers(axis);
            double sum = 0;
            for (int64_t o = 0; o < all.outer; ++o) {
                for (int64_t i = 0; i < all.inner; ++i) {
                    sum += nets_[e][static_cast<size_t>(all.at(o, all.degree, i))] -
                           nets_[e][static_cast<size_t>(all.at(o, 0, i))];
                }
            }
            slopes[e][axis] = sum / (static_cast<double>(all.outer * all.inner) * (1 + 2 * widening));
        }
    }
    return slopes;
}

FeetPlace FeetNets::bends_of(const std::vector<double> &net) const noexcept {
    FeetPlace bends{};
    for (size_t a = 0; a < 3; ++a) {
        for (size_t b = a; b < 3; ++b) {
            const double most = factor(a) * factor(b) * largest_second_difference(net, a, b);
            bends[a] += most;
            bends[b] += a == b ? 0 : most;
        }
    }
    return bends;
}

double FeetNets::largest_second_difference(const std::vector<double> &net, size_t a,
                                           size_t b) const noexcept {
    const auto [p, q, n] = degrees_;
    const std::array<int64_t, 3> strides{q + 1, 1, int64_t{p + 1} * (q + 1)};
    std::array<int64_t, 3> counts{p + 1, q + 1, n + 1};
    --counts[a];
    --counts[b];
    const int64_t to_a = strides[a], to_b = strides[b];
    double most = 0;
    for (int64_t t = 0; t < counts[2]; ++t) {
        for (int64_t u = 0; u < counts[0]; ++u) {
            const double *x = net.data() + t * strides[2] + u * strides[0];
            for (int64_t v = 0; v < counts[1]; ++v, ++x) {
                most = std::max(most, std::abs(x[0] - x[to_a] - x[to_b] + x[to_a + to_b]));
            }
        }
    }
    return most;
}

bool FeetChart::set_rows(const FeetSlopes &slopes) noexcept {
    const FeetPlace direction = null_vector(slopes);
    axis_ = 0;
    for (size_t i = 1; i < 3; ++i) {
        axis_ = std::abs(direction[i]) > std::abs(direction[axis_]) ? i : axis_;
    }
    direction_ = direction[axis_] > 0 ? 1 : -1;
    const auto [i, j] = others_of(axis_);
    const double a = slopes[0][i], b = slopes[0][j], c = slopes[1][i], d = slopes[1][j],
                 determinant = a * d - b * c;
    rows_ = {};
    if (!(std::abs(determinant) > least_determinant * std::hypot(a, c) * std::hypot(b, d))) {
        return false;
    }
    rows_[i] = {d / determinant, -b / determinant};
    rows_[j] = {-c / determinant, a / determinant};
    return std::isfinite(rows_[i][0] + rows_[i][1] + rows_[j][0] + rows_[j][1]);
}

// Bounds row i of M F, of its derivative by coordinate k, and of I - M F'; false: that row of M F has no
// zero.
bool FeetChart::set_row(size_t i, FeetNets &nets) {
    const auto [a, b] = rows_[i];
    const std::vector<double> &net = nets.combined(a, b);
    noise_[i] = 1.0001 * (std::abs(a) * nets.near(0) + std::abs(b) * nets.near(1));
    const Interval range = FeetNets::range_of(net);
    const double far = magnitude_of(range), room = noise_[i] + 8 * eps * far;
    if (range.lower > room || range.upper < -room) {
        return false;
    }
    for (size_t k = 0; k < 3; ++k) {
        const double rounding = 4 * nets.degree(k) * room, wanted = k == i ? 1 : 0;
        Interval slopes = nets.slopes_of(net, k);
        slopes = {slopes.lower - rounding, slopes.upper + rounding};
        if (k == axis_) {
            shifts_[i] = slopes;
        } else {
            coupling_.set_off(
                i, k, 1.0001 * magnitude_of({slopes.lower - wanted, slopes.upper - wanted}) + 16 * eps);
        }
    }
    return true;
}

FeetChart::Verdict FeetChart::set(FeetNets &nets) {
    for (size_t e = 0; e < 2; ++e) {
        const Interval range = FeetNets::range_of(nets.of(e));
        if (range.lower > nets.near(e) || range.upper < -nets.near(e)) {
            return Verdict::apart;
        }
    }
    has_rows_ = set_rows(nets.mean_slopes());
    count_work(static_cast<int64_t>(4 * nets.of(0).size()));
    if (!has_rows_) {
        return Verdict::flat;
    }
    coupling_.clear();
    most_noise_ = 0;
    for (const size_t i : others_of(axis_)) {
        count_work(static_cast<int64_t>(4 * nets.of(0).size()));
        if (!set_row(i, nets)) {
            return Verdict::apart;
        }
        most_noise_ = std::max(most_noise_, noise_[i]);
    }
    shifts_[axis_] = {-1, -1};
    noise_[axis_] = 0;
    if (!(coupling_.norm() <= most_rho) || !coupling_.invert(1 / (1 - most_rho)) ||
        !(most_noise_ < least_digits)) {
        return Verdict::bent;
    }
    set_rises();
    return Verdict::chart;
}

void FeetChart::set_rises() noexcept {
    FeetPlace fastest{};
    for (const size_t i : others_of(axis_)) {
        fastest[i] = magnitude_of(shifts_[i]);
    }
    const FeetPlace room = coupling_.drift(coupling_.reach(fastest));
    for (size_t i = 0; i < 3; ++i) {
        rises_[i] = {-shifts_[i].upper - room[i], -shifts_[i].lower + room[i]};
    }
}

FeetPlace FeetChart::drift(const FeetPlace &step, double off, double far,
                           const FeetPlace &farthest) const noexcept {
    FeetPlace size{};
    for (const size_t i : others_of(axis_)) {
        size[i] = std::abs(step[i]) + off * noise_[i] + magnitude_of(shifts_[i]) * far;
    }
    FeetPlace reach = coupling_.reach_in_norm(size);
    for (double &x : reach) {
        x = std::min(x, largest(farthest));
    }
    return coupling_.drift(reach);
}

FeetPlace FeetChart::off_at(const FeetPlace &step) const noexcept {
    FeetPlace off = coupling_.drift(coupling_.reach_in_norm(step));
    for (size_t i = 0; i < 3; ++i) {
        off[i] = i == axis_ ? 0 : 1.0001 * (off[i] + step[i]);
    }
    return off;
}

FeetPlace FeetChart::step(const std::array<double, 2> &value) const noexcept {
    FeetPlace step{};
    for (size_t i = 0; i < 3; ++i) {
        step[i] = rows_[i][0] * value[0] + rows_[i][1] * value[1];
    }
    return step;
}

FeetPlace FeetChart::largest_step(const std::array<double, 2> &bound) const noexcept {
    FeetPlace step{};
    for (size_t i = 0; i < 3; ++i) {
        step[i] = 1.0001 * (std::abs(rows_[i][0]) * bound[0] + std::abs(rows_[i][1]) * bound[1]);
    }
    return step;
}

// A mixed second derivative counts for both of its axes; the factor sqrt(length) then prefers the longer one.
size_t FeetChart::bent_axis(FeetNets &nets, const FeetPlace &lengths) const {
    constexpr double little = 0.05;

    FeetPlace bends{};
    const auto add = [&](const std::vector<double> &net, double size) {
        const FeetPlace own = nets.bends_of(net);
        for (size_t axis = 0; axis < 3 && size > 0; ++axis) {
            bends[axis] += own[axis] / size;
        }
    };
    count_work(static_cast<int64_t>(12 * nets.of(0).size()));
    if (has_rows_) {
        for (const size_t i : others_of(axis_)) {
            add(nets.combined(rows_[i][0], rows_[i][1]), 1);
        }
    } else {
        for (size_t e = 0; e < 2; ++e) {
            add(nets.of(e), magnitude_of(FeetNets::range_of(nets.of(e))));
        }
    }
    for (size_t axis = 0; axis < 3; ++axis) {
        bends[axis] = nets.degree(axis) == 0 ? -1 : (bends[axis] + little) * std::sqrt(lengths[axis]);
    }
    return static_cast<size_t>(std::ranges::max_element(bends) - bends.begin());
}

FeetBox::Value FeetBox::at(const FeetPlace &z) const noexcept {
    std::array<double, 8> value{}, by_u{}, by_v{};
    std::array<double, 4> own{}, by_t{}, none{};
    const FeetNet &net = patch->net(), &curve = span->net();
    evaluate_net(net.degrees, 8, net.values.data(), patch->in_piece({z[0], z[1]}), value.data(),
                 {by_u.data(), by_v.data()});
    evaluate_net(curve.degrees, 4, curve.values.data(), span->in_piece({z[2], 0}), own.data(),
                 {by_t.data(), none.data()});
    Value result{};
    for (size_t e = 0; e < 2; ++e) {
        for (size_t c = 0; c < 4; ++c) {
            result.difference[e] += value[4 * e + c] * own[c];
            result.slopes[e][0] += patch->length(0) * by_u[4 * e + c] * own[c];
            result.slopes[e][1] += patch->length(1) * by_v[4 * e + c] * own[c];
            result.slopes[e][2] += span->length(0) * value[4 * e + c] * by_t[c];
        }
    }
    return result;
}

// The normal is that of the tangents T_k, which do not vanish at poles, unlike S_u or S_v.
FeetBox::Contact FeetBox::contact_at(const FeetPlace &z) const noexcept {
    Contact contact{};
    const FeetNet &net = patch->net(), &of_curve = span->net();
    const std::array<double, 2> on = patch->in_piece({z[0], z[1]});
    const CrossPiece::Point point = net.piece->evaluate(on);
    contact.surface = point.at;
    contact.slopes = {patch->length(0) * point.slope[0], patch->length(1) * point.slope[1]};
    std::array<double, 4> own{}, by_t{}, none{};
    evaluate_net(of_curve.degrees, 4, of_curve.values.data(), span->in_piece({z[2], 0}), own.data(),
                 {by_t.data(), none.data()});
    const auto vector = [](const double *x) { return Vector3{x[0], x[1], x[2]}; };
    contact.curve = (-1 / own[0]) * vector(own.data() + 1);
    contact.slope = (span->length(0) / own[0]) * (-1 * vector(by_t.data() + 1) - by_t[0] * contact.curve);
    std::array<double, 8> value{};
    evaluate_net(net.degrees, 8, net.values.data(), on, value.data(), {nullptr, nullptr});
    const Vector3 across = cross(vector(value.data() + 1), vector(value.data() + 5));
    const double size = numeric::length(across);
    contact.normal = size > 0 ? (1 / size) * across : Vector3{};
    const Vector3 way = contact.surface - contact.curve;
    contact.distance = size > 0 ? dot(way, contact.normal) : numeric::length(way);
    return contact;
}

FeetPlace FeetBox::tangent_at(const FeetPlace &z) const noexcept {
    return null_vector(at(z).slopes);
}

bool FeetBox::solve(size_t fixed, FeetPlace &z) const {
    const auto [i, j] = others_of(fixed);
    const auto work = static_cast<int64_t>(4 * patch->net().values.size() + 100);
    return newton_on_side(
        fixed, chart.noise(), z, [&, i = i, j = j](const FeetPlace &place, FeetPlace &step) {
            count_work(work);
            const Value value = at(place);
            const auto &[f, g] = value.slopes;
            const auto &[x, y] = value.difference;
            const double determinant = f[i] * g[j] - f[j] * g[i];
            step[i] = (g[j] * x - f[j] * y) / determinant;
            step[j] = (f[i] * y - g[i] * x) / determinant;
            return std::abs(determinant) > 0x1p-50 * std::hypot(f[i], g[i]) * std::hypot(f[j], g[j]);
        });
}

} // namespace nrb::intersect
