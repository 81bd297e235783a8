// SPDX-License-Identifier: MIT
#include "refine/compose/compose.h"

#include "base/watch.h"
#include "refine/algebra/product.h"
#include "refine/compose/axes_under.h"
#include "refine/compose/composed_layer.h"
#include "refine/compose/span_cells.h"
#include "refine/forms/homogeneous.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

// The number of knots that the continuity of f and g requires between two cells, in a spline of degree
// `degree`.
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
            const int64_t crossed = std::abs(b.spans[at] - a.spans[at]); // knots, with multiplicity
            smooth = static_cast<int>(std::min<int64_t>(smooth, g.axis(k).degree() - crossed));
        }
    }
    return degree - std::max(smooth, -1);
}

using Window = CommonKnots::Window;
using Knots = std::array<double, max_basis>;

class Composer {
public:
    Composer(const Spline &g, const Spline &f, int degree)
        : g_(g), degree_(degree), pieces_(pieces_of(f)), axes_(axes_under(g, pieces_)),
          cells_(span_cells(axes_, pieces_)), layer_(g, f, pieces_, axes_) {
        const auto [lower, upper] = f.axis(0).domain();
        append_knots(lower, degree + 1, 0);
        for (size_t i = 1; i < cells_.size(); ++i) {
            append_knots(cells_[i].start, copies_between(g, f, degree, pieces_, cells_[i - 1], cells_[i]), i);
        }
        append_knots(upper, degree + 1, cells_.size() - 1);
        int64_t length = g.width();
        for (int k = 0; k < g.axes(); ++k) {
            length *= g.axis(k).degree() + 1;
        }
        block_.resize(static_cast<size_t>(length));
    }

    SplinePtr run() {
        std::vector<double> records;
        const auto layers = std::ssize(knots_) - degree_ - 1;
        records.reserve(static_cast<size_t>(layers * g_.width()) + Spline::padding);
        Steps steps(layers);
        for (int64_t layer = 0; layer < layers;) {
            for (const int64_t end = append_layers(layer, layers, records); layer < end; ++layer) {
                steps.next();
            }
        }
        const Form form = has_negative_weight(records) ? Form::homogeneous : g_.form();
        return from_records({make_knot_vector(degree_, knots_)}, g_.dim(), form, std::move(records));
    }

private:
    void append_knots(double t, int copies, size_t cell) {
        knots_.insert(knots_.end(), static_cast<size_t>(copies), t);
        cell_after_.insert(cell_after_.end(), static_cast<size_t>(copies), cell);
    }

    // Whether a weight is negative. This can happen if polar values of f overshoot the values of f.
    [[nodiscard]] bool has_negative_weight(const std::vector<double> &records) const noexcept {
        const auto width = static_cast<size_t>(g_.width());
        bool negative = false;
        for (size_t i = width; g_.rational() && i <= records.size(); i += width) {
            negative = negative || records[i - 1] < 0;
        }
        return negative;
    }

    // The cell that contains the longest span in the support of a layer (the first such span if several are
    // equally long). All spans of the support give the same control point, as far as crossings are known.
    // Next to a piece so short that they are not known, the spans outside the piece count.
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

    // The window of a layer, and the distinct knots among its arguments.
    [[nodiscard]] Window window(int64_t layer, Knots &distinct) const noexcept {
        Window window{};
        for (int64_t i = layer + 1; i <= layer + degree_; ++i) {
            const double knot = knots_[static_cast<size_t>(i)];
            if (window.size == 0 || distinct[static_cast<size_t>(window.size - 1)] != knot) {
                distinct[static_cast<size_t>(window.size++)] = knot;
            }
            ++window.copies[static_cast<size_t>(window.size - 1)];
        }
        return window;
    }

    // Appends a layer, and the layers after it that have the same cell and the same distinct knots. Returns
    // the layer after them.
    int64_t append_layers(int64_t layer, int64_t layers, std::vector<double> &records) {
        cell_ = &cell_for(layer);
        windows_.assign(1, window(layer, window_knots_));
        const Window &around = windows_.front();
        const std::span knots = std::span(window_knots_).first(static_cast<size_t>(around.size));
        int64_t end = layer + 1;
        for (Knots of_next; end < layers && &cell_for(end) == cell_; ++end) {
            const Window next = window(end, of_next);
            if (!std::ranges::equal(knots, std::span(of_next).first(static_cast<size_t>(next.size)))) {
                break;
            }
            windows_.push_back(next);
        }
        load_block(0, 0, block_.data());
        layer_.begin(windows_, knots, *cell_, block_.data());
        for (const Window &window : windows_) {
            append_record(layer_.make(window).data(), records);
        }
        return end;
    }
    void append_record(const double *record, std::vector<double> &records) const {
        records.insert(records.end(), record, record + g_.width());
        if (!std::all_of(record, record + g_.width(), [](double x) { return std::isfinite(x); })) {
            fail(Status::not_representable, "a new control point overflows double precision");
        }
    }

    // Copies the control points of g that are active in the cell. On a periodic axis they repeat with the
    // period.
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

    const Spline &g_;
    int degree_;
    std::vector<CurvePiece> pieces_;
    Spline::Axes axes_; // of g, with the periods that f visits
    std::vector<SpanCell> cells_;
    std::vector<double> knots_;      // of the result
    std::vector<size_t> cell_after_; // for each knot, the cell that follows it

    // Data of the layers that are being computed.
    ComposedLayer layer_;
    const SpanCell *cell_ = nullptr;
    std::vector<Window> windows_;
    Knots window_knots_{};
    std::vector<double> block_;
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
