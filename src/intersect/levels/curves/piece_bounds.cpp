// SPDX-License-Identifier: MIT
#include "intersect/levels/curves/piece_bounds.h"

#include "base/numbers.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t lanes = 4;

size_t step_along(const std::array<int, 2> &degrees, size_t axis, size_t width) noexcept {
    return axis == 0 ? (static_cast<size_t>(degrees[1]) + 1) * width : width;
}

// degree (next + sign this) of neighbours along an axis. Precondition: a degree of 1 or more.
std::vector<double> of_neighbours(const std::array<int, 2> &degrees, size_t width, size_t axis, double sign,
                                  const std::vector<double> &values) {
    const size_t step = step_along(degrees, axis, width), degree = static_cast<size_t>(degrees[axis]),
                 line = step * (degree + 1);
    std::vector<double> result;
    result.reserve(values.size() - values.size() / (degree + 1));
    for (size_t i = 0; i < values.size(); ++i) {
        if (i % line < step * degree) {
            result.push_back(static_cast<double>(degree) * (values[i + step] + sign * values[i]));
        }
    }
    return result;
}

std::vector<double> restricted(std::array<int, 2> degrees, size_t lower_along, size_t width,
                               const std::array<Interval, 2> &box, std::vector<double> values) {
    if (lower_along < 2) {
        --degrees[lower_along];
    }
    restrict_to(degrees, static_cast<int64_t>(width), box, values);
    return values;
}

Vector3 vector_at(const double *record) noexcept {
    return {record[0], record[1], record[2]};
}

// A centre of the points of a part, which is one of them, and how far the others are from it.
struct Hull {
    Vector3 centre{};
    double radius = 0, least_weight = infinity, largest_weight = 0;
};
Hull hull_of(const std::vector<double> &records) noexcept {
    Hull hull;
    for (size_t i = 0; i < records.size(); i += lanes) {
        hull.least_weight = std::min(hull.least_weight, records[i + 3]);
        hull.largest_weight = std::max(hull.largest_weight, std::abs(records[i + 3]));
    }
    if (hull.least_weight > 0) {
        hull.centre = (1 / records[3]) * vector_at(records.data());
        for (size_t i = 0; i < records.size(); i += lanes) {
            const Vector3 point = (1 / records[i + 3]) * vector_at(&records[i]);
            hull.radius = std::max(hull.radius, length(point - hull.centre));
        }
    }
    return hull;
}

} // namespace

void PieceBounds::set(const LevelNet &net, const std::array<int, 2> &degrees, std::vector<double> records) {
    degrees_ = degrees;
    degrees_of_f_ = net.degrees;
    records_ = std::move(records);
    std::vector<double> room(net.values.size());
    for (size_t i = 0; i < room.size(); ++i) {
        room[i] = net.noise.of(net.weight(i));
    }
    for (size_t k = 0; k < 2; ++k) {
        if (degrees_of_f_[k] > 0) {
            slopes_[k] = of_neighbours(degrees_of_f_, 1, k, -1, net.values);
            rooms_[k] = of_neighbours(degrees_of_f_, 1, k, 1, room);
        }
        if (degrees_[k] > 0) {
            moves_[k] = of_neighbours(degrees_, lanes, k, -1, records_);
        }
    }
}

double PieceBounds::least_slope(const std::array<Interval, 2> &box, size_t axis) const {
    const std::vector<double> slopes = restricted(degrees_of_f_, axis, 1, box, slopes_[axis]),
                              rooms = restricted(degrees_of_f_, axis, 1, box, rooms_[axis]);
    double rising = infinity, falling = infinity;
    for (size_t i = 0; i < slopes.size(); ++i) {
        rising = std::min(rising, slopes[i] - rooms[i]);
        falling = std::min(falling, -slopes[i] - rooms[i]);
    }
    return std::max({rising, falling, 0.0});
}

// S_k = ((A_k - c w_k) - (S - c) w_k) / w of the numerator A, about a centre c.
PartBounds PieceBounds::over(const std::array<Interval, 2> &box, size_t axis) const {
    PartBounds bounds;
    const Hull hull = hull_of(restricted(degrees_, 2, lanes, box, records_));
    bounds.least_weight = hull.least_weight;
    bounds.largest_weight = hull.largest_weight;
    bounds.least_slope = degrees_of_f_[axis] > 0 ? least_slope(box, axis) : 0;
    for (size_t k = 0; k < 2; ++k) {
        if (degrees_[k] == 0 || !(hull.least_weight > 0)) {
            continue;
        }
        const std::vector<double> moves = restricted(degrees_, k, lanes, box, moves_[k]);
        for (size_t i = 0; i < moves.size(); i += lanes) {
            const double own = length(vector_at(&moves[i]) - moves[i + 3] * hull.centre);
            bounds.moves[k] = std::max(bounds.moves[k], own + hull.radius * std::abs(moves[i + 3]));
        }
        bounds.moves[k] /= hull.least_weight;
    }
    return bounds;
}

} // namespace nrb::intersect
