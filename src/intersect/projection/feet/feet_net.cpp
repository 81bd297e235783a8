// SPDX-License-Identifier: MIT
#include "intersect/projection/feet/feet_net.h"

#include "base/limits.h"
#include "base/numbers.h"
#include "bernstein/coarse_products.h"
#include "pieces/slopes.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t most_width = 8;
constexpr int most_divisions = 4; // by the distance from one side

// Components [first, first + count) of the homogeneous control points of a piece with positive weights.
RoundedPolynomial part_of(const pieces::BezierPiece &piece, int first, int count) {
    RoundedPolynomial part{piece.shape(), {}, {}};
    part.shape.width = count;
    const pieces::Rounding &rounding = piece.rounding();
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        for (int c = first; c < first + count; ++c) {
            part.values.push_back(piece.record(i)[c]);
            part.errors.push_back(c == piece.dim() ? rounding.weight
                                                   : rounding.record + piece.weight(i) * rounding.apart);
        }
    }
    return part;
}

bool is_constant(const RoundedPolynomial &weight) noexcept {
    return std::ranges::all_of(weight.values, [&](double w) { return w == weight.values.front(); });
}

// Divides by the distances from all sides along which it vanishes; false: it vanishes identically.
bool divide_sides(RoundedPolynomial &tangent) {
    for (int axis = 1; axis < max_axes; ++axis) {
        for (const bool upper : {false, true}) {
            if (divide_end(tangent, axis, upper, most_divisions) < 0) {
                return false;
            }
        }
    }
    return !vanishes(tangent);
}

struct Largest {
    double value = 0, error = 0;
};

// The largest norm of a coefficient, and a bound of its error.
Largest largest_of(const RoundedPolynomial &a) noexcept {
    const auto wide = static_cast<size_t>(a.shape.width);
    Largest most;
    for (size_t i = 0; i < a.values.size(); i += wide) {
        double square = 0, error = 0;
        for (size_t c = i; c < i + wide; ++c) {
            square += a.values[c] * a.values[c];
            error += a.error(c);
        }
        most = {std::max(most.value, 1.0001 * std::sqrt(square)), std::max(most.error, error)};
    }
    return most;
}

// A . T_k and w T_k of both axes, raised to common degrees.
std::array<RoundedPolynomial, 4> parts_of(const CrossPiece &piece,
                                          const std::array<RoundedPolynomial, 2> &tangents) {
    const RoundedPolynomial points = part_of(piece.piece, 0, 3), weight = part_of(piece.piece, 3, 1);
    const bool weighted = !is_constant(weight);
    std::array<RoundedPolynomial, 4> parts;
    BernsteinShape shape;
    for (size_t k = 0; k < 2; ++k) {
        parts[2 * k] = coarse_dot(points, tangents[k]);
        parts[2 * k + 1] =
            weighted ? coarse_times(tangents[k], weight) : scaled(tangents[k], weight.values.front());
    }
    for (const RoundedPolynomial &part : parts) {
        for (size_t k = 0; k < max_axes; ++k) {
            shape.degrees[k] = std::max(shape.degrees[k], part.shape.degrees[k]);
        }
    }
    for (RoundedPolynomial &part : parts) {
        shape.width = part.shape.width;
        part = coarse_raised(part, shape);
    }
    return parts;
}

FeetNet::Size size_of(const RoundedPolynomial &first, const RoundedPolynomial &others) noexcept {
    const Largest one = largest_of(first), three = largest_of(others);
    return {one.value, three.value, one.error, three.error};
}

} // namespace

std::optional<std::array<RoundedPolynomial, 2>> tangents_of(const CrossPiece &piece) {
    const RoundedPolynomial points = part_of(piece.piece, 0, 3), weight = part_of(piece.piece, 3, 1);
    const bool weighted = !is_constant(weight);
    std::array<RoundedPolynomial, 2> tangents;
    for (int k = 0; k < 2; ++k) {
        RoundedPolynomial &tangent = tangents[static_cast<size_t>(k)];
        const RoundedPolynomial slope = derivative(points, 1 + k);
        tangent = weighted ? coarse_times(slope, weight) - coarse_times(points, derivative(weight, 1 + k))
                           : scaled(slope, weight.values.front());
        if (!divide_sides(tangent)) {
            return std::nullopt;
        }
    }
    return tangents;
}

std::optional<FeetNet> feet_net_of(const CrossPiece &piece) {
    const auto tangents = tangents_of(piece);
    if (!tangents) {
        return std::nullopt;
    }
    const std::array<RoundedPolynomial, 4> parts = parts_of(piece, *tangents);
    const std::array<int, max_axes> &degrees = parts[0].shape.degrees;
    FeetNet net{&piece,
                {degrees[1], degrees[2]},
                most_width,
                {},
                {size_of(parts[0], parts[1]), size_of(parts[2], parts[3])},
                {largest_speed(piece.piece, 0), largest_speed(piece.piece, 1)}};
    for (size_t i = 0; i < parts[0].values.size(); ++i) {
        for (const RoundedPolynomial &part : parts) {
            const auto width = static_cast<size_t>(part.shape.width);
            for (size_t c = 0; c < width; ++c) {
                net.values.push_back(part.values[width * i + c]);
            }
        }
    }
    return net;
}

FeetNet feet_net_of(const pieces::BezierPiece &curve, const CrossPiece &lines) {
    const RoundedPolynomial points = part_of(curve, 0, 3), weight = part_of(curve, 3, 1);
    FeetNet net{&lines, {curve.degree(0), 0}, 4, {}, {}, {largest_speed(curve, 0), 0}};
    for (size_t i = 0; i < weight.values.size(); ++i) {
        net.values.push_back(weight.values[i]);
        for (size_t c = 0; c < 3; ++c) {
            net.values.push_back(-points.values[3 * i + c]);
        }
    }
    net.sizes[0] = size_of(weight, points);
    return net;
}

double largest_speed(const pieces::BezierPiece &piece, size_t axis) {
    const int k = static_cast<int>(axis);
    if (piece.degree(k) == 0) {
        return 0;
    }
    const pieces::Slopes slopes(piece, k);
    return 1.0001 * (slopes.largest() + slopes.error());
}

void evaluate_net(const std::array<int, 2> &degrees, size_t width, const double *net,
                  const std::array<double, 2> &place, double *value,
                  std::array<double *, 2> slopes) noexcept {
    constexpr size_t stride = max_product_degree + 1;
    std::array<std::array<double, 2 * stride>, 2> b;
    const bool sloped = slopes[0] != nullptr;
    for (size_t k = 0; k < 2; ++k) {
        bernstein_functions(degrees[k], place[k], sloped ? 1 : 0, stride, b[k].data());
    }
    for (double *out : {value, slopes[0], slopes[1]}) {
        if (out != nullptr) {
            std::fill_n(out, width, 0.0);
        }
    }
    for (int i = 0; i <= degrees[0]; ++i) {
        std::array<double, most_width> row{}, row_v{};
        for (int j = 0; j <= degrees[1]; ++j, net += width) {
            const double f = b[1][static_cast<size_t>(j)],
                         g = sloped ? b[1][stride + static_cast<size_t>(j)] : 0;
            for (size_t c = 0; c < width; ++c) {
                row[c] += f * net[c];
                row_v[c] += g * net[c];
            }
        }
        const double f = b[0][static_cast<size_t>(i)];
        for (size_t c = 0; c < width; ++c) {
            value[c] += f * row[c];
            if (sloped) {
                slopes[0][c] += b[0][stride + static_cast<size_t>(i)] * row[c];
                slopes[1][c] += f * row_v[c];
            }
        }
    }
}

} // namespace nrb::intersect
