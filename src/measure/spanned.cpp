// SPDX-License-Identifier: MIT
#include "measure/spanned.h"

#include "numeric/norm.h"

#include <algorithm>

namespace nrb::measure {

namespace {

// Subtracts from x its component along a unit vector.
void take_off(const double *unit, int dim, double *x) noexcept {
    double product = 0;
    for (int c = 0; c < dim; ++c) {
        product += unit[c] * x[c];
    }
    for (int c = 0; c < dim; ++c) {
        x[c] -= product * unit[c];
    }
}

} // namespace

double spanned(std::vector<double> &vectors, int axes, int dim) noexcept {
    double product = 1;
    for (int k = 0; k < axes; ++k) {
        double *own = vectors.data() + k * dim;
        for (int pass = 0; pass < 2; ++pass) { // re-orthogonalization: two passes are enough
            for (int j = 0; j < k; ++j) {
                take_off(vectors.data() + j * dim, dim, own);
            }
        }
        const double rest = norm(own, dim);
        product *= rest;
        std::for_each(own, own + dim, [rest](double &x) { x = rest > 0 ? x / rest : 0; });
    }
    return axes <= dim ? product : 0;
}

} // namespace nrb::measure
