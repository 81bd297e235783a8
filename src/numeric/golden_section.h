// SPDX-License-Identifier: MIT
// Golden-section search for minima of functions of one variable.
#pragma once

namespace nrb::inline numeric {

// The minimiser in [a, b] of a function that is unimodal there, within 0.618^sections (b - a). The function
// is evaluated sections + 2 times.
template <class Value>
double golden_section(double a, double b, int sections, Value &&value) {
    constexpr double golden = 0.6180339887498949;
    double x = b - golden * (b - a), y = a + golden * (b - a);
    double at_x = value(x), at_y = value(y);
    for (int i = 0; i < sections; ++i) {
        if (at_x < at_y) {
            b = y;
            y = x;
            at_y = at_x;
            x = b - golden * (b - a);
            at_x = value(x);
        } else {
            a = x;
            x = y;
            at_x = at_y;
            y = a + golden * (b - a);
            at_y = value(y);
        }
    }
    return a + (b - a) / 2;
}

} // namespace nrb::inline numeric
