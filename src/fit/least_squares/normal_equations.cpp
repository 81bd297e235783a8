// SPDX-License-Identifier: MIT
#include "fit/least_squares/normal_equations.h"

#include "base/watch.h"
#include "fit/least_squares/fit_axis.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace nrb::fit {

namespace {

constexpr int64_t work_of_a_product = 12; // of two double-double numbers

// Multiplies sums[outer][from][inner] by table[to][from] into [outer][to][inner].
std::vector<DoubleDouble> contracted(const std::vector<DoubleDouble> &sums,
                                     const std::vector<DoubleDouble> &table, size_t from, size_t inner) {
    const size_t to = table.size() / from, outer = sums.size() / (from * inner);
    std::vector<DoubleDouble> result(outer * to * inner);
    count_work(work_of_a_product * static_cast<int64_t>(result.size() * from));
    for (size_t o = 0; o < outer; ++o) {
        for (size_t t = 0; t < to; ++t) {
            DoubleDouble *const out = result.data() + (o * to + t) * inner;
            for (size_t f = 0; f < from; ++f) {
                const DoubleDouble factor = table[t * from + f];
                const DoubleDouble *const in = sums.data() + (o * from + f) * inner;
                for (size_t i = 0; i < inner; ++i) {
                    out[i] = out[i] + factor * in[i];
                }
            }
        }
    }
    return result;
}

class EquationAssembly {
public:
    EquationAssembly(const Statistics &statistics, const std::vector<KnotVectorPtr> &axes,
                     const Index &least_reach)
        : statistics_(statistics), form_(statistics.form()),
          layout_(form_), made_{axes, StencilMatrix(axes, least_reach), {},       {}, {},
                                {},   statistics.data_count(),          form_.dim} {
        for (size_t k = 0; k < axes.size(); ++k) {
            axes_.emplace_back(axes[k], form_.breaks[k], form_.degrees[k], static_cast<int>(k));
        }
        made_.right.resize(static_cast<size_t>(made_.matrix.size() * form_.dim));
        made_.squares.resize(static_cast<size_t>(form_.dim));
        made_.support.resize(static_cast<size_t>(made_.matrix.size()), 0.0);
    }

    NormalEquations equations() {
        std::vector<std::pair<int64_t, int64_t>> cells; // span and number of each cell, sorted
        for (int64_t i = 0; i < std::ssize(statistics_.cells()); ++i) {
            cells.emplace_back(span_of(statistics_.cells()[static_cast<size_t>(i)]), i);
        }
        std::ranges::sort(cells);
        Steps steps(std::ssize(cells));
        for (size_t first = 0; first < cells.size();) {
            moments_.assign(static_cast<size_t>(layout_.moments), DoubleDouble{});
            right_.assign(static_cast<size_t>(layout_.functions * layout_.dim), DoubleDouble{});
            weight_ = DoubleDouble{};
            size_t i = first;
            for (; i < cells.size() && cells[i].first == cells[first].first; ++i) {
                add_cell(cells[i].second);
                steps.next();
            }
            add_span(cells[first].first);
            first = i;
        }
        return std::move(made_);
    }

private:
    [[nodiscard]] Index cell_index(int64_t cell) const noexcept {
        Index index{};
        for (size_t k = axes_.size(); k-- > 0;) {
            index[k] = cell % form_.cells_along(k);
            cell /= form_.cells_along(k);
        }
        return index;
    }
    [[nodiscard]] int64_t span_of(int64_t cell) const noexcept {
        const Index index = cell_index(cell);
        int64_t span = 0;
        for (size_t k = 0; k < axes_.size(); ++k) {
            span = span * axes_[k].spans() + axes_[k].span_of(index[k]);
        }
        return span;
    }

    // Adds the sums of a cell, turned into those of the Bernstein polynomials on its span.
    void add_cell(int64_t i) {
        const std::span<const ExactSum> sums = statistics_.sums(i);
        constexpr int of_functions = -function_bits - value_bits, of_values = -value_bits - value_bits;
        const auto scaled = [&](int64_t first, int64_t end, int exponent) {
            std::vector<DoubleDouble> values;
            values.reserve(static_cast<size_t>(end - first));
            for (int64_t e = first; e < end; ++e) {
                values.push_back(sums[static_cast<size_t>(e)].scaled(exponent));
            }
            return values;
        };
        const Index cell = cell_index(statistics_.cells()[static_cast<size_t>(i)]);
        add_widened(cell, 2, 1, scaled(0, layout_.moments, of_functions), moments_);
        add_widened(cell, 1, layout_.dim, scaled(layout_.right(), layout_.squares(), of_functions), right_);
        const std::vector<DoubleDouble> squares = scaled(layout_.squares(), layout_.weight(), of_values);
        for (size_t c = 0; c < squares.size(); ++c) {
            made_.squares[c] = made_.squares[c] + squares[c];
        }
        const DoubleDouble weight = sums.back().scaled(-value_bits);
        weight_ = weight_ + weight;
        made_.weight = made_.weight + weight;
    }
    // The same for sums of polynomials of `times` the degree, with `inner` sums each.
    void add_widened(const Index &cell, int times, int64_t inner, std::vector<DoubleDouble> sums,
                     std::vector<DoubleDouble> &total) const {
        for (size_t k = axes_.size(); k-- > 0;) {
            const int degree = times * form_.degrees[k];
            const int64_t layer = inner, block = (degree + 1) * layer;
            for (int64_t o = 0; o < std::ssize(sums); o += block) {
                axes_[k].widen(cell[k], degree, layer, sums.data() + o);
            }
            inner = block;
        }
        count_work(work_of_a_product * std::ssize(sums));
        for (size_t e = 0; e < sums.size(); ++e) {
            total[e] = total[e] + sums[e];
        }
    }

    void add_span(int64_t number) {
        Index span{}, first{};
        for (size_t k = axes_.size(); k-- > 0;) {
            span[k] = number % axes_[k].spans();
            number /= axes_[k].spans();
            first[k] = axes_[k].knot_index(span[k]) - axes_[k].degree();
        }
        std::array<const SpanTables *, max_axes> tables{};
        for (size_t k = 0; k < axes_.size(); ++k) {
            tables[k] = &tables_of(k, span[k]);
        }
        add_right(first, tables);
        add_pairs(first, tables);
    }
    // The tables are kept, because the spans of an axis recur; those of a curve do not.
    const SpanTables &tables_of(size_t k, int64_t span) {
        auto &kept = tables_[k];
        if (axes_.size() == 1) {
            kept.clear();
            return kept.emplace(span, SpanTables{axes_[0].function_table(span), {}}).first->second;
        }
        const auto found = kept.find(span);
        return found != kept.end() ? found->second : kept.emplace(span, axes_[k].tables(span)).first->second;
    }

    // Visits the active control points of a span, last axis fastest.
    template <class Visit>
    void for_each_function(const Index &first, Visit &&visit) const {
        Index counts{1, 1, 1};
        for (size_t k = 0; k < axes_.size(); ++k) {
            counts[k] = axes_[k].degree() + 1;
        }
        for_each_index(first, counts, visit);
    }

    void add_right(const Index &first, const std::array<const SpanTables *, max_axes> &tables) {
        std::vector<DoubleDouble> sums = right_;
        auto inner = static_cast<size_t>(form_.dim);
        for (size_t k = axes_.size(); k-- > 0;) {
            sums = contracted(sums, tables[k]->functions, static_cast<size_t>(form_.degrees[k] + 1), inner);
            inner *= static_cast<size_t>(axes_[k].degree() + 1);
        }
        const DoubleDouble *next = sums.data();
        for_each_function(first, [&](const Index &layer) {
            const auto unknown = static_cast<size_t>(made_.matrix.unknown(layer));
            made_.support[unknown] += weight_.high;
            for (size_t c = 0; c < static_cast<size_t>(form_.dim); ++c) {
                DoubleDouble &sum = made_.right[unknown * static_cast<size_t>(form_.dim) + c];
                sum = sum + *next++;
            }
        });
    }

    void add_pairs(const Index &first, const std::array<const SpanTables *, max_axes> &tables) {
        const std::vector<DoubleDouble> sums =
            axes_.size() == 1 ? axes_[0].pair_sums(tables[0]->functions, moments_) : pair_sums(tables);
        for_each_function(first, [&](const Index &a) {
            for_each_function(first, [&](const Index &b) {
                if (a <= b) {
                    made_.matrix.add(a, b, sums[pair(first, a, b)]);
                }
            });
        });
    }
    [[nodiscard]] std::vector<DoubleDouble>
    pair_sums(const std::array<const SpanTables *, max_axes> &tables) const {
        std::vector<DoubleDouble> sums = moments_;
        size_t inner = 1;
        for (size_t k = axes_.size(); k-- > 0;) {
            const auto from = static_cast<size_t>(2 * form_.degrees[k] + 1);
            sums = contracted(sums, tables[k]->pairs, from, inner);
            inner *= tables[k]->pairs.size() / from;
        }
        return sums;
    }
    // The place of the product of functions a and b: on each axis that of the pair, in either order.
    [[nodiscard]] size_t pair(const Index &first, const Index &a, const Index &b) const noexcept {
        int64_t place = 0;
        for (size_t k = 0; k < axes_.size(); ++k) {
            const int64_t width = axes_[k].degree() + 1;
            const int64_t i = std::min(a[k], b[k]) - first[k], j = std::max(a[k], b[k]) - first[k];
            place = place * (width * (width + 1) / 2) + i * width - i * (i - 1) / 2 + j - i;
        }
        return static_cast<size_t>(place);
    }

    const Statistics &statistics_;
    const StatisticsForm &form_;
    CellLayout layout_;
    NormalEquations made_;
    std::vector<FitAxis> axes_;
    std::array<std::map<int64_t, SpanTables>, max_axes> tables_;
    // Sums of the span that is being assembled.
    std::vector<DoubleDouble> moments_, right_;
    DoubleDouble weight_;
};

} // namespace

NormalEquations normal_equations(const Statistics &statistics, const std::vector<KnotVectorPtr> &axes,
                                 const Index &least_reach) {
    return EquationAssembly(statistics, axes, least_reach).equations();
}

} // namespace nrb::fit
