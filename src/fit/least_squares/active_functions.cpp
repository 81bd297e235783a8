// SPDX-License-Identifier: MIT
#include "fit/least_squares/active_functions.h"

#include "basis/bspline.h"

namespace nrb::fit {

ActiveFunctions::ActiveFunctions(const std::vector<KnotVectorPtr> &axes) : axes_(axes) {
    Index counts{1, 1, 1};
    along_.fill({1.0});
    for (size_t k = 0; k < axes.size(); ++k) {
        counts[k] = axes[k]->degree() + 1;
        widths_[k] = static_cast<size_t>(counts[k]);
        along_[k].resize(widths_[k]);
    }
    for_each_index({}, counts, [&](const Index &step) { steps_.push_back(step); });
    values_.resize(steps_.size());
}

void ActiveFunctions::set(size_t axis, int64_t span, double t, int order) {
    const KnotVector &knots = *axes_[axis];
    std::vector<double> &along = along_[axis];
    first_[axis] = span - knots.degree();
    along.resize(static_cast<size_t>(order + 1) * widths_[axis]);
    if (order == 0) {
        basis_values(knots.knots().data(), knots.degree(), span, t, along.data());
    } else {
        basis_derivs(knots.knots().data(), knots.degree(), span, t, order, along.data());
    }
}

void ActiveFunctions::multiply() noexcept {
    std::array<const double *, max_axes> along{};
    for (size_t k = 0; k < along.size(); ++k) {
        along[k] = along_[k].data() + along_[k].size() - widths_[k];
    }
    double *value = values_.data();
    for (size_t i = 0; i < widths_[0]; ++i) {
        for (size_t j = 0; j < widths_[1]; ++j) {
            const double factor = along[0][i] * along[1][j];
            for (size_t k = 0; k < widths_[2]; ++k) {
                *value++ = factor * along[2][k];
            }
        }
    }
}

Index ActiveFunctions::layer(size_t i) const noexcept {
    Index layer = first_;
    for (size_t k = 0; k < layer.size(); ++k) {
        layer[k] += steps_[i][k];
    }
    return layer;
}

} // namespace nrb::fit
