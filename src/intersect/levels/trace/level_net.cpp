// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/level_net.h"

#include "base/numbers.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// The net as [outer][degree + 1][inner] along an axis.
AxisLayers layers(const LevelNet &net, size_t axis) noexcept {
    return axis == 0 ? AxisLayers{1, net.degrees[0], static_cast<int64_t>(net.columns())}
                     : AxisLayers{static_cast<int64_t>(net.rows()), net.degrees[1], 1};
}

} // namespace

int LevelNet::side(double times) const noexcept {
    bool above = true, below = true;
    for (size_t i = 0; i < values.size(); ++i) {
        const double far = times * noise.of(weight(i));
        above = above && values[i] > far;
        below = below && values[i] < -far;
    }
    return above ? 1 : below ? -1 : 0;
}

bool LevelNet::is_near(double distance) const noexcept {
    for (size_t i = 0; i < values.size(); ++i) {
        if (!(std::abs(values[i]) <= distance * weight(i))) {
            return false;
        }
    }
    return true;
}

bool LevelNet::has_positive_weights() const noexcept {
    return std::ranges::all_of(weights, [this](double w) { return w > least_weight; });
}

double LevelNet::largest_weight() const noexcept {
    return weights.empty() ? 1 : *std::ranges::max_element(weights);
}

LevelNet::Slope LevelNet::slope(size_t axis) const noexcept {
    const size_t step = axis == 0 ? columns() : 1;
    double least = infinity, most = -infinity, room = 0;
    for (size_t i = 0; i < rows(); ++i) {
        for (size_t j = 0; j < columns(); ++j) {
            if ((axis == 0 ? i : j) == static_cast<size_t>(degrees[axis])) {
                continue;
            }
            const size_t at = i * columns() + j;
            const double change = values[at + step] - values[at];
            least = std::min(least, change);
            most = std::max(most, change);
            room = std::max(room, noise.of(weight(at)) + noise.of(weight(at + step)));
        }
    }
    if (!(least <= most)) {
        return {};
    }
    const double size = std::max(std::abs(least), std::abs(most));
    if (least > room) {
        return {1, least - room, size};
    }
    return most < -room ? Slope{-1, -most - room, size} : Slope{0, 0, size};
}

LevelNet LevelNet::take_lower_half(size_t axis) {
    LevelNet lower = *this;
    subdivide(layers(*this, axis), 0.5, values.data(), lower.values.data());
    if (!weights.empty()) {
        subdivide(layers(*this, axis), 0.5, weights.data(), lower.weights.data());
    }
    return lower;
}

LevelNet::Edge LevelNet::edge(size_t axis, int end) const {
    const size_t size = axis == 0 ? columns() : rows(), step = axis == 0 ? 1 : columns();
    const size_t last = axis == 0 ? (rows() - 1) * columns() : columns() - 1;
    const size_t first = end == 0 ? 0 : last;
    Edge edge{{}, {}, noise};
    for (size_t i = 0; i < size; ++i) {
        edge.values.push_back(values[first + i * step]);
        if (!weights.empty()) {
            edge.weights.push_back(weights[first + i * step]);
        }
    }
    return edge;
}

bool LevelNet::Edge::is_hidden() const noexcept {
    for (size_t i = 0; i < values.size(); ++i) {
        if (is_known(i)) {
            return false;
        }
    }
    return true;
}

double LevelNet::Edge::largest_known() const noexcept {
    double largest = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        largest = std::max(largest, known(i));
    }
    return largest;
}

double LevelNet::Edge::value(double place) const {
    std::vector<double> b = values;
    evaluate(static_cast<int>(b.size()) - 1, 1, place, b.data());
    return b.front();
}

LevelNet::Edge LevelNet::Edge::take_lower_half() {
    Edge lower = *this;
    const int degree = static_cast<int>(values.size()) - 1;
    subdivide(degree, 1, 0.5, values.data(), lower.values.data());
    if (!weights.empty()) {
        subdivide(degree, 1, 0.5, weights.data(), lower.weights.data());
    }
    return lower;
}

double LevelNet::value(const std::array<double, 2> &place) const noexcept {
    std::array<double, max_product_degree + 1> across, along;
    bernstein_functions(degrees[0], place[0], across.data());
    bernstein_functions(degrees[1], place[1], along.data());
    double sum = 0;
    for (size_t i = 0; i < rows(); ++i) {
        double row = 0;
        for (size_t j = 0; j < columns(); ++j) {
            row += along[j] * values[i * columns() + j];
        }
        sum += across[i] * row;
    }
    return sum;
}

LevelNet::Point LevelNet::at(const std::array<double, 2> &place) const noexcept {
    constexpr size_t stride = max_product_degree + 1;
    std::array<std::array<double, 2 * stride>, 2> functions; // values, then derivatives
    for (size_t k = 0; k < 2; ++k) {
        bernstein_functions(degrees[k], place[k], 1, stride, functions[k].data());
    }
    Point point{};
    for (size_t i = 0; i < rows(); ++i) {
        double value = 0, slope = 0;
        for (size_t j = 0; j < columns(); ++j) {
            const double c = values[i * columns() + j];
            value += functions[1][j] * c;
            slope += functions[1][stride + j] * c;
        }
        point.value += functions[0][i] * value;
        point.slope[0] += functions[0][stride + i] * value;
        point.slope[1] += functions[0][i] * slope;
    }
    return point;
}

// Each end by de Casteljau's algorithm.
void restrict_to(const std::array<int, 2> &degrees, int64_t width, const std::array<Interval, 2> &box,
                 std::vector<double> &values) {
    std::vector<double> lower(values.size());
    for (size_t k = 0; k < 2; ++k) {
        const AxisLayers all = k == 0 ? AxisLayers{1, degrees[0], (degrees[1] + 1) * width}
                                      : AxisLayers{degrees[0] + 1, degrees[1], width};
        if (box[k].upper < 1) {
            subdivide(all, box[k].upper, values.data(), lower.data());
            std::swap(values, lower);
        }
        if (box[k].lower > 0) {
            subdivide(all, box[k].lower / box[k].upper, values.data(), lower.data());
        }
    }
}

} // namespace nrb::intersect
