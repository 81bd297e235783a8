// SPDX-License-Identifier: MIT
#include "fit/offset/offset_side.h"

#include "base/numbers.h"
#include "bernstein/rounded_polynomial.h"
#include "fit/offset/homogeneous_piece.h"
#include "fit/offset/patch_axis.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::fit {

namespace {

// All numbers between two, after the rounding of what was done to them.
struct Bounds {
    double lower, upper;

    [[nodiscard]] int sign() const noexcept { return lower > 0 ? 1 : upper < 0 ? -1 : 0; }
};

Bounds widened(double lower, double upper) noexcept {
    const double by = 2 * eps * std::max(std::abs(lower), std::abs(upper));
    return by < infinity ? Bounds{lower - by, upper + by} : Bounds{-infinity, infinity};
}
Bounds operator+(Bounds a, Bounds b) noexcept {
    return widened(a.lower + b.lower, a.upper + b.upper);
}
Bounds operator-(Bounds a, Bounds b) noexcept {
    return widened(a.lower - b.upper, a.upper - b.lower);
}
Bounds operator*(Bounds a, Bounds b) noexcept {
    const auto [least, most] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return widened(least, most);
}
// By numbers above 0.
Bounds operator/(Bounds a, Bounds b) noexcept {
    return a * widened(1 / b.upper, 1 / b.lower);
}
Bounds operator*(double s, Bounds a) noexcept {
    return Bounds{s, s} * a;
}

using Box = std::array<Bounds, 3>;

template <class Of>
Box each(Of &&of) {
    return {of(0), of(1), of(2)};
}
Bounds dot(const Box &a, const Box &b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Box cross(const Box &a, const Box &b) {
    return each([&](size_t c) {
        const size_t d = (c + 1) % 3, e = (c + 2) % 3;
        return a[d] * b[e] - a[e] * b[d];
    });
}
Box operator/(const Box &a, Bounds b) {
    return each([&](size_t c) { return a[c] / b; });
}
Vector3 middle_of(const Box &a) noexcept {
    return {a[0].lower / 2 + a[0].upper / 2, a[1].lower / 2 + a[1].upper / 2,
            a[2].lower / 2 + a[2].upper / 2};
}
// Of the lengths; nothing is known if the box is not on one side of a plane.
Bounds length_of(const Box &a) {
    const Vector3 middle = middle_of(a);
    const double l = length(middle);
    if (!(l > 0)) {
        return {0, infinity};
    }
    const Vector3 m = (1 / l) * middle;
    const Box way{Bounds{m.x, m.x}, Bounds{m.y, m.y}, Bounds{m.z, m.z}};
    double most = 0;
    for (const Bounds &x : a) {
        most = std::hypot(most, std::max(-x.lower, x.upper));
    }
    return {dot(a, way).lower * (1 - 8 * eps), most * (1 + 8 * eps)};
}

Bounds bounds_of(const RoundedPolynomial &a, size_t c) noexcept {
    Bounds found{infinity, -infinity};
    for (size_t i = c; i < a.values.size(); i += static_cast<size_t>(a.shape.width)) {
        found = {std::min(found.lower, a.values[i] - a.error(i)),
                 std::max(found.upper, a.values[i] + a.error(i))};
    }
    return widened(found.lower, found.upper);
}

Box box_of(const RoundedPolynomial &a) {
    return each([&](size_t c) { return bounds_of(a, c); });
}

// The points w (x - c) about their middle, and where that x - c lies.
Box move_to_middle(HomogeneousPiece &s) {
    const size_t count = s.weight.values.size();
    Box all;
    for (size_t c = 0; c < 3; ++c) {
        Bounds box{infinity, -infinity};
        for (size_t i = 0; i < count; ++i) {
            const double w = s.weight.values[i], x = s.points.values[3 * i + c];
            box = {std::min(box.lower, x / w), std::max(box.upper, x / w)};
        }
        const double centre = box.lower / 2 + box.upper / 2;
        double error = 0;
        for (size_t i = 0; i < count; ++i) {
            const double w = s.weight.values[i];
            double &x = s.points.values[3 * i + c], &known = s.points.errors[3 * i + c];
            known += std::abs(centre) * (s.weight.error(i) + 2 * eps * w) + 2 * eps * std::abs(x);
            x -= centre * w;
            error = std::max(error, 2 * known / w + 2 * eps * std::abs(x / w));
        }
        all[c] = widened(box.lower - centre - error, box.upper - centre + error);
    }
    return all;
}

constexpr Bounds nothing_known{-infinity, infinity};

// The determinant of I - d II, of the fundamental forms, whose sign is that of (1 - k1 d)(1 - k2 d). Derivatives of S = A / w are
//     S_u = (A_u - S w_u) / w,   S_uv = (A_uv - S_u w_v - S_v w_u - S w_uv) / w
Bounds determinant(HomogeneousPiece s, double distance) {
    const Bounds w = bounds_of(s.weight, 0);
    if (!(w.lower > 0)) {
        return nothing_known;
    }
    const Box x = move_to_middle(s);
    std::array<Box, 2> first;
    std::array<Bounds, 2> slopes{};
    for (const size_t k : {size_t{0}, size_t{1}}) {
        const int axis = static_cast<int>(k) + 1;
        slopes[k] = bounds_of(derivative(s.weight, axis), 0);
        const Box along = box_of(derivative(s.points, axis));
        first[k] = each([&](size_t c) { return (along[c] - x[c] * slopes[k]) / w; });
    }
    const Box across = cross(first[0], first[1]);
    const Bounds area = length_of(across);
    if (!(area.lower > 0)) {
        return nothing_known;
    }
    const Box normal = across / area;
    const auto form = [&](size_t k, size_t l) {
        const int a = static_cast<int>(k) + 1, b = static_cast<int>(l) + 1;
        const Box along = box_of(derivative(derivative(s.points, a), b));
        const Bounds bend = bounds_of(derivative(derivative(s.weight, a), b), 0);
        const Box second = each([&](size_t c) {
            return (along[c] - first[k][c] * slopes[l] - first[l][c] * slopes[k] - x[c] * bend) / w;
        });
        return dot(first[k], first[l]) - distance * dot(second, normal);
    };
    const Bounds mixed = form(0, 1);
    return form(0, 0) * form(1, 1) - mixed * mixed;
}

// How far the points go along an axis.
double extent(const HomogeneousPiece &s, int axis) {
    double largest = 0;
    for (const double x : derivative(s.points, axis).values) {
        largest = std::max(largest, std::abs(x));
    }
    return largest;
}

struct Part {
    HomogeneousPiece piece;
    Bounds determinant;
};

// On the axis along which less remains unknown.
std::array<Part, 2> halves(const HomogeneousPiece &piece, double distance) {
    const auto cut_along = [&](int axis) {
        HomogeneousPiece upper = piece;
        HomogeneousPiece lower{split(upper.points, axis), split(upper.weight, axis)};
        const Bounds below = determinant(lower, distance), above = determinant(upper, distance);
        return std::array<Part, 2>{Part{std::move(lower), below}, Part{std::move(upper), above}};
    };
    const auto unknown = [](const std::array<Part, 2> &parts) {
        double width = 0;
        for (const auto &[piece_of_it, d] : parts) {
            width += d.sign() == 0 ? d.upper - d.lower : 0;
        }
        return width;
    };
    std::array<Part, 2> u = cut_along(1), v = cut_along(2);
    const double of_u = unknown(u), of_v = unknown(v);
    return of_u < of_v || (of_u == of_v && extent(piece, 1) >= extent(piece, 2)) ? std::move(u)
                                                                                 : std::move(v);
}

// The sign on all of a piece, where others have `all`.
int side_on(HomogeneousPiece whole, double distance, int all, int64_t &pieces) {
    const Bounds first = determinant(whole, distance);
    std::vector<Part> rest;
    rest.push_back({std::move(whole), first});
    while (!rest.empty()) {
        const Part part = std::move(rest.back());
        rest.pop_back();
        const int sign = part.determinant.sign();
        if (--pieces < 0 || sign * all < 0) {
            pieces = std::max<int64_t>(pieces, 0);
            return 0;
        }
        if (sign == 0) {
            for (Part &half : halves(part.piece, distance)) {
                rest.push_back(std::move(half));
            }
        }
        all = sign != 0 ? sign : all;
    }
    return all;
}

} // namespace

int offset_side(const SplinePtr &surface, double distance, int64_t &pieces) {
    const std::array<PatchAxis, 2> axes{patch_axis(surface->axis(0)), patch_axis(surface->axis(1))};
    const HomogeneousPieces all(*surface, {axes[0].breaks, axes[1].breaks, {}});
    int side = 0;
    for (int64_t i = 0; i < all.count() && all.positive() && (i == 0 || side != 0); ++i) {
        side = side_on(all.piece(i), distance, side, pieces);
    }
    return side;
}

} // namespace nrb::fit
