// SPDX-License-Identifier: MIT
#include "recognize/shape_refine.h"

#include "base/numbers.h"
#include "numeric/solvers/small_svd.h"

#include <cmath>

namespace nrb::recognize {

namespace {

constexpr double quarter_turn = 1.5707963267948966;

// The degrees of freedom: motions along and about the axes of the shape's frame, and its sizes.
enum Freedom { move_x, move_y, move_z, turn_x, turn_y, turn_z, first_size, second_size };

std::vector<Freedom> freedoms(int32_t kind) {
    switch (kind) {
    case shape_circle:
        return {move_x, move_y, first_size};
    case shape_ellipse:
    case shape_hyperbola:
        return {move_x, move_y, turn_z, first_size, second_size};
    case shape_parabola:
        return {move_x, move_y, turn_z, first_size};
    case shape_sphere:
        return {move_x, move_y, move_z, first_size};
    case shape_cylinder:
        return {move_x, move_y, turn_x, turn_y, first_size};
    case shape_cone:
        return {move_x, move_y, move_z, turn_x, turn_y, first_size};
    case shape_torus:
        return {move_x, move_y, move_z, turn_x, turn_y, first_size, second_size};
    default:
        return {};
    }
}

Shape moved(const Shape &shape, Freedom freedom, double step) {
    Shape other = shape;
    const Vector3 &x = shape.x, &y = shape.y, &z = shape.z;
    const double c = std::cos(step), s = std::sin(step);
    switch (freedom) {
    case move_x:
        other.origin = shape.origin + step * x;
        break;
    case move_y:
        other.origin = shape.origin + step * y;
        break;
    case move_z:
        other.origin = shape.origin + step * z;
        break;
    case turn_x:
        other.set_frame(c * z - s * y, x);
        break;
    case turn_y:
        other.set_frame(c * z + s * x, c * x - s * z);
        break;
    case turn_z:
        other.set_frame(z, c * x + s * y);
        break;
    case first_size:
        other.sizes[0] += step;
        break;
    case second_size:
        other.sizes[1] += step;
        break;
    }
    return other;
}

Shape moved(const Shape &shape, const std::vector<Freedom> &free, const std::vector<double> &steps,
            double factor) {
    Shape other = shape;
    for (size_t i = 0; i < free.size(); ++i) {
        other = moved(other, free[i], factor * steps[i]);
    }
    return other;
}

bool valid(const Shape &shape) noexcept {
    const bool two =
        shape.kind == shape_ellipse || shape.kind == shape_hyperbola || shape.kind == shape_torus;
    return shape.sizes[0] > 0 && (!two || shape.sizes[1] > 0) &&
           (shape.kind != shape_cone || shape.sizes[0] < quarter_turn);
}

std::vector<double> residuals(const Shape &shape, std::span<const Vector3> points) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vector3 &p : points) {
        values.push_back(signed_distance(shape, shape.local(p)));
    }
    return values;
}

double sum_of_squares(const std::vector<double> &values) noexcept {
    double sum = 0;
    for (const double x : values) {
        sum += x * x;
    }
    return std::isfinite(sum) ? sum : infinity;
}

// The step for difference quotients: small compared to the shape and to the points that it is fitted to.
double trial_step(const Shape &shape, Freedom freedom, double size, double reach) noexcept {
    const bool angle = freedom >= turn_x && freedom <= turn_z;
    const bool opening = freedom == first_size && shape.kind == shape_cone;
    double least = size;
    for (const double length : shape.sizes) {
        least = length > 0 && shape.kind != shape_cone ? std::min(least, length) : least;
    }
    return 1e-6 * (angle || opening ? least / reach : least);
}

// The least-squares step. Columns are scaled to length 1, so that no column is lost among larger ones.
std::vector<double> newton_step(const Shape &shape, const std::vector<Freedom> &free,
                                std::span<const Vector3> points, const std::vector<double> &values) {
    double size = 0, reach = 0;
    for (const Vector3 &p : points) {
        size = std::max(size, length(p));
        reach = std::max(reach, length(p - shape.origin));
    }
    const size_t n = free.size(), m = points.size();
    std::vector<double> rows(m * n), right(m), scales(n);
    for (size_t j = 0; j < n; ++j) {
        const double step = trial_step(shape, free[j], size, reach);
        const auto beside = residuals(moved(shape, free[j], step), points);
        double square = 0;
        for (size_t i = 0; i < m; ++i) {
            rows[i * n + j] = (beside[i] - values[i]) / step;
            square += rows[i * n + j] * rows[i * n + j];
        }
        scales[j] = square > 0 ? 1 / std::sqrt(square) : 0;
        for (size_t i = 0; i < m; ++i) {
            rows[i * n + j] *= scales[j];
        }
    }
    for (size_t i = 0; i < m; ++i) {
        right[i] = -values[i];
    }
    std::vector<double> steps = SmallSvd(rows, static_cast<int>(n), right).solution(1e-11);
    for (size_t j = 0; j < n; ++j) {
        steps[j] *= scales[j];
    }
    return steps;
}

// At most 160 of the points, evenly spaced in their order.
std::vector<Vector3> some_of(std::span<const Vector3> points) {
    const size_t step = (points.size() + 159) / 160;
    std::vector<Vector3> some;
    for (size_t i = 0; i < points.size(); i += step) {
        some.push_back(points[i]);
    }
    return some;
}

} // namespace

Shape refined(const Shape &shape, std::span<const Vector3> points, double tolerance) {
    const std::vector<Freedom> free = freedoms(shape.kind);
    const std::vector<Vector3> some = some_of(points);
    const double enough = tolerance * tolerance * static_cast<double>(some.size());
    Shape best = shape;
    std::vector<double> values = residuals(best, some);
    double sum = sum_of_squares(values);
    int slow = 0;
    for (int round = 0; round < 12 && std::isfinite(sum) && sum > 0 && slow < 2; ++round) {
        const std::vector<double> steps = newton_step(best, free, some, values);
        double reached = sum;
        for (int attempt = 0; attempt < 5 && reached >= sum; ++attempt) {
            const Shape next = moved(best, free, steps, std::ldexp(1.0, -2 * attempt));
            const std::vector<double> fresh = residuals(next, some);
            if (valid(next) && sum_of_squares(fresh) < sum) {
                best = next;
                values = fresh;
                reached = sum_of_squares(fresh);
            }
        }
        if (!(reached < 0.98 * sum)) {
            break;
        }
        slow += reached > enough && reached > sum / 4 ? 1 : 0;
        sum = reached;
    }
    return best;
}

double largest_distance(const Shape &shape, std::span<const Vector3> points) noexcept {
    double largest = 0;
    for (const Vector3 &p : points) {
        const double d = least_distance(shape, shape.local(p));
        if (!(d <= largest)) {
            largest = std::isnan(d) ? infinity : d;
        }
    }
    return largest;
}

} // namespace nrb::recognize
