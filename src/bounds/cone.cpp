// SPDX-License-Identifier: MIT
#include "bounds/cone.h"

#include "base/numbers.h"
#include "numeric/norm.h"
#include "pieces/derivative_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace nrb::bounds {

namespace {

constexpr double pi = std::numbers::pi;

using Vector = std::vector<double>;

// The angle between a unit vector and another vector, accurate for angles of any size (W. Kahan).
double angle_between(const double *unit, const double *v, int n) noexcept {
    const double size = norm(v, n);
    const double apart = norm_of(n, [&](int c) { return v[c] / size - unit[c]; });
    const double across = norm_of(n, [&](int c) { return v[c] / size + unit[c]; });
    return 2 * std::atan2(apart, across);
}

// The angle by which rounding may have turned coefficient i; pi if the coefficient may be 0.
double turned(const RoundedPolynomial &a, size_t i, double size) noexcept {
    const auto n = static_cast<size_t>(a.shape.width);
    const double error =
        norm_of(a.shape.width, [&](int c) { return a.error(i * n + static_cast<size_t>(c)); });
    return error < size ? 1.01 * std::asin(std::min(1.0, error / size)) + 8 * eps : pi;
}

// The largest angle between the coefficients and a unit vector, each increased by the angle of its rounding.
// Coefficients that are exactly 0 have no direction.
double largest_angle(const RoundedPolynomial &a, const double *unit) noexcept {
    const int n = a.shape.width;
    double largest = 0;
    for (size_t i = 0; i * static_cast<size_t>(n) < a.values.size(); ++i) {
        const double *v = a.values.data() + i * static_cast<size_t>(n);
        const double size = norm(v, n);
        const double error =
            norm_of(n, [&](int c) { return a.error(i * static_cast<size_t>(n) + static_cast<size_t>(c)); });
        if (size == 0 && error == 0) {
            continue;
        }
        const double reach = angle_between(unit, v, n) + turned(a, i, size);
        largest = reach <= largest ? largest : reach;
    }
    return largest <= pi ? largest : pi;
}

// The unit vector of the sum of the unit vectors of all coefficients; empty if that sum vanishes.
Vector mean_direction(const RoundedPolynomial &a) {
    const auto n = static_cast<size_t>(a.shape.width);
    Vector sum(n, 0.0);
    for (size_t i = 0; i < a.values.size(); i += n) {
        const double size = norm(a.values.data() + i, a.shape.width);
        for (size_t c = 0; c < n && size > 0 && std::isfinite(size); ++c) {
            sum[c] += a.values[i + c] / size;
        }
    }
    const double size = norm(sum.data(), a.shape.width);
    std::for_each(sum.begin(), sum.end(), [size](double &x) { x /= size; });
    return size > 0 && std::isfinite(size) ? sum : Vector();
}

// The numerator with its zeros at ends of the piece divided out.
RoundedPolynomial without_zeros(RoundedPolynomial a) {
    for (int axis = 0; axis < max_axes; ++axis) {
        if (a.shape.degrees[static_cast<size_t>(axis)] > 0 && !vanishes(a)) {
            divide_end(a, axis, false);
            divide_end(a, axis, true);
        }
    }
    return a;
}

using Numerators = std::function<RoundedPolynomial(int64_t)>;

// Branch and bound for the largest angle from a direction.
class AngleProblem {
public:
    struct Piece {
        RoundedPolynomial numerator;
        std::array<int, max_axes> halvings{};
    };
    AngleProblem(const Numerators &source, const Vector &direction, double tolerance)
        : source_(source), direction_(direction), tolerance_(tolerance) {}

    [[nodiscard]] Piece load(int64_t index) const { return {source_(index), {}}; }
    // If all coefficients are within a right angle of the direction, their convex cone is no farther from it
    // than they are. Otherwise the cone is bounded about a direction of its own, and the angle between both
    // directions is added.
    [[nodiscard]] double upper(const RoundedPolynomial &a) const {
        const double about = largest_angle(a, direction_.data());
        if (about < pi / 2) {
            return about;
        }
        const Vector own = mean_direction(a);
        const double inner = own.empty() ? pi : largest_angle(a, own.data());
        const double outer =
            inner < pi / 2 ? inner + angle_between(own.data(), direction_.data(), a.shape.width) : pi;
        return std::min(pi, outer + 4 * eps);
    }
    [[nodiscard]] pieces::Enclosure bounds(const Piece &piece) const {
        return {lower(piece.numerator), upper(piece.numerator)};
    }
    [[nodiscard]] static double noise(const Piece & /*piece*/) noexcept { return 0; }
    [[nodiscard]] static std::optional<Piece> split(Piece &piece) {
        int axis = -1;
        for (int k = 0; k < max_axes; ++k) {
            const auto at = static_cast<size_t>(k);
            const bool fewer = axis < 0 || piece.halvings[at] < piece.halvings[static_cast<size_t>(axis)];
            if (piece.numerator.shape.degrees[at] > 0 && piece.halvings[at] < 30 && fewer) {
                axis = k;
            }
        }
        if (axis < 0 || vanishes(piece.numerator)) {
            return std::nullopt;
        }
        ++piece.halvings[static_cast<size_t>(axis)];
        Piece half{nrb::split(piece.numerator, axis), piece.halvings};
        return half;
    }
    void found(int64_t /*index*/, const Piece & /*piece*/) const noexcept {}
    [[nodiscard]] bool reached(double lower, double upper, double /*noise*/) const noexcept {
        return upper - lower <= tolerance_ || lower >= pi;
    }

private:
    // The largest angle at the corners, where coefficients are values.
    [[nodiscard]] double lower(const RoundedPolynomial &a) const noexcept {
        double largest = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const auto i = static_cast<size_t>(a.shape.corner(corner));
            const double *v = a.values.data() + i * static_cast<size_t>(a.shape.width);
            const double off = turned(a, i, norm(v, a.shape.width));
            if (off < pi) {
                largest = std::max(largest, angle_between(direction_.data(), v, a.shape.width) - off);
            }
        }
        return largest;
    }

    const Numerators &source_;
    const Vector &direction_;
    double tolerance_;
};

double product(const Vector &a, const Vector &b) noexcept {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// The direction whose smallest dot product with the unit vectors is largest: that of the shortest vector of
// their convex hull. The algorithm moves weight from the vector farthest along the current point to the
// vector least far along it (B. Mitchell, V. Demyanov, V. Malozemov, "Finding the point of a polyhedron
// closest to the origin", SIAM J. Control 12 (1974)). Empty if there are no vectors, or if the hull contains
// the origin up to rounding.
Vector middle_direction(const std::vector<Vector> &units) {
    constexpr int most_steps = 500;
    if (units.empty()) {
        return {};
    }
    Vector x = units.front(), weights(units.size(), 0.0), along(units.size());
    weights.front() = 1;
    for (int step = 0; step < most_steps; ++step) {
        size_t least = 0, most = 0;
        double largest = -2;
        for (size_t i = 0; i < units.size(); ++i) {
            along[i] = product(units[i], x);
            least = along[i] < along[least] ? i : least;
            if (weights[i] > 0 && along[i] > largest) {
                most = i;
                largest = along[i];
            }
        }
        const double gain = along[most] - along[least];
        const double square = 2 - 2 * product(units[most], units[least]);
        if (!(gain > 4 * eps) || !(square > 0)) {
            break;
        }
        const double share = std::min(weights[most], gain / square);
        weights[most] = share == weights[most] ? 0 : weights[most] - share;
        weights[least] += share;
        for (size_t c = 0; c < x.size(); ++c) {
            x[c] += share * (units[least][c] - units[most][c]);
        }
    }
    const double size = norm(x.data(), static_cast<int>(x.size()));
    if (!(size > 1e3 * eps)) {
        return {};
    }
    std::for_each(x.begin(), x.end(), [size](double &c) { c /= size; });
    return x;
}

// The unit vectors of all coefficients that have a direction; a sample of them if there are very many.
std::vector<Vector> directions(int64_t pieces, const Numerators &source) {
    constexpr int64_t most_pieces = 1024;
    constexpr size_t most_units = 8192;
    std::vector<Vector> units;
    const int64_t step = pieces / most_pieces + 1;
    for (int64_t e = 0; e < pieces; e += step) {
        const RoundedPolynomial a = source(e);
        const auto n = static_cast<size_t>(a.shape.width);
        for (size_t i = 0; i * n < a.values.size(); ++i) {
            const double *v = a.values.data() + i * n, size = norm(v, a.shape.width);
            if (turned(a, i, size) < pi && units.size() < most_units) {
                units.emplace_back(n);
                std::transform(v, v + n, units.back().begin(), [size](double x) { return x / size; });
            }
        }
    }
    return units;
}

// Where derivatives vanish along lines inside pieces, no number of subdivisions would be enough.
constexpr int most_cone_halvings = 2000;

Cone cone_of(int64_t pieces, int dim, const Numerators &source, double tolerance) {
    Vector direction = middle_direction(directions(pieces, source));
    if (direction.empty()) {
        direction.assign(static_cast<size_t>(dim), 0.0);
        direction[0] = 1;
        return {direction, pi};
    }
    AngleProblem problem(source, direction, tolerance);
    std::vector<double> uppers;
    for (int64_t e = 0; e < pieces; ++e) {
        uppers.push_back(problem.upper(source(e)));
    }
    const pieces::Enclosure found = pieces::BranchAndBound(problem, uppers, 0).run(most_cone_halvings);
    return {direction, std::min(pi, found.upper)};
}

} // namespace

Cone tangent_cone(const Spline &spline, int axis, const Part &part, double tolerance) {
    const pieces::PieceMaker maker(spline, part);
    const Numerators source = [&](int64_t i) {
        return without_zeros(pieces::tangent_numerator(maker.piece(i), axis));
    };
    return cone_of(maker.count(), spline.dim(), source, tolerance);
}

Cone normal_cone(const Spline &spline, const Part &part, double tolerance) {
    const pieces::PieceMaker maker(spline, part);
    const Numerators source = [&](int64_t i) {
        return without_zeros(pieces::normal_numerator(maker.piece(i)));
    };
    return cone_of(maker.count(), spline.dim(), source, tolerance);
}

} // namespace nrb::bounds
