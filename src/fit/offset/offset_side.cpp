// SPDX-License-Identifier: MIT
#include "fit/offset/offset_side.h"

#include "bernstein/rounded_polynomial.h"
#include "fit/offset/bounds_box.h"
#include "fit/offset/homogeneous_piece.h"
#include "fit/offset/patch_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::fit {

namespace {

using boxes::Bounds;
using boxes::Box;

Bounds bounds_of(const RoundedPolynomial &a, size_t c) noexcept {
    Bounds found{infinity, -infinity};
    for (size_t i = c; i < a.values.size(); i += static_cast<size_t>(a.shape.width)) {
        found = {std::min(found.lower, a.values[i] - a.error(i)),
                 std::max(found.upper, a.values[i] + a.error(i))};
    }
    return boxes::widened(found.lower, found.upper);
}

Box box_of(const RoundedPolynomial &a) {
    return boxes::each([&](size_t c) { return bounds_of(a, c); });
}

// Moves the points w (x - c) to the middle of their box as the new centre c; returns the box of x - c.
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
        all[c] = boxes::widened(box.lower - centre - error, box.upper - centre + error);
    }
    return all;
}

constexpr int64_t most_pieces = 1 << 12;
constexpr int64_t patches_of_a_piece = 4; // that take as much time as a piece

constexpr Bounds nothing_known{-infinity, infinity};

// The determinant of I - d II with the fundamental forms I and II, whose sign is that of
// (1 - k1 d)(1 - k2 d). The derivatives of S = A / w are
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
        first[k] = boxes::each([&](size_t c) { return (along[c] - x[c] * slopes[k]) / w; });
    }
    const std::optional<Box> normal = boxes::unit_of(cross(first[0], first[1]));
    if (!normal) {
        return nothing_known;
    }
    const auto form = [&](size_t k, size_t l) {
        const int a = static_cast<int>(k) + 1, b = static_cast<int>(l) + 1;
        const Box along = box_of(derivative(derivative(s.points, a), b));
        const Bounds bend = bounds_of(derivative(derivative(s.weight, a), b), 0);
        const Box second = boxes::each([&](size_t c) {
            return (along[c] - first[k][c] * slopes[l] - first[l][c] * slopes[k] - x[c] * bend) / w;
        });
        return dot(first[k], first[l]) - distance * dot(second, *normal);
    };
    const Bounds mixed = form(0, 1);
    return form(0, 0) * form(1, 1) - mixed * mixed;
}

// How far the points extend along an axis.
double extent(const HomogeneousPiece &s, int axis) {
    double largest = 0;
    for (const double x : derivative(s.points, axis).values) {
        largest = std::max(largest, std::abs(x));
    }
    return largest;
}

struct SidePart {
    HomogeneousPiece piece;
    Bounds determinant;
};

// Halves a piece along the axis on which less remains undecided.
std::array<SidePart, 2> halves(const HomogeneousPiece &piece, double distance) {
    const auto cut_along = [&](int axis) {
        HomogeneousPiece upper = piece;
        HomogeneousPiece lower{split(upper.points, axis), split(upper.weight, axis)};
        const Bounds below = determinant(lower, distance), above = determinant(upper, distance);
        return std::array<SidePart, 2>{SidePart{std::move(lower), below}, SidePart{std::move(upper), above}};
    };
    const auto unknown = [](const std::array<SidePart, 2> &parts) {
        double width = 0;
        for (const auto &[piece_of_it, d] : parts) {
            width += d.sign() == 0 ? d.upper - d.lower : 0;
        }
        return width;
    };
    std::array<SidePart, 2> u = cut_along(1), v = cut_along(2);
    const double of_u = unknown(u), of_v = unknown(v);
    return of_u < of_v || (of_u == of_v && extent(piece, 1) >= extent(piece, 2)) ? std::move(u)
                                                                                 : std::move(v);
}

// The sign on all of a piece; 0 if it varies, cannot be told, or is not `all`, that of the other pieces (0:
// there are none).
int side_on(HomogeneousPiece whole, double distance, int all, int64_t &pieces) {
    const Bounds first = determinant(whole, distance);
    std::vector<SidePart> rest;
    rest.push_back({std::move(whole), first});
    while (!rest.empty()) {
        const SidePart part = std::move(rest.back());
        rest.pop_back();
        const int sign = part.determinant.sign();
        if (--pieces < 0 || sign * all < 0) {
            pieces = std::max<int64_t>(pieces, 0);
            return 0;
        }
        if (sign == 0) {
            for (SidePart &half : halves(part.piece, distance)) {
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

int offset_side(const SplinePtr &surface, double distance, const OffsetRule &rule) {
    if (distance == 0) {
        return 1;
    }
    const int64_t most =
        rule.left == nullptr ? most_pieces : std::min(most_pieces, *rule.left / patches_of_a_piece);
    int64_t rest = most;
    const int side = offset_side(surface, distance, rest);
    if (rule.left != nullptr) {
        *rule.left -= patches_of_a_piece * (most - rest);
    }
    return side;
}

// The surface that the curve sweeps along V has the normal C' x V, opposite to V x C'. One of its principal
// curvatures is 0; the other one is that of the curve as seen along V, which also decides about the offset.
int offset_side(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule) {
    const Vector3 &v = offset.reference;
    const int64_t count = curve->point_count();
    const int dim = curve->dim(), width = curve->stored_width();
    const bool homogeneous = curve->form() == Form::homogeneous;
    std::vector<double> points, weights;
    for (int64_t i = 0; i < count; ++i) {
        const double *x = curve->points().data() + i * width, w = homogeneous ? x[dim] : 1;
        const Vector3 from{x[0], x[1], dim == space_dim ? x[2] : 0}, to = from + w * v;
        for (const Vector3 &end : {from, to}) {
            points.insert(points.end(), {end.x, end.y, end.z});
            if (homogeneous) {
                points.push_back(w);
            }
            if (curve->form() == Form::rational) {
                weights.push_back(curve->weight(i));
            }
        }
    }
    const SplinePtr moved = make_result({curve->knot_vectors().front(), make_knot_vector(1, {0, 0, 1, 1})},
                                        space_dim, curve->form(), std::move(points), std::move(weights));
    return offset_side(moved, -offset.distance, rule);
}

} // namespace nrb::fit
