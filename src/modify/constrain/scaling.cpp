// SPDX-License-Identifier: MIT
#include "modify/constrain/scaling.h"

#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nrb::modify {

double pivot_threshold(const Spline &spline, size_t equations, int64_t unknowns) noexcept {
    double degrees = 1;
    for (int k = 0; k < spline.axes(); ++k) {
        degrees += spline.axis(k).degree();
    }
    const double size = std::max(static_cast<double>(equations), static_cast<double>(unknowns));
    return 16 * eps * degrees * std::sqrt(size);
}

void divide_by_root(std::vector<double> &x, const std::vector<double> &costs, size_t width) noexcept {
    for (size_t i = 0; i < costs.size() * width; ++i) {
        x[i] /= std::sqrt(costs[i / width]);
    }
}

double length_of(const std::vector<double> &x) noexcept {
    return norm_of(static_cast<int>(x.size()), [&x](int i) { return x[static_cast<size_t>(i)]; });
}

double largest_move(const std::vector<double> &moves, int dim) noexcept {
    double largest = 0;
    for (size_t i = 0; i < moves.size(); i += static_cast<size_t>(dim)) {
        largest = std::max(largest, norm(moves.data() + i, dim));
    }
    return largest;
}

std::vector<double> lengths(const std::vector<LocalEquations> &all) {
    std::vector<double> result;
    std::transform(all.begin(), all.end(), std::back_inserter(result),
                   [](const LocalEquations &local) { return local.length(); });
    return result;
}

} // namespace nrb::modify
