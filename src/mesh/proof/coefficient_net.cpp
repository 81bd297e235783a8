// SPDX-License-Identifier: MIT
#include "mesh/proof/coefficient_net.h"

#include <cmath>

namespace nrb::mesh {

void differences(const CoefficientNet &net, int axis, CoefficientNet &out) noexcept {
    const int step = net.step(axis);
    out.u = net.u - (axis == 0 ? 1 : 0);
    out.v = net.v - (axis == 0 ? 0 : 1);
    for (int i = 0; i < out.u; ++i) {
        const double *x = net.row(i, 0);
        double *to = out.row(i, 0);
        for (int j = 0; j < out.v; ++j, x += 4, to += 4) {
            (Four(x + step) - Four(x)).store(to);
        }
    }
}

std::array<Range, 4> ranges_of_differences(const CoefficientNet &net, int axis, double factor, double error,
                                           bool planes) noexcept {
    const int step = net.step(axis), m = net.u - (axis == 0 ? 1 : 0), n = net.v - (axis == 0 ? 0 : 1);
    if (m <= 0 || n <= 0 || factor == 0) {
        return {};
    }
    const auto at = [step](const double *x) { return Four(x + step) - Four(x); };
    Four u, v, low(infinity), high(-infinity);
    if (planes) {
        const Four a = at(net.row(0, 0)), b = at(net.row(m - 1, 0)), c = at(net.row(m - 1, n - 1)),
                   d = at(net.row(0, n - 1));
        u = ((b - a) + (c - d)) * 0.5;
        v = ((d - a) + (c - b)) * 0.5;
    }
    const double u_step = m > 1 ? 1.0 / (m - 1) : 0, v_step = n > 1 ? 1.0 / (n - 1) : 0;
    for (int i = 0; i < m; ++i) {
        const Four along = u * (m > 1 ? i * u_step - 0.5 : 0);
        const double *x = net.row(i, 0);
        for (int j = 0; j < n; ++j, x += 4) {
            const Four rest = at(x) - (along + v * (n > 1 ? j * v_step - 0.5 : 0));
            low = least(low, rest);
            high = greatest(high, rest);
        }
    }
    const Four size = greatest(abs(low), abs(high)) + abs(u) + abs(v);
    const std::array<Four, 4> ranges =
        transposed({(low + high) * (factor / 2), u * factor, v * factor,
                    ((high - low) * 0.5 + Four(error) + size * (8 * eps)) * std::abs(factor)});
    return {range_of(ranges[0]), range_of(ranges[1]), range_of(ranges[2]), range_of(ranges[3])};
}

} // namespace nrb::mesh
