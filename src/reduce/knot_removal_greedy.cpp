// SPDX-License-Identifier: MIT
#include "reduce/knot_removal_greedy.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"
#include "reduce/layers.h"
#include "refine/periodic/period.h"

#include <algorithm>
#include <cmath>

namespace nrb::reduce {

namespace {

constexpr int64_t work_of_a_node = 16; // of a list
constexpr size_t most_in_heap = 8192;

} // namespace

GreedyKnotRemoval::GreedyKnotRemoval(const Spline &spline, int axis, bool forgive_rounding)
    : spline_(spline), axis_index_(axis), axis_(spline.axis(axis)), degree_(axis_.degree()),
      width_(spline.width()), length_(layer_length(spline, axis)), forgive_rounding_(forgive_rounding),
      period_(axis_.periodic() ? axis_.domain().upper - axis_.domain().lower : 0),
      layers_left_(axis_.distinct_layers()), points_(layer_records(spline, axis)) {
    link_knots();
    link_layers();
    note_inert_places();
    gap_.resize(static_cast<size_t>(length_));
    trial_.resize(static_cast<size_t>(length_) * (max_basis + 2));
}

// On a periodic axis, the ring of one period begins with the first copy of the seam, which is never removed.
void GreedyKnotRemoval::link_knots() {
    const auto [lower, upper] = axis_.domain();
    const int64_t seam =
        std::lower_bound(axis_.knots().begin(), axis_.knots().end(), lower) - axis_.knots().begin();
    const int64_t first = axis_.periodic() ? seam : 0;
    const int64_t count = axis_.periodic() ? axis_.distinct_layers() : std::ssize(axis_.knots());
    knots_.reserve(static_cast<size_t>(count));
    count_work(work_of_a_node * count);
    for (int64_t i = 0; i < count; ++i) {
        const double value = axis_[first + i];
        const bool inside = value > lower && value < upper;
        const int64_t layer = axis_.periodic() ? (first + i) % count : i;
        knots_.push_back({value, (i + 1) % count, (i + count - 1) % count, layer, 0, 0, true,
                          inside || (axis_.periodic() && i > 0), true});
    }
}

void GreedyKnotRemoval::link_layers() {
    const int64_t count = axis_.distinct_layers();
    layers_.reserve(static_cast<size_t>(count));
    count_work(work_of_a_node * count);
    for (int64_t i = 0; i < count; ++i) {
        layers_.push_back({(i + 1) % count, (i + count - 1) % count, false, true});
    }
}

// Visits the layers of all other axes, the last axis fastest.
void GreedyKnotRemoval::note_inert_places() {
    std::vector<char> inert{0};
    for (int k = 0; k < spline_.axes(); ++k) {
        if (k == axis_index_) {
            continue;
        }
        const auto [first, end] = spline_.axis(k).active_layers();
        std::vector<char> finer;
        for (const char before : inert) {
            for (int64_t i = 0; i < spline_.count(k); ++i) {
                finer.push_back(before != 0 || i < first || i >= end ? 1 : 0);
            }
        }
        inert = std::move(finer);
    }
    if (std::find(inert.begin(), inert.end(), 1) != inert.end()) {
        inert_ = std::move(inert);
    }
}

bool GreedyKnotRemoval::last_copy(int64_t knot) const noexcept {
    const Knot &at = knots_[static_cast<size_t>(knot)];
    return at.next == head_ || knots_[static_cast<size_t>(at.next)].value > at.value;
}

bool GreedyKnotRemoval::removable(int64_t knot) const noexcept {
    const Knot &at = knots_[static_cast<size_t>(knot)];
    return at.present && at.movable && last_copy(knot);
}

// Leaves the window and the gap for a removal.
double GreedyKnotRemoval::key_of(int64_t knot, Window &window) {
    count_work(4 * length_ * (degree_ + 2));
    return locate(knot, window) ? cost(window) : infinity;
}

void GreedyKnotRemoval::refresh(int64_t knot) {
    Knot &at = knots_[static_cast<size_t>(knot)];
    if (at.stale) {
        Window window;
        at.key = key_of(knot, window);
        at.stale = false;
    }
}

void GreedyKnotRemoval::push(int64_t knot) {
    refresh(knot);
    const Knot &at = knots_[static_cast<size_t>(knot)];
    if (at.key < infinity) {
        std::vector<Candidate> &heap = heap_of(knot);
        heap.push_back({at.key, knot});
        std::push_heap(heap.begin(), heap.end());
    }
}

std::vector<GreedyKnotRemoval::Candidate> &GreedyKnotRemoval::heap_of(int64_t knot) noexcept {
    const auto after = std::upper_bound(heap_starts_.begin(), heap_starts_.end(), knot);
    return heaps_[static_cast<size_t>(after - heap_starts_.begin())];
}

void GreedyKnotRemoval::queue_all() {
    heaps_.assign(1, {});
    heap_starts_.clear();
    int64_t knot = head_;
    do {
        const Knot &at = knots_[static_cast<size_t>(knot)];
        if (removable(knot)) {
            refresh(knot);
            if (heaps_.back().size() == most_in_heap) {
                heaps_.emplace_back();
                heap_starts_.push_back(knot);
            }
            if (at.key < infinity) {
                heaps_.back().push_back({at.key, knot});
            }
        }
        knot = at.next;
    } while (knot != head_);
    for (std::vector<Candidate> &heap : heaps_) {
        std::make_heap(heap.begin(), heap.end());
    }
}

// Removes one after the other the knots whose removal costs no more than rounding, such as knots that were
// inserted; each is examined about once. Knots that carry shape have to wait, since the order of their
// removals matters.
int64_t GreedyKnotRemoval::remove_free(double tolerance) {
    const double most = tolerance / 0x1p20;
    int64_t removed = 0;
    Window window;
    for (int64_t knot = knots_[static_cast<size_t>(head_)].next; knot != head_;) {
        Knot &at = knots_[static_cast<size_t>(knot)];
        const int64_t previous = at.previous;
        bool gone = false;
        if (removable(knot) && (at.stale || at.key <= most)) {
            at.key = key_of(knot, window);
            at.stale = false;
            gone = at.key <= most && at.key < infinity && at.key <= rounding(window) &&
                   remove(knot, window, tolerance);
            removed += gone ? 1 : 0;
        }
        // The previous copy is the last one now.
        knot = gone && previous != head_ && knots_[static_cast<size_t>(previous)].value == at.value ? previous
                                                                                                    : at.next;
    }
    return removed;
}

int64_t GreedyKnotRemoval::run(double tolerance) {
    constexpr double rise = 64; // small enough that the order is about that of a single heap
    int64_t removed = remove_free(tolerance);
    queue_all();
    double dearest = tolerance / 0x1p42;
    do {
        const Phase phase;
        dearest = heaps_.size() == 1 ? tolerance : std::min(rise * dearest, tolerance);
        for (std::vector<Candidate> &heap : heaps_) {
            removed += run(heap, dearest, tolerance);
        }
        if (dearest < tolerance) {
            queue_all(); // in fewer heaps
        }
    } while (dearest < tolerance);
    return removed;
}

// Removes the knots whose cost is at most `dearest`.
int64_t GreedyKnotRemoval::run(std::vector<Candidate> &heap, double dearest, double tolerance) {
    int64_t removed = 0;
    SearchSteps steps;
    while (!heap.empty() && heap.front().key <= dearest) {
        const auto [key, knot] = heap.front();
        std::pop_heap(heap.begin(), heap.end());
        heap.pop_back();
        steps.next(heap.size());
        Knot &at = knots_[static_cast<size_t>(knot)];
        if (!at.present || key != at.key) {
            continue;
        }
        if (at.stale) {
            push(knot);
            continue;
        }
        Window window;
        if (!locate(knot, window)) {
            continue;
        }
        find_gap(window);
        if (remove(knot, window, tolerance)) {
            ++removed;
            if (window.multiplicity > 1 && removable(at.previous)) {
                push(at.previous);
            }
        }
    }
    return removed;
}

// Visits the spans from the first affected one to the last.
template <class Body>
void GreedyKnotRemoval::for_each_span(const Window &window, Body &&body) {
    int64_t knot = window.first_knot;
    for (int i = 0; i < window.after + window.ahead; ++i) {
        Knot &at = knots_[static_cast<size_t>(knot)];
        body(at);
        knot = at.next;
    }
}

// Precondition: gap_ holds the gap of the window.
bool GreedyKnotRemoval::remove(int64_t knot, const Window &window, double tolerance) {
    const double step = knots_[static_cast<size_t>(knot)].key;
    double before = 0;
    for_each_span(window, [&](const Knot &at) { before = std::max(before, at.error); });
    if (!(before + step <= tolerance)) {
        return false;
    }
    if (!solve(window)) {
        return false;
    }
    for_each_span(window, [&](Knot &at) { at.error += step; });
    unlink(knot, window);
    return true;
}

// The support of a layer begins at its knot. Removing the knot at the end of the window and a layer inside it
// shifts the knots between them to the next layers.
void GreedyKnotRemoval::unlink(int64_t knot, const Window &window) noexcept {
    const bool jump = window.multiplicity > degree_;
    const int skipped = jump ? 0 : window.step.skipped;
    Knot &gone = knots_[static_cast<size_t>(knot)];
    int64_t at = gone.previous;
    for (int i = skipped; i < degree_; ++i, at = knots_[static_cast<size_t>(at)].previous) {
        Knot &moved = knots_[static_cast<size_t>(at)];
        moved.layer = layers_[static_cast<size_t>(moved.layer)].next;
    }
    Layer &layer = layers_[static_cast<size_t>(window.layers[skipped + 1])];
    layers_[static_cast<size_t>(layer.previous)].next = layer.next;
    layers_[static_cast<size_t>(layer.next)].previous = layer.previous;
    layer.present = false;
    --layers_left_;
    Knot &before = knots_[static_cast<size_t>(gone.previous)];
    before.error = before.value < gone.value ? std::max(before.error, gone.error) : gone.error;
    before.next = gone.next;
    knots_[static_cast<size_t>(gone.next)].previous = gone.previous;
    gone.present = false;
    int64_t back = gone.previous, front = gone.next;
    for (int i = 0; i < degree_ + 2; ++i) {
        knots_[static_cast<size_t>(back)].stale = knots_[static_cast<size_t>(front)].stale = true;
        back = knots_[static_cast<size_t>(back)].previous;
        front = knots_[static_cast<size_t>(front)].next;
    }
}

void GreedyKnotRemoval::set_errors(std::span<const double> breaks, const std::vector<double> &errors) {
    int64_t knot = head_;
    size_t i = 0;
    do {
        Knot &at = knots_[static_cast<size_t>(knot)];
        const double end =
            at.next == head_ ? axis_.domain().upper : knots_[static_cast<size_t>(at.next)].value;
        at.error = 0;
        for (; i < errors.size() && breaks[i] < end; ++i) {
            at.error = std::max(at.error, errors[i]);
        }
        knot = at.next;
    } while (knot != head_);
}

KnotVectorPtr GreedyKnotRemoval::remaining_axis() const {
    std::vector<double> knots;
    int64_t knot = head_;
    do {
        knots.push_back(knots_[static_cast<size_t>(knot)].value);
        knot = knots_[static_cast<size_t>(knot)].next;
    } while (knot != head_);
    if (!axis_.periodic()) {
        return std::make_shared<const KnotVector>(degree_, std::move(knots));
    }
    const auto p = static_cast<size_t>(degree_), count = knots.size();
    std::vector<double> stored(count + 2 * p + 1);
    std::copy(knots.begin(), knots.end(), stored.begin() + degree_);
    stored[p + count] = axis_.domain().upper;
    refine::continue_knots(stored, p, p + count, count);
    check_periodic_knots(degree_, stored, -1, 0);
    return std::make_shared<const KnotVector>(degree_, std::move(stored), true);
}

SplinePtr GreedyKnotRemoval::result() const {
    KnotVectorPtr axis = remaining_axis();
    // The stored layers begin p before that of the first knot of the ring.
    int64_t layer = knots_[static_cast<size_t>(head_)].layer;
    for (int i = 0; axis_.periodic() && i < degree_; ++i) {
        layer = layers_[static_cast<size_t>(layer)].previous;
    }
    std::vector<LayerSource> sources;
    sources.reserve(static_cast<size_t>(axis->count()));
    for (int64_t l = 0; l < axis->count(); ++l, layer = layers_[static_cast<size_t>(layer)].next) {
        const bool changed = layers_[static_cast<size_t>(layer)].changed;
        sources.push_back({changed ? -1 : layer, points_.data() + layer * length_});
    }
    return spline_of_layers(spline_, axis_index_, std::move(axis), sources);
}

} // namespace nrb::reduce
