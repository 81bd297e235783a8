// SPDX-License-Identifier: MIT
// The window of knots and layers around a removable knot: the cost of its removal, and the layers after it.
#include "reduce/knot_removal_greedy.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "numeric/norm.h"
#include "reduce/layers.h"

#include <algorithm>
#include <cmath>

namespace nrb::reduce {

// The homogeneous points at one place of the layers of a window.
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
    // The point of largest weight.
    [[nodiscard]] double centre(int c) const noexcept { return record(heaviest_)[c] / weight(heaviest_); }
    // The largest distance from there to any other point of positive weight.
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
    // An estimate of the least denominator: the least weight or, if that is 0, the least mean with both
    // neighbours.
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

// Also counts the copies of the knot; returns the layer whose support begins degree knots before it.
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
            window.after = degree_ + 1; // a jump affects one more knot
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

// How large the gap of the weights may be from their rounding alone.
double GreedyKnotRemoval::gap_rounding(const Window &window, const Column &column) const noexcept {
    double sum = 0;
    for (int i = 0; i < window.size; ++i) {
        sum += (window.multiplicity > degree_ ? 0.5 : std::abs(window.step.functional[i])) * column.weight(i);
    }
    return rounding_of_zero * sum;
}

// |D - f E| / v, where D and E are the changes of points and weights, f is a point of the spline and v its
// weight.
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

// The rounding level of the points of the window: what removing an inserted knot may cost.
double GreedyKnotRemoval::rounding(const Window &window) const noexcept {
    double largest = 0;
    for (int64_t at = 0; at < length_; at += width_) {
        if (!inert_.empty() && inert_[static_cast<size_t>(at / width_)] != 0) {
            continue;
        }
        for (int i = 0; i < window.size; ++i) {
            const double *record = window.points[i] + at;
            const int dim = width_ - (spline_.rational() ? 1 : 0);
            const double weight = spline_.rational() && record[dim] > 0 ? record[dim] : 1;
            largest = std::max(largest, largest_magnitude({record, static_cast<size_t>(dim)}) / weight);
        }
    }
    return 64 * eps * largest;
}

// Whether all weights of a new layer are allowed; weights that are 0 up to rounding become 0.
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

// Computes the layers of the window; false if a weight would not be allowed.
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

} // namespace nrb::reduce
