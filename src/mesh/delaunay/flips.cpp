// SPDX-License-Identifier: MIT
#include "mesh/delaunay/flips.h"

#include "base/watch.h"

namespace nrb::mesh {

namespace {

constexpr int64_t work_of_an_edge = 20;

// Whether the circle of the triangle beyond an edge contains the apex of the edge. Precondition: the apex is
// not infinite.
bool is_to_flip(const TriangleNet &net, EdgeId e) noexcept {
    return net.mark(e) == TriangleNet::unmarked &&
           net.circle_contains(TriangleNet::triangle_of(net.twin(e)), net.point(net.apex(e)));
}

} // namespace

void StarFlips::run(TriangleNet &net, VertexId v) {
    waiting_.clear();
    const EdgeId start = net.fan_of(v);
    EdgeId e = start;
    do {
        waiting_.push_back(e);
        e = net.next_in_fan(e);
    } while (e != start);
    flip_waiting(net);
}

void StarFlips::run_beyond(TriangleNet &net, EdgeId e) {
    waiting_ = {e};
    flip_waiting(net);
}

void StarFlips::flip_waiting(TriangleNet &net) {
    while (!waiting_.empty()) {
        count_work(work_of_an_edge);
        const EdgeId e = waiting_.back(), other = TriangleNet::previous(net.twin(e));
        waiting_.pop_back();
        if (is_to_flip(net, e)) {
            net.flip(e);
            waiting_.push_back(e);
            waiting_.push_back(other);
        }
    }
}

} // namespace nrb::mesh
