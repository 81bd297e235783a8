// SPDX-License-Identifier: MIT
#include "eval/frames/curve_limit.h"

#include "base/numbers.h"

#include <array>
#include <cmath>

namespace nrb::eval {

namespace {

// The Taylor coefficients A_1, A_2, ... of a curve and the bounds of their errors, each coefficient times a
// power of two that brings it near 1. A span may be much shorter than its neighbours, so that products of its
// coefficients may leave the range of double.
class Coefficients {
public:
    Coefficients(const Jet &jet, int order) noexcept : order_(order) {
        for (int i = 1; i <= order; ++i) {
            const auto at = static_cast<size_t>(i);
            exponents_[at] = size_exponent(jet.at(i));
            values_[at] = times_power(jet.at(i), -exponents_[at]);
            errors_[at] = std::ldexp(jet.error(i), -exponents_[at]);
        }
    }

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] const Vector3 &at(int i) const noexcept { return values_[static_cast<size_t>(i)]; }
    [[nodiscard]] double error(int i) const noexcept { return errors_[static_cast<size_t>(i)]; }
    [[nodiscard]] int exponent(int i) const noexcept { return exponents_[static_cast<size_t>(i)]; }

private:
    int order_;
    std::array<Vector3, max_jet_order + 1> values_;
    std::array<double, max_jet_order + 1> errors_{};
    std::array<int, max_jet_order + 1> exponents_{};
};

// The leading orders of C = C_0 + A_m s^m + ... + A_k s^k + ...: A_m is the first coefficient that does not
// vanish, and A_k the first one after it that is not parallel to A_m. 0 if there is none.
struct LeadingOrders {
    int m = 0;
    int k = 0;
};

// A bound of the error of A_m x A_k.
double product_error(const Coefficients &jet, int m, int k) noexcept {
    return length(jet.at(m)) * jet.error(k) + jet.error(m) * (length(jet.at(k)) + jet.error(k));
}

LeadingOrders leading_orders(const Coefficients &jet) noexcept {
    LeadingOrders found;
    for (int i = 1; i <= jet.order() && found.k == 0; ++i) {
        if (found.m == 0) {
            found.m = length(jet.at(i)) > jet.error(i) ? i : 0;
        } else if (length(cross(jet.at(found.m), jet.at(i))) > product_error(jet, found.m, i)) {
            found.k = i;
        }
    }
    return found;
}

// The limit of factor * s^exponent as s -> 0+.
double limit_of_power(double factor, int exponent) noexcept {
    return exponent == 0 ? factor : exponent > 0 ? 0 : std::copysign(infinity, factor);
}

// The limit of the curvature. With V the component of A_k across A_m, the curve s^m A_m + s^k A_k has the
// curvature k (k - m) |V| / (m |A_m|)^2 s^(k - 2m) + .... `height` is |V|, with a sign in the plane.
double curvature_limit(const Coefficients &jet, LeadingOrders orders, double height) noexcept {
    const auto [m, k] = orders;
    const double speed = m * length(jet.at(m)), factor = k * (k - m) * (height / speed) / speed;
    return limit_of_power(std::ldexp(factor, jet.exponent(k) - 2 * jet.exponent(m)), k - 2 * m);
}

// The limit of the torsion. With A_l the first coefficient outside the plane of A_m and A_k, and B the
// binormal, det(C', C'', C''') / |C' x C''|^2 is
//   l (l - m) (l - k) / (m k (k - m)) (A_l . B) / (|A_m| |V|) s^(l - m - k) + ....
double torsion_limit(const Coefficients &jet, LeadingOrders orders, const Vector3 &binormal) noexcept {
    const auto [m, k] = orders;
    const double area = length(cross(jet.at(m), jet.at(k)));
    const double tilt = product_error(jet, m, k) / area;
    for (int l = k + 1; l <= jet.order(); ++l) {
        const double height = dot(jet.at(l), binormal);
        if (std::fabs(height) > jet.error(l) + length(jet.at(l)) * tilt) {
            const double factor = static_cast<double>(l * (l - m) * (l - k)) / (m * k * (k - m));
            const int exponent = jet.exponent(l) - jet.exponent(m) - jet.exponent(k);
            return limit_of_power(std::ldexp(factor * height / area, exponent), l - m - k);
        }
    }
    return 0;
}

void complete_in_plane(const Coefficients &jet, LeadingOrders orders, CurveFrame &frame) noexcept {
    frame.normal = {-frame.tangent.y, frame.tangent.x, 0};
    if (orders.k > 0) {
        const double height = dot(jet.at(orders.k), frame.normal); // the side of s enters through the normal
        frame.curvature = curvature_limit(jet, orders, height);
    }
}

void complete_in_space(const Coefficients &jet, double side, LeadingOrders orders,
                       CurveFrame &frame) noexcept {
    const Vector3 &t = frame.tangent;
    if (orders.k == 0) {
        frame.normal = any_normal(t);
        frame.binormal = cross(t, frame.normal);
        frame.status |= frame_rule;
        return;
    }
    const Vector3 area = cross(jet.at(orders.m), jet.at(orders.k));
    const Vector3 turned = unit_across(area, t); // the binormal of the curve as a function of s
    frame.binormal = side * turned;
    frame.normal = cross(frame.binormal, t);
    frame.curvature = curvature_limit(jet, orders, length(area) / length(jet.at(orders.m)));
    frame.torsion = torsion_limit(jet, orders, turned);
    frame.status |= orders.m == 1 && orders.k == 2 ? 0 : frame_normal_limit;
}

// The highest order of Taylor coefficients to look at. Those of a polynomial end at its degree; the torsion
// needs the third one in any case.
int highest_frame_order(const Spline &spline) noexcept {
    return spline.rational() ? max_jet_order : std::min(max_jet_order, std::max(spline.axis(0).degree(), 3));
}

} // namespace

CurveFrame undefined_frame() noexcept {
    const Vector3 none{nan_value, nan_value, nan_value};
    return {none, none, none, nan_value, nan_value, frame_undefined};
}

CurveTangent curve_tangent(const Spline &spline, const AxisRules &rules, double t) noexcept {
    Jet jet;
    for (int order = 1; order <= highest_frame_order(spline); ++order) {
        if (!jet.evaluate(spline, rules, &t, order)) {
            break;
        }
        if (length(jet.at(order)) > jet.error(order)) {
            return {order, jet.side(0) * unit(jet.at(order))};
        }
    }
    return {};
}

CurveFrame limit_frame(const Spline &spline, const AxisRules &rules, double t) noexcept {
    Jet jet;
    const int order = highest_frame_order(spline);
    if (!jet.evaluate(spline, rules, &t, order)) {
        return undefined_frame();
    }
    const Coefficients coefficients(jet, order);
    const LeadingOrders orders = leading_orders(coefficients);
    if (orders.m == 0) {
        return undefined_frame();
    }
    CurveFrame frame;
    frame.tangent = jet.side(0) * unit(coefficients.at(orders.m));
    frame.status = orders.m > 1 ? frame_limit : 0;
    if (spline.dim() == 2) {
        complete_in_plane(coefficients, orders, frame);
    } else {
        complete_in_space(coefficients, jet.side(0), orders, frame);
    }
    return frame;
}

} // namespace nrb::eval
