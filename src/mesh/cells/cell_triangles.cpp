// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_triangles.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

enum : unsigned { on_left = 1, on_right = 2, on_bottom = 4, on_top = 8 };

constexpr size_t most_stops = 48;
constexpr int64_t work_of_a_stop = 16;

// The numbers of stops on each side of the cell.
class SideCounts {
public:
    template <typename Stops>
    explicit SideCounts(const Stops &stops) : all_(stops.size()) {
        for (const auto &stop : stops) {
            for (size_t k = 0; k < 4; ++k) {
                counts_[k] += stop.sides >> k & 1U;
            }
        }
    }
    // Whether, without a stop on these sides, all others lie on one side.
    [[nodiscard]] bool flat_without(unsigned sides) const noexcept {
        bool flat = false;
        for (size_t k = 0; k < 4; ++k) {
            flat = flat || counts_[k] - (sides >> k & 1U) == all_ - 1;
        }
        return flat;
    }
    [[nodiscard]] unsigned fullest() const noexcept {
        return 1U << static_cast<unsigned>(std::ranges::max_element(counts_) - counts_.begin());
    }

private:
    size_t all_;
    std::array<size_t, 4> counts_{};
};

// Rotates the stops such that those on a side, which are consecutive around the cell, come first.
template <typename Stops>
void rotate_to_start(Stops &stops, unsigned side) {
    const auto off = std::ranges::find_if(stops, [&](const auto &stop) { return (stop.sides & side) == 0; });
    std::rotate(stops.begin(), off, stops.end());
    const auto on = std::ranges::find_if(stops, [&](const auto &stop) { return (stop.sides & side) != 0; });
    std::rotate(stops.begin(), on, stops.end());
}

// Of the stops that are not on this side, the one nearest to the middle stop as measured along this side.
template <typename Stops>
size_t opposite_of(const Stops &stops, unsigned side, size_t middle) {
    const auto along = [&](const auto &stop) { return (side & (on_left | on_right)) != 0 ? stop.v : stop.u; };
    size_t best = 0;
    double least = infinity;
    for (size_t i = middle; i < stops.size(); ++i) {
        const double distance = std::abs(along(stops[i]) - along(stops[middle]));
        if ((stops[i].sides & side) == 0 && distance < least) {
            best = i;
            least = distance;
        }
    }
    return best;
}

} // namespace

void CellTriangles::make_two(const Cell &cell, const std::vector<int32_t> &border,
                             std::vector<std::array<int32_t, 3>> &out) {
    if (std::abs(cell.bends.along(2, 1, 1)) <= std::abs(cell.bends.along(2, 1, -1))) {
        out.push_back({border[0], border[1], border[2]});
        out.push_back({border[0], border[2], border[3]});
    } else {
        out.push_back({border[0], border[1], border[3]});
        out.push_back({border[1], border[2], border[3]});
    }
}

CellTriangles::Stops CellTriangles::stops_of(const PlaceTable &table, const Cell &cell,
                                             const std::vector<int32_t> &border) const {
    const Rectangle part = tree_.rectangle(cell);
    Stops stops;
    for (const int32_t place : border) {
        const auto [u, v] = table.place(place).lines;
        const unsigned sides = (u == cell.lower[0] ? on_left : 0U) | (u == cell.upper[0] ? on_right : 0U) |
                               (v == cell.lower[1] ? on_bottom : 0U) | (v == cell.upper[1] ? on_top : 0U);
        stops.push_back({place, sides,
                         (tree_.lines(0)[static_cast<size_t>(u)].t - part.lower[0]) / part.side(0),
                         (tree_.lines(1)[static_cast<size_t>(v)].t - part.lower[1]) / part.side(1)});
    }
    return stops;
}

// The ear over whose cut the surface bends least.
size_t CellTriangles::best_ear(const Stops &stops, const Cell &cell) {
    const size_t n = stops.size();
    const SideCounts counts(stops);
    size_t best = 0;
    double least = infinity;
    for (size_t i = 0; i < n; ++i) {
        const Stop &a = stops[i == 0 ? n - 1 : i - 1], &b = stops[i + 1 == n ? 0 : i + 1];
        if ((a.sides & stops[i].sides & b.sides) != 0 || (n > 3 && counts.flat_without(stops[i].sides))) {
            continue;
        }
        const double u = b.u - a.u, v = b.v - a.v;
        const double bend = std::abs(cell.bends.along(2, u, v)) +
                            (std::abs(cell.bends.along(0, u, v)) + std::abs(cell.bends.along(1, u, v))) / 16;
        if (bend < least || least == infinity) {
            least = bend;
            best = i;
        }
    }
    return best;
}

void CellTriangles::cut_ears(Stops stops, const Cell &cell, std::vector<std::array<int32_t, 3>> &out) {
    while (stops.size() >= 3) {
        const size_t n = stops.size(), i = best_ear(stops, cell);
        count_work(work_of_a_stop * static_cast<int64_t>(n));
        out.push_back({stops[(i + n - 1) % n].place, stops[i].place, stops[(i + 1) % n].place});
        stops.erase(stops.begin() + static_cast<int64_t>(i));
    }
}

// Cuts many stops in two, from the middle one of the side with most stops to the opposite one: both parts
// have an eighth of the stops or more.
void CellTriangles::make_in_parts(Stops stops, const Cell &cell, std::vector<std::array<int32_t, 3>> &out) {
    if (stops.size() <= most_stops) {
        return cut_ears(std::move(stops), cell, out);
    }
    const unsigned side = SideCounts(stops).fullest();
    rotate_to_start(stops, side);
    const auto on_side = static_cast<size_t>(
        std::ranges::count_if(stops, [&](const Stop &stop) { return (stop.sides & side) != 0; }));
    const size_t middle = on_side / 2, opposite = opposite_of(stops, side, middle);
    Stops rest(stops.begin() + static_cast<int64_t>(opposite), stops.end());
    rest.insert(rest.end(), stops.begin(), stops.begin() + static_cast<int64_t>(middle) + 1);
    stops.erase(stops.begin() + static_cast<int64_t>(opposite) + 1, stops.end());
    stops.erase(stops.begin(), stops.begin() + static_cast<int64_t>(middle));
    make_in_parts(std::move(stops), cell, out);
    make_in_parts(std::move(rest), cell, out);
}

// A pole is a side of the cell in the domain, but one point in space, so that it lies on the sides beside it as well:
// with two places on one of these it would make a triangle without a width. Cuts off all stops at it but one; the
// triangles have two corners there.
void CellTriangles::cut_poles(const PlaceTable &table, Stops &stops,
                              std::vector<std::array<int32_t, 3>> &out) {
    for (size_t i = 0; i < stops.size() && stops.size() > 3;) {
        const size_t next = (i + 1) % stops.size();
        if (table.point_of(stops[i].place) != table.point_of(stops[next].place)) {
            ++i;
            continue;
        }
        out.push_back({stops[i].place, stops[next].place, stops[(i + 2) % stops.size()].place});
        stops[i].sides |= stops[next].sides;
        stops.erase(stops.begin() + static_cast<int64_t>(next));
        i -= next < i ? 1 : 0;
    }
}

void CellTriangles::make(const PlaceTable &table, const Cell &cell, const std::vector<int32_t> &border,
                         std::vector<std::array<int32_t, 3>> &out) {
    if (border.size() == 4) {
        return make_two(cell, border, out);
    }
    Stops stops = stops_of(table, cell, border);
    cut_poles(table, stops, out);
    make_in_parts(std::move(stops), cell, out);
}

} // namespace nrb::mesh
