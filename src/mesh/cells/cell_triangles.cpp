// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_triangles.h"

#include <cmath>

namespace nrb::mesh {

namespace {

enum : unsigned { on_left = 1, on_right = 2, on_bottom = 4, on_top = 8 };

} // namespace

void CellTriangles::make_two(const Cell &cell, const std::vector<int32_t> &border,
                             std::vector<std::array<int32_t, 3>> &out) const {
    const Hessian height = cell.box.of(2);
    if (std::abs(height.along(1, 1)) <= std::abs(height.along(1, -1))) {
        out.push_back({border[0], border[1], border[2]});
        out.push_back({border[0], border[2], border[3]});
    } else {
        out.push_back({border[0], border[1], border[3]});
        out.push_back({border[1], border[2], border[3]});
    }
}

void CellTriangles::set_stops(const PlaceTable &table, const Cell &cell, const std::vector<int32_t> &border) {
    const Rectangle part = tree_.rectangle(cell);
    stops_.clear();
    for (const int32_t place : border) {
        const auto [u, v] = table.place(place).lines;
        const unsigned sides = (u == cell.lower[0] ? on_left : 0U) | (u == cell.upper[0] ? on_right : 0U) |
                               (v == cell.lower[1] ? on_bottom : 0U) | (v == cell.upper[1] ? on_top : 0U);
        stops_.push_back({place, sides,
                          (tree_.lines(0)[static_cast<size_t>(u)].t - part.lower[0]) / part.side(0),
                          (tree_.lines(1)[static_cast<size_t>(v)].t - part.lower[1]) / part.side(1)});
    }
}

// Whether the others lie on one side.
bool CellTriangles::flat_without(size_t i) const noexcept {
    unsigned sides = ~0U;
    for (size_t k = 0; k < stops_.size(); ++k) {
        sides &= k == i ? ~0U : stops_[k].sides;
    }
    return sides != 0;
}

bool CellTriangles::is_ear(size_t i) const noexcept {
    const size_t n = stops_.size();
    const unsigned common = stops_[(i + n - 1) % n].sides & stops_[i].sides & stops_[(i + 1) % n].sides;
    return common == 0 && (n == 3 || !flat_without(i));
}

void CellTriangles::make(const PlaceTable &table, const Cell &cell, const std::vector<int32_t> &border,
                         std::vector<std::array<int32_t, 3>> &out) {
    if (border.size() == 4) {
        return make_two(cell, border, out);
    }
    set_stops(table, cell, border);
    const Hessian height = cell.box.of(2), along = cell.box.of(0), across = cell.box.of(1);
    while (stops_.size() >= 3) {
        const size_t n = stops_.size();
        size_t best = 0;
        double least = infinity;
        for (size_t i = 0; i < n; ++i) {
            if (!is_ear(i)) {
                continue;
            }
            const Stop &a = stops_[(i + n - 1) % n], &b = stops_[(i + 1) % n];
            const double u = b.u - a.u, v = b.v - a.v;
            const double bend = std::abs(height.along(u, v)) + height.beside(u, v) +
                                (std::abs(along.along(u, v)) + std::abs(across.along(u, v))) / 16;
            if (bend < least || least == infinity) {
                least = bend;
                best = i;
            }
        }
        out.push_back({stops_[(best + n - 1) % n].place, stops_[best].place, stops_[(best + 1) % n].place});
        stops_.erase(stops_.begin() + static_cast<int64_t>(best));
        if (stops_.size() < 3) {
            break;
        }
    }
}

} // namespace nrb::mesh
