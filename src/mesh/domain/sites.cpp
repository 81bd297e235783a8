// SPDX-License-Identifier: MIT
#include "mesh/domain/sites.h"

#include "eval/evaluate.h"
#include "eval/frames/surface_frames.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Sites that are evaluated in one batch.
constexpr size_t most_at_once = 8192;

// Leaves no spare capacity where many values come at once, but some where they come one by one.
template <class T>
void resize(std::vector<T> &values, size_t n, const T &value = T{}) {
    if (n > values.size() + values.size() / 4) {
        values.reserve(n);
    }
    values.resize(n, value);
}

} // namespace

Sites::Sites(const MeshDomain &domain, const CellGrid &cells)
    : domain_(domain), cells_(cells), place_sites_(static_cast<size_t>(cells.table().count()), -1),
      place_points_(place_sites_.size(), -1) {
    static_cast<void>(take_border()); // there are no sites yet
    make_room();
}

int32_t Sites::add_point(int32_t border) {
    points_.push_back({border});
    return static_cast<int32_t>(points_.size()) - 1;
}

int32_t Sites::point_of_border(int32_t border) {
    const auto [known, fresh] = of_border_.try_emplace(border, point_count());
    return fresh ? add_point(border) : known->second;
}

bool Sites::take_border() {
    bool apart = true;
    for (const BorderPoint &point : domain_.border.points) {
        const bool fresh = border_points_.try_emplace(point.param, point.point).second;
        apart = apart && !(fresh && param_points_.contains(before_seams(point.param)));
    }
    return set_border_points() && apart;
}

// Where all of the domain is inside, every place becomes a site.
void Sites::make_room() {
    if (!domain_.inside) {
        sites_.reserve(place_sites_.size());
    }
}

// Returns whether the place has a point of the border then, not an own one.
bool Sites::set_point(int32_t place, int32_t border) {
    int32_t &own = place_points_[static_cast<size_t>(cells_.table().point_of(place))];
    own = own < 0 ? point_of_border(border) : own;
    return border_of(own) >= 0;
}

// Points of the border stand for the places of cells at which they are, and for poles. Returns whether no
// such place has an own point already.
bool Sites::set_border_points() {
    bool all = true;
    for (const auto &[param, point] : border_points_) {
        if (const int32_t pole = cells_.pole_at(param); pole >= 0) {
            all = set_point(pole, point) && all;
        }
    }
    for (int32_t i = 0; i < cells_.table().count() && !border_points_.empty(); ++i) {
        const auto found = border_points_.find(cells_.param(i));
        if (found != border_points_.end()) {
            all = set_point(i, found->second) && all;
        }
    }
    return all;
}

void Sites::renumber(const std::vector<int32_t> &places) {
    std::vector<int32_t> sites(static_cast<size_t>(cells_.table().count()), -1), points(sites.size(), -1);
    for (size_t i = 0; i < places.size(); ++i) {
        const auto at = static_cast<size_t>(places[i]);
        sites[at] = place_sites_[i];
        if (place_sites_[i] >= 0) {
            points[static_cast<size_t>(cells_.table().point_of(places[i]))] =
                sites_[static_cast<size_t>(place_sites_[i])].point;
        }
    }
    place_sites_ = std::move(sites);
    place_points_ = std::move(points);
    set_border_points();
    make_room();
}

int32_t Sites::of_place(int32_t place) {
    int32_t &site = place_sites_[static_cast<size_t>(place)];
    if (site < 0) {
        const auto lines = cells_.table().place(place).lines;
        int32_t &point = place_points_[static_cast<size_t>(cells_.table().point_of(place))];
        point = point < 0 ? add_point(-1) : point;
        Site made;
        for (size_t k = 0; k < 2; ++k) {
            const CellLine &line = cells_.tree().lines(k)[static_cast<size_t>(lines[k])];
            made.param[k] = line.t;
            made.from_left[k] = line.from_left;
        }
        made.point = point;
        site = static_cast<int32_t>(sites_.size());
        sites_.push_back(made);
    }
    return site;
}

// The copy of a place at the lower ends of closed axes.
std::array<double, 2> Sites::before_seams(std::array<double, 2> param) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = cells_.tree().block_ends(k);
        param[k] = domain_.closed[k] && param[k] == ends.back() ? ends.front() : param[k];
    }
    return param;
}

int32_t Sites::of_param(const std::array<double, 2> &param, int32_t number, int32_t border) {
    const auto [known, fresh] = param_sites_.try_emplace({param[0], param[1], static_cast<double>(number)},
                                                         static_cast<int32_t>(sites_.size()));
    if (!fresh) {
        return known->second;
    }
    const Rectangle block = cells_.tree().block(number);
    Site site{param, {}, border < 0 ? -1 : point_of_border(border)};
    for (size_t k = 0; k < 2; ++k) {
        site.from_left[k] = param[k] == block.upper[k];
    }
    if (const int32_t pole = border < 0 ? cells_.pole_at(param) : -1; pole >= 0) {
        int32_t &own = place_points_[static_cast<size_t>(cells_.table().point_of(pole))];
        own = own < 0 ? add_point(-1) : own;
        site.point = own;
    } else if (border < 0) {
        const auto [own, none] = param_points_.try_emplace(before_seams(param), point_count());
        site.point = none ? add_point(-1) : own->second;
    }
    sites_.push_back(site);
    return known->second;
}

void Sites::evaluate() {
    const size_t known = positions_.size();
    for (std::vector<Vector3> *all : {&positions_, &normals_}) {
        resize(*all, sites_.size());
    }
    for (size_t first = known; first < sites_.size(); first += most_at_once) {
        evaluate(first, std::min(first + most_at_once, sites_.size()));
    }
    for (size_t i = known; i < sites_.size(); ++i) {
        int32_t &first = points_[static_cast<size_t>(sites_[i].point)].site;
        first = first < 0 ? static_cast<int32_t>(i) : first;
    }
}

double Sites::way(int32_t from, int32_t to) const {
    const Site &a = (*this)[from], &b = (*this)[to];
    std::array<double, 2> middle{};
    eval::AxisRules rules{};
    for (size_t k = 0; k < 2; ++k) {
        middle[k] = a.param[k] / 2 + b.param[k] / 2;
        rules[k].left = a.from_left[k] && b.from_left[k];
    }
    Vector3 x{0, 0, 0};
    eval::evaluate_points(*domain_.surface, rules, 0, {middle.data(), 1, 2, 2, 1},
                          {&x.x, 1, domain_.surface->dim(), 3, 1});
    return length(x - position(from)) + length(position(to) - x);
}

// In groups of sites that are limits from the same side.
void Sites::evaluate(size_t first, size_t last) {
    std::array<std::vector<size_t>, 4> groups;
    for (size_t i = first; i < last; ++i) {
        groups[(sites_[i].from_left[0] ? 1U : 0U) + (sites_[i].from_left[1] ? 2U : 0U)].push_back(i);
    }
    for (unsigned group = 0; group < 4; ++group) {
        evaluate_group({(group & 1U) != 0, (group & 2U) != 0}, groups[group]);
    }
}

void Sites::evaluate_group(const std::array<bool, 2> &from_left, const std::vector<size_t> &members) {
    std::vector<double> params;
    params.reserve(2 * members.size());
    for (const size_t i : members) {
        params.insert(params.end(), sites_[i].param.begin(), sites_[i].param.end());
    }
    eval::AxisRules rules{};
    rules[0].left = from_left[0];
    rules[1].left = from_left[1];
    const auto n = static_cast<int64_t>(members.size());
    const ConstRecords at{params.data(), n, 2, 2, 1};
    std::vector<double> points(3 * members.size()), normals(points.size());
    const Spline &surface = *domain_.surface;
    if (surface.dim() == 3) {
        eval::surface_frames(surface, rules, at,
                             {{points.data(), n, 3, 3, 1}, {}, {}, {normals.data(), n, 3, 3, 1}, nullptr});
    } else {
        std::vector<double> jets(6 * members.size());
        eval::evaluate_points(surface, rules, 1, at, {jets.data(), n, 6, 6, 1});
        for (size_t i = 0; i < members.size(); ++i) {
            const double *jet = jets.data() + 6 * i;
            const double area = jet[2] * jet[5] - jet[3] * jet[4];
            points[3 * i] = jet[0];
            points[3 * i + 1] = jet[1];
            normals[3 * i + 2] = area > 0 ? 1 : area < 0 ? -1 : nan_value;
        }
    }
    for (size_t i = 0; i < members.size(); ++i) {
        positions_[members[i]] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
        normals_[members[i]] = {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
    }
}

} // namespace nrb::mesh
