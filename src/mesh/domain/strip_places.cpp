// SPDX-License-Identifier: MIT
#include "mesh/domain/strip_places.h"

#include <algorithm>

namespace nrb::mesh {

StripPlaces::StripPlaces(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                         const std::set<std::array<double, 2>> &extra)
    : domain_(domain), index_(index), cells_(cells) {
    add_border();
    look_at_cells();
    add_places();
    for (const auto &param : extra) {
        add_point(cells.at_lines(param), -1); // lines may have been added since
    }
    add_walls();
}

void StripPlaces::add_point(const std::array<double, 2> &param, int32_t place) {
    const auto [at, fresh] = of_param_.try_emplace(param, static_cast<int32_t>(points_.size()));
    if (fresh) {
        points_.push_back(param);
        corners_.push_back(place);
    }
}

// Adds all points of the border in their order, several at one place among them.
void StripPlaces::add_border() {
    for (const BorderPoint &point : domain_.border.points) {
        of_param_.try_emplace(point.param, static_cast<int32_t>(points_.size()));
        points_.push_back(point.param);
        corners_.push_back(-1);
    }
}

void StripPlaces::look_at_cells() {
    needed_.assign(static_cast<size_t>(cells_.table().count()), false);
    touched_.assign(needed_.size(), false);
    sides_.assign(needed_.size(), {infinity, infinity});
    std::vector<int32_t> border;
    for (const Cell &cell : cells_.tree().cells()) {
        if (cell.side == Side::outside) {
            continue;
        }
        cells_.table().border(cell, border);
        const Rectangle part = cells_.tree().rectangle(cell);
        for (const int32_t place : border) {
            const auto at = static_cast<size_t>(place);
            if (cell.side == Side::inside) {
                needed_[at] = true;
            } else {
                touched_[at] = true;
                sides_[at] = {std::min(sides_[at][0], part.side(0)), std::min(sides_[at][1], part.side(1))};
            }
        }
    }
}

// Whether a corner of cells is inside or at an end of the domain, and not near the border.
bool StripPlaces::is_wanted(int32_t place) const {
    const std::array<double, 2> param = cells_.param(place);
    const auto &sides = sides_[static_cast<size_t>(place)];
    Rectangle near{param, param};
    for (size_t k = 0; k < 2; ++k) {
        near.lower[k] -= near_border * sides[k];
        near.upper[k] += near_border * sides[k];
    }
    if (cells_.is_crossing(place)) { // of two kinks: without it one of the lines would have no wall
        return domain_.inside({param[0], param[1]});
    }
    return !index_.any_in(near) && (cells_.is_at_end(place) || domain_.inside({param[0], param[1]}));
}

// Adds the corners of cells at the border, except those that are outside or too near to the border; corners
// that cells inside share are always added. Both sides of a seam or a kink get the same places.
void StripPlaces::add_places() {
    const PlaceTable &table = cells_.table();
    std::vector<bool> kept(needed_.size(), false), dropped(needed_.size(), false);
    for (int32_t place = 0; place < table.count(); ++place) {
        const auto at = static_cast<size_t>(place), point = static_cast<size_t>(table.point_of(place));
        kept[point] = kept[point] || needed_[at];
        dropped[point] = dropped[point] || (touched_[at] && !needed_[at] && !is_wanted(place));
    }
    shared_.assign(needed_.size(), false);
    for (int32_t place = 0; place < table.count(); ++place) {
        const auto point = static_cast<size_t>(table.point_of(place));
        if (touched_[static_cast<size_t>(place)]) {
            shared_[point] = true;
            const bool of_line = cells_.ends_line(place); // without it the line would end before this place
            if (kept[point] || !dropped[point] || of_line) {
                add_point(cells_.param(place), place);
            }
        }
    }
}

// Walls are the segments of the border, the sides at which cells inside meet the strip, seams, and lines at
// which the surface may have a kink.
void StripPlaces::add_walls() {
    for (size_t i = 0; i < domain_.border.segments.size(); ++i) {
        const BorderSegment &segment = domain_.border.segments[i];
        walls_.push_back({segment.from, segment.to, static_cast<int32_t>(i)});
    }
    add_staircase();
    const std::set<Step> steps = steps_on_seams();
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        for (size_t i = 0; i < ends.size(); ++i) {
            const bool inner = i > 0 && i + 1 < ends.size();
            if (inner || domain_.closed[k]) {
                add_line_walls(k, ends[i], inner, steps);
            }
        }
    }
}

bool StripPlaces::is_shared(int32_t place) const {
    return shared_[static_cast<size_t>(cells_.table().point_of(place))];
}

int32_t StripPlaces::point_at(int32_t place) const {
    const auto found = of_param_.find(cells_.param(place));
    return found == of_param_.end() ? -1 : found->second;
}

// Adds the sides at which cells inside meet the strip, a staircase: those that a cell inside and one at the
// border have in opposite directions. Sides are compared by places of the domain, so that the two lines of a
// kink are one.
void StripPlaces::add_staircase() {
    using Ends = std::pair<int32_t, int32_t>;
    std::vector<Ends> of_inside;
    std::set<Ends> of_border;
    std::vector<int32_t> border;
    for (const Cell &cell : cells_.tree().cells()) {
        if (cell.side == Side::outside) {
            continue;
        }
        cells_.table().border(cell, border);
        for (size_t i = 0; i < border.size(); ++i) {
            const int32_t a = border[i], b = border[(i + 1) % border.size()];
            if (!is_shared(a) || !is_shared(b)) {
                continue;
            }
            if (cell.side == Side::border) {
                of_border.insert({point_at(b), point_at(a)});
            } else {
                of_inside.emplace_back(point_at(a), point_at(b));
            }
        }
    }
    for (const Ends &step : of_inside) {
        if (step.first >= 0 && step.second >= 0 && of_border.contains(step)) {
            walls_.push_back({step.first, step.second});
        }
    }
}

// Sides of cells inside that lie on a seam, at either end of the domain.
std::set<StripPlaces::Step> StripPlaces::steps_on_seams() const {
    std::set<Step> result;
    std::vector<int32_t> border;
    for (const Cell &cell : cells_.tree().cells()) {
        if (cell.side != Side::inside || !touches_seam(cells_.tree().rectangle(cell))) {
            continue;
        }
        cells_.table().border(cell, border);
        for (size_t i = 0; i < border.size(); ++i) {
            const auto a = cells_.param(border[i]), b = cells_.param(border[(i + 1) % border.size()]);
            for (size_t k = 0; k < 2; ++k) {
                if (a[k] == b[k] && is_on_seam(k, a[k])) {
                    result.insert(
                        {static_cast<double>(k), std::min(a[1 - k], b[1 - k]), std::max(a[1 - k], b[1 - k])});
                }
            }
        }
    }
    return result;
}

bool StripPlaces::is_on_seam(size_t k, double t) const noexcept {
    const auto &ends = cells_.tree().block_ends(k);
    return domain_.closed[k] && (t == ends.front() || t == ends.back());
}

bool StripPlaces::touches_seam(const Rectangle &part) const noexcept {
    return is_on_seam(0, part.lower[0]) || is_on_seam(0, part.upper[0]) || is_on_seam(1, part.lower[1]) ||
           is_on_seam(1, part.upper[1]);
}

// Adds walls between neighbouring places on a line. A side on a seam may be divided unless it is a side of a
// cell inside, at either end of the domain.
void StripPlaces::add_line_walls(size_t k, double t, bool passable, const std::set<Step> &steps) {
    std::vector<std::pair<double, int32_t>> on;
    for (size_t i = 0; i < points_.size(); ++i) {
        if (points_[i][k] == t) {
            on.emplace_back(points_[i][1 - k], static_cast<int32_t>(i));
        }
    }
    std::ranges::sort(on);
    for (size_t i = 0; i + 1 < on.size(); ++i) {
        const bool divisible =
            passable || !steps.contains({static_cast<double>(k), on[i].first, on[i + 1].first});
        walls_.push_back({on[i].second, on[i + 1].second, -1, passable, divisible});
    }
}

} // namespace nrb::mesh
