// SPDX-License-Identifier: MIT
#include "mesh/domain/border_strip.h"

#include "mesh/domain/pole_fins.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace nrb::mesh {

BorderStrip::BorderStrip(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                         const std::vector<std::array<double, 2>> &extra)
    : domain_(domain), index_(index), cells_(cells) {
    add_border();
    look_at_cells();
    add_places();
    for (const auto &param : extra) {
        add_point(param, -1);
    }
    add_walls();
    make_strip();
}

void BorderStrip::add_point(const std::array<double, 2> &param, int32_t place) {
    const auto [at, fresh] = of_param_.try_emplace(param, static_cast<int32_t>(points_.size()));
    if (fresh) {
        points_.push_back(param);
        places_.push_back(place);
    }
}

// All of it, in its order.
void BorderStrip::add_border() {
    for (const BorderPoint &point : domain_.border.points) {
        of_param_.try_emplace(point.param, static_cast<int32_t>(points_.size()));
        points_.push_back(point.param);
        places_.push_back(-1);
    }
}

void BorderStrip::look_at_cells() {
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

// Whether a corner of cells is inside, or at an end of the domain, and not near the border.
bool BorderStrip::is_wanted(int32_t place) const {
    const std::array<double, 2> param = cells_.param(place);
    const auto &sides = sides_[static_cast<size_t>(place)];
    Rectangle near{param, param};
    for (size_t k = 0; k < 2; ++k) {
        near.lower[k] -= near_border * sides[k];
        near.upper[k] += near_border * sides[k];
    }
    if (cells_.is_crossing(place)) { // two kinks: without it one of the lines would have no wall
        return domain_.inside({param[0], param[1]});
    }
    return !index_.any_in(near) && (cells_.is_at_end(place) || domain_.inside({param[0], param[1]}));
}

// Corners of cells that the border cuts, and what cells inside share with these. Both sides of a seam or a kink have the same places.
void BorderStrip::add_places() {
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
            const bool of_line = cells_.ends_line(place); // without it the line would end before it
            if (kept[point] || !dropped[point] || of_line) {
                add_point(cells_.param(place), place);
            }
        }
    }
}

// The border; what cells inside end at; seams, and lines at which the surface may have a kink.
void BorderStrip::add_walls() {
    for (size_t i = 0; i < domain_.border.segments.size(); ++i) {
        const BorderSegment &segment = domain_.border.segments[i];
        walls_.push_back({segment.from, segment.to, static_cast<int32_t>(i)});
    }
    const size_t first = walls_.size();
    add_staircase();
    const std::set<Step> steps = steps_on_seams(first);
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

bool BorderStrip::is_shared(int32_t place) const {
    return shared_[static_cast<size_t>(cells_.table().point_of(place))];
}

int32_t BorderStrip::point_at(int32_t place) const {
    const auto found = of_param_.find(cells_.param(place));
    return found == of_param_.end() ? -1 : found->second;
}

// Sides that a cell inside and one at the border have in opposite directions; both sides of a kink are one line of the plane.
void BorderStrip::add_staircase() {
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

// Sides of cells inside, from the wall on, that are on a seam: the axis and where they begin and end on it.
std::set<BorderStrip::Step> BorderStrip::steps_on_seams(size_t first) const {
    std::set<Step> result;
    for (size_t i = first; i < walls_.size(); ++i) {
        const auto &a = points_[static_cast<size_t>(walls_[i].from)],
                   &b = points_[static_cast<size_t>(walls_[i].to)];
        for (size_t k = 0; k < 2; ++k) {
            if (domain_.closed[k] && a[k] == b[k]) {
                result.insert(
                    {static_cast<double>(k), std::min(a[1 - k], b[1 - k]), std::max(a[1 - k], b[1 - k])});
            }
        }
    }
    return result;
}

// A seam can be divided where no cell is on either side.
void BorderStrip::add_line_walls(size_t k, double t, bool passable, const std::set<Step> &steps) {
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

// Over all cells, with lengths as the largest of these have them.
void BorderStrip::make_strip() {
    const CellTree &tree = cells_.tree();
    Rectangle part = tree.rectangle(tree.cells().front());
    for (const Cell &cell : tree.cells()) {
        const Rectangle own = tree.rectangle(cell);
        for (size_t k = 0; k < 2; ++k) {
            part.lower[k] = std::min(part.lower[k], own.lower[k]);
            part.upper[k] = std::max(part.upper[k], own.upper[k]);
        }
    }
    strip_ = std::make_unique<const Strip>(
        part, std::array<double, 2>{tree.speed(0) * part.side(0), tree.speed(1) * part.side(1)}, points_, walls_);
}

// Lines may cross the border outside of the face.
std::vector<int32_t> BorderStrip::crossed() const {
    std::vector<int32_t> result;
    for (const auto &[one, other] : strip_->crossings()) {
        const int32_t a = walls_[static_cast<size_t>(one)].border,
                      b = walls_[static_cast<size_t>(other)].border;
        if (a >= 0) {
            result.push_back(a);
            if (b >= 0) {
                result.push_back(b);
            }
        }
    }
    return result;
}

int32_t BorderStrip::point_of_border(int32_t point) const noexcept {
    const auto &border = domain_.border.points;
    return static_cast<size_t>(point) < border.size() ? border[static_cast<size_t>(point)].point : -1;
}

std::vector<std::pair<int32_t, double>> BorderStrip::touched() const {
    std::vector<std::pair<int32_t, double>> result;
    for (const auto &[number, point] : strip_->touches()) {
        const Wall &wall = walls_[static_cast<size_t>(number)];
        const auto &a = points_[static_cast<size_t>(wall.from)], &b = points_[static_cast<size_t>(wall.to)],
                   &x = points_[static_cast<size_t>(point)];
        const int32_t own = point_of_border(point);
        if (own >= 0 && (own == point_of_border(wall.from) || own == point_of_border(wall.to))) {
            continue; // an end, of another curve
        }
        const size_t k = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1;
        result.emplace_back(wall.border, (x[k] - a[k]) / (b[k] - a[k]));
    }
    return result;
}

// Points of the border come first.
std::vector<std::array<int32_t, 2>> BorderStrip::united() const {
    std::vector<std::array<int32_t, 2>> result;
    const auto &border = domain_.border.points;
    for (size_t i = 0; i < border.size(); ++i) {
        const int32_t first = border[static_cast<size_t>(strip_->first(static_cast<int32_t>(i)))].point;
        if (first != border[i].point) {
            result.push_back({first, border[i].point});
        }
    }
    return result;
}

// On a seam there may be segments both ways.
bool BorderStrip::on_seam(const BorderSegment &segment) const noexcept {
    const auto &a = domain_.border.points[static_cast<size_t>(segment.from)].param,
               &b = domain_.border.points[static_cast<size_t>(segment.to)].param;
    bool result = false;
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        result =
            result || (domain_.closed[k] && a[k] == b[k] && (a[k] == ends.front() || a[k] == ends.back()));
    }
    return result;
}

// The inside is to the left of the border.
double BorderStrip::left_of(const StripTriangle &triangle) const noexcept {
    double left = 0;
    for (size_t k = 0; k < 3; ++k) {
        if (triangle.border[k] < 0) {
            continue;
        }
        const BorderSegment &segment = domain_.border.segments[static_cast<size_t>(triangle.border[k])];
        if (on_seam(segment)) {
            continue;
        }
        const auto &a = domain_.border.points[static_cast<size_t>(segment.from)].param,
                   &b = domain_.border.points[static_cast<size_t>(segment.to)].param,
                   &from = points_[static_cast<size_t>(triangle.corners[(k + 1) % 3])],
                   &to = points_[static_cast<size_t>(triangle.corners[(k + 2) % 3])];
        double along = 0;
        for (size_t c = 0; c < 2; ++c) {
            const auto &ends = cells_.tree().block_ends(c);
            const double unit = ends.back() - ends.front();
            along += (b[c] - a[c]) / unit * ((to[c] - from[c]) / unit);
        }
        left += std::copysign(std::sqrt(std::abs(along)), segment.backwards ? -along : along);
    }
    return left;
}

// Triangles along the border may be as thin as what is between curves and segments, and so may a whole component be.
BorderStrip::Vote BorderStrip::vote_of(const Strip::Component &component) const {
    Vote vote;
    std::array<double, 2> middle{};
    for (const StripTriangle &triangle : component.triangles) {
        vote.left += left_of(triangle);
        const auto &a = points_[static_cast<size_t>(triangle.corners[0])],
                   &b = points_[static_cast<size_t>(triangle.corners[1])],
                   &c = points_[static_cast<size_t>(triangle.corners[2])];
        const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (area > vote.inside) {
            vote.inside = area;
            middle = {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
        }
    }
    cells_.tree().for_each_in({middle, middle}, [&](int32_t number) {
        const Cell &cell = cells_.tree().cells()[static_cast<size_t>(number)];
        vote.in_cell = vote.in_cell || cell.side == Side::inside;
    });
    if (!vote.in_cell && !domain_.inside({middle[0], middle[1]})) {
        vote.inside = -vote.inside;
    }
    return vote;
}

int32_t BorderStrip::site_of(int32_t point, int32_t block, Sites &sites) const {
    const auto at = static_cast<size_t>(point);
    if (places_[at] >= 0) {
        return sites.of_place(cells_.in_block(places_[at], cells_.tree().block(block)));
    }
    const bool of_border = at < domain_.border.points.size();
    return sites.of_param(points_[at], block, of_border ? domain_.border.points[at].point : -1);
}

// Segments know it, wherever polylines are in relation to their curves; middles of triangles where there is none but on seams.
std::vector<bool> BorderStrip::are_inside(const std::vector<Vote> &votes) const {
    const auto &components = strip_->components();
    std::vector<Vote> sums(components.size()); // of groups
    for (size_t i = 0; i < components.size(); ++i) {
        Vote &sum = sums[static_cast<size_t>(components[i].group)];
        sum.left += components[i].side * votes[i].left;
        sum.inside += components[i].side * votes[i].inside;
    }
    std::vector<bool> result;
    for (const Strip::Component &component : components) {
        const Vote &sum = sums[static_cast<size_t>(component.group)];
        result.push_back(component.side * (sum.left != 0 ? sum.left : sum.inside) > 0);
    }
    return result;
}

std::vector<BorderStrip::Piece> BorderStrip::triangles(Sites &sites) const {
    std::vector<Piece> result;
    const auto &components = strip_->components();
    std::vector<Vote> votes;
    votes.reserve(components.size());
    for (const Strip::Component &component : components) {
        votes.push_back(vote_of(component));
    }
    const std::vector<bool> inside = are_inside(votes);
    for (size_t i = 0; i < components.size(); ++i) {
        if (votes[i].in_cell || !inside[i]) {
            continue;
        }
        for (const StripTriangle &triangle : components[i].triangles) {
            std::array<double, 2> middle{};
            for (const int32_t corner : triangle.corners) {
                for (size_t k = 0; k < 2; ++k) {
                    middle[k] += points_[static_cast<size_t>(corner)][k] / 3;
                }
            }
            const int32_t block = cells_.tree().block_at(middle);
            Piece piece{{}, triangle.border, triangle.fixed};
            for (size_t k = 0; k < 3; ++k) {
                piece.sites[k] = site_of(triangle.corners[k], block, sites);
            }
            result.push_back(piece);
        }
    }
    const auto is_pole = [](const std::array<bool, 2> &ends) { return ends[0] || ends[1]; };
    if (std::ranges::any_of(domain_.collapsed, is_pole)) {
        open_fins(sites, result);
    }
    return result;
}

} // namespace nrb::mesh
