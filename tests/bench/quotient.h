// What a program has to add to a library that knows polynomial splines, or no normals.
#pragma once

#include <cmath>

namespace bench {

inline void normalize(const double *a, double *n) {
    const double scale = 1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int c = 0; c < 3; ++c) {
        n[c] = a[c] * scale;
    }
}

// n = a x b / |a x b|.
inline void unit_normal(const double *a, const double *b, double *n) {
    const double product[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                               a[0] * b[1] - a[1] * b[0]};
    normalize(product, n);
}

// Derivatives of a rational curve or surface in space to an order of at most 2 from those of its homogeneous
// form, [slot][4]; slots in graded order (Piegl & Tiller A4.2, A4.4).
template <int Axes, int Order>
void divide(const double *homogeneous, double *out) {
    const double inverse = 1 / homogeneous[3];
    for (int c = 0; c < 3; ++c) {
        const auto h = [=](int slot) { return homogeneous[4 * slot + c]; };
        const auto w = [=](int slot) { return homogeneous[4 * slot + 3]; };
        const auto result = [=](int slot) -> double & { return out[3 * slot + c]; };
        result(0) = h(0) * inverse;
        for (int a = 1; Order >= 1 && a <= Axes; ++a) {
            result(a) = (h(a) - w(a) * result(0)) * inverse;
        }
        int slot = Axes + 1;
        for (int a = 1; Order >= 2 && a <= Axes; ++a) {
            for (int b = a; b <= Axes; ++b, ++slot) {
                result(slot) =
                    (h(slot) - w(a) * result(b) - w(b) * result(a) - w(slot) * result(0)) * inverse;
            }
        }
    }
}

} // namespace bench
