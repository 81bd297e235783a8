// SPDX-License-Identifier: MIT
#include "mesh/border/curve_pairing.h"

#include "eval/curve_point.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Interpolates linearly in a table whose arguments rise or fall.
double interpolated(const std::vector<double> &from, const std::vector<double> &to, double x) noexcept {
    const bool rising = from.front() < from.back();
    const auto above = rising ? std::upper_bound(from.begin() + 1, from.end() - 1, x)
                              : std::upper_bound(from.begin() + 1, from.end() - 1, x, std::greater<>());
    const auto i = static_cast<size_t>(above - from.begin());
    const double step = from[i] - from[i - 1];
    const double share = step == 0 ? 0 : std::clamp((x - from[i - 1]) / step, 0.0, 1.0);
    return to[i - 1] * (1 - share) + to[i] * share;
}

// Parameters at equal shares of the arc length, from points at equal steps of the parameter.
std::vector<double> at_equal_lengths(Interval domain, const std::vector<Vector3> &points, size_t count) {
    std::vector<double> lengths{0}, params{domain.lower};
    for (size_t i = 1; i < points.size(); ++i) {
        lengths.push_back(lengths.back() + length(points[i] - points[i - 1]));
        params.push_back(
            parameter_in(domain, static_cast<double>(i) / static_cast<double>(points.size() - 1)));
    }
    std::vector<double> result;
    for (size_t i = 0; i <= count; ++i) {
        const double wanted = lengths.back() * static_cast<double>(i) / static_cast<double>(count);
        result.push_back(i == 0       ? domain.lower
                         : i == count ? domain.upper
                                      : interpolated(lengths, params, wanted));
    }
    return result;
}

} // namespace

CurvePairing::CurvePairing(const face::Face &face, const Spline &curve, const Spline &edge, bool against,
                           double near)
    : face_(face), curve_(curve), edge_(edge), against_(against), curve_domain_(curve.axis(0).domain()),
      edge_domain_(edge.axis(0).domain()) {
    if (!is_near(near)) {
        make_tables();
    }
}

bool CurvePairing::is_near(double distance) const {
    constexpr int samples = 8;
    for (int i = 0; i <= samples; ++i) {
        const double s = parameter_in(curve_domain_, static_cast<double>(i) / samples);
        if (!(length(image(s) - edge_jet(by_line(s, curve_domain_, edge_domain_)).point) <= distance)) {
            return false;
        }
    }
    return true;
}

void CurvePairing::make_tables() {
    const auto steps = static_cast<size_t>(64 + 8 * std::max(curve_.count(0), edge_.count(0)));
    std::vector<Vector3> images, points;
    for (size_t i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(steps);
        images.push_back(image(parameter_in(curve_domain_, share)));
        points.push_back(edge_jet(parameter_in(edge_domain_, share)).point);
    }
    s_ = at_equal_lengths(curve_domain_, images, steps);
    t_ = at_equal_lengths(edge_domain_, points, steps);
    if (against_) {
        std::ranges::reverse(t_);
    }
}

double CurvePairing::by_line(double x, Interval from, Interval to) const noexcept {
    const double share = (x - from.lower) / (from.upper - from.lower);
    return parameter_in(to, against_ ? 1 - share : share);
}

CurvePairing::Jet CurvePairing::edge_jet(double t) const {
    std::array<double, 6> jet{};
    const int dim = edge_.dim();
    eval::evaluate_points(edge_, {}, 1, {&t, 1, 1, 1, 1}, {jet.data(), 1, 2 * dim, 2 * dim, 1});
    return {vector_of(jet.data(), dim), vector_of(jet.data() + dim, dim)};
}

CurvePairing::Jet CurvePairing::image_jet(double s) const {
    std::array<double, 4> plane{};
    eval::evaluate_points(curve_, {}, 1, {&s, 1, 1, 1, 1}, {plane.data(), 1, 4, 4, 1});
    const face::Point2 x = face_.covering().in_domain({plane[0], plane[1]});
    std::array<double, 9> jet{};
    const int dim = face_.surface()->dim();
    eval::evaluate_points(*face_.surface(), {}, 1, {x.data(), 1, 2, 2, 1},
                          {jet.data(), 1, 3 * dim, 3 * dim, 1});
    return {vector_of(jet.data(), dim),
            plane[2] * vector_of(jet.data() + dim, dim) + plane[3] * vector_of(jet.data() + 2 * dim, dim)};
}

Vector3 CurvePairing::image(double s) const {
    return image_jet(s).point;
}

namespace {

// Gauss-Newton steps from x to the foot point on a curve, whose point and derivative jet(x) returns.
template <class JetOf>
double nearer(double x, Interval domain, const Vector3 &point, JetOf &&jet) {
    for (int i = 0; i < 6; ++i) {
        const auto [at, along] = jet(x);
        const double squared = dot(along, along), step = squared > 0 ? dot(point - at, along) / squared : 0;
        const double next = std::clamp(x + step, domain.lower, domain.upper);
        if (!std::isfinite(next) || next == x) {
            break;
        }
        const bool done = std::abs(next - x) <= 1e-12 * (domain.upper - domain.lower);
        x = next;
        if (done) {
            break;
        }
    }
    return x;
}

} // namespace

// The interval in which the foot point is sought: the guess by arc lengths is expected to be closer than
// that.
Interval CurvePairing::around(double guess, Interval domain) noexcept {
    const double step = (domain.upper - domain.lower) / 16;
    return {std::max(domain.lower, guess - step), std::min(domain.upper, guess + step)};
}

// One pair after the other is kept if it is between the one that was kept last and the next fixed one.
void put_in_order(std::vector<PairedParam> &pairs) noexcept {
    const bool rising = pairs.front().found <= pairs.back().found;
    const auto is_before = [&](size_t a, size_t b) {
        return rising ? pairs[a].found <= pairs[b].found : pairs[a].found >= pairs[b].found;
    };
    size_t kept = 0, fixed = 0;
    for (size_t i = 1; i < pairs.size(); ++i) {
        for (fixed = std::max(fixed, i); fixed + 1 < pairs.size() && !pairs[fixed].fixed; ++fixed) {
        }
        if (!pairs[i].fixed && !(is_before(kept, i) && is_before(i, fixed))) {
            continue;
        }
        const PairedParam &from = pairs[kept], &to = pairs[i];
        for (size_t k = kept + 1; k < i; ++k) {
            const double step = to.given - from.given,
                         share = step > 0 ? (pairs[k].given - from.given) / step : 0;
            pairs[k].found = from.found * (1 - share) + to.found * share;
        }
        kept = i;
    }
}

double CurvePairing::on_edge(double s) const {
    if (s_.empty() || s == curve_domain_.lower || s == curve_domain_.upper) {
        return by_line(s, curve_domain_, edge_domain_);
    }
    const double guess = interpolated(s_, t_, s);
    return nearer(guess, around(guess, edge_domain_), image(s), [&](double t) { return edge_jet(t); });
}

double CurvePairing::on_curve(double t) const {
    if (s_.empty() || t == edge_domain_.lower || t == edge_domain_.upper) {
        return by_line(t, edge_domain_, curve_domain_);
    }
    const double guess = interpolated(t_, s_, t);
    return nearer(guess, around(guess, curve_domain_), edge_jet(t).point,
                  [&](double s) { return image_jet(s); });
}

} // namespace nrb::mesh
