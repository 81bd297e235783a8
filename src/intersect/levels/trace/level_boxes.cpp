// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/level_boxes.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/levels/trace/edge_roots.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr int most_halvings = 96;
constexpr size_t most_clusters = 4096; // of a piece; then what is left of it is not halved
constexpr size_t most_clusters_of_all = 100000;
// Of the slopes of arcs: what is less even is halved, since errors of curves are told by the least slope.
constexpr double least_evenness = 1.0 / 16;
constexpr int depth_of_evenness = 24;

bool has_roots(const LevelBorder &border) noexcept {
    return std::ranges::any_of(border.edges, [](const auto &edge) { return !edge.empty(); });
}

struct PlacedRoot {
    int32_t root;
    std::array<double, 2> place;
    bool enters;  // what has f > 0 on its left comes into the box there
    size_t order; // a stable sort would take memory that nobody can refuse
};

// All of them, by their places along an axis. Anticlockwise around a box f changes to below where the level comes in.
std::vector<PlacedRoot> roots_along(const LevelBorder &border, const LevelPart &part, size_t axis) {
    std::vector<PlacedRoot> all;
    for (size_t k = 0; k < 2; ++k) {
        for (size_t end = 0; end < 2; ++end) {
            const bool anticlockwise = (k == 1) == (end == 0);
            bool above = k == 0 ? border.above[end][0] : border.above[0][end];
            for (const EdgeRoot &root : border.edges[2 * k + end]) {
                PlacedRoot &placed = all.emplace_back();
                placed.root = root.root;
                placed.place[k] = part.lower[k] + static_cast<double>(end) * part.length[k];
                placed.place[1 - k] = root.place;
                placed.enters = above == anticlockwise;
                placed.order = all.size();
                above = !above;
            }
        }
    }
    std::ranges::sort(all, {},
                      [axis](const PlacedRoot &root) { return std::pair(root.place[axis], root.order); });
    return all;
}

// Makes entries and exits alternate where their places cannot be told apart; false: they do not.
bool alternate(std::vector<PlacedRoot> &roots, size_t axis, double near, bool enters) {
    for (size_t i = 0; i < roots.size(); ++i, enters = !enters) {
        size_t next = i;
        while (next < roots.size() && roots[next].enters != enters) {
            ++next;
        }
        if (next == roots.size() || roots[next].place[axis] - roots[i].place[axis] > near) {
            return false;
        }
        std::swap(roots[i], roots[next]);
    }
    return roots.size() % 2 == 0;
}

bool is_certain(const LevelNet::Edge &edge) noexcept {
    for (size_t i = 0; i < edge.values.size(); ++i) {
        if (!(edge.values[i] > edge.known(i))) {
            return false;
        }
    }
    return true;
}

} // namespace

bool LevelArc::is_point() const noexcept {
    return std::abs(first[0] - last[0]) + std::abs(first[1] - last[1]) <= 16 * eps;
}

int32_t LevelPieces::add_root(const std::array<double, 2> &at) {
    roots.push_back({at});
    return static_cast<int32_t>(roots.size()) - 1;
}

int32_t LevelPieces::corner(const std::array<double, 2> &at) {
    std::array<double, 2> key = at;
    for (size_t k = 0; k < 2; ++k) {
        key[k] = closed[k] && at[k] == closed[k]->upper ? closed[k]->lower : at[k];
    }
    const auto [known, is_new] = corners.try_emplace(key, 0);
    if (is_new) {
        known->second = add_root(at);
    }
    return known->second;
}

void BoxSearch::run(int64_t piece, const PieceDomain &domain, LevelNet net, LevelBorder border) {
    domain_ = domain;
    const size_t before = found_.clusters.size();
    stack_.push_back({{piece, {0, 0}, {1, 1}}, std::move(net), std::move(border), 0});
    while (!stack_.empty()) {
        Box box = std::move(stack_.back());
        stack_.pop_back();
        const size_t clusters = found_.clusters.size();
        if (work_ended() || clusters - before > most_clusters || clusters > most_clusters_of_all) {
            take_cluster(box, false);
        } else {
            look(box);
        }
    }
}

// Signs at the borders of neighbours are off by the noise of both, hence four times of it.
void BoxSearch::look(Box &box) {
    const LevelNet &net = box.net;
    count_work(1000 + 80 * std::ssize(net.values)); // with what halving it takes
    if (net.side(4) != 0) {
        return;
    }
    const bool roots = has_roots(box.border), positive = net.has_positive_weights();
    if (positive) {
        const std::array<LevelNet::Slope, 2> slopes{net.slope(0), net.slope(1)};
        const auto evenness = [&](size_t k) {
            return slopes[k].sign != 0 ? slopes[k].least / slopes[k].most : 0;
        };
        const size_t best = evenness(1) > evenness(0) ? 1 : 0;
        const bool near = net.is_near(near_);
        const bool even =
            !roots || evenness(best) >= least_evenness || (box.depth >= depth_of_evenness && !near);
        if (slopes[best].sign != 0 && even && (!roots || take_arcs(box, 1 - best, slopes[best].sign))) {
            take_sides(box, slopes);
            return;
        }
        if (near) {
            take_cluster(box, true);
            return;
        }
    }
    if (box.depth >= most_halvings) {
        take_cluster(box, false);
    } else {
        halve(box);
    }
}

// As graphs over the axis; sign: of the slope along the other one. f > 0 lies on the left of (f_v, -f_u).
bool BoxSearch::take_arcs(const Box &box, size_t axis, int sign) {
    std::vector<PlacedRoot> roots = roots_along(box.border, box.part, axis);
    const bool rises = axis == 0 ? sign > 0 : sign < 0;
    if (!alternate(roots, axis, 0x1p-36 * box.part.length[axis], rises)) {
        return false;
    }
    for (size_t i = 0; i < roots.size(); i += 2) {
        const PlacedRoot &first = roots[rises ? i : i + 1], &last = roots[rises ? i + 1 : i];
        if (const std::optional<LevelPart> pole = pole_of(box, first.place, last.place)) {
            found_.clusters.push_back({*pole, {first.root, last.root}, true, false});
        } else {
            found_.arcs.push_back({box.part, axis, first.root, last.root, first.place, last.place});
        }
    }
    return true;
}

// The part of a side of one point along which an arc would run.
std::optional<LevelPart> BoxSearch::pole_of(const Box &box, const std::array<double, 2> &first,
                                            const std::array<double, 2> &last) {
    for (size_t axis = 0; axis < 2; ++axis) {
        for (size_t end = 0; end < 2; ++end) {
            LevelPart side = box.part;
            side.lower[axis] += static_cast<double>(end) * side.length[axis];
            side.length[axis] = 0;
            if (box.border.collapsed[2 * axis + end] && first[axis] == side.lower[axis] &&
                last[axis] == first[axis]) {
                return side;
            }
        }
    }
    return std::nullopt;
}

// Where f rises from the border inwards.
void BoxSearch::take_sides(const Box &box, const std::array<LevelNet::Slope, 2> &slopes) {
    for (size_t axis = 0; axis < 2; ++axis) {
        for (size_t end = 0; end < 2; ++end) {
            const size_t side = 2 * axis + end;
            const bool rises = slopes[axis].sign == (end == 0 ? 1 : -1);
            const bool above = axis == 0 ? box.border.above[end][0] : box.border.above[0][end];
            const LevelSide kind = box.border.sides[side];
            if (kind == LevelSide::inside || !rises || !above || !box.border.edges[side].empty()) {
                continue;
            }
            const LevelNet::Edge edge = box.net.edge(axis, static_cast<int>(end));
            if (kind == LevelSide::open && box.net.degrees[1 - axis] > 0 && !box.border.collapsed[side] &&
                edge.is_hidden()) {
                take_edge(box, axis, end);
            } else {
                take_touches(box, axis, end, edge);
            }
        }
    }
}

// f > 0 on the left: inside.
void BoxSearch::take_edge(const Box &box, size_t axis, size_t end) {
    const size_t other = 1 - axis;
    std::array<std::array<double, 2>, 2> places{box.part.lower, box.part.lower};
    places[0][axis] = places[1][axis] =
        box.part.lower[axis] + static_cast<double>(end) * box.part.length[axis];
    places[1][other] += box.part.length[other];
    const bool rises = (axis == 0) == (end == 1);
    const auto &first = places[rises ? 0 : 1], &last = places[rises ? 1 : 0];
    found_.arcs.push_back(
        {box.part, other, found_.corner(parameters(first)), found_.corner(parameters(last)), first, last});
}

// Places on an edge that cannot be told from zeros. A sign that contradicts those of the corners leaves much of it so: then
// what is left is not halved.
void BoxSearch::take_touches(const Box &box, size_t axis, size_t end, LevelNet::Edge edge) {
    constexpr double smallest_part = 0x1p-30;
    constexpr int most_touches = 64;
    struct Part {
        LevelNet::Edge edge;
        double from, length;
    };
    std::vector<Part> stack;
    stack.push_back({std::move(edge), 0, 1});
    for (int touches = 0; !stack.empty();) {
        Part upper = std::move(stack.back());
        stack.pop_back();
        count_work(20 * std::ssize(upper.edge.values));
        if (is_certain(upper.edge)) {
            continue;
        }
        const bool near = upper.length < smallest_part || upper.edge.is_hidden();
        if (near || touches >= most_touches) {
            take_touch(box, axis, end, {upper.from, upper.from + upper.length}, near);
            ++touches;
            continue;
        }
        upper.length /= 2;
        Part lower{upper.edge.take_lower_half(), upper.from, upper.length};
        upper.from += upper.length;
        stack.push_back(std::move(upper));
        stack.push_back(std::move(lower));
    }
}

void BoxSearch::take_touch(const Box &box, size_t axis, size_t end, Interval range, bool near) {
    LevelPart part = box.part;
    part.lower[axis] += static_cast<double>(end) * part.length[axis];
    part.length[axis] = 0;
    part.lower[1 - axis] += range.lower * part.length[1 - axis];
    part.length[1 - axis] *= range.upper - range.lower;
    found_.clusters.push_back({part, {}, near, box.border.sides[2 * axis + end] == LevelSide::joined});
}

std::array<double, 2> BoxSearch::parameters(const std::array<double, 2> &place) const noexcept {
    return {domain_.parameter(0, place[0]), domain_.parameter(1, place[1])};
}

void BoxSearch::take_cluster(const Box &box, bool near) {
    LevelCluster cluster{box.part, {}, near, false};
    for (const std::vector<EdgeRoot> &edge : box.border.edges) {
        for (const EdgeRoot &root : edge) {
            cluster.roots.push_back(root.root);
        }
    }
    found_.clusters.push_back(std::move(cluster));
}

// Along the axis along which f changes more.
void BoxSearch::halve(Box &box) {
    const auto change = [&](size_t k) { return box.net.degrees[k] * box.net.slope(k).most; };
    const bool first =
        change(0) > change(1) || (change(0) == change(1) && box.part.length[0] >= box.part.length[1]);
    const size_t axis = box.net.degrees[1] == 0 || (first && box.net.degrees[0] > 0) ? 0 : 1;
    Box upper = std::move(box), lower;
    lower.part = upper.part;
    lower.depth = ++upper.depth;
    lower.part.length[axis] = upper.part.length[axis] /= 2;
    const double middle = lower.part.lower[axis] + lower.part.length[axis];
    upper.part.lower[axis] = middle;
    lower.net = upper.net.take_lower_half(axis);
    LevelBorder whole = std::move(upper.border);
    set_middle(whole, lower, upper, axis, middle);
    stack_.push_back(std::move(upper));
    stack_.push_back(std::move(lower));
}

// The roots on edges along the axis are those of one half or the other; a sign in the middle of an edge is that at its
// start, changed at each root before.
void BoxSearch::set_middle(LevelBorder &whole, Box &lower, Box &upper, size_t axis, double middle) {
    const size_t other = 1 - axis;
    std::array<bool, 2> above{};
    for (size_t end = 0; end < 2; ++end) {
        std::vector<EdgeRoot> &edge = whole.edges[2 * other + end];
        const auto first_above = std::ranges::lower_bound(edge, middle, {}, &EdgeRoot::place);
        const bool start = axis == 0 ? whole.above[0][end] : whole.above[end][0];
        above[end] = start != ((first_above - edge.begin()) % 2 != 0);
        lower.border.edges[2 * other + end].assign(edge.begin(), first_above);
        upper.border.edges[2 * other + end].assign(first_above, edge.end());
        for (size_t side = 0; side < 2; ++side) {
            const auto corner = [&](LevelBorder &border, size_t along) -> bool & {
                return axis == 0 ? border.above[along][end] : border.above[end][along];
            };
            corner(lower.border, side) = side == 1 ? above[end] : corner(whole, 0);
            corner(upper.border, side) = side == 0 ? above[end] : corner(whole, 1);
        }
    }
    lower.border.edges[2 * axis] = std::move(whole.edges[2 * axis]);
    upper.border.edges[2 * axis + 1] = std::move(whole.edges[2 * axis + 1]);
    lower.border.sides = upper.border.sides = whole.sides;
    lower.border.collapsed = upper.border.collapsed = whole.collapsed;
    lower.border.collapsed[2 * axis + 1] = upper.border.collapsed[2 * axis] = false;
    lower.border.sides[2 * axis + 1] = upper.border.sides[2 * axis] = LevelSide::inside;
    lower.border.edges[2 * axis + 1] = upper.border.edges[2 * axis] =
        middle_roots(upper, axis, above[0], above[1]);
}

// On the lower side of a box.
std::vector<EdgeRoot> BoxSearch::middle_roots(const Box &box, size_t axis, bool start, bool end) {
    const size_t other = 1 - axis;
    std::vector<EdgeRoot> roots;
    for (const double along : edge_roots(box.net.edge(axis, 0), start, end)) {
        const double place = box.part.lower[other] + along * box.part.length[other];
        std::array<double, 2> at{};
        at[axis] = box.part.lower[axis];
        at[other] = place;
        roots.push_back({found_.add_root(parameters(at)), place});
    }
    return roots;
}

} // namespace nrb::intersect
