// SPDX-License-Identifier: MIT
// Evaluation on grids: the tables and the working memory of the grid kernel, and grids in strips for sinks.
#include "base/checked.h"
#include "eval/blocks.h"
#include "eval/evaluate.h"
#include "eval/grid_layout.h"
#include "eval/kernels/derivative_source.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace nrb::eval {

namespace {

// Appends a stretch, joined to the last one if the two are adjacent.
void append(std::vector<Stretch> &stretches, Stretch next) {
    if (!stretches.empty() && stretches.back().offset + stretches.back().length == next.offset) {
        stretches.back().length += next.length;
    } else {
        stretches.push_back(next);
    }
}

// The tables and the working memory of one grid, or of one strip of a grid.
class GridEvaluator {
public:
    // `tables`: the tables of basis functions that another strip of the same grid has already made; null for
    // the axes whose table has to be made.
    GridEvaluator(const Spline &spline, const AxisRules &rules, int order,
                  const std::array<ConstRecords, max_axes> &params, GridAxes tables = {})
        : spline_(spline), shape_(spline, order), net_(spline.records().data()),
          sources_(axis_sources(spline, rules, order, {params[0].count, params[1].count, params[2].count})),
          scratch_(scratch_size()), tables_(std::move(tables)) {
        if (shape_.rational) {
            quotient_.emplace(shape_.axes, order, scratch_);
        }
        for (size_t k = 0; k < axes(); ++k) {
            sources_[k].take_work(scratch_);
            if (tables_[k] == nullptr) {
                tables_[k] = make_table(k, params[k]);
            }
        }
        find_stretches();
        make_slabs();
        make_groups();
    }

    void write(const Records &out) noexcept { write(out, 0, tables_[0]->size(), nullptr, 0, 0); }

    // Writes the grid points of parameters [begin, end) of axis 0. Without a sink, `out` is the whole grid.
    // With a sink, `out` holds one row of the last axis, and the sink is called for every row of this strip.
    // In the whole grid, the first row of the strip begins with point number sink_first, and consecutive rows
    // begin sink_stride points apart.
    void write(const Records &out, int64_t begin, int64_t end, BlockSink *sink, int64_t sink_first,
               int64_t sink_stride) noexcept {
        run(GridJob{spline_,
                    shape_,
                    quotient_ ? &*quotient_ : nullptr,
                    net_,
                    sources_,
                    tables_,
                    groups_,
                    rising_,
                    group_values_,
                    exceptions_,
                    {stretches_[0], stretches_[1], stretches_[2]},
                    slabs_,
                    rows_,
                    out,
                    begin,
                    end,
                    sink,
                    sink_first,
                    sink_stride});
    }

    [[nodiscard]] const GridAxes &tables() const noexcept { return tables_; }

private:
    [[nodiscard]] size_t axes() const noexcept { return static_cast<size_t>(shape_.axes); }
    [[nodiscard]] const GridAxis &last_table() const noexcept { return *tables_[axes() - 1]; }
    [[nodiscard]] int64_t rows_size() const noexcept { return shape_.slots * shape_.width * grid_group; }

    [[nodiscard]] size_t scratch_size() const noexcept {
        size_t size =
            QuotientRule::scratch_size(shape_.order) + static_cast<size_t>(rows_size()) + Scratch::line;
        for (const AxisSource &source : sources_) {
            size += source.work_size;
        }
        return size;
    }

    [[nodiscard]] std::shared_ptr<const GridAxis> make_table(size_t k, ConstRecords params) const {
        GridAxis table;
        table.points.resize(static_cast<size_t>(params.count));
        table.values.resize(static_cast<size_t>(
            checked_product(params.count, sources_[k].values_size(shape_.order), "params")));
        tabulate(sources_[k], shape_.order, params, table);
        return std::make_shared<const GridAxis>(std::move(table));
    }

    // Finds the stretches of each slab that some parameter needs, from the last axis to the first: each
    // needed layer of an axis consists of the stretches of the axes after it.
    void find_stretches() {
        std::vector<Stretch> inner{{0, shape_.width}};
        int64_t length = shape_.width;
        for (size_t k = axes() - 1; k > 0; --k) {
            const std::vector<int64_t> layers = needed_layers(*tables_[k], sources_[k].degree);
            std::vector<Stretch> &joined = stretches_[k - 1];
            joined.reserve(layers.size() * inner.size());
            for (const int64_t layer : layers) {
                for (const Stretch &stretch : inner) {
                    append(joined, {layer * length + stretch.offset, stretch.length});
                }
            }
            length *= spline_.count(static_cast<int>(k));
            inner = joined;
        }
    }

    void make_slabs() {
        for (size_t k = 0; k + 1 < axes(); ++k) {
            const int axis = static_cast<int>(k);
            slabs_.length[k] = axis_view(spline_, axis, shape_.width).inner;
            const int64_t size = checked_product(slot_count(axis + 1, shape_.order), slabs_.length[k],
                                                 "working memory of the grid");
            storage_[k].reset(
                new double[static_cast<size_t>(size)]); // uninitialised, because only small parts may be used
            slabs_.data[k] = storage_[k].get();
        }
        rows_ = scratch_.take_aligned(static_cast<size_t>(rows_size()));
    }

    void make_groups() {
        const AxisSource &source = sources_[axes() - 1];
        groups_ = group_by_layers(last_table());
        int64_t next = 0;
        for (const GridGroup &group : groups_) {
            rising_ = rising_ && group.consecutive && group.position[0] >= next;
            next = group.position[0] + group.count;
        }
        const int64_t one = static_cast<int64_t>(shape_.order + 1) * (source.degree + 1) * grid_group;
        const auto size = static_cast<size_t>(checked_product(std::ssize(groups_), one, "params"));
        group_memory_.resize(size + Scratch::line);
        const size_t over =
            reinterpret_cast<uintptr_t>(group_memory_.data()) / sizeof(double) % Scratch::line;
        group_values_ = group_memory_.data() + (Scratch::line - over) % Scratch::line;
        transpose_values(last_table(), source, shape_.order, groups_, group_values_);
        for (int64_t i = 0; i < last_table().size(); ++i) {
            const AxisPoint &point = last_table().points[static_cast<size_t>(i)];
            if (!point.valid() || point.sole >= 0) {
                exceptions_.push_back(i);
            }
        }
    }

    const Spline &spline_;
    RecordShape shape_;
    const double *net_;
    AxisSources sources_;
    Scratch scratch_;
    std::optional<QuotientRule> quotient_;
    GridAxes tables_;
    std::array<std::vector<Stretch>, max_axes> stretches_;
    std::array<std::unique_ptr<double[]>, max_axes> storage_;
    std::vector<GridGroup> groups_;
    bool rising_ = true;
    std::vector<double> group_memory_;
    double *group_values_ = nullptr;
    std::vector<int64_t> exceptions_;
    Slabs slabs_;
    double *rows_ = nullptr;
};

// Whether a grid is evaluated faster as a list of points. Entering a parameter of the last axis into the
// tables of a grid costs as much as evaluating several points of a list, and a row of few points costs as
// much as a whole vector.
bool is_narrow(const Spline &spline, const std::array<ConstRecords, max_axes> &params) noexcept {
    constexpr int64_t fewest_rows = 16;
    constexpr int64_t fewest_columns = 4;
    constexpr int64_t many_columns = 256;
    const auto last = static_cast<size_t>(spline.axes() - 1);
    int64_t rows = 1;
    for (size_t k = 0; k < last; ++k) {
        rows *= params[k].count;
    }
    const int64_t columns = params[last].count;
    return columns < fewest_columns || (rows < fewest_rows && columns > many_columns);
}

// A grid cut into strips along the last axis, so that a row of a strip is one block for a sink.
class GridStrips {
public:
    GridStrips(const Spline &spline, const AxisRules &rules, int order,
               const std::array<ConstRecords, max_axes> &params, const BlockSink &sink)
        : points_(sink.wants_points()), size_(points_ ? BlockSink::most_points : block_size),
          last_(params[static_cast<size_t>(spline.axes() - 1)]),
          width_(slot_count(spline.axes(), order) * spline.dim()) {
        const auto last = static_cast<size_t>(spline.axes() - 1);
        for (int64_t i = 0; i < count(); ++i) {
            std::array<ConstRecords, max_axes> part = params;
            part[last].data = last_.record(i * size_);
            part[last].count = length(i);
            GridAxes shared = strips_.empty() ? GridAxes() : strips_.front()->tables();
            shared[last] = nullptr;
            strips_.push_back(std::make_unique<GridEvaluator>(spline, rules, order, part, std::move(shared)));
        }
    }

    [[nodiscard]] int64_t count() const noexcept { return (last_.count + size_ - 1) / size_; }

    // Writes the rows of strip `i` for parameter `row` of axis 0. `rows` is memory for one block.
    void write(int64_t i, int64_t row, double *rows, BlockSink &sink) noexcept {
        const Records block{rows, length(i), width_, points_ ? width_ : 1, points_ ? 1 : size_};
        strips_[static_cast<size_t>(i)]->write(block, row, row + 1, &sink, i * size_, last_.count);
    }

private:
    [[nodiscard]] int64_t length(int64_t i) const noexcept {
        return std::min(size_, last_.count - i * size_);
    }

    bool points_;
    int64_t size_; // of a block
    ConstRecords last_;
    int64_t width_;
    std::vector<std::unique_ptr<GridEvaluator>> strips_;
};

// Passes blocks of derivatives of the moved surface on to their sink, with the points in them replaced by the
// points of the stored surface.
class PointSink final : public BlockSink {
public:
    PointSink(const Spline &surface, const AxisRules &rules, const std::array<ConstRecords, max_axes> &params,
              double *rows, BlockSink &sink)
        : points_(surface, rules, 0, params, *this), columns_(params[1].count), rows_(rows), sink_(sink) {}
    virtual ~PointSink() = default;

    void operator()(int64_t first, ConstRecords values) noexcept override {
        class Nothing final : public BlockSink {
        public:
            virtual ~Nothing() = default;
            void operator()(int64_t, ConstRecords) noexcept override {}
        } nothing;
        points_.write(first % columns_ / block_size, first / columns_, rows_, nothing);
        sink_(first, values);
    }

private:
    GridStrips points_;
    int64_t columns_;
    double *rows_;
    BlockSink &sink_;
};

} // namespace

void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, const Records &out) {
    if (out.count == 0) {
        return;
    }
    if (spline.axes() == 1) {
        return evaluate_points(spline, rules, order, params[0], out);
    }
    if (is_narrow(spline, params)) {
        return evaluate_combinations(spline, rules, order, params, out);
    }
    const Spline &source = derivative_source(spline, order);
    GridEvaluator derivs(source, rules, order, params);
    std::optional<GridEvaluator> points;
    if (&source != &spline) {
        points.emplace(spline, rules, 0, params);
    }
    derivs.write(out);
    if (points) {
        points->write({out.data, out.count, spline.dim(), out.stride, out.component_stride});
    }
}

void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, BlockSink &sink) {
    if (spline.axes() == 1) {
        return evaluate_points(spline, rules, order, params[0], sink);
    }
    const Spline &source = derivative_source(spline, order);
    // PointSink finds a row by its parameter of axis 0, which does not identify the rows of a volume.
    if (is_narrow(spline, params) || (&source != &spline && spline.axes() > 2)) {
        return evaluate_combinations(spline, rules, order, params, sink);
    }
    const int64_t width = slot_count(spline.axes(), order) * spline.dim();
    const std::unique_ptr<double[]> rows(
        new double[static_cast<size_t>(checked_product(width, BlockSink::most_points, "points"))]);
    // All tables are made first, so that nothing is written if memory runs out.
    GridStrips strips(source, rules, order, params, sink);
    std::optional<PointSink> points;
    if (&source != &spline) {
        points.emplace(spline, rules, params, rows.get(), sink);
    }
    // Row by row, in the order of the caller's memory.
    for (int64_t row = 0; row < params[0].count; ++row) {
        for (int64_t i = 0; i < strips.count(); ++i) {
            strips.write(i, row, rows.get(), points ? *points : sink);
        }
    }
}

} // namespace nrb::eval
