// SPDX-License-Identifier: MIT
// Control nets that are sums of products of functions along the axes.
#pragma once

#include "build/coons/blend_axis.h"

#include <span>
#include <vector>

namespace nrb::build {

// out += factor * x, n values.
inline void add_scaled(double factor, const double *x, size_t n, double *out) noexcept {
    if (factor == 0) {
        return;
    }
    for (size_t i = 0; i < n; ++i) {
        out[i] += factor * x[i];
    }
}

// out += f x + g y, n values.
inline void add_scaled_pair(double f, const double *x, double g, const double *y, size_t n,
                            double *out) noexcept {
    for (size_t i = 0; i < n; ++i) {
        out[i] += f * x[i] + g * y[i];
    }
}

// out += f (x) record (the tensor product): a function of one parameter times a point or any other record.
inline void add_product(const std::vector<double> &f, std::span<const double> record,
                        std::span<double> out) noexcept {
    for (size_t i = 0; i < f.size(); ++i) {
        add_scaled(f[i], record.data(), record.size(), out.data() + i * record.size());
    }
}

// out += f (x) x + g (x) y, where x and y are points. The loop goes coordinate by coordinate, because there
// are few coordinates and many layers.
inline void add_product_pair(const std::vector<double> &f, const double *x, const std::vector<double> &g,
                             const double *y, size_t dim, double *out) noexcept {
    for (size_t c = 0; c < dim; ++c) {
        for (size_t i = 0; i < f.size(); ++i) {
            out[i * dim + c] += f[i] * x[c] + g[i] * y[c];
        }
    }
}

// Sets the layers of a function in the margins of an axis to 0; a layer has `width` values.
void clear_margins(const BlendAxis &axis, size_t width, std::vector<double> &function);

// A net of zeros over the axes, the last one fastest. Throws Status::overflow.
std::vector<double> net_of_zeros(const std::vector<const BlendAxis *> &axes, int dim);

// The spline of a net, whose entries are numerators over the product of the divisors of the axes
// (BlendAxis::divisor()). If it is rational, it has the given form, or is homogeneous if there are points at
// infinity. Throws Status::not_representable and what make_result() throws.
SplinePtr blended_spline(const std::vector<const BlendAxis *> &axes, int dim, Form form,
                         std::vector<double> net);

} // namespace nrb::build
