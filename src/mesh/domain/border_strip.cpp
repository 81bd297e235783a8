// SPDX-License-Identifier: MIT
#include "mesh/domain/border_strip.h"

#include "mesh/domain/pole_fins.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace nrb::mesh {

BorderStrip::BorderStrip(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                         const std::set<std::array<double, 2>> &extra, const std::array<double, 2> &density)
    : domain_(domain), cells_(cells), density_(density), places_(domain, index, cells, extra) {
    make_strip();
}

// Over the bounding box of all cells, with lengths by the largest speeds of the surface over them.
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
        part, std::array<double, 2>{tree.speed(0) * part.side(0), tree.speed(1) * part.side(1)},
        std::array<double, 2>{density_[0] * part.side(0), density_[1] * part.side(1)}, places_.points(),
        places_.walls());
}

// Other walls, on seams and kinks, may cross the border outside of the face, and do not count.
std::vector<int32_t> BorderStrip::crossed() const {
    std::vector<int32_t> result;
    for (const auto &[one, other] : strip_->crossings()) {
        const int32_t a = places_.wall(one).border, b = places_.wall(other).border;
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
        const Wall &wall = places_.wall(number);
        const auto &a = places_.point(wall.from), &b = places_.point(wall.to), &x = places_.point(point);
        const int32_t own = point_of_border(point);
        if (own >= 0 && (own == point_of_border(wall.from) || own == point_of_border(wall.to))) {
            continue; // an end of the segment, at which another curve ends, too
        }
        const size_t k = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1;
        result.emplace_back(wall.border, (x[k] - a[k]) / (b[k] - a[k]));
    }
    return result;
}

// Points of the border come first among the places, so that the first place of a vertex is one of them.
std::vector<std::array<int32_t, 2>> BorderStrip::united() const {
    std::vector<std::array<int32_t, 2>> result;
    const auto &border = domain_.border.points;
    for (size_t i = 0; i < border.size(); ++i) {
        const int32_t first = border[static_cast<size_t>(strip_->first(static_cast<int32_t>(i)))].point;
        if (first != border[i].point) {
            result.push_back({first, border[i].point});
        }
    }
    unite_at_poles(result);
    return result;
}

// Points at one pole are one in space, however far apart they are in the domain.
void BorderStrip::unite_at_poles(std::vector<std::array<int32_t, 2>> &united) const {
    std::map<int32_t, int32_t> first; // by poles
    for (const BorderPoint &own : domain_.border.points) {
        if (const int32_t pole = cells_.pole_at(own.param); pole >= 0) {
            const auto [known, fresh] = first.try_emplace(cells_.table().point_of(pole), own.point);
            if (known->second != own.point) {
                united.push_back({known->second, own.point});
            }
        }
    }
}

// Whether a segment is on a seam, where there may be segments in both directions.
bool BorderStrip::on_seam(const BorderSegment &segment) const noexcept {
    const auto &a = places_.point(segment.from), &b = places_.point(segment.to);
    bool result = false;
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        result =
            result || (domain_.closed[k] && a[k] == b[k] && (a[k] == ends.front() || a[k] == ends.back()));
    }
    return result;
}

// The scalar product of two steps in the domain, measured by its extents: positive if they run in the same
// direction, negative if they run in opposite ones.
double BorderStrip::along(const std::array<double, 2> &one,
                          const std::array<double, 2> &other) const noexcept {
    double sum = 0;
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        const double unit = ends.back() - ends.front();
        sum += one[k] / unit * (other[k] / unit);
    }
    return sum;
}

// Lengths of the sides of a triangle that are segments of the border: positive where the triangle is to the
// left of the border, as the inside is, negative where it is to the right.
double BorderStrip::left_of(const StripTriangle &triangle) const noexcept {
    const auto step = [](const std::array<double, 2> &a, const std::array<double, 2> &b) {
        return std::array<double, 2>{b[0] - a[0], b[1] - a[1]};
    };
    double left = 0;
    for (size_t k = 0; k < 3; ++k) {
        if (triangle.border[k] < 0) {
            continue;
        }
        const BorderSegment &segment = domain_.border.segments[static_cast<size_t>(triangle.border[k])];
        if (!on_seam(segment)) {
            const auto own = step(places_.point(triangle.corners[(k + 1) % 3]),
                                  places_.point(triangle.corners[(k + 2) % 3]));
            const double product = along(step(places_.point(segment.from), places_.point(segment.to)), own);
            left += std::copysign(std::sqrt(std::abs(product)), segment.backwards ? -product : product);
        }
    }
    return left;
}

// The largest triangle is tested, since others at the border may be as thin as the gap between segments and
// curves. A whole component may be as thin as that.
BorderStrip::Vote BorderStrip::vote_of(const Strip::Component &component) const {
    Vote vote;
    std::array<double, 2> middle{};
    for (const StripTriangle &triangle : component.triangles) {
        vote.left += left_of(triangle);
        const auto &a = places_.point(triangle.corners[0]), &b = places_.point(triangle.corners[1]),
                   &c = places_.point(triangle.corners[2]);
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
    const int32_t corner = places_.corner(point);
    return corner >= 0 ? sites.of_place(cells_.in_block(corner, cells_.tree().block(block)))
                       : sites.of_param(places_.point(point), block, point_of_border(point));
}

// The segments of the border decide, wherever the polylines lie relative to their curves. The middles of
// triangles decide only where there are no segments but those on seams.
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

// A triangle, with the sites of the block that it is in.
BorderStrip::Piece BorderStrip::piece_of(const StripTriangle &triangle, Sites &sites) const {
    std::array<double, 2> middle{};
    for (const int32_t corner : triangle.corners) {
        for (size_t k = 0; k < 2; ++k) {
            middle[k] += places_.point(corner)[k] / 3;
        }
    }
    const int32_t block = cells_.tree().block_at(middle);
    Piece piece{{}, triangle.border, triangle.fixed};
    for (size_t k = 0; k < 3; ++k) {
        piece.sites[k] = site_of(triangle.corners[k], block, sites);
    }
    return piece;
}

std::vector<BorderStrip::Piece> BorderStrip::triangles(Sites &sites,
                                                       std::vector<std::array<double, 2>> &divided) const {
    std::vector<Piece> result;
    const auto &components = strip_->components();
    std::vector<Vote> votes;
    votes.reserve(components.size());
    for (const Strip::Component &component : components) {
        votes.push_back(vote_of(component));
    }
    const std::vector<bool> inside = are_inside(votes);
    for (size_t i = 0; i < components.size(); ++i) {
        if (!votes[i].in_cell && inside[i]) {
            for (const StripTriangle &triangle : components[i].triangles) {
                result.push_back(piece_of(triangle, sites));
            }
        }
    }
    const auto is_pole = [](const std::array<bool, 2> &ends) { return ends[0] || ends[1]; };
    if (std::ranges::any_of(domain_.collapsed, is_pole)) {
        open_fins(cells_, sites, result, divided);
    }
    return result;
}

} // namespace nrb::mesh
