#include "base/checked.h"
#include "eval/contraction.h"
#include "eval/evaluate.h"
#include "eval/finish.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace nrb {

namespace {

// The basis functions of all parameters of one axis.
class AxisTable {
public:
    AxisTable(const KnotVector &axis, const AxisRule &rule, int order, ConstRecords params)
        : evaluator_(axis, rule, order), bases_(static_cast<size_t>(params.count)),
          valid_(static_cast<size_t>(params.count)),
          values_(static_cast<size_t>(
              checked_product(params.count, static_cast<int64_t>(evaluator_.values_size()), "params"))) {
        for (size_t i = 0; i < bases_.size(); ++i) {
            bases_[i].values = values_.data() + i * evaluator_.values_size();
            valid_[i] = evaluator_(params(static_cast<int64_t>(i), 0), bases_[i]) ? 1 : 0;
        }
    }

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(bases_.size()); }
    [[nodiscard]] int degree() const noexcept { return evaluator_.degree(); }
    [[nodiscard]] bool valid(int64_t i) const noexcept { return valid_[static_cast<size_t>(i)] != 0; }
    // Every layer that is active at some parameter, in rising order.
    [[nodiscard]] std::vector<int64_t> needed_layers() const;
    [[nodiscard]] const AxisBasis &operator[](int64_t i) const noexcept {
        return bases_[static_cast<size_t>(i)];
    }

private:
    AxisEvaluator evaluator_;
    std::vector<AxisBasis> bases_;
    std::vector<char> valid_;
    std::vector<double> values_;
};

std::vector<int64_t> AxisTable::needed_layers() const {
    std::vector<int64_t> firsts;
    firsts.reserve(bases_.size());
    for (int64_t i = 0; i < size(); ++i) {
        if (valid(i)) {
            firsts.push_back((*this)[i].first);
        }
    }
    std::sort(firsts.begin(), firsts.end());
    std::vector<int64_t> layers;
    if (!firsts.empty()) {
        const int64_t range = firsts.back() - firsts.front() + degree() + 1;
        layers.reserve(static_cast<size_t>(std::min(range, std::ssize(firsts) * (degree() + 1))));
    }
    for (const int64_t first : firsts) {
        const int64_t begin = layers.empty() ? first : std::max(first, layers.back() + 1);
        for (int64_t layer = begin; layer <= first + degree(); ++layer) {
            layers.push_back(layer);
        }
    }
    return layers;
}

// Row contraction: axis 0 is contracted once for each of its parameters over the whole net, axis 1 once for
// each pair, and so on; layers of the later axes that no parameter needs are left out.
class GridEvaluator {
public:
    GridEvaluator(const Spline &spline, const AxisRules &rules, int order,
                  const std::array<ConstRecords, max_axes> &params)
        : spline_(spline), order_(order), net_(spline.records().data()),
          scratch_(Finisher::scratch_size(spline, order)), finisher_(spline, order, scratch_) {
        tables_.reserve(max_axes);
        for (int k = 0; k < spline.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            tables_.emplace_back(spline.axis(k), rules[at], order, params[at]);
            slabs_.length[at] = axis_view(spline, k, spline.width()).inner;
            const int64_t size =
                checked_product(slot_count(k + 1, order), slabs_.length[at], "working memory of the grid");
            storage_[at].reset(
                new double[static_cast<size_t>(size)]); // uninitialised: little of it may be used
            slabs_.data[at] = storage_[at].get();
        }
        find_stretches();
    }

    void write(Records out) noexcept {
        next_ = 0;
        descend<0>(out);
    }

private:
    // From the last axis forward: each needed layer of an axis holds the stretches of the axes behind it.
    void find_stretches() {
        const int last = spline_.axes() - 1;
        stretches_[static_cast<size_t>(last)] = {{0, spline_.width()}};
        for (int k = last; k > 0; --k) {
            const auto at = static_cast<size_t>(k);
            std::vector<Stretch> &joined = stretches_[at - 1];
            const std::vector<int64_t> layers = tables_[at].needed_layers();
            joined.reserve(layers.size() * stretches_[at].size());
            for (const int64_t layer : layers) {
                for (const Stretch &inner : stretches_[at]) {
                    append(joined, {layer * slabs_.length[at] + inner.offset, inner.length});
                }
            }
        }
    }

    static void append(std::vector<Stretch> &stretches, Stretch next) {
        if (!stretches.empty() && stretches.back().offset + stretches.back().length == next.offset) {
            stretches.back().length += next.length;
        } else {
            stretches.push_back(next);
        }
    }

    template <int level>
    void descend(Records out) noexcept {
        const AxisTable &table = tables_[level];
        for (int64_t i = 0; i < table.size(); ++i) {
            if (!table.valid(i)) {
                skip(level, out);
                continue;
            }
            bases_[level] = table[i];
            contract_rows(level, table);
            if constexpr (level + 1 < max_axes) {
                if (level + 1 < spline_.axes()) {
                    descend<level + 1>(out);
                    continue;
                }
            }
            finisher_.write(slabs_.data[level], bases_, out, next_++);
        }
    }

    void contract_rows(int level, const AxisTable &table) noexcept {
        const AxisBasis &basis = bases_[static_cast<size_t>(level)];
        const std::vector<Stretch> &stretches = stretches_[static_cast<size_t>(level)];
        if (level > 0) {
            return contract_level(level, order_, table.degree(), basis, basis.first, slabs_, stretches);
        }
        const int functions = table.degree() + 1;
        const int64_t length = slabs_.length[0];
        for (int a = 0; a <= order_; ++a) {
            for (const Stretch &stretch : stretches) {
                contract(basis.values + static_cast<int64_t>(a) * functions, functions,
                         net_ + basis.first * length + stretch.offset, length, stretch.length,
                         slabs_.data[0] + a * length + stretch.offset);
            }
        }
    }

    // All grid points below an invalid parameter are NaN.
    void skip(int level, Records out) noexcept {
        int64_t points = 1;
        for (int k = level + 1; k < spline_.axes(); ++k) {
            points *= tables_[static_cast<size_t>(k)].size();
        }
        for (; points > 0; --points) {
            finisher_.write_nan(out, next_++);
        }
    }

    const Spline &spline_;
    int order_;
    const double *net_;
    Scratch scratch_;
    Finisher finisher_;
    std::vector<AxisTable> tables_;
    std::array<std::unique_ptr<double[]>, max_axes> storage_;
    std::array<std::vector<Stretch>, max_axes> stretches_;
    Slabs slabs_;
    Bases bases_;
    int64_t next_ = 0;
};

} // namespace

void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, Records out) {
    if (out.count == 0) {
        return;
    }
    GridEvaluator(spline, rules, order, params).write(out);
}

} // namespace nrb
