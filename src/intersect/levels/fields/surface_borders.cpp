// SPDX-License-Identifier: MIT
#include "intersect/levels/fields/surface_borders.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t width = 4; // x, y, z, w

bool are_one(const double *a, const double *b, double near) noexcept {
    for (size_t c = 0; c < 3; ++c) {
        if (!(std::abs(a[c] - b[c]) <= near)) {
            return false;
        }
    }
    return true;
}

} // namespace

SurfaceBorders::SurfaceBorders(const pieces::PieceGrid &grid) : grid_(grid) {
    const double near = 4 * (grid.moved() + 8 * eps * grid.radius());
    for (size_t axis = 0; axis < 2; ++axis) {
        const std::array<std::vector<double>, 2> sides{side(axis, false), side(axis, true)};
        bool closed = true;
        for (size_t i = 0; i < sides[0].size(); i += width) {
            const double *a = sides[0].data() + i, *b = sides[1].data() + i;
            closed = closed && are_one(a, b, near) && std::abs(a[3] - b[3]) <= 64 * eps * std::abs(a[3]);
            for (size_t end = 0; end < 2; ++end) {
                collapsed_[axis][end] =
                    (i == 0 || collapsed_[axis][end]) && are_one(&sides[end][i], sides[end].data(), near);
            }
        }
        closed_[axis] = closed && !grid.periodic(static_cast<int>(axis));
    }
}

std::vector<double> SurfaceBorders::side(size_t axis, bool up) const {
    const auto lanes = static_cast<size_t>(grid_.shape().lanes);
    std::vector<double> work(static_cast<size_t>(grid_.shape().values())), patch(work.size()), points;
    std::array<size_t, 2> sizes{1, 1};
    for (int k = 0; k < grid_.shape().axes; ++k) {
        sizes[static_cast<size_t>(grid_.spline_axis(k))] = static_cast<size_t>(grid_.shape().degree(k)) + 1;
    }
    const size_t other = 1 - axis;
    pieces::PieceGrid::Index index{};
    index[axis] = up ? grid_.count(static_cast<int>(axis)) - 1 : 0;
    for (; index[other] < grid_.count(static_cast<int>(other)); ++index[other]) {
        grid_.patch(grid_.piece(index), work.data(), patch.data());
        for (size_t j = 0; j < sizes[other]; ++j) {
            const size_t fixed = up ? sizes[axis] - 1 : 0,
                         i = axis == 0 ? fixed * sizes[1] + j : j * sizes[1] + fixed;
            const double *record = patch.data() + i * lanes;
            for (size_t c = 0; c < 3; ++c) {
                points.push_back(record[c] / record[3]);
            }
            points.push_back(record[3]);
        }
    }
    return points;
}

double SurfaceBorders::period(size_t axis) const noexcept {
    const int k = static_cast<int>(axis);
    return grid_.break_at(k, grid_.count(k)) - grid_.break_at(k, 0);
}

bool SurfaceBorders::is_end(const std::array<double, 2> &at) const noexcept {
    for (size_t axis = 0; axis < 2; ++axis) {
        const int k = static_cast<int>(axis);
        const int64_t i = grid_.find(k, at[axis]);
        if ((at[axis] == grid_.break_at(k, i) && !goes_on(axis, i, false)) ||
            (at[axis] == grid_.break_at(k, i + 1) && !goes_on(axis, i, true))) {
            return true;
        }
    }
    return false;
}

} // namespace nrb::intersect
