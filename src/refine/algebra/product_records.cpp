// SPDX-License-Identifier: MIT
#include "refine/algebra/product_records.h"

#include "base/checked.h"
#include "base/representable.h"
#include "base/watch.h"
#include "numeric/sum.h"
#include "refine/algebra/product_terms.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nrb::refine {

namespace {

// The dot product in four partial sums, which the compiler keeps in registers. Its error bound is that of a
// sum of a quarter of the length.
double dot(const double *a, const double *b, int64_t size) noexcept {
    std::array<double, 4> sums{};
    int64_t i = 0;
    for (; i + 4 <= size; i += 4) {
        for (size_t l = 0; l < 4; ++l) {
            sums[l] += a[i + static_cast<int64_t>(l)] * b[i + static_cast<int64_t>(l)];
        }
    }
    for (; i < size; ++i) {
        sums[0] += a[i] * b[i];
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// Values of a factor's polar form for rows on all axes: the layers of one axis after another are contracted
// to rows. After axis k the layout is [rows of axis 0] ... [rows of axis k][layers of axis k + 1] ...
// [width]. Before the last axis is contracted it is moved to the front, so that the inner loops are long; the
// final layout is [rows of the last axis][width][rows of axis 0] ... .
class PolarValues {
public:
    explicit PolarValues(const Factor &factor)
        : width_(factor.width), last_(factor.axes.size() - 1), records_(factor.records) {
        int64_t rest = width_;
        for (size_t k = factor.axes.size(); k-- > 0;) {
            counts_[k] = factor.axes[k]->count();
            rests_[k] = rest;
            rest *= counts_[k];
        }
    }

    // Contracts the layers of axis k to rows. Precondition: this has been done for the axes before it.
    void replace(size_t k, const PolarRows &rows) {
        const double *from = k == 0 ? records_.data() : stages_[k - 1].data();
        outer_[k + 1] = outer_[k] * rows.size();
        const int64_t outer = k == last_ ? 1 : outer_[k];
        const int64_t length = k == last_ ? outer_[k] * width_ : rests_[k];
        std::vector<double> &stage = stages_[k];
        stage.resize(static_cast<size_t>(outer * rows.size() * length));
        double *out = stage.data();
        for (int64_t o = 0; o < outer; ++o, from += counts_[k] * length) {
            for (int64_t row = 0; row < rows.size(); ++row, out += length) {
                rows.contract(row, from, length, out);
            }
        }
        constexpr int64_t work_of_a_value = 8;
        count_work(work_of_a_value * std::ssize(stage));
        if (k + 1 == last_) {
            bring_last_axis_first(stage);
        }
    }

    // The number of combinations of rows of all axes but the last.
    [[nodiscard]] int64_t outer_rows() const noexcept { return outer_[last_]; }
    [[nodiscard]] const double *values() const noexcept { return stages_[last_].data(); }
    [[nodiscard]] int width() const noexcept { return width_; }

private:
    void bring_last_axis_first(std::vector<double> &stage) {
        const int64_t outer = outer_[last_], length = counts_[last_] * width_;
        turned_.resize(stage.size());
        for (int64_t o = 0; o < outer; ++o) {
            for (int64_t i = 0; i < length; ++i) {
                turned_[static_cast<size_t>(i * outer + o)] = stage[static_cast<size_t>(o * length + i)];
            }
        }
        stage.swap(turned_);
    }

    int width_;
    size_t last_;
    std::span<const double> records_;
    std::array<int64_t, max_axes> counts_{}, rests_{};
    std::array<int64_t, max_axes + 1> outer_{1};
    std::array<std::vector<double>, max_axes> stages_;
    std::vector<double> turned_;
};

// One combination of choices on all axes but the last: the rows of both factors, numbered over these axes
// together.
struct OuterTerm {
    double weight;
    int64_t a;
    int64_t b;
};

// The values of a factor for all outer terms, side by side: [rows of the last axis][width][terms]. Another
// column stands for the constant 1.
class Columns {
public:
    void gather(const PolarValues &values, int64_t rows, std::span<const OuterTerm> terms, bool first) {
        width_ = values.width();
        terms_ = std::ssize(terms);
        ones_.resize(terms.size());
        columns_.resize(static_cast<size_t>(rows * width_ * terms_));
        const double *from = values.values();
        double *out = columns_.data();
        for (int64_t i = 0; i < rows * width_; ++i, from += values.outer_rows(), out += terms_) {
            for (size_t t = 0; t < terms.size(); ++t) {
                out[t] = first ? terms[t].weight * from[terms[t].a] : from[terms[t].b];
            }
        }
        std::transform(terms.begin(), terms.end(), ones_.begin(),
                       [first](const OuterTerm &term) { return first ? term.weight : 1; });
    }
    [[nodiscard]] const double *column(int32_t row, int component) const noexcept {
        return component == width_ ? ones_.data()
                                   : columns_.data() + (int64_t{row} * width_ + component) * terms_;
    }

private:
    int width_ = 0;
    int64_t terms_ = 0;
    std::vector<double> columns_;
    std::vector<double> ones_;
};

class Multiplier {
public:
    Multiplier(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes, int width,
               const Bilinear &form)
        : axes_(axes), form_(form), width_(width), last_(axes.size() - 1), a_(a), b_(b),
          sums_(static_cast<size_t>(width)), terms_(axes.size()) {
        int64_t size = width;
        for (size_t k = axes.size(); k-- > 0;) {
            degrees_[k] = a.axes[k]->degree();
            total_ *= ProductTerms::total(axes[k].axis()->degree(), degrees_[k]);
            strides_[k] = size;
            size = checked_product(size, axes[k].axis()->count(), "points");
            for (int64_t layer = 0; k > 0 && layer < axes[k].axis()->count();
                 layer = terms_[k].back().end()) {
                terms_[k].emplace_back(axes[k], degrees_[k], layer);
            }
        }
        grow_watched(result_, static_cast<size_t>(size));
    }

    std::vector<double> run() {
        const int64_t count = axes_[0].axis()->count();
        Steps steps(count);
        for (int64_t layer = 0; layer < count;) {
            const ProductTerms terms(axes_[0], degrees_[0], layer);
            add_axis(0, terms);
            for (; layer < terms.end(); ++layer) {
                steps.next();
            }
        }
        require_representable(result_, "products of control points");
        return std::move(result_);
    }

private:
    void add_axis(size_t k, const ProductTerms &terms) {
        chunk_[k] = &terms;
        a_.replace(k, terms.rows(0));
        b_.replace(k, terms.rows(1));
        if (k == last_) {
            const std::array<OuterTerm, 1> none{OuterTerm{1, 0, 0}};
            write_layers(0, none, result_.data());
            return;
        }
        for (const ProductTerms &next : terms_[k + 1]) {
            add_axis(k + 1, next);
        }
    }

    // Writes the layers of axis k for one layer of each axis before it.
    void write_layers(size_t k, std::span<const OuterTerm> outer, double *out) {
        const ProductTerms &chunk = *chunk_[k];
        if (k == last_) {
            write_last(outer, out);
            return;
        }
        std::vector<OuterTerm> &inner = outer_[k];
        for (int64_t layer = chunk.first(); layer < chunk.end(); ++layer) {
            inner.clear();
            for (const OuterTerm &term : outer) {
                for (const ProductTerms::Term &own : chunk.layer(layer)) {
                    inner.push_back({term.weight * own.weight, term.a * chunk.rows(0).size() + own.a,
                                     term.b * chunk.rows(1).size() + own.b});
                }
            }
            write_layers(k + 1, inner, out + layer * strides_[k]);
        }
    }

    void write_last(std::span<const OuterTerm> outer, double *out) {
        const ProductTerms &chunk = *chunk_[last_];
        columns_a_.gather(a_, chunk.rows(0).size(), outer, true);
        columns_b_.gather(b_, chunk.rows(1).size(), outer, false);
        for (int64_t layer = chunk.first(); layer < chunk.end(); ++layer) {
            write_record(chunk.layer(layer), std::ssize(outer), out + layer * width_);
        }
    }

    void write_record(std::span<const ProductTerms::Term> terms, int64_t outer, double *out) {
        constexpr int64_t part = 128; // short enough for the accuracy that is claimed
        std::fill(sums_.begin(), sums_.end(), CompensatedSum());
        count_work(std::ssize(terms) * std::ssize(form_) * (outer * form_[0].size + work_of_a_sum));
        for (const ProductTerms::Term &term : terms) {
            for (const BilinearTerm &own : form_) {
                const double *x = columns_a_.column(term.a, own.a), *y = columns_b_.column(term.b, own.b);
                const double factor = own.factor * term.weight;
                const int64_t size = outer * own.size;
                for (int64_t i = 0; i < size; i += part) {
                    sums_[static_cast<size_t>(own.out)].add(factor *
                                                            dot(x + i, y + i, std::min(part, size - i)));
                }
            }
        }
        for (size_t c = 0; c < sums_.size(); ++c) {
            out[c] = sums_[c].value() / total_;
        }
    }

    static constexpr int64_t work_of_a_sum = 12;

    const std::vector<CommonKnots> &axes_;
    const Bilinear &form_;
    int width_;
    size_t last_;
    PolarValues a_, b_;
    Columns columns_a_, columns_b_;
    std::vector<CompensatedSum> sums_;
    std::vector<std::vector<ProductTerms>> terms_; // of all axes but the first; made once
    std::array<const ProductTerms *, max_axes> chunk_{};
    std::array<std::vector<OuterTerm>, max_axes> outer_;
    std::array<int64_t, max_axes> strides_{};
    std::array<int, max_axes> degrees_{};
    double total_ = 1;
    std::vector<double> result_;
};

} // namespace

std::vector<double> product_records(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes,
                                    int width, const Bilinear &form) {
    return Multiplier(a, b, axes, width, form).run();
}

} // namespace nrb::refine
