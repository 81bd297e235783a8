// SPDX-License-Identifier: MIT
#include "pieces/derivative_pieces.h"

#include "base/finite.h"
#include "base/representable.h"
#include "refine/forms/weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace nrb::pieces {

namespace {

// A vector polynomial and its weight, or derivatives of both; no weight: it is constant, 1 or 0.
struct Jet1 {
    RoundedPolynomial points;
    std::optional<RoundedPolynomial> weight;
};

Jet1 derivative(const Jet1 &a, int axis) {
    Jet1 result{derivative(a.points, axis), std::nullopt};
    if (a.weight) {
        result.weight = derivative(*a.weight, axis);
    }
    return result;
}

Jet1 jet_of(const HomogeneousPiece &piece) {
    Jet1 jet{piece.points, std::nullopt};
    if (piece.weight.shape.coefficients() > 1) {
        jet.weight = piece.weight;
    }
    return jet;
}

RoundedPolynomial determinant(const RoundedPolynomial &a, const RoundedPolynomial &b,
                              const RoundedPolynomial &c) {
    return dot(cross(a, b), c);
}

// w P x Q + q A x P - p A x Q, where P, p and Q, q are derivatives of A, w.
RoundedPolynomial wedge(const Jet1 &a, const Jet1 &p, const Jet1 &q) {
    RoundedPolynomial first = cross(p.points, q.points);
    if (!a.weight) {
        return first;
    }
    return first * *a.weight +
           (cross(a.points, p.points) * *q.weight - cross(a.points, q.points) * *p.weight);
}

// w [P Q R] - p [A Q R] + q [A P R] - r [A P Q].
RoundedPolynomial wedge(const Jet1 &a, const Jet1 &p, const Jet1 &q, const Jet1 &r) {
    RoundedPolynomial first = determinant(p.points, q.points, r.points);
    if (!a.weight) {
        return first;
    }
    return (first * *a.weight - determinant(a.points, q.points, r.points) * *p.weight) +
           (determinant(a.points, p.points, r.points) * *q.weight -
            determinant(a.points, p.points, q.points) * *r.weight);
}

RoundedPolynomial with_sign(const HomogeneousPiece &piece, RoundedPolynomial numerator) {
    return piece.positive ? std::move(numerator) : numerator * piece.weight;
}

// (A, w) and (-A, -w) represent the same piece.
void make_positive(HomogeneousPiece &piece) {
    const int sign = certain_sign(piece.weight);
    if (sign < 0) {
        piece.points = scaled(std::move(piece.points), -1);
        piece.weight = scaled(std::move(piece.weight), -1);
    }
    piece.positive = sign != 0;
}

// The control point of largest weight where weights differ, so that it does not contribute to the rounding;
// else the middle.
std::vector<double> local_centre(const Spline &spline) {
    if (spline.form() != Form::rational) {
        return centre_of(spline);
    }
    const auto heaviest = std::max_element(spline.weights().begin(), spline.weights().end());
    const auto at = static_cast<size_t>(heaviest - spline.weights().begin()),
               dim = static_cast<size_t>(spline.dim());
    const auto point = spline.points().subspan(at * dim, dim);
    return {point.begin(), point.end()};
}

// The magnitudes to which records and their combinations are accurate, in units of BernsteinNet::error(). For
// Cartesian points they are the magnitudes of the values, since x - c is; for homogeneous points those of A
// and of w c, which their sizes bound.
CentredRecords magnitudes_of(const CentredRecords &records, Form form) {
    CentredRecords sizes = records;
    const auto width = static_cast<size_t>(records.width), dim = width - (records.weighted ? 1 : 0);
    for (size_t i = 0; i < sizes.values.size(); ++i) {
        double &x = sizes.values[i];
        x = std::abs(x);
        if (form == Form::homogeneous && i % width < dim) {
            x += records.sizes[i / width] * std::abs(records.values[i - i % width + dim]);
        }
    }
    return sizes;
}

} // namespace

double HomogeneousPiece::parameter(int k, double place) const noexcept {
    const Interval range = part[static_cast<size_t>(k)];
    return place == 1 ? range.upper
                      : std::clamp(range.lower * (1 - place) + range.upper * place, range.lower, range.upper);
}

PieceMaker::PieceMaker(const Spline &spline, const Part &part) : PieceMaker(spline, part, {}) {}

PieceMaker::PieceMaker(const Spline &spline, const Part &part, std::vector<double> centre)
    : spline_(spline), weighted_(spline.rational() && !refine::equal_weights(spline)),
      centre_(std::move(centre)) {
    for (size_t k = 0; k < static_cast<size_t>(spline.axes()); ++k) {
        breaks_[k] = breaks_in(spline.axis(static_cast<int>(k)), part[k]);
    }
}

int64_t PieceMaker::count() const noexcept {
    int64_t total = 1;
    for (int k = 0; k < spline_.axes(); ++k) {
        total *= count(k);
    }
    return total;
}

// The control points that are active on a span, over their knots.
Spline PieceMaker::sub_spline(const std::array<int64_t, max_axes> &spans) const {
    Spline::Axes axes;
    std::array<int64_t, max_axes> first{}, counts{1, 1, 1}, sizes{1, 1, 1};
    for (int k = 0; k < spline_.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const KnotVector &axis = spline_.axis(k);
        const int p = axis.degree();
        first[at] = spans[at] - p;
        counts[at] = p + 1;
        sizes[at] = axis.count();
        const auto knots =
            axis.knots().subspan(static_cast<size_t>(first[at]), static_cast<size_t>(2 * p + 2));
        axes.push_back(
            std::make_shared<const KnotVector>(p, std::vector<double>(knots.begin(), knots.end())));
    }
    const auto width = static_cast<size_t>(spline_.stored_width());
    std::vector<double> points, weights;
    for (int64_t i = 0; i < counts[0]; ++i) {
        for (int64_t j = 0; j < counts[1]; ++j) {
            for (int64_t l = 0; l < counts[2]; ++l) {
                const auto at =
                    static_cast<size_t>(((first[0] + i) * sizes[1] + first[1] + j) * sizes[2] + first[2] + l);
                const auto record = spline_.points().subspan(at * width, width);
                points.insert(points.end(), record.begin(), record.end());
                if (spline_.form() == Form::rational) {
                    weights.push_back(spline_.weights()[at]);
                }
            }
        }
    }
    return {std::move(axes), spline_.dim(), spline_.form(), std::move(points), std::move(weights)};
}

HomogeneousPiece PieceMaker::piece(int64_t index) const {
    HomogeneousPiece piece;
    std::array<int64_t, max_axes> spans{};
    std::array<int, max_axes> degrees{};
    BernsteinNet::Breaks ends;
    piece.first_axis = max_axes - spline_.axes();
    for (int k = spline_.axes(); k-- > 0; index /= count(k)) {
        const auto at = static_cast<size_t>(k), e = static_cast<size_t>(index % count(k));
        ends[at] = {breaks_[at][e], breaks_[at][e + 1]};
        piece.part[at] = {ends[at][0], ends[at][1]};
        spans[at] = spline_.axis(k).find_span(ends[at][0], false);
        degrees[at] = spline_.axis(k).degree();
    }
    const Spline sub = sub_spline(spans);
    const bool homogeneous = sub.form() == Form::homogeneous;
    const bool weighted = weighted_ || homogeneous;
    piece.centre = centre_.empty() ? local_centre(sub) : centre_;
    piece.weight_exponent = weighted ? weight_exponent(sub) : 0;
    const CentredRecords records = centred_records(sub, piece.centre, weighted, piece.weight_exponent);
    const BernsteinNet net(sub, records, ends, degrees),
        sizes(sub, magnitudes_of(records, sub.form()), ends, degrees);
    piece.positive = !weighted || net.positive();

    RoundedPolynomial &points = piece.points, &weight = piece.weight;
    points.shape = weight.shape = net.shape();
    points.shape.width = sub.dim();
    weight.shape.width = 1;
    points.values.resize(static_cast<size_t>(points.shape.values()));
    weight.values.resize(weighted ? static_cast<size_t>(weight.shape.values()) : 0);
    points.errors = points.values;
    weight.errors = weight.values;
    net.copy(0, points.values.data(), weight.values.data());
    sizes.copy(0, points.errors.data(), weight.errors.data());
    const double largest = largest_magnitude(points.values);
    piece.exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
    for (double &x : weight.errors) {
        x *= 1.01 * net.error();
    }
    for (size_t i = 0; i < points.values.size(); ++i) {
        points.values[i] = std::ldexp(points.values[i], -piece.exponent);
        points.errors[i] = std::ldexp(1.01 * net.error() * points.errors[i], -piece.exponent);
    }
    require_representable(points.values, "Bernstein coefficients");
    require_representable(points.errors, "Bernstein coefficients");
    if (!weighted) {
        weight = constant(1);
    } else if (!piece.positive) {
        make_positive(piece);
    }
    return piece;
}

RoundedPolynomial tangent_numerator(const HomogeneousPiece &piece, int k) {
    const Jet1 a = jet_of(piece), d = derivative(a, piece.axis(k));
    return a.weight ? d.points * *a.weight - a.points * *d.weight : d.points;
}

RoundedPolynomial normal_numerator(const HomogeneousPiece &piece) {
    const Jet1 a = jet_of(piece);
    return with_sign(piece, wedge(a, derivative(a, piece.axis(0)), derivative(a, piece.axis(1))));
}

RoundedPolynomial volume_numerator(const HomogeneousPiece &piece) {
    const Jet1 a = jet_of(piece);
    return wedge(a, derivative(a, piece.axis(0)), derivative(a, piece.axis(1)), derivative(a, piece.axis(2)));
}

RoundedPolynomial bend_numerator(const HomogeneousPiece &piece) {
    const Jet1 a = jet_of(piece), d = derivative(a, piece.axis(0));
    return with_sign(piece, wedge(a, d, derivative(d, piece.axis(0))));
}

RoundedPolynomial twist_numerator(const HomogeneousPiece &piece) {
    const Jet1 a = jet_of(piece), d = derivative(a, piece.axis(0)), dd = derivative(d, piece.axis(0));
    return wedge(a, d, dd, derivative(dd, piece.axis(0)));
}

} // namespace nrb::pieces
