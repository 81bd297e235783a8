// SPDX-License-Identifier: MIT
#include "mesh/domain_mesh.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "eval/frames/surface_frames.h"
#include "mesh/border/segment_index.h"
#include "mesh/cells/cell_triangles.h"
#include "mesh/cells/piece_bound.h"
#include "mesh/proof/mesh_bound.h"
#include "mesh/strip/strip.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

namespace nrb::mesh {

namespace {

// What is left for the differences of an estimate and a proof.
constexpr double share_of_estimate = 0.97;
constexpr int most_rounds = 16;
// Triangles of the strip over more pieces are bounded by the cells that they meet.
constexpr int64_t most_pieces = 64;
// Places nearer to the border than this share of a cell are left out, and cells that it comes nearer to are no cells inside.
constexpr double near_border = 0.2;

// A place in a block: what a vertex is made for.
struct Site {
    std::array<double, 2> param;
    std::array<bool, 2> from_left{};
    int32_t point = -1;
};

struct Triangle {
    std::array<int32_t, 3> sites;
    int32_t cell = -1; // -1: of the strip
    std::array<int32_t, 3> border{-1, -1, -1};
    std::array<bool, 3> fixed{};
};

// Of a triangle: parameters of the corners, and segments of the border.
using BoundKey = std::array<double, 9>;
struct BoundHash {
    size_t operator()(const BoundKey &key) const noexcept {
        uint64_t hash = 0x9e3779b97f4a7c15U;
        for (const double x : key) {
            hash = (hash ^ std::bit_cast<uint64_t>(x)) * 0xff51afd7ed558ccdU;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

class DomainMesher {
public:
    DomainMesher(const MeshDomain &domain, const MeshRule &rule)
        : domain_(domain), rule_(rule), surface_(*domain.surface), grid_(pieces::piece_grid_of(surface_)),
          index_(domain.border), nets_(grid_), by_pieces_(surface_, nets_), tree_(grid_, cell_rule()) {}

    DomainMesh run();

private:
    [[nodiscard]] CellRule cell_rule() const;
    [[nodiscard]] Side side_of(const Rectangle &part) const;
    [[nodiscard]] Rectangle around(const Rectangle &part) const noexcept;
    void make_tables();
    void make_cells();
    void make_strip();
    void add_strip_points();
    [[nodiscard]] bool is_wanted(int32_t place, const std::array<double, 2> &sides) const;
    void add_walls();
    void add_line_walls(size_t k, double t, bool passable);
    [[nodiscard]] bool is_kept(const Strip::Component &component) const;
    [[nodiscard]] int32_t site_of_place(int32_t place);
    [[nodiscard]] int32_t site_of(int32_t strip_point, int32_t block);
    [[nodiscard]] int32_t place_in_block(int32_t place, const Rectangle &block) const;
    [[nodiscard]] int32_t pole_at(const std::array<double, 2> &param);
    void place_points();
    void evaluate();
    [[nodiscard]] TriangleBound bound_over_cells(const std::array<TriangleCorner, 3> &corners,
                                                 const Rectangle &part, int32_t block,
                                                 const Triangle &triangle, double &over) const;
    [[nodiscard]] double moves_over(const Triangle &triangle, const HessianBox &box,
                                    const Rectangle &cell) const;
    struct Known {
        TriangleBound bound;
        double over = 0;
    };
    [[nodiscard]] const Known &known_bound(const Triangle &triangle);
    void prove();
    [[nodiscard]] Vector3 in_grid(const Vector3 &x) const noexcept;
    [[nodiscard]] TriangleBound bound_of(const Triangle &triangle, double &over);
    struct Split {
        double size = 0;
        std::array<double, 2> place{};
        int32_t border = -1; // segment of the border
    };
    [[nodiscard]] Split split_of(const Triangle &triangle) const;
    [[nodiscard]] bool improve();
    [[nodiscard]] DomainMesh output();
    [[nodiscard]] double t_of(size_t k, int32_t line) const noexcept {
        return tree_.lines(k)[static_cast<size_t>(line)].t;
    }

    const MeshDomain &domain_;
    const MeshRule &rule_;
    const Spline &surface_;
    const pieces::PieceGrid &grid_;
    SegmentIndex index_;
    CellNets nets_;
    PieceBound by_pieces_;
    CellTree tree_;
    std::optional<LineTwins> twins_;
    std::optional<PlaceTable> table_;
    std::vector<std::array<double, 2>> extra_; // places that the strip needs besides

    std::vector<Site> sites_;
    std::vector<int32_t> place_sites_;  // -1: none yet
    std::vector<int32_t> place_points_; // of the first of those that are one in space; -1: none yet
    std::vector<std::array<double, 2>> strip_points_;
    std::vector<int32_t> strip_places_; // of strip points, -1: of the border, or an extra one
    std::map<std::array<double, 2>, int32_t> strip_of_param_;
    std::vector<Wall> walls_;
    std::map<std::pair<int32_t, int32_t>, int32_t> strip_sites_;
    std::vector<int32_t> extra_points_; // of the mesh
    std::vector<Triangle> triangles_;
    std::vector<Vector3> positions_, normals_; // of the sites
    std::vector<TriangleBound> bounds_;
    std::vector<Distances> distances_;
    int32_t first_point_ = 0, next_point_ = 0; // points of the mesh that are new
    std::vector<Vector3> new_points_;
    std::vector<bool> touched_;           // places on the border of cells that the border cuts
    std::vector<int32_t> crossed_, weak_; // segments of the border
    double slack_ = 0;                    // of rounding
    std::unordered_map<BoundKey, Known, BoundHash> known_;
};

CellRule DomainMesher::cell_rule() const {
    CellRule rule;
    rule.chord = grid_.scaled(rule_.chord) * share_of_estimate;
    if (domain_.inside) {
        rule.side = [this](const Rectangle &part) { return side_of(part); };
    }
    return rule;
}

Rectangle DomainMesher::around(const Rectangle &part) const noexcept {
    Rectangle result = part;
    for (size_t k = 0; k < 2; ++k) {
        result.lower[k] -= near_border * part.side(k);
        result.upper[k] += near_border * part.side(k);
    }
    return result;
}

Side DomainMesher::side_of(const Rectangle &part) const {
    if (index_.any_in(around(part)) || domain_.cut(part)) {
        return Side::border;
    }
    return domain_.inside({part.lower[0] / 2 + part.upper[0] / 2, part.lower[1] / 2 + part.upper[1] / 2})
               ? Side::inside
               : Side::outside;
}

void DomainMesher::make_tables() {
    twins_.emplace(tree_, grid_);
    for (size_t k = 0; k < 2; ++k) {
        if (domain_.closed[k]) {
            twins_->close(k);
        }
        twins_->collapsed[k].front() = domain_.collapsed[k][0] ? 1 : 0;
        twins_->collapsed[k].back() = domain_.collapsed[k][1] ? 1 : 0;
    }
    table_.emplace(tree_, *twins_);
    place_sites_.assign(static_cast<size_t>(table_->count()), -1);
    place_points_.assign(static_cast<size_t>(table_->count()), -1);
    sites_.clear();
    triangles_.clear();
    strip_points_.clear();
    strip_places_.clear();
    strip_of_param_.clear();
    strip_sites_.clear();
    walls_.clear();
    first_point_ = next_point_ = domain_.points != nullptr ? static_cast<int32_t>(domain_.points->size()) : 0;
}

int32_t DomainMesher::site_of_place(int32_t place) {
    int32_t &site = place_sites_[static_cast<size_t>(place)];
    if (site < 0) {
        const auto lines = table_->place(place).lines;
        int32_t &point = place_points_[static_cast<size_t>(table_->point_of(place))];
        if (point < 0) {
            point = next_point_++;
        }
        site = static_cast<int32_t>(sites_.size());
        Site made;
        for (size_t k = 0; k < 2; ++k) {
            const CellLine &line = tree_.lines(k)[static_cast<size_t>(lines[k])];
            made.param[k] = line.t;
            made.from_left[k] = line.from_left;
        }
        made.point = point;
        sites_.push_back(made);
    }
    return site;
}

// Points of the border stand for the places at which they are, and for poles.
void DomainMesher::place_points() {
    std::map<std::array<double, 2>, int32_t> at;
    for (const BorderPoint &point : domain_.border.points) {
        at.try_emplace(point.param, point.point);
        for (size_t k = 0; k < 2; ++k) {
            for (const size_t end : {size_t{0}, size_t{1}}) {
                const double t = end == 0 ? tree_.lines(k).front().t : tree_.lines(k).back().t;
                if (domain_.collapsed[k][end] && point.param[k] == t) {
                    const std::vector<int32_t> places =
                        table_->on_line(k, end == 0 ? 0 : static_cast<int32_t>(tree_.lines(k).size()) - 1);
                    if (!places.empty()) {
                        int32_t &own = place_points_[static_cast<size_t>(table_->point_of(places.front()))];
                        own = own < 0 ? point.point : own;
                    }
                }
            }
        }
    }
    for (int32_t i = 0; i < table_->count() && !at.empty(); ++i) {
        const auto lines = table_->place(i).lines;
        const auto found = at.find({t_of(0, lines[0]), t_of(1, lines[1])});
        if (found != at.end()) {
            int32_t &own = place_points_[static_cast<size_t>(table_->point_of(i))];
            own = own < 0 ? found->second : own;
        }
    }
}

void DomainMesher::make_cells() {
    CellTriangles maker(tree_);
    std::vector<int32_t> border;
    std::vector<std::array<int32_t, 3>> made;
    for (size_t i = 0; i < tree_.cells().size(); ++i) {
        const Cell &cell = tree_.cells()[i];
        if (cell.side != Side::inside) {
            continue;
        }
        table_->border(cell, border);
        made.clear();
        maker.make(*table_, cell, border, made);
        for (const auto &places : made) {
            Triangle triangle;
            for (size_t k = 0; k < 3; ++k) {
                triangle.sites[k] = site_of_place(places[k]);
            }
            triangle.cell = static_cast<int32_t>(i);
            triangles_.push_back(triangle);
        }
    }
}

// Whether a corner of cells of such sides is inside, or at an end of the domain, and not near the border.
bool DomainMesher::is_wanted(int32_t place, const std::array<double, 2> &sides) const {
    const auto lines = table_->place(place).lines;
    const std::array<double, 2> param{t_of(0, lines[0]), t_of(1, lines[1])};
    Rectangle near{param, param};
    bool at_end = false;
    for (size_t k = 0; k < 2; ++k) {
        near.lower[k] -= near_border * sides[k];
        near.upper[k] += near_border * sides[k];
        at_end = at_end || lines[k] == 0 || lines[k] + 1 == std::ssize(tree_.lines(k));
    }
    return !index_.any_in(near) && (at_end || domain_.inside({param[0], param[1]}));
}

// The border, the corners of cells that it cuts and that are inside, and what cells inside share with these.
void DomainMesher::add_strip_points() {
    const auto add = [&](const std::array<double, 2> &param, int32_t place) {
        const auto [at, fresh] =
            strip_of_param_.try_emplace(param, static_cast<int32_t>(strip_points_.size()));
        if (fresh) {
            strip_points_.push_back(param);
            strip_places_.push_back(place);
        }
    };
    for (const BorderPoint &point : domain_.border.points) { // all of them, in their order
        strip_of_param_.try_emplace(point.param, static_cast<int32_t>(strip_points_.size()));
        strip_points_.push_back(point.param);
        strip_places_.push_back(-1);
    }
    std::vector<bool> needed(static_cast<size_t>(table_->count()), false);
    std::vector<int32_t> border;
    for (const Cell &cell : tree_.cells()) {
        if (cell.side == Side::inside) {
            table_->border(cell, border);
            for (const int32_t place : border) {
                needed[static_cast<size_t>(place)] = true;
            }
        }
    }
    touched_.assign(needed.size(), false);
    std::vector<std::array<double, 2>> sides(needed.size(), {infinity, infinity});
    for (const Cell &cell : tree_.cells()) {
        if (cell.side == Side::border) {
            table_->border(cell, border);
            const Rectangle part = tree_.rectangle(cell);
            for (const int32_t place : border) {
                touched_[static_cast<size_t>(place)] = true;
                for (size_t k = 0; k < 2; ++k) {
                    sides[static_cast<size_t>(place)][k] =
                        std::min(sides[static_cast<size_t>(place)][k], part.side(k));
                }
            }
        }
    }
    // Both sides of a seam have the same places.
    std::vector<bool> kept(needed.size(), false), dropped(needed.size(), false);
    for (int32_t place = 0; place < table_->count(); ++place) {
        const auto at = static_cast<size_t>(place), point = static_cast<size_t>(table_->point_of(place));
        if (touched_[at]) {
            kept[point] = kept[point] || needed[at];
            dropped[point] = dropped[point] || (!needed[at] && !is_wanted(place, sides[at]));
        }
    }
    for (int32_t place = 0; place < table_->count(); ++place) {
        const auto point = static_cast<size_t>(table_->point_of(place));
        if (touched_[static_cast<size_t>(place)] && (kept[point] || !dropped[point])) {
            const auto lines = table_->place(place).lines;
            add({t_of(0, lines[0]), t_of(1, lines[1])}, place);
        }
    }
    for (const auto &param : extra_) {
        add(param, -1);
    }
}

// The border; seams; what cells inside end at; lines at which the surface may have a kink.
void DomainMesher::add_walls() {
    for (size_t i = 0; i < domain_.border.segments.size(); ++i) {
        const BorderSegment &segment = domain_.border.segments[i];
        walls_.push_back({segment.from, segment.to, static_cast<int32_t>(i)});
    }
    std::vector<std::pair<int32_t, int32_t>> of_border, of_inside;
    std::vector<int32_t> border;
    for (const Cell &cell : tree_.cells()) {
        if (cell.side == Side::outside) {
            continue;
        }
        table_->border(cell, border);
        for (size_t i = 0; i < border.size(); ++i) {
            const int32_t a = border[i], b = border[(i + 1) % border.size()];
            if (touched_[static_cast<size_t>(a)] && touched_[static_cast<size_t>(b)]) {
                if (cell.side == Side::border) {
                    of_border.emplace_back(b, a);
                } else {
                    of_inside.emplace_back(a, b);
                }
            }
        }
    }
    // Sides of kinks are one line of the plane.
    const auto strip_at = [&](int32_t place) {
        const auto lines = table_->place(place).lines;
        const auto found = strip_of_param_.find({t_of(0, lines[0]), t_of(1, lines[1])});
        return found == strip_of_param_.end() ? -1 : found->second;
    };
    std::map<std::pair<int32_t, int32_t>, bool> sides;
    for (const auto &[a, b] : of_border) {
        sides[{strip_at(a), strip_at(b)}] = true;
    }
    for (const auto &[a, b] : of_inside) {
        const int32_t from = strip_at(a), to = strip_at(b);
        if (from >= 0 && to >= 0 && sides.contains({from, to})) {
            walls_.push_back({from, to});
        }
    }
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = tree_.block_ends(k);
        for (size_t i = 0; i < ends.size(); ++i) {
            const bool inner = i > 0 && i + 1 < ends.size();
            if (inner || domain_.closed[k]) {
                add_line_walls(k, ends[i], inner);
            }
        }
    }
}

void DomainMesher::add_line_walls(size_t k, double t, bool passable) {
    std::vector<std::pair<double, int32_t>> on;
    for (size_t i = 0; i < strip_points_.size(); ++i) {
        if (strip_points_[i][k] == t) {
            on.emplace_back(strip_points_[i][1 - k], static_cast<int32_t>(i));
        }
    }
    std::ranges::sort(on);
    for (size_t i = 0; i + 1 < on.size(); ++i) {
        walls_.push_back({on[i].second, on[i + 1].second, -1, passable});
    }
}

// By its fattest triangle: those along the border are as thin as what is between curves and segments.
bool DomainMesher::is_kept(const Strip::Component &component) const {
    double best = -1;
    std::array<double, 2> middle{};
    for (const StripTriangle &triangle : component) {
        const auto &a = strip_points_[static_cast<size_t>(triangle.corners[0])],
                   &b = strip_points_[static_cast<size_t>(triangle.corners[1])],
                   &c = strip_points_[static_cast<size_t>(triangle.corners[2])];
        const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (area > best) {
            best = area;
            middle = {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
        }
    }
    bool in_cell = false;
    tree_.for_each_in({middle, middle},
                      [&](const Cell &cell) { in_cell = in_cell || cell.side == Side::inside; });
    return !in_cell && domain_.inside({middle[0], middle[1]});
}

int32_t DomainMesher::place_in_block(int32_t place, const Rectangle &block) const {
    auto lines = table_->place(place).lines;
    for (size_t k = 0; k < 2; ++k) {
        const auto &all = tree_.lines(k);
        const auto at = static_cast<size_t>(lines[k]);
        if (all[at].t == block.upper[k] && !all[at].from_left && at > 0 && all[at - 1].t == all[at].t) {
            --lines[k];
        } else if (all[at].t == block.lower[k] && all[at].from_left && at + 1 < all.size() &&
                   all[at + 1].t == all[at].t) {
            ++lines[k];
        }
    }
    return table_->find(lines[0], lines[1]);
}

// The point of the pole at which a place is, -1: none.
int32_t DomainMesher::pole_at(const std::array<double, 2> &param) {
    for (size_t k = 0; k < 2; ++k) {
        for (const size_t end : {size_t{0}, size_t{1}}) {
            const int32_t line = end == 0 ? 0 : static_cast<int32_t>(tree_.lines(k).size()) - 1;
            if (domain_.collapsed[k][end] && param[k] == t_of(k, line)) {
                const std::vector<int32_t> places = table_->on_line(k, line);
                if (places.empty()) {
                    return -1;
                }
                int32_t &point = place_points_[static_cast<size_t>(table_->point_of(places.front()))];
                point = point < 0 ? next_point_++ : point;
                return point;
            }
        }
    }
    return -1;
}

int32_t DomainMesher::site_of(int32_t strip_point, int32_t number) {
    const auto at = static_cast<size_t>(strip_point);
    const Rectangle block = tree_.block(number);
    if (strip_places_[at] >= 0) {
        return site_of_place(place_in_block(strip_places_[at], block));
    }
    const auto [known, fresh] =
        strip_sites_.try_emplace({strip_point, number}, static_cast<int32_t>(sites_.size()));
    if (fresh) {
        Site site;
        site.param = strip_points_[at];
        for (size_t k = 0; k < 2; ++k) {
            site.from_left[k] = site.param[k] == block.upper[k];
        }
        if (at < domain_.border.points.size()) {
            site.point = domain_.border.points[at].point;
        } else if (const int32_t pole = pole_at(site.param); pole >= 0) {
            site.point = pole;
        } else {
            const auto [own, none] = strip_sites_.try_emplace({strip_point, -1}, next_point_);
            next_point_ += none ? 1 : 0;
            site.point = own->second;
        }
        sites_.push_back(site);
    }
    return known->second;
}

void DomainMesher::make_strip() {
    add_strip_points();
    add_walls();
    Rectangle part = tree_.rectangle(tree_.cells().front());
    for (const Cell &cell : tree_.cells()) {
        const Rectangle own = tree_.rectangle(cell);
        for (size_t k = 0; k < 2; ++k) {
            part.lower[k] = std::min(part.lower[k], own.lower[k]);
            part.upper[k] = std::max(part.upper[k], own.upper[k]);
        }
    }
    std::array<double, 2> lengths{};
    for (const Cell &cell : tree_.cells()) {
        for (size_t k = 0; k < 2; ++k) {
            const double speed =
                cell.box.move(k == 0 ? 1 : 0, k == 0 ? 0 : 1) / tree_.rectangle(cell).side(k) * part.side(k);
            lengths[k] = std::max(lengths[k], std::isfinite(speed) ? speed : 0);
        }
    }
    const Strip strip(part, lengths, strip_points_, walls_);
    // Lines may cross the border outside of the face.
    crossed_.clear();
    for (const auto &[one, other] : strip.crossings()) {
        for (const int32_t wall : {one, other}) {
            if (walls_[static_cast<size_t>(one)].border >= 0 &&
                walls_[static_cast<size_t>(wall)].border >= 0) {
                crossed_.push_back(walls_[static_cast<size_t>(wall)].border);
            }
        }
    }
    for (const Strip::Component &component : strip.components()) {
        if (!is_kept(component)) {
            continue;
        }
        for (const StripTriangle &triangle : component) {
            std::array<double, 2> middle{};
            for (const int32_t corner : triangle.corners) {
                for (size_t k = 0; k < 2; ++k) {
                    middle[k] += strip_points_[static_cast<size_t>(corner)][k] / 3;
                }
            }
            const int32_t block = tree_.block_at(middle);
            Triangle made;
            for (size_t k = 0; k < 3; ++k) {
                made.sites[k] = site_of(triangle.corners[k], block);
            }
            made.border = triangle.border;
            made.fixed = triangle.fixed;
            triangles_.push_back(made);
        }
    }
}

// In groups of equal sides.
void DomainMesher::evaluate() {
    positions_.resize(sites_.size());
    normals_.resize(sites_.size());
    for (unsigned group = 0; group < 4; ++group) {
        const std::array<bool, 2> from_left{(group & 1U) != 0, (group & 2U) != 0};
        std::vector<size_t> members;
        std::vector<double> params;
        for (size_t i = 0; i < sites_.size(); ++i) {
            if (sites_[i].from_left == from_left) {
                members.push_back(i);
                params.insert(params.end(), sites_[i].param.begin(), sites_[i].param.end());
            }
        }
        eval::AxisRules rules{};
        rules[0].left = from_left[0];
        rules[1].left = from_left[1];
        const auto n = static_cast<int64_t>(members.size());
        const ConstRecords at{params.data(), n, 2, 2, 1};
        std::vector<double> points(3 * members.size()), normals(points.size());
        if (surface_.dim() == 3) {
            eval::surface_frames(
                surface_, rules, at,
                {{points.data(), n, 3, 3, 1}, {}, {}, {normals.data(), n, 3, 3, 1}, nullptr});
        } else {
            std::vector<double> jets(6 * members.size());
            eval::evaluate_points(surface_, rules, 1, at, {jets.data(), n, 6, 6, 1});
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
    new_points_.assign(static_cast<size_t>(next_point_ - first_point_), {nan_value, 0, 0});
    for (size_t i = 0; i < sites_.size(); ++i) {
        if (sites_[i].point >= first_point_) {
            Vector3 &x = new_points_[static_cast<size_t>(sites_[i].point - first_point_)];
            x = std::isnan(x.x) ? positions_[i] : x;
        }
    }
}

Vector3 DomainMesher::in_grid(const Vector3 &x) const noexcept {
    const std::array<double, 3> given{x.x, x.y, x.z};
    std::array<double, 8> placed{};
    grid_.place(given.data(), placed.data());
    return {placed[0], placed[1], surface_.dim() == 3 ? placed[2] : 0};
}

// How far places between a segment of the border and its curve are from it, in space.
double move_over(const BorderSegment &segment, const HessianBox &box, const Rectangle &cell) noexcept {
    const double u = segment.over[0] / cell.side(0), v = segment.over[1] / cell.side(1);
    return segment.across ? box.move(u, v) : box.move(u, 0) + box.move(0, v);
}

// over: how far the corners, and what is between sides and curves of the border, are from the surface over the triangle.
TriangleBound DomainMesher::bound_of(const Triangle &triangle, double &over) {
    std::array<TriangleCorner, 3> corners;
    Rectangle part;
    for (size_t k = 0; k < 3; ++k) {
        const auto site = static_cast<size_t>(triangle.sites[k]);
        const int32_t point = sites_[site].point;
        const Vector3 &x = point < first_point_ ? (*domain_.points)[static_cast<size_t>(point)]
                                                : new_points_[static_cast<size_t>(point - first_point_)];
        corners[k] = {sites_[site].param, in_grid(x)};
        over = std::max(over, grid_.scaled(length(x - positions_[site])));
        for (size_t axis = 0; axis < 2; ++axis) {
            part.lower[axis] =
                k == 0 ? corners[k].param[axis] : std::min(part.lower[axis], corners[k].param[axis]);
            part.upper[axis] =
                k == 0 ? corners[k].param[axis] : std::max(part.upper[axis], corners[k].param[axis]);
        }
    }
    if (triangle.cell >= 0) {
        const Cell &cell = tree_.cells()[static_cast<size_t>(triangle.cell)];
        const CellPart here{&cell.box, tree_.rectangle(cell)};
        const TriangleBound bound = triangle_bound(corners, {&here, 1});
        const PieceRange pieces = nets_.pieces_in(part);
        const bool fits = grid_.unscaled(std::max(bound.from_shape(), bound.from_mesh())) <= rule_.chord;
        return fits || pieces.count() == 1 || pieces.count() > most_pieces
                   ? bound
                   : by_pieces_.bound(corners, pieces, tree_.block(cell.block));
    }
    std::array<double, 2> beside{};
    for (const int32_t border : triangle.border) {
        for (size_t k = 0; k < 2 && border >= 0; ++k) {
            beside[k] =
                std::max(beside[k], std::abs(domain_.border.segments[static_cast<size_t>(border)].over[k]));
        }
    }
    const std::array<double, 2> middle{(corners[0].param[0] + corners[1].param[0] + corners[2].param[0]) / 3,
                                       (corners[0].param[1] + corners[1].param[1] + corners[2].param[1]) / 3};
    const int32_t block = tree_.block_at(middle);
    for (size_t k = 0; k < 2; ++k) {
        part.lower[k] -= beside[k];
        part.upper[k] += beside[k];
    }
    const Rectangle bounds = tree_.block(block);
    for (size_t k = 0; k < 2; ++k) {
        const double room = 1e-6 * bounds.side(k);
        if (part.lower[k] + beside[k] < bounds.lower[k] - room ||
            part.upper[k] - beside[k] > bounds.upper[k] + room) {
            over = infinity; // over a line at which the surface may have a kink
        }
        part.lower[k] = std::max(part.lower[k], bounds.lower[k]);
        part.upper[k] = std::min(part.upper[k], bounds.upper[k]);
        if (!(part.lower[k] < part.upper[k])) { // along a line
            const double step = 1e-9 * bounds.side(k);
            part.lower[k] = std::max(bounds.lower[k], part.lower[k] - step);
            part.upper[k] = std::min(bounds.upper[k], part.upper[k] + step);
        }
    }
    const PieceRange pieces = nets_.pieces_in(part);
    if (pieces.count() > most_pieces) {
        return bound_over_cells(corners, part, block, triangle, over);
    }
    const HessianBox box = nets_.box(part, pieces);
    if (pieces.count() > 1) {
        over += moves_over(triangle, box, part);
        return by_pieces_.bound(corners, pieces, tree_.block(block));
    }
    over += moves_over(triangle, box, part);
    const CellPart here{&box, part};
    return triangle_bound(corners, {&here, 1});
}

// How far places between curves of the border and the sides of a triangle are from it, in space.
double DomainMesher::moves_over(const Triangle &triangle, const HessianBox &box,
                                const Rectangle &cell) const {
    double moves = 0;
    for (const int32_t border : triangle.border) {
        if (border >= 0) {
            moves =
                std::max(moves, move_over(domain_.border.segments[static_cast<size_t>(border)], box, cell));
        }
    }
    return moves;
}

TriangleBound DomainMesher::bound_over_cells(const std::array<TriangleCorner, 3> &corners,
                                             const Rectangle &part, int32_t block, const Triangle &triangle,
                                             double &over) const {
    std::vector<CellPart> cells;
    double moves = 0;
    tree_.for_each_in(part, [&](const Cell &cell) {
        if (cell.block == block) {
            const Rectangle own = tree_.rectangle(cell);
            cells.push_back({&cell.box, own});
            moves = std::max(moves, moves_over(triangle, cell.box, own));
        }
    });
    over += moves;
    return triangle_bound(corners, cells);
}

// Most triangles stay from one round to the next.
const DomainMesher::Known &DomainMesher::known_bound(const Triangle &triangle) {
    BoundKey key{};
    for (size_t k = 0; k < 3; ++k) {
        const Site &site = sites_[static_cast<size_t>(triangle.sites[k])];
        const auto offset = 2 * k;
        key[offset] = site.param[0];
        key[offset + 1] = site.param[1];
    }
    for (size_t k = 0; k < 3; ++k) {
        key[6 + k] = triangle.border[k];
    }
    const auto [known, fresh] = known_.try_emplace(key);
    if (fresh) {
        known->second.bound = bound_of(triangle, known->second.over);
    }
    return known->second;
}

void DomainMesher::prove() {
    MeshBound all(static_cast<size_t>(next_point_));
    for (const BorderPoint &point : domain_.border.points) {
        all.set_border(point.point);
    }
    for (const Site &site : sites_) {
        for (size_t k = 0; k < 2; ++k) {
            const bool low = site.param[k] == tree_.lines(k).front().t,
                       high = site.param[k] == tree_.lines(k).back().t;
            if ((low && !domain_.closed[k] && !domain_.collapsed[k][0]) ||
                (high && !domain_.closed[k] && !domain_.collapsed[k][1])) {
                all.set_border(site.point);
            }
        }
    }
    bounds_.clear();
    std::vector<double> overs;
    const auto points_of = [&](const Triangle &triangle) {
        return std::array<int32_t, 3>{sites_[static_cast<size_t>(triangle.sites[0])].point,
                                      sites_[static_cast<size_t>(triangle.sites[1])].point,
                                      sites_[static_cast<size_t>(triangle.sites[2])].point};
    };
    for (const Triangle &triangle : triangles_) {
        const Known &known = known_bound(triangle);
        bounds_.push_back(known.bound);
        overs.push_back(known.over);
        all.add_normal(points_of(triangle), bounds_.back().normal);
        count_work(500);
    }
    for (size_t i = 0; i < triangles_.size(); ++i) {
        all.add(points_of(triangles_[i]), bounds_[i]);
    }
    slack_ = grid_.moved() + 8 * grid_.value_error() * grid_.radius() + 4 * eps * grid_.size();
    distances_.clear();
    for (size_t i = 0; i < triangles_.size(); ++i) {
        Distances d = all.distances(points_of(triangles_[i]), bounds_[i]);
        const double more = overs[i] + slack_;
        d.from_shape = grid_.unscaled(d.from_shape + more) * (1 + 4 * eps);
        d.from_mesh = grid_.unscaled(d.from_mesh + more) * (1 + 4 * eps);
        distances_.push_back(d);
    }
}

// Where a triangle of the strip is best divided: at a pole on that side, else on the longest one that can be.
DomainMesher::Split DomainMesher::split_of(const Triangle &triangle) const {
    Split best;
    for (size_t k = 0; k < 3; ++k) {
        const auto from = static_cast<size_t>(triangle.sites[(k + 1) % 3]),
                   to = static_cast<size_t>(triangle.sites[(k + 2) % 3]);
        const Site &a = sites_[from], &b = sites_[to];
        const bool pole = a.point == b.point;
        const double size = pole ? infinity : length(positions_[from] - positions_[to]);
        const bool can = pole || !triangle.fixed[k] || triangle.border[k] >= 0;
        if (can && size > best.size) {
            best = {size, {(a.param[0] + b.param[0]) / 2, (a.param[1] + b.param[1]) / 2}, triangle.border[k]};
        }
    }
    return best;
}

// Cells over the tolerance are cut, triangles of the strip get a new point.
bool DomainMesher::improve() {
    std::vector<int32_t> cells;
    std::vector<std::array<double, 2>> more;
    weak_.clear();
    for (size_t i = 0; i < triangles_.size(); ++i) {
        const Triangle &triangle = triangles_[i];
        if (distances_[i].most() <= rule_.chord) {
            continue;
        }
        if (triangle.cell >= 0) {
            if (cells.empty() || cells.back() != triangle.cell) {
                cells.push_back(triangle.cell);
            }
            continue;
        }
        const Split split = split_of(triangle);
        if (split.border >= 0) {
            weak_.push_back(split.border);
        } else if (split.size > rule_.chord / 4) {
            more.push_back(split.place);
        }
    }
    std::ranges::sort(more);
    more.erase(std::ranges::unique(more).begin(), more.end());
    extra_.insert(extra_.end(), more.begin(), more.end());
    if (!cells.empty()) {
        tree_.cut(cells);
    }
    return !cells.empty() || !more.empty();
}

DomainMesh DomainMesher::output() {
    DomainMesh result;
    for (size_t i = 0; i < sites_.size(); ++i) {
        const int32_t point = sites_[i].point;
        result.vertices.push_back(
            {point < first_point_ ? point : first_point_ - 1 - point, sites_[i].param, normals_[i]});
    }
    for (size_t i = 0; i < triangles_.size(); ++i) {
        result.from_shape = std::max(result.from_shape, distances_[i].from_shape);
        result.from_mesh = std::max(result.from_mesh, distances_[i].from_mesh);
        const auto &sites = triangles_[i].sites;
        std::array<int32_t, 3> points{};
        for (size_t k = 0; k < 3; ++k) {
            points[k] = sites_[static_cast<size_t>(sites[k])].point;
        }
        if (points[0] != points[1] && points[1] != points[2] && points[2] != points[0]) {
            result.triangles.push_back(sites);
        }
    }
    result.points = std::move(new_points_);
    result.reached = crossed_.empty() && !result.triangles.empty() &&
                     std::max(result.from_shape, result.from_mesh) <= rule_.chord;
    result.weak = std::move(weak_);
    result.weak.insert(result.weak.end(), crossed_.begin(), crossed_.end());
    std::ranges::sort(result.weak);
    result.weak.erase(std::ranges::unique(result.weak).begin(), result.weak.end());
    return result;
}

DomainMesh DomainMesher::run() {
    for (int round = 0;; ++round) {
        make_tables();
        place_points();
        make_cells();
        if (domain_.inside) {
            make_strip();
        }
        evaluate();
        prove();
        if (round == most_rounds || work_ended() || !improve()) {
            return output();
        }
    }
}

} // namespace

DomainMesh mesh_of(const MeshDomain &domain, const MeshRule &rule) {
    return DomainMesher(domain, rule).run();
}

} // namespace nrb::mesh
