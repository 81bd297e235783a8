// SPDX-License-Identifier: MIT
#include "mesh/volume/piece_bend.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"
#include "pieces/slopes.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

using pieces::BezierPiece;

// A ball around the middle of the box of a piece that contains its control points.
struct Ball {
    std::vector<double> centre;
    double radius = 0;
};

Ball ball_of(const BezierPiece &piece) {
    const auto dim = static_cast<size_t>(piece.dim());
    Ball ball{std::vector<double>(dim), 0};
    for (size_t c = 0; c < dim; ++c) {
        ball.centre[c] = piece.lower()[c] / 2 + piece.upper()[c] / 2;
    }
    ball.radius = norm_of(piece.dim(), [&](int c) {
        const auto at = static_cast<size_t>(c);
        return std::max(piece.upper()[at] - ball.centre[at], ball.centre[at] - piece.lower()[at]);
    });
    ball.radius = ball.radius * (1 + 8 * eps) + 4 * eps * piece.reach();
    return ball;
}

// The largest differences along an axis: second ones of A - w c for the centre c, and first and second ones
// of the weights w.
struct Differences {
    double points = 0, weight_step = 0, weight_bend = 0;
};

Differences differences_along(const BezierPiece &piece, int axis, const std::vector<double> &centre) {
    const BernsteinShape &shape = piece.shape();
    const AxisLayers layers = shape.along(max_axes - piece.axes() + axis);
    const int p = piece.degree(axis), dim = piece.dim();
    const int64_t width = shape.width;
    Differences most;
    for (int64_t o = 0; o < layers.outer; ++o) {
        for (int64_t r = 0; r < layers.inner; r += width) {
            const auto record = [&](int i) { return piece.record(0) + layers.at(o, i, r); };
            for (int i = 0; i < p; ++i) {
                most.weight_step = std::max(most.weight_step, std::abs(record(i + 1)[dim] - record(i)[dim]));
            }
            for (int i = 0; i + 1 < p; ++i) {
                const double *a = record(i), *b = record(i + 1), *c = record(i + 2);
                const double w = a[dim] - 2 * b[dim] + c[dim];
                most.weight_bend = std::max(most.weight_bend, std::abs(w));
                most.points = std::max(most.points, norm_of(dim, [&](int x) {
                                           return a[x] - 2 * b[x] + c[x] - w * centre[static_cast<size_t>(x)];
                                       }));
            }
        }
    }
    return most;
}

// A bound on V'' along an axis, from w V'' = A'' - 2 w' V' - w'' V about the centre of the ball.
double second_along(const BezierPiece &piece, int axis, double first, double least, double largest) {
    const Ball ball = ball_of(piece);
    const Differences d = differences_along(piece, axis, ball.centre);
    const double p = piece.degree(axis), noise = 16 * eps * largest;
    const double step = p * d.weight_step, bend = p * (p - 1) * d.weight_bend;
    const double points = p * (p - 1) * (d.points + noise * piece.reach());
    if (step == 0 && bend == 0) {
        return points / least;
    }
    return (points + 2 * first * (step + p * noise) + ball.radius * (bend + p * p * noise)) / least;
}

} // namespace

double PieceBend::bound(const std::array<double, max_axes> &shares) const noexcept {
    double sum = moved;
    for (size_t k = 0; k < second.size(); ++k) {
        sum += second[k] > 0 ? second[k] * shares[k] * shares[k] / 8 : 0;
    }
    return sum * (1 + 32 * eps);
}

PieceBend bend_of(const BezierPiece &piece) {
    PieceBend bend;
    count_work(64 * piece.coefficients() * piece.dim());
    double least = piece.weight(0), largest = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        least = std::min(least, piece.weight(i));
        largest = std::max(largest, piece.weight(i));
    }
    for (int k = 0; k < piece.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        bend.first[at] = bend.second[at] = infinity;
        if (piece.positive()) {
            const pieces::Slopes slopes(piece, k);
            bend.first[at] = (slopes.largest() + slopes.error()) * (1 + 16 * eps);
            bend.second[at] = second_along(piece, k, bend.first[at], least, largest) * (1 + 64 * eps);
        }
    }
    bend.moved = piece.positive() ? piece.moved() : infinity;
    return bend;
}

} // namespace nrb::mesh
