// SPDX-License-Identifier: MIT
#include "mesh/delaunay/corridor.h"

#include "base/watch.h"

#include <algorithm>
#include <utility>

namespace nrb::mesh {

namespace {

constexpr int64_t work_of_a_corner = 50;
// The mark of the edges along which ears are cut off: they are not flipped.
constexpr int32_t held = -2;

// Removes leftover marks of ears. Where the triangulation was constrained Delaunay there are none. Elsewhere
// sides of the polygon may be flipped, and ears moved by that before they come back.
void release(TriangleNet &net, TriangleId t) noexcept {
    for (int k = 0; k < 3; ++k) {
        if (const EdgeId e = TriangleNet::edge_of(t, k); net.mark(e) == held) {
            net.set_mark(e, TriangleNet::unmarked);
        }
    }
}

} // namespace

void Corridor::open(TriangleNet &net, std::span<const EdgeId> crossed, int32_t mark) {
    find_sides(net, crossed);
    // Old triangles stay until all new ones are there: both half-edges of an edge may be sides of a polygon.
    net.reserve_triangles(crossed.size() + 1);
    const TriangleId first_ear = net.size();
    draw_ = 1; // so that the same segment always makes the same triangles
    const EdgeId below = cut_ears(net, right_);
    net.join(below, cut_ears(net, left_), mark);
    return_ears(net, first_ear);
    const bool inside = net.inside(old_.front());
    for (const TriangleId t : old_) {
        net.move_last_to(t);
        net.set_inside(t, inside);
        release(net, t);
    }
}

// Each crossed edge leads from the right of the segment to its left.
void Corridor::find_sides(const TriangleNet &net, std::span<const EdgeId> crossed) {
    old_ = {TriangleNet::triangle_of(crossed.front())};
    right_ = {TriangleNet::previous(crossed.front())};
    left_ = {TriangleNet::next(crossed.front())};
    for (size_t i = 0; i < crossed.size(); ++i) {
        const EdgeId f = net.twin(crossed[i]), right = TriangleNet::next(f), left = TriangleNet::previous(f);
        const EdgeId then = i + 1 < crossed.size() ? crossed[i + 1] : -1;
        old_.push_back(TriangleNet::triangle_of(f));
        if (then != right) {
            right_.push_back(right);
        }
        if (then != left) {
            left_.push_back(left);
        }
    }
    std::reverse(left_.begin(), left_.end());
}

// Returns the base, as an edge of the last ear.
EdgeId Corridor::cut_ears(TriangleNet &net, std::span<const EdgeId> sides) {
    set_corners(net, sides);
    while (!waiting_.empty()) {
        count_work(work_of_a_corner);
        const int32_t i = take_waiting();
        if (is_ear(net, i)) {
            cut(net, i);
        }
    }
    return corners_.front().side;
}

void Corridor::set_corners(const TriangleNet &net, std::span<const EdgeId> sides) {
    corners_.clear();
    for (const EdgeId e : sides) {
        const auto i = static_cast<int32_t>(corners_.size());
        corners_.push_back({net.from(e), e, i - 1, i + 1, false});
        waiting_.push_back(i);
    }
    const auto last = static_cast<int32_t>(corners_.size());
    corners_.push_back({net.to(sides.back()), -1, last - 1, -1, false});
}

// A random one, drawn by the minimal standard generator of S. Park and K. Miller.
int32_t Corridor::take_waiting() {
    draw_ = draw_ * 48271 % 2147483647;
    std::swap(waiting_[draw_ % waiting_.size()], waiting_.back());
    const int32_t i = waiting_.back();
    waiting_.pop_back();
    return i;
}

bool Corridor::is_ear(const TriangleNet &net, int32_t i) const noexcept {
    const Corner &corner = corners_[static_cast<size_t>(i)];
    if (corner.cut || corner.previous < 0 || corner.next < 0) {
        return false; // an end of the base
    }
    const auto point = [&](int32_t k) { return net.point(corners_[static_cast<size_t>(k)].vertex); };
    return orientation(point(corner.previous), point(i), point(corner.next)) > 0;
}

// Cuts off the ear at corner i. Its third side closes the polygon, and is its own twin as long as nothing is
// beyond it.
void Corridor::cut(TriangleNet &net, int32_t i) {
    Corner &corner = corners_[static_cast<size_t>(i)];
    Corner &before = corners_[static_cast<size_t>(corner.previous)],
           &after = corners_[static_cast<size_t>(corner.next)];
    const EdgeId opposite =
        TriangleNet::edge_of(net.add_triangle(before.vertex, corner.vertex, after.vertex), 1);
    const auto attach = [&](EdgeId e, EdgeId side) { net.join(e, net.twin(side), net.mark(side)); };
    attach(TriangleNet::next(opposite), before.side);
    attach(TriangleNet::previous(opposite), corner.side);
    net.join(opposite, opposite, held);
    before.side = opposite;
    before.next = corner.next;
    after.previous = corner.previous;
    corner.cut = true;
    waiting_.push_back(corner.previous);
    waiting_.push_back(corner.next);
}

// The ears of one polygon do not affect those of the other one. The segment itself, the side of the last ear
// of each polygon, has a mark of its own by now.
void Corridor::return_ears(TriangleNet &net, TriangleId first_ear) {
    for (TriangleId t = net.size() - 1; t >= first_ear; --t) {
        if (const EdgeId e = TriangleNet::edge_of(t, 1); net.mark(e) == held) {
            net.set_mark(e, TriangleNet::unmarked);
            flips_.run_beyond(net, e);
        }
    }
}

} // namespace nrb::mesh
