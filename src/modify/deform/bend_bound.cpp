// SPDX-License-Identifier: MIT
#include "modify/deform/bend_bound.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "fit/span_samples.h"
#include "numeric/binomial.h"
#include "numeric/norm.h"
#include "pieces/bernstein_net.h"
#include "refine/forms/homogeneous.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::modify {

namespace {

using Series = std::vector<double>; // coefficients from order 0 on, none negative

// Bounds of the Taylor coefficients of a Bernstein polynomial along an axis, at every point of its domain:
// for order j, binomial(p, j) times the largest j-th difference of its coefficients, `values`.
Series taylor_bounds(const BernsteinShape &shape, size_t axis, std::vector<double> values) {
    const int p = shape.degrees[axis];
    int64_t inner = 1;
    for (size_t k = axis + 1; k < shape.degrees.size(); ++k) {
        inner *= shape.degrees[k] + 1;
    }
    const auto size = static_cast<int64_t>(values.size());
    count_work(4 * size * (p + 1));
    Series bounds(static_cast<size_t>(p) + 2, 0.0);
    for (int j = 0; j <= p; ++j) {
        double largest = 0;
        for (int64_t i = 0; i < size; ++i) {
            if (i / inner % (p + 1) <= p - j) { // the last j values of a row are no j-th differences
                largest = std::max(largest, std::abs(values[static_cast<size_t>(i)]));
            }
        }
        bounds[static_cast<size_t>(j)] = binomial(p, j) * largest;
        for (int64_t i = 0; i + inner < size; ++i) {
            values[static_cast<size_t>(i)] =
                values[static_cast<size_t>(i + inner)] - values[static_cast<size_t>(i)];
        }
    }
    return bounds;
}

// The series of numerator / (least - rest), where the constants of numerator and rest are taken as 0.
Series quotient(const Series &numerator, const Series &rest, double least) {
    Series result(numerator.size(), 0.0);
    for (size_t n = 1; n < result.size(); ++n) {
        double sum = numerator[n];
        for (size_t j = 1; j < n; ++j) {
            sum += rest[j] * result[n - j];
        }
        result[n] = sum / least;
    }
    return result;
}

// exp of a series, whose constant is taken as 0.
Series exponential(const Series &series) {
    Series result(series.size(), 0.0);
    result[0] = 1;
    for (size_t n = 1; n < result.size(); ++n) {
        for (size_t j = 1; j <= n; ++j) {
            result[n] += static_cast<double>(j) * series[j] * result[n - j];
        }
        result[n] /= static_cast<double>(n);
    }
    return result;
}

// The Bernstein coefficients of w a, w b and w on one cell.
struct CellPieces {
    BernsteinShape shape;
    std::vector<double> along;
    std::vector<double> across;
    std::vector<double> weights;

    [[nodiscard]] double least_weight() const { return *std::min_element(weights.begin(), weights.end()); }
    // Bounds of a on the cell: its values are means of these quotients (convex hull property).
    [[nodiscard]] Interval range() const {
        Interval range{infinity, -infinity};
        for (size_t i = 0; i < along.size(); ++i) {
            const double a = along[i] / weights[i];
            range = {std::min(range.lower, a), std::max(range.upper, a)};
        }
        return range;
    }
    // A bound of |b| on the cell.
    [[nodiscard]] double reach() const {
        double reach = 0;
        for (size_t i = 0; i < across.size(); ++i) {
            reach = std::max(reach, std::abs(across[i] / weights[i]));
        }
        return reach;
    }
};

// A bound that could not be computed bounds nothing.
double or_infinite(double bound) noexcept {
    return std::isnan(bound) ? infinity : bound;
}

// A bound of the Taylor coefficient of order p + 1 of (w / k + w b) exp(i k a) along an axis.
double remainder_along(const CellPieces &cell, size_t axis, double curvature) {
    const auto [lower, upper] = cell.range();
    const double middle = lower + (upper - lower) / 2;
    std::vector<double> factor(cell.weights), shifted(cell.along);
    for (size_t i = 0; i < factor.size(); ++i) {
        factor[i] = cell.weights[i] / curvature + cell.across[i];
        shifted[i] -= middle * cell.weights[i];
    }
    const Series front = taylor_bounds(cell.shape, axis, std::move(factor)),
                 weight = taylor_bounds(cell.shape, axis, cell.weights);
    Series numerator = taylor_bounds(cell.shape, axis, std::move(shifted));
    for (size_t j = 1; j < numerator.size(); ++j) {
        numerator[j] += (upper - lower) / 2 * weight[j];
    }
    Series angle = quotient(numerator, weight, cell.least_weight());
    for (double &x : angle) {
        x *= std::abs(curvature);
    }
    const Series back = exponential(angle);
    double sum = 0;
    for (size_t j = 0; j < front.size(); ++j) {
        sum += front[j] * back[back.size() - 1 - j];
    }
    return sum;
}

class BendBound {
    static constexpr int64_t work_of_a_node = 100; // sines and cosines

public:
    BendBound(const Spline &g, const Spline &image, const Bend &bend)
        : g_(g), bend_(bend), dim_(static_cast<size_t>(g.dim())), width_(dim_ + (g.rational() ? 1 : 0)),
          records_(pieces::centred_records(g, {bend.origin, bend.origin + dim_}, g.rational(), 0)) {
        fit::Places places;
        std::vector<int> degrees;
        for (int k = 0; k < g.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            breaks_[at] = refine::breaks_of(g.axis(k));
            degrees.push_back(g.axis(k).degree());
            places[at] = fit::LocalNodes(degrees.back()).nodes();
        }
        net_ = std::make_unique<pieces::BernsteinNet>(g, records_, breaks_, degrees);
        before_ = fit::sampled(g.rational() ? *refine::to_homogeneous(g) : g, places);
        after_ = fit::sampled(g.rational() ? *refine::to_homogeneous(image) : image, places);
    }

    double run(double tolerance, fit::Cuts &cuts) {
        for (int k = 0; k < g_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            cuts[at].assign(breaks_[at].size() - 1, 0);
        }
        double bound = 0;
        for (int64_t i = 0; i < net_->pieces() && bound < infinity; ++i) {
            count_work(work_of_a_node * net_->shape().coefficients());
            const CellBound cell = cell_bound(i);
            bound = std::max(bound, cell.bound);
            if (cell.crosses && cell.bound > tolerance) {
                mark(i, cuts);
            }
        }
        if (rounding_ > tolerance) { // cuts could not lead to a proof
            for (std::vector<char> &spans : cuts) {
                std::fill(spans.begin(), spans.end(), 0);
            }
        }
        return bound;
    }

private:
    [[nodiscard]] CellPieces pieces_of(int64_t piece) const {
        const BernsteinShape &shape = net_->shape();
        const auto count = static_cast<size_t>(shape.coefficients());
        CellPieces cell{shape, {}, {}, std::vector<double>(count, 1.0)};
        cell.along.reserve(count);
        cell.across.reserve(count);
        std::vector<double> coordinates(count * dim_);
        net_->copy(piece, coordinates.data(), cell.weights.data());
        for (size_t i = 0; i < count; ++i) {
            double a = 0, b = 0;
            for (size_t c = 0; c < dim_; ++c) {
                a += coordinates[i * dim_ + c] * bend_.along[c];
                b += coordinates[i * dim_ + c] * bend_.across[c];
            }
            cell.along.push_back(a);
            cell.across.push_back(b);
        }
        return cell;
    }

    struct CellBound {
        double bound;
        bool crosses; // an end of the bent part
    };

    void mark(int64_t piece, fit::Cuts &cuts) const noexcept {
        for (int k = g_.axes(); k-- > 0;) {
            std::vector<char> &spans = cuts[static_cast<size_t>(k)];
            spans[static_cast<size_t>(piece % std::ssize(spans))] = 1;
            piece /= std::ssize(spans);
        }
    }

    // A bound of the distance on a cell apart from the remainder, from the formula of one part.
    double nodes_bound(const CellPieces &cell, int64_t piece, BendPart part) {
        const double rounding = rounding_on(cell, piece, part);
        rounding_ = std::max(rounding_, rounding);
        return or_infinite(node_error(piece, part) / cell.least_weight() + rounding);
    }

    // What is rounded are coordinates, also those of the origin and of the end u from which a part goes on,
    // and the angle k u. A turn by that error moves a point that is b + 1 / k off the axis of the bend and
    // goes on straight for a - u. At the nodes all this is multiplied by w, and then divided by the least w.
    [[nodiscard]] double rounding_on(const CellPieces &cell, int64_t piece, BendPart part) const {
        const auto [lower, upper] = cell.range();
        const double u = part == BendPart::bent ? 0 : part == BendPart::before ? bend_.lower : bend_.upper;
        const double beyond = part == BendPart::bent ? 0 : std::max(std::abs(lower - u), std::abs(upper - u));
        const double size = net_->size(piece) + norm(bend_.origin, static_cast<int>(dim_)) + std::abs(u);
        const double ratio =
            *std::max_element(cell.weights.begin(), cell.weights.end()) / cell.least_weight();
        return 4096 * eps * ratio * size * (1 + std::abs(bend_.curvature) * (cell.reach() + beyond));
    }

    CellBound cell_bound(int64_t piece) {
        const CellPieces cell = pieces_of(piece);
        if (!(cell.least_weight() > 0)) {
            return {infinity, false};
        }
        const auto [lower, upper] = cell.range();
        if (upper <= bend_.lower || lower >= bend_.upper) {
            const BendPart part = upper <= bend_.lower ? BendPart::before : BendPart::after;
            return {nodes_bound(cell, piece, part), false};
        }
        const double before = std::max(0.0, bend_.lower - lower), after = std::max(0.0, upper - bend_.upper);
        double bound =
            or_infinite(nodes_bound(cell, piece, BendPart::bent) + remainder(cell) / cell.least_weight() +
                        formula_gap(cell, std::max(before, after)));
        if (before > 0 && after == 0) {
            const double gap = formula_gap(cell, upper - bend_.lower);
            bound = std::min(bound, nodes_bound(cell, piece, BendPart::before) + gap);
        }
        if (after > 0 && before == 0) {
            const double gap = formula_gap(cell, bend_.upper - lower);
            bound = std::min(bound, nodes_bound(cell, piece, BendPart::after) + gap);
        }
        return {bound, before > 0 || after > 0};
    }

    // A bound of the difference between the formulas of two neighbouring parts at points whose a is at most
    // `beyond` past the end between them.
    [[nodiscard]] double formula_gap(const CellPieces &cell, double beyond) const {
        return std::abs(bend_.curvature) * beyond * (cell.reach() + beyond / 2);
    }

    static double lebesgue(int degree) noexcept { return 1 + 2 / std::numbers::pi * std::log(degree + 1.0); }

    [[nodiscard]] double remainder(const CellPieces &cell) const {
        double sum = 0, factor = 1;
        for (size_t axis = 0; axis < cell.shape.degrees.size(); ++axis) {
            const int p = cell.shape.degrees[axis];
            if (p > 0) {
                sum += factor * std::ldexp(remainder_along(cell, axis, bend_.curvature), -2 * p);
                factor *= lebesgue(p);
            }
        }
        return sum;
    }

    // Lambda max |w F(A / w) - B| over the nodes of a cell, with the product of the Lambdas of all axes.
    [[nodiscard]] double node_error(int64_t piece, BendPart part) {
        std::array<int64_t, max_axes> cells{}, sizes{1, 1, 1}, rows{1, 1, 1};
        double factor = 1;
        for (int k = g_.axes(); k-- > 0;) {
            const auto at = static_cast<size_t>(k);
            const int64_t spans = std::ssize(breaks_[at]) - 1;
            sizes[at] = g_.axis(k).degree() + 1;
            rows[at] = spans * sizes[at];
            cells[at] = piece % spans * sizes[at];
            piece /= spans;
            factor *= lebesgue(g_.axis(k).degree());
        }
        double largest = 0;
        for (int64_t i = cells[0]; i < cells[0] + sizes[0]; ++i) {
            for (int64_t j = cells[1]; j < cells[1] + sizes[1]; ++j) {
                for (int64_t k = cells[2]; k < cells[2] + sizes[2]; ++k) {
                    const auto sample = static_cast<size_t>((i * rows[1] + j) * rows[2] + k);
                    largest = std::max(largest, or_infinite(error_at(sample, part)));
                }
            }
        }
        return factor * largest;
    }

    [[nodiscard]] double error_at(size_t sample, BendPart part) {
        const double *const record = before_->points().data() + sample * width_, *const got =
                                                                                     after_->points().data() +
                                                                                     sample * width_;
        const double w = width_ > dim_ ? record[dim_] : 1;
        std::transform(record, record + dim_, point_.begin(), [w](double x) { return x / w; });
        bend_point(bend_, part, point_.data(), image_.data());
        return norm_of(static_cast<int>(dim_), [&](int c) {
            return w * image_[static_cast<size_t>(c)] - got[static_cast<size_t>(c)];
        });
    }

    const Spline &g_;
    const Bend &bend_;
    size_t dim_;
    size_t width_;
    pieces::CentredRecords records_;
    pieces::BernsteinNet::Breaks breaks_;
    std::unique_ptr<pieces::BernsteinNet> net_;
    SplinePtr before_;
    SplinePtr after_;
    std::vector<double> point_ = std::vector<double>(dim_), image_ = point_; // work
    double rounding_ = 0; // the largest bound of it on a cell
};

} // namespace

double bend_bound(const Spline &g, const Spline &image, const Bend &bend, double tolerance, fit::Cuts &cuts) {
    return BendBound(g, image, bend).run(tolerance, cuts);
}

} // namespace nrb::modify
