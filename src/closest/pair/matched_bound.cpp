// SPDX-License-Identifier: MIT
#include "closest/pair/matched_bound.h"

#include "base/numbers.h"
#include "bernstein/rounded_polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

// A polynomial whose coefficients are exact.
RoundedPolynomial exact_polynomial(const BernsteinShape &shape, std::vector<double> values) {
    RoundedPolynomial p;
    p.shape = shape;
    p.errors.resize(values.size());
    p.values = std::move(values);
    return p;
}

// Components [first, first + count) of the records of a piece.
RoundedPolynomial part_of(const pieces::BezierPiece &piece, int first, int count) {
    BernsteinShape shape = piece.shape();
    shape.width = count;
    std::vector<double> values;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        values.insert(values.end(), piece.record(i) + first, piece.record(i) + first + count);
    }
    return exact_polynomial(shape, std::move(values));
}

// The multilinear map from x to y, whose values at the corners of x are the given places.
struct Map {
    std::vector<RoundedPolynomial> low, high; // for each axis of y: 1 - u, and u
};

// Lowers the degree from 1 to 0 along the axes along which the corner values do not change.
void drop_constant_axes(BernsteinShape &shape, std::vector<double> &values) {
    size_t inner = 1;
    for (size_t k = max_axes; k-- > 0;) {
        if (shape.degrees[k] == 0) {
            continue;
        }
        bool same = true;
        std::vector<double> lower;
        for (size_t i = 0; i < values.size(); ++i) {
            if (i / inner % 2 == 0) {
                same = same && values[i] == values[i + inner];
                lower.push_back(values[i]);
            }
        }
        if (same) {
            shape.degrees[k] = 0;
            values = std::move(lower);
        } else {
            inner *= 2;
        }
    }
}

Map map_of(const pieces::BezierPiece &x, const pieces::BezierPiece &y,
           const std::vector<pieces::LocalParam> &corners) {
    BernsteinShape cube;
    for (int k = 0; k < x.axes(); ++k) {
        cube.degrees[static_cast<size_t>(max_axes - x.axes() + k)] = x.degree(k) > 0 ? 1 : 0;
    }
    Map map;
    for (size_t k = 0; k < static_cast<size_t>(y.axes()); ++k) {
        BernsteinShape shape = cube;
        std::vector<double> u, rest;
        for (const pieces::LocalParam &corner : corners) {
            u.push_back(corner[k]);
        }
        drop_constant_axes(shape, u);
        for (const double place : u) {
            rest.push_back(1 - place);
        }
        map.high.push_back(exact_polynomial(shape, std::move(u)));
        map.low.push_back(exact_polynomial(shape, std::move(rest)));
        std::fill(map.low.back().errors.begin(), map.low.back().errors.end(),
                  std::numeric_limits<double>::epsilon());
    }
    return map;
}

// de Casteljau's algorithm for y with polynomials as parameters, from the last axis to the first.
RoundedPolynomial composition(const pieces::BezierPiece &y, const Map &map) {
    std::vector<RoundedPolynomial> net;
    BernsteinShape point;
    point.width = y.dim() + 1;
    for (int64_t i = 0; i < y.coefficients(); ++i) {
        net.push_back(exact_polynomial(point, {y.record(i), y.record(i) + point.width}));
    }
    for (int k = y.axes(); k-- > 0;) {
        const auto at = static_cast<size_t>(k);
        const int degree = y.degree(k);
        std::vector<RoundedPolynomial> next;
        for (auto row = net.begin(); row != net.end(); row += degree + 1) {
            for (int level = degree; level > 0; --level) {
                for (int i = 0; i < level; ++i) {
                    row[i] = row[i] * map.low[at] + row[i + 1] * map.high[at];
                }
            }
            next.push_back(std::move(*row));
        }
        net = std::move(next);
    }
    return std::move(net.front());
}

// Components [first, first + count).
RoundedPolynomial components(const RoundedPolynomial &a, int first, int count) {
    std::vector<RoundedPolynomial> parts;
    for (int c = first; c < first + count; ++c) {
        parts.push_back(component(a, c));
    }
    return side_by_side(parts);
}

double largest_quotient_of(const RoundedPolynomial &numerator, const RoundedPolynomial &denominator) {
    const auto width = static_cast<size_t>(numerator.shape.width);
    double largest = 0;
    for (size_t i = 0; i < denominator.values.size(); ++i) {
        double square = 0;
        for (size_t c = i * width; c < (i + 1) * width; ++c) {
            const double x = std::abs(numerator.values[c]) + numerator.error(c);
            square += x * x;
        }
        const double w = denominator.values[i] - denominator.error(i);
        if (!(w > 0)) {
            return infinity;
        }
        largest = std::max(largest, std::sqrt(square) / w);
    }
    return largest * (1 + 1e-14 * static_cast<double>(width + 4));
}

// The most multiply-adds of one bound, some tenths of a second: the limit of work is tested only between
// bounds.
constexpr int64_t most_work = 1000000000;

// The shape of the composition of y with a map that is linear along each axis of x.
BernsteinShape shape_of_image(const pieces::BezierPiece &x, const pieces::BezierPiece &y) {
    int degree = 0;
    for (int k = 0; k < y.axes(); ++k) {
        degree += y.degree(k);
    }
    BernsteinShape shape = x.shape();
    for (int &along : shape.degrees) {
        along = along > 0 ? degree : 0;
    }
    return shape;
}

// Whether the denominators of x and y have no zeros, and the difference of x and the image takes no more than
// the limit of work.
bool are_comparable(const pieces::BezierPiece &x, const pieces::BezierPiece &y) {
    return x.positive() && y.positive() && shape_of_image(x, y).values() * x.coefficients() <= most_work;
}

// A bound on the same quotient from the Bernstein coefficients of its square, which do not change when the
// vectors rotate: they are all equal for concentric arcs.
double largest_norm_of(const RoundedPolynomial &numerator, const RoundedPolynomial &denominator) {
    if (numerator.shape.values() * numerator.shape.coefficients() > most_work) {
        return infinity;
    }
    const RoundedPolynomial squares = dot(numerator, numerator), weights = denominator * denominator;
    double largest = 0;
    for (size_t i = 0; i < squares.values.size(); ++i) {
        const double w = weights.values[i] - weights.error(i);
        if (!(w > 0)) {
            return infinity;
        }
        largest = std::max(largest, (squares.values[i] + squares.error(i)) / w);
    }
    return std::sqrt(largest) * (1 + 1e-15);
}

} // namespace

std::vector<pieces::LocalParam> MatchedBound::corners_of(const pieces::BezierPiece &x) {
    std::vector<pieces::LocalParam> corners;
    std::array<int, max_axes> ends{0, 0, 0};
    for (int k = 0; k < x.axes(); ++k) {
        ends[static_cast<size_t>(k)] = x.degree(k) > 0 ? 1 : 0;
    }
    for (int i = 0; i <= ends[0]; ++i) {
        for (int j = 0; j <= ends[1]; ++j) {
            for (int k = 0; k <= ends[2]; ++k) {
                corners.push_back({double(i), double(j), double(k)});
            }
        }
    }
    return corners;
}

std::vector<pieces::LocalParam> MatchedBound::corners(const pieces::BezierPiece &x,
                                                      const pieces::BezierPiece &y,
                                                      const pieces::LocalParam &guess) {
    if (!are_comparable(x, y)) {
        return {};
    }
    std::vector<pieces::LocalParam> corners = corners_of(x);
    for (pieces::LocalParam &corner : corners) {
        jet_.evaluate(x, corner, false);
        PairPlace at;
        at.b = guess;
        descent_.run(pieces::BezierPiece(jet_.value(), x.dim()), y, at);
        corner = at.b;
    }
    return corners;
}

double MatchedBound::upper(const pieces::BezierPiece &x, const pieces::BezierPiece &y,
                           const std::vector<pieces::LocalParam> &corners, double enough) {
    if (corners.empty() || !are_comparable(x, y)) {
        return infinity;
    }
    const int dim = x.dim();
    const RoundedPolynomial image = composition(y, map_of(x, y, corners));
    const RoundedPolynomial points = part_of(x, 0, dim), w = part_of(x, dim, 1), v = component(image, dim);
    const RoundedPolynomial difference = points * v - components(image, 0, dim) * w;
    const RoundedPolynomial weights = v * w;
    const double moved = x.moved() + y.moved(), most = largest_quotient_of(difference, weights) + moved;
    return most <= enough ? most : std::min(most, largest_norm_of(difference, weights) + moved);
}

} // namespace nrb::closest
