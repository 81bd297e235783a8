// SPDX-License-Identifier: MIT
#include "refine/compose/compose.h"

#include "base/watch.h"
#include "numeric/sum.h"
#include "refine/algebra/product.h"
#include "refine/compose/axes_under.h"
#include "refine/compose/composed_cell.h"
#include "refine/compose/span_cells.h"
#include "refine/forms/homogeneous.h"
#include "refine/knots/blossom.h"
#include "spline/contract.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <functional>
#include <numeric>

namespace nrb::refine {

namespace {

void check_operands(const Spline &g, const Spline &f) {
    check_kind(f, 1, "f");
    if (f.rational() && !(f.all_weights().smallest > 0)) {
        fail(Status::rational, "f has the weight %s; expected only positive weights, or none",
             Number(f.all_weights().smallest).text);
    }
    if (f.dim() != g.axes()) {
        fail(Status::dimension, "dimension %d of f, expected %d, the number of axes of g", f.dim(), g.axes());
    }
}

int composed_degree(const Spline &g, const Spline &f) {
    int total = 0;
    for (int k = 0; k < g.axes(); ++k) {
        total += g.axis(k).degree();
    }
    const int q = f.axis(0).degree();
    if (total * q > max_degree) {
        fail(Status::degree, "degrees %d of f and %d of g give %d, which exceeds the limit of %d", q, total,
             total * q, max_degree);
    }
    return total * q;
}

// The order of continuity that f and g leave to a spline of degree `degree` between two cells.
int copies_between(const Spline &g, const Spline &f, int degree, const std::vector<CurvePiece> &pieces,
                   const SpanCell &a, const SpanCell &b) noexcept {
    int smooth = degree;
    if (a.piece != b.piece) {
        const int64_t times = pieces[b.piece].span() - pieces[a.piece].span();
        smooth = std::min(smooth, f.axis(0).degree() - static_cast<int>(times));
    }
    for (int k = 0; k < g.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        if (a.spans[at] != b.spans[at]) {
            const int64_t crossed = std::abs(b.spans[at] - a.spans[at]); // knots, as often as they occur
            smooth = static_cast<int>(std::min<int64_t>(smooth, g.axis(k).degree() - crossed));
        }
    }
    return degree - std::max(smooth, -1);
}

using Window = CommonKnots::Window;

constexpr int64_t work_of_a_term = 100; // for each component: arguments, contractions, a compensated sum

class Composer {
public:
    Composer(const Spline &g, const Spline &f, int degree)
        : g_(g), f_(f), degree_(degree), pieces_(pieces_of(f)), axes_(axes_under(g, pieces_)),
          cells_(span_cells(axes_, pieces_)), whole_(axes_, f.axis(0).degree(), g.width()) {
        const auto [lower, upper] = f.axis(0).domain();
        append_knots(lower, degree + 1, 0);
        for (size_t i = 1; i < cells_.size(); ++i) {
            append_knots(cells_[i].start, copies_between(g, f, degree, pieces_, cells_[i - 1], cells_[i]), i);
        }
        append_knots(upper, degree + 1, cells_.size() - 1);
        int64_t length = g.width();
        for (int k = g.axes(); k-- > 0;) {
            lengths_[static_cast<size_t>(k)] = length;
            parts_[static_cast<size_t>(k)].resize(static_cast<size_t>(length));
            length *= g.axis(k).degree() + 1;
        }
        block_.resize(static_cast<size_t>(length));
        sums_.resize(static_cast<size_t>(g.width()));
    }

    SplinePtr run() {
        std::vector<double> records;
        const auto layers = std::ssize(knots_) - degree_ - 1;
        records.reserve(static_cast<size_t>(layers * g_.width()) + Spline::padding);
        Steps steps(layers);
        for (int64_t layer = 0; layer < layers; ++layer, steps.next()) {
            append_layer(layer, records);
        }
        const Form form = has_negative_weight(records) ? Form::homogeneous : g_.form();
        return from_records({make_knot_vector(degree_, knots_)}, g_.dim(), form, std::move(records));
    }

private:
    void append_knots(double t, int copies, size_t cell) {
        knots_.insert(knots_.end(), static_cast<size_t>(copies), t);
        cell_after_.insert(cell_after_.end(), static_cast<size_t>(copies), cell);
    }

    // If polar values of f overshoot its values, weights of the result may overshoot to below 0.
    [[nodiscard]] bool has_negative_weight(const std::vector<double> &records) const noexcept {
        const auto width = static_cast<size_t>(g_.width());
        bool negative = false;
        for (size_t i = width; g_.rational() && i <= records.size(); i += width) {
            negative = negative || records[i - 1] < 0;
        }
        return negative;
    }

    // The cell of the longest span in the support of a layer; the first one if there are several. All spans
    // give the same control point, as far as crossings are known. Next to a piece so short that they are not,
    // the spans outside it count.
    [[nodiscard]] const SpanCell &cell_for(int64_t layer) const noexcept {
        const auto length = [&](int64_t span) {
            return knots_[static_cast<size_t>(span) + 1] - knots_[static_cast<size_t>(span)];
        };
        int64_t best = layer;
        for (int64_t span = layer + 1; span <= layer + degree_; ++span) {
            best = length(span) > length(best) ? span : best;
        }
        return cells_[cell_after_[static_cast<size_t>(best)]];
    }

    // Distinct knots among the arguments of a layer.
    [[nodiscard]] Window window(int64_t layer) noexcept {
        Window window{};
        for (int64_t i = layer + 1; i <= layer + degree_; ++i) {
            const double knot = knots_[static_cast<size_t>(i)];
            if (window.size == 0 || window_knots_[static_cast<size_t>(window.size - 1)] != knot) {
                window_knots_[static_cast<size_t>(window.size++)] = knot;
            }
            ++window.copies[static_cast<size_t>(window.size - 1)];
        }
        return window;
    }

    void append_layer(int64_t layer, std::vector<double> &records) {
        cell_ = &cell_for(layer);
        const Window around = window(layer);
        if (f_.axis(0).degree() > 1 && around.size == 2 && is_cell(window_knots_[0], window_knots_[1])) {
            return append_coefficient(around.copies[1], records);
        }
        load_block(0, 0, block_.data());
        std::ranges::fill(sums_, CompensatedSum{});
        total_ = {};
        terms_ = 0;
        next_axis(0, around, block_.data(), 1);
        for (size_t c = 0; c < sums_.size(); ++c) {
            records.push_back(terms_ == 1 ? only_weight_ * only_[c] : sums_[c].value() / total_.value());
            if (!std::isfinite(records.back())) {
                fail(Status::not_representable, "a new control point overflows double precision");
            }
        }
    }

    // Whether the present cell is that between two knots of the result.
    [[nodiscard]] bool is_cell(double start, double end) const noexcept {
        const SpanCell *const next = cell_ + 1;
        const bool last = next == cells_.data() + cells_.size();
        return cell_->start == start && (last ? f_.axis(0).domain().upper : next->start) == end;
    }

    // Most layers are Bernstein coefficients of their cell, all of which are made at once. Those at the ends of the cell
    // are values of the composition.
    void append_coefficient(int i, std::vector<double> &records) {
        if (made_ != cell_) {
            make_cell();
        }
        for (int c = 0; c < g_.width(); ++c) {
            records.push_back((*coefficients_)[static_cast<size_t>(i * g_.width() + c)]);
            if (!std::isfinite(records.back())) {
                fail(Status::not_representable, "a new control point overflows double precision");
            }
        }
    }

    void make_cell() {
        const auto q = static_cast<size_t>(f_.axis(0).degree());
        const double start = window_knots_[0], end = window_knots_[1];
        const CurvePiece &piece = pieces_[cell_->piece];
        Coefficients weights;
        weights.fill(1);
        if (weighted_) {
            weights = piece.weights_between(start, end);
        }
        CellArguments arguments;
        for (int k = 0; k < g_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            arguments.weights[at] = weights;
            arguments.values[at] = piece.coefficients_between(k, start, end);
            for (const auto &[j, t] : {std::pair(size_t{0}, start), std::pair(q, end)}) {
                double &value = arguments.values[at][j];
                value = snapped(*axes_[at], value, uncertainty_at(k, t));
            }
        }
        load_block(0, 0, block_.data());
        coefficients_ = &whole_.make(block_.data(), cell_->spans, arguments);
        made_ = cell_;
    }

    // The control points of g that are active in the cell; they repeat with the periods of an axis.
    double *load_block(int k, int64_t base, double *out) const {
        if (k == g_.axes()) {
            return std::copy_n(g_.records().data() + base * g_.width(), g_.width(), out);
        }
        const int p = g_.axis(k).degree();
        const int64_t first = cell_->spans[static_cast<size_t>(k)] - p;
        for (int64_t layer = first; layer <= first + p; ++layer) {
            const int64_t stored = g_.axis(k).periodic() ? layer % g_.axis(k).distinct_layers() : layer;
            out = load_block(k + 1, base * g_.count(k) + stored, out);
        }
        return out;
    }

    // Adds the values of G for all ways to distribute the remaining knots, from axis k on.
    void next_axis(int k, const Window &left, const double *points, double times) {
        if (k < g_.axes()) {
            if (f_.axis(0).degree() == 1) {
                all_arguments(k, left, points, times);
            } else {
                next_argument(k, 0, left, nullptr, 0, points, times);
            }
            return;
        }
        count_work(work_of_a_term * std::ssize(sums_));
        double share = times;
        if (weighted_) {
            only_weight_ = product_of_weights();
            share *= only_weight_;
        }
        for (size_t c = 0; c < sums_.size(); ++c) {
            sums_[c].add(share * points[c]);
        }
        total_.add(times);
        only_ = points;
        ++terms_;
    }

    // The same for all arguments.
    [[nodiscard]] double product_of_weights() const noexcept {
        double product = 1;
        for (int k = 0; k < g_.axes(); ++k) {
            const double *weights = weights_[static_cast<size_t>(k)].data();
            product = std::accumulate(weights, weights + g_.axis(k).degree(), product, std::multiplies<>());
        }
        return product;
    }

    // The order of the arguments of an axis does not matter, so only orders that do not fall are visited. A
    // choice that occurs n times has 1 / n! as many orders as n different choices.
    void next_argument(int k, int number, const Window &left, const int *previous, int run,
                       const double *points, double times) {
        const auto at = static_cast<size_t>(k);
        const int missing = g_.axis(k).degree() - number;
        if (missing == 0) {
            contract_axis(k, points);
            next_axis(k + 1, left, parts_[at].data(), times);
            return;
        }
        for_each_choice(left, f_.axis(0).degree(), [&](const int *chosen, double ways) {
            const auto order = against(previous, chosen, left.size);
            if (order < 0 || chosen[0] * missing > left.copies[0]) {
                return; // the choices after this one have no fewer copies of the first knot
            }
            const int again = order == 0 ? run + 1 : 1;
            double *argument = arguments_[at].data() + number;
            *argument = order == 0 ? repeated(at, number) : argument_of(k, number, left.size, chosen);
            next_argument(k, number + 1, without(left, chosen), chosen, again, points, times * ways / again);
        });
    }

    // All arguments of an axis at once, where each is a value of f at one knot: the orders of a choice are
    // alike, and as many for every choice.
    void all_arguments(int k, const Window &left, const double *points, double times) {
        const auto at = static_cast<size_t>(k);
        for_each_choice(left, g_.axis(k).degree(), [&](const int *chosen, double ways) {
            int number = 0;
            for (int i = 0; i < left.size; ++i) {
                std::array<int, max_basis> one{};
                one[static_cast<size_t>(i)] = 1;
                for (int copy = 0; copy < chosen[i]; ++copy, ++number) {
                    arguments_[at][static_cast<size_t>(number)] =
                        copy > 0 ? repeated(at, number) : argument_of(k, number, left.size, one.data());
                }
            }
            contract_axis(k, points);
            next_axis(k + 1, without(left, chosen), parts_[at].data(), times * ways);
        });
    }

    static std::strong_ordering against(const int *previous, const int *chosen, int size) noexcept {
        return previous == nullptr
                   ? std::strong_ordering::greater
                   : std::lexicographical_compare_three_way(chosen, chosen + size, previous, previous + size);
    }

    static Window without(Window window, const int *chosen) noexcept {
        for (int i = 0; i < window.size; ++i) {
            window.copies[static_cast<size_t>(i)] -= chosen[i];
        }
        return window;
    }

    // The argument before this one, with its weight.
    double repeated(size_t axis, int number) noexcept {
        const auto place = static_cast<size_t>(number);
        weights_[axis][place] = weights_[axis][place - 1];
        return arguments_[axis][place - 1];
    }

    // Coordinate k of the polar form of f. If that is a value of f, the knot it stands for. Its weight goes
    // to weights_[k][number].
    [[nodiscard]] double argument_of(int k, int number, int size, const int *chosen) noexcept {
        std::array<double, max_basis> knots{};
        int count = 0, distinct = 0;
        for (int i = 0; i < size; ++i) {
            std::fill_n(knots.begin() + count, chosen[i], window_knots_[static_cast<size_t>(i)]);
            count += chosen[i];
            distinct += chosen[i] > 0 ? 1 : 0;
        }
        const std::span<const double> arguments = std::span(knots).first(static_cast<size_t>(count));
        const CurvePiece &piece = pieces_[cell_->piece];
        if (weighted_) {
            weights_[static_cast<size_t>(k)][static_cast<size_t>(number)] = piece.polar_weight(arguments);
        }
        const double value = piece.polar_value(k, arguments);
        return distinct > 1 ? value
                            : snapped(*axes_[static_cast<size_t>(k)], value, uncertainty_at(k, knots[0]));
    }

    // The uncertainty of the value of f there. The pieces on both sides count: one of them may be much
    // steeper.
    [[nodiscard]] double uncertainty_at(int k, double t) const noexcept {
        const size_t i = cell_->piece;
        double least = pieces_[i].uncertainty_at(k, t);
        if (i > 0 && t == pieces_[i].lower()) {
            least = std::min(least, pieces_[i - 1].uncertainty_at(k, t));
        }
        if (i + 1 < pieces_.size() && t == pieces_[i].upper()) {
            least = std::min(least, pieces_[i + 1].uncertainty_at(k, t));
        }
        return least;
    }

    void contract_axis(int k, const double *points) noexcept {
        const auto at = static_cast<size_t>(k);
        const int p = g_.axis(k).degree();
        const int64_t span = cell_->spans[at], length = lengths_[at];
        const BlossomRow row =
            blossom_row(*axes_[at], span, std::span(arguments_[at]).first(static_cast<size_t>(p)));
        contract(row.coefficients, row.size, points + (row.first - span + p) * length, length, length,
                 parts_[at].data());
    }

    const Spline &g_;
    const Spline &f_;
    int degree_;
    bool weighted_ = f_.rational();
    std::vector<CurvePiece> pieces_;
    Spline::Axes axes_; // of g, with the periods that f runs through
    std::vector<SpanCell> cells_;
    std::vector<double> knots_;      // of the result
    std::vector<size_t> cell_after_; // of each knot

    // All of a cell.
    ComposedCell whole_;
    const SpanCell *made_ = nullptr;
    const std::vector<double> *coefficients_ = nullptr;

    // Data of the layer that is being made.
    const SpanCell *cell_ = nullptr;
    std::array<double, max_basis> window_knots_{};
    std::vector<double> block_;
    std::array<std::array<double, max_basis>, max_axes> arguments_{};
    std::array<std::array<double, max_basis>, max_axes> weights_{}; // of the arguments, if f has weights
    std::array<int64_t, max_axes> lengths_{};
    std::array<std::vector<double>, max_axes> parts_;
    std::vector<CompensatedSum> sums_;
    CompensatedSum total_;
    int64_t terms_ = 0;
    const double *only_ = nullptr;
    double only_weight_ = 1;
};

} // namespace

SplinePtr compose(const SplinePtr &g, const SplinePtr &f) {
    check_operands(*g, *f);
    const int degree = composed_degree(*g, *f);
    if (g->axes() == 1 && !strictly_monotone(f)) {
        fail(Status::not_monotone, "f neither increases nor decreases strictly on its whole domain");
    }
    const SplinePtr weighted = f->rational() ? make_rational(g) : g;
    return Composer(*weighted, *f, degree).run();
}

} // namespace nrb::refine
