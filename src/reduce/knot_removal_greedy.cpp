// SPDX-License-Identifier: MIT
#include "reduce/knot_removal_greedy.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "numeric/norm.h"
#include "reduce/layers.h"
#include "refine/periodic/period.h"

#include <algorithm>
#include <cmath>

namespace nrb::reduce {

// The homogeneous points of one place of the layers of a window.
class GreedyKnotRemoval::Column {
public:
    Column(double *const *layers, int size, int64_t at, int dim) noexcept
        : layers_(layers), size_(size), at_(at), dim_(dim) {
        for (int i = 1; i < size; ++i) {
            heaviest_ = weight(i) > weight(heaviest_) ? i : heaviest_;
        }
    }
    [[nodiscard]] const double *record(int i) const noexcept { return layers_[i] + at_; }
    [[nodiscard]] double weight(int i) const noexcept { return record(i)[dim_]; }
    // The point of the largest weight.
    [[nodiscard]] double centre(int c) const noexcept { return record(heaviest_)[c] / weight(heaviest_); }
    // The distance from there to any other point that has a place.
    [[nodiscard]] double radius() const noexcept {
        const double quick = largest_square();
        if (quick > 1e-280 && quick < 1e300) {
            return std::sqrt(quick);
        }
        double largest = 0;
        for (int i = 0; i < size_; ++i) {
            if (weight(i) > 0) {
                largest = std::max(
                    largest, norm_of(dim_, [&](int c) { return record(i)[c] / weight(i) - centre(c); }));
            }
        }
        return largest;
    }
    // The least value of the denominator: where a weight is 0, about the mean with both its neighbours.
    [[nodiscard]] double least_weight() const noexcept {
        double least = infinity, mean = infinity;
        for (int i = 0; i < size_; ++i) {
            const double before = weight(std::max(i - 1, 0)), after = weight(std::min(i + 1, size_ - 1));
            least = std::min(least, weight(i));
            mean = std::min(mean, before / 4 + weight(i) / 2 + after / 4);
        }
        return least > 0 ? least : mean;
    }

private:
    // The square of the radius, with one division for each point.
    [[nodiscard]] double largest_square() const noexcept {
        const double *middle = record(heaviest_);
        const double shrink = 1 / weight(heaviest_);
        double largest = 0;
        for (int i = 0; i < size_; ++i) {
            if (!(weight(i) > 0)) {
                continue;
            }
            const double *point = record(i);
            const double scale = 1 / weight(i);
            double square = 0;
            for (int c = 0; c < dim_; ++c) {
                const double apart = point[c] * scale - middle[c] * shrink;
                square += apart * apart;
            }
            largest = std::max(largest, square);
        }
        return largest;
    }

    double *const *layers_;
    int size_;
    int64_t at_;
    int dim_;
    int heaviest_ = 0;
};

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
    queue_all();
}

// On a periodic axis the ring of one period, which begins with the first copy of the seam; that copy is never
// removed.
void GreedyKnotRemoval::link_knots() {
    const auto [lower, upper] = axis_.domain();
    const int64_t seam =
        std::lower_bound(axis_.knots().begin(), axis_.knots().end(), lower) - axis_.knots().begin();
    const int64_t first = axis_.periodic() ? seam : 0;
    const int64_t count = axis_.periodic() ? axis_.distinct_layers() : std::ssize(axis_.knots());
    knots_.reserve(static_cast<size_t>(count));
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
    for (int64_t i = 0; i < count; ++i) {
        layers_.push_back({(i + 1) % count, (i + count - 1) % count, false, true});
    }
}

// The layers of every other axis in turn, the last one fastest.
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

// Counts the copies of the knot as well; returns the layer whose support begins degree knots before it.
int64_t GreedyKnotRemoval::collect_knots_before(int64_t knot, Window &window) const noexcept {
    const auto at = [this](int64_t i) -> const Knot & { return knots_[static_cast<size_t>(i)]; };
    double *last = window.knots + max_basis;
    window.last = last;
    *last = at(knot).value;
    window.multiplicity = 1;
    window.after = degree_;
    double shift = 0;
    int64_t back = knot, layer = at(knot).layer;
    for (int i = 1; i <= window.after; ++i) {
        shift -= back == head_ ? period_ : 0;
        back = at(back).previous;
        last[-i] = at(back).value + shift;
        if (last[-i] == *last && ++window.multiplicity > degree_) {
            window.after = degree_ + 1; // a jump reaches one knot farther
        }
        layer = i == degree_ ? at(back).layer : layer;
    }
    if (degree_ == 0) {
        window.after = 1;
        back = at(knot).previous;
    }
    window.first_knot = back;
    return layer;
}

void GreedyKnotRemoval::collect_knots_after(int64_t knot, Window &window) const noexcept {
    window.ahead = std::max(1, degree_ - window.multiplicity + 1);
    double shift = 0;
    int64_t front = knot;
    for (int i = 1; i <= window.ahead; ++i) {
        front = knots_[static_cast<size_t>(front)].next;
        shift += front == head_ ? period_ : 0;
        window.knots[max_basis + i] = knots_[static_cast<size_t>(front)].value + shift;
    }
}

void GreedyKnotRemoval::collect_layers(int64_t first, Window &window) noexcept {
    window.size = window.multiplicity > degree_ ? 2 : degree_ - window.multiplicity + 3;
    int64_t layer = first;
    for (int i = 0; i < window.size; ++i) {
        window.layers[i] = layer;
        window.points[i] = points_.data() + layer * length_;
        layer = layers_[static_cast<size_t>(layer)].next;
    }
}

bool GreedyKnotRemoval::locate(int64_t knot, Window &window) noexcept {
    const int64_t layer = collect_knots_before(knot, window);
    collect_knots_after(knot, window);
    collect_layers(layers_[static_cast<size_t>(layer)].previous, window);
    if (period_ != 0 && layers_left_ < window.size) {
        return false;
    }
    if (window.multiplicity <= degree_) {
        window.step = removal_step(window.last, degree_, window.multiplicity);
    }
    return true;
}

void GreedyKnotRemoval::find_gap(const Window &window) noexcept {
    if (window.multiplicity <= degree_) {
        return removal_gap(window.step, window.points, length_, gap_.data());
    }
    std::transform(window.points[0], window.points[0] + length_, window.points[1], gap_.data(),
                   [](double a, double b) { return a / 2 - b / 2; });
}

// How large the gap of weights may be from their rounding alone.
double GreedyKnotRemoval::gap_rounding(const Window &window, const Column &column) const noexcept {
    double sum = 0;
    for (int i = 0; i < window.size; ++i) {
        sum += (window.multiplicity > degree_ ? 0.5 : std::abs(window.step.functional[i])) * column.weight(i);
    }
    return rounding_of_zero * sum;
}

// |D - f E| / v for the moves D of the points and E of the weights, about a point f.
double GreedyKnotRemoval::column_cost(const Window &window, int64_t at) const noexcept {
    const int dim = width_ - 1;
    const Column column(window.points, window.size, at, dim);
    const double *gap = gap_.data() + at;
    const double radius = column.radius();
    double away = norm_of(dim, [&](int c) { return gap[c] - column.centre(c) * gap[dim]; });
    double turned = std::abs(gap[dim]);
    if (forgive_rounding_) {
        const double none = gap_rounding(window, column);
        const double size = radius + 2 * norm_of(dim, [&](int c) { return column.centre(c); });
        away = std::max(away - none * size, 0.0);
        turned = std::max(turned - none, 0.0);
    }
    const double weight = column.least_weight() - turned;
    const double result = (away + radius * turned) / weight;
    return weight > 0 && !std::isnan(result) ? result : infinity;
}

double GreedyKnotRemoval::cost(const Window &window) noexcept {
    find_gap(window);
    double largest = 0;
    for (int64_t at = 0; at < length_; at += width_) {
        if (!inert_.empty() && inert_[static_cast<size_t>(at / width_)] != 0) {
            continue;
        }
        const double one = spline_.rational() ? column_cost(window, at) : norm(gap_.data() + at, width_);
        if (!(one <= largest)) {
            largest = one;
        }
    }
    return std::isnan(largest) ? infinity : largest;
}

double GreedyKnotRemoval::key_of(int64_t knot) noexcept {
    Window window;
    return locate(knot, window) ? cost(window) : infinity;
}

void GreedyKnotRemoval::push(int64_t knot) {
    Knot &at = knots_[static_cast<size_t>(knot)];
    at.key = key_of(knot);
    at.stale = false;
    if (at.key < infinity) {
        heap_.push_back({at.key, knot});
        std::push_heap(heap_.begin(), heap_.end());
    }
}

void GreedyKnotRemoval::queue_all() {
    heap_.clear();
    for (int64_t i = 0; i < std::ssize(knots_); ++i) {
        Knot &at = knots_[static_cast<size_t>(i)];
        if (removable(i)) {
            at.key = at.stale ? key_of(i) : at.key;
            at.stale = false;
            if (at.key < infinity) {
                heap_.push_back({at.key, i});
            }
        }
    }
    std::make_heap(heap_.begin(), heap_.end());
}

int64_t GreedyKnotRemoval::run(double tolerance) {
    int64_t removed = 0;
    while (!heap_.empty() && heap_.front().key <= tolerance) {
        const auto [key, knot] = heap_.front();
        std::pop_heap(heap_.begin(), heap_.end());
        heap_.pop_back();
        Knot &at = knots_[static_cast<size_t>(knot)];
        if (!at.present || key != at.key) {
            continue;
        }
        if (at.stale) {
            push(knot);
        } else if (remove(knot, tolerance)) {
            ++removed;
        }
    }
    return removed;
}

// Spans from the first affected one to the last.
template <class Body>
void GreedyKnotRemoval::for_each_span(const Window &window, Body &&body) {
    int64_t knot = window.first_knot;
    for (int i = 0; i < window.after + window.ahead; ++i) {
        Knot &at = knots_[static_cast<size_t>(knot)];
        body(at);
        knot = at.next;
    }
}

bool GreedyKnotRemoval::remove(int64_t knot, double tolerance) {
    Window window;
    if (!locate(knot, window)) {
        return false;
    }
    const double step = knots_[static_cast<size_t>(knot)].key;
    double before = 0;
    for_each_span(window, [&](const Knot &at) { before = std::max(before, at.error); });
    if (!(before + step <= tolerance)) {
        return false;
    }
    find_gap(window);
    if (!solve(window)) {
        return false;
    }
    for_each_span(window, [&](Knot &at) { at.error += step; });
    unlink(knot, window);
    return true;
}

// Whether all weights of a new layer are positive; weights that are 0 apart from rounding become 0.
bool GreedyKnotRemoval::clear_rounded_weights(const Window &window, double *layer) const noexcept {
    for (int64_t at = 0; at < length_; at += width_) {
        RecordRounding largest{0, 0};
        for (int i = 0; i < window.size; ++i) {
            const double *record = window.points[i] + at;
            largest.weight = std::max(largest.weight, record[width_ - 1]);
            largest.coordinate =
                std::max(largest.coordinate, largest_magnitude({record, static_cast<size_t>(width_) - 1}));
        }
        const Weight kind =
            clear_rounding(layer + at, width_ - 1,
                           {rounding_of_zero * largest.weight, rounding_of_zero * largest.coordinate});
        if (kind == Weight::negative || (kind == Weight::infinite && spline_.form() == Form::rational)) {
            return false;
        }
    }
    return true;
}

// The layers of the window, unless a weight would be negative.
bool GreedyKnotRemoval::solve(const Window &window) {
    const int size = window.size;
    double *layers[max_basis + 2];
    for (int i = 0; i < size; ++i) {
        layers[i] = trial_.data() + i * length_;
        std::copy_n(window.points[i], length_, layers[i]);
    }
    int skipped = 1;
    if (window.multiplicity > degree_) {
        std::transform(layers[0], layers[0] + length_, layers[1], layers[0],
                       [](double a, double b) { return a / 2 + b / 2; });
    } else {
        remove_layer(window.step, layers, length_, gap_.data());
        skipped = window.step.skipped + 1;
    }
    for (int i = 0; i < size && spline_.rational(); ++i) {
        if (i != skipped && !clear_rounded_weights(window, layers[i])) {
            return false;
        }
    }
    const int first = window.multiplicity > degree_ ? 0 : 1;
    for (int i = first; i < std::max(size - 1, 1); ++i) {
        std::copy_n(layers[i], length_, window.points[i]);
        layers_[static_cast<size_t>(window.layers[i])].changed = true;
    }
    return true;
}

// The support of a layer begins at its knot. When the knot at the end of the window and a layer inside it are
// removed, the knots between belong to the next layers.
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
    if (window.multiplicity > 1 && removable(gone.previous)) {
        push(gone.previous);
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
    queue_all();
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
    for (int64_t l = 0; l < axis->count(); ++l, layer = layers_[static_cast<size_t>(layer)].next) {
        const bool changed = layers_[static_cast<size_t>(layer)].changed;
        sources.push_back({changed ? -1 : layer, points_.data() + layer * length_});
    }
    return spline_of_layers(spline_, axis_index_, std::move(axis), sources);
}

} // namespace nrb::reduce
