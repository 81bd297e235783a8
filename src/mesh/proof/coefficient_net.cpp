// SPDX-License-Identifier: MIT
#include "mesh/proof/coefficient_net.h"

#include <cmath>

namespace nrb::mesh {

void second_differences(const CoefficientNet &net, int first, int second, CoefficientNet &out) noexcept {
    const int along = net.step(first), across = net.step(second); // the same along one axis
    out.u = net.u - (first == 0 ? 1 : 0) - (second == 0 ? 1 : 0);
    out.v = net.v - (first == 0 ? 0 : 1) - (second == 0 ? 0 : 1);
    for (int i = 0; i < out.u; ++i) {
        for (int j = 0; j < out.v; ++j) {
            const double *x = net.row(i, j);
            out.set(i, j, (Four(x + along + across) - Four(x + across)) - (Four(x + along) - Four(x)));
        }
    }
}

CoordinateRanges ranges_of(const CoefficientNet &net, double factor, double error, bool planes) noexcept {
    CoordinateRanges result{};
    if (net.u <= 0 || net.v <= 0 || factor == 0) {
        return result;
    }
    Four u, v, low(infinity), high(-infinity);
    if (planes) {
        const Four a = net.at(0, 0), b = net.at(net.u - 1, 0), c = net.at(net.u - 1, net.v - 1),
                   d = net.at(0, net.v - 1);
        u = ((b - a) + (c - d)) * 0.5;
        v = ((d - a) + (c - b)) * 0.5;
    }
    const double u_step = net.u > 1 ? 1.0 / (net.u - 1) : 0, v_step = net.v > 1 ? 1.0 / (net.v - 1) : 0;
    for (int i = 0; i < net.u; ++i) {
        const Four along = u * (net.u > 1 ? i * u_step - 0.5 : 0);
        for (int j = 0; j < net.v; ++j) {
            const Four rest = net.at(i, j) - (along + v * (net.v > 1 ? j * v_step - 0.5 : 0));
            low = least(low, rest);
            high = greatest(high, rest);
        }
    }
    const Four size = greatest(abs(low), abs(high)) + abs(u) + abs(v);
    ((low + high) * (factor / 2)).store(result.middle.data());
    (u * factor).store(result.u.data());
    (v * factor).store(result.v.data());
    (((high - low) * 0.5 + Four(error) + size * (8 * eps)) * std::abs(factor)).store(result.radius.data());
    return result;
}

} // namespace nrb::mesh
