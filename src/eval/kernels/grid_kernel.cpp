// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/grid_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/kernels/axis-inl.h"
#include "eval/kernels/contract-inl.h"
#include "eval/kernels/grid_kernel.h"
#include "eval/kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

static_assert(grid_group == group_size);

// Evaluates a grid, or a strip of one: contracts the axes recursively and writes row after row of the last
// axis.
class GridKernel {
public:
    explicit GridKernel(const GridJob &job)
        : job_(job), last_(job.spline.axes() - 1), write_(job.shape, job.out) {}

    // The net is contracted along axis 0 once for each parameter of axis 0, the result along axis 1 once for
    // each pair of parameters, and so on.
    void run() { descend(0, 0); }

private:
    // Contracts axis `level` for each of its parameters, then the axes after it. `row`: the number of the
    // combination of parameters chosen on the axes before.
    void descend(int level, int64_t row) {
        const GridAxis &table = *job_.tables[static_cast<size_t>(level)];
        const int64_t begin = level == 0 ? job_.begin : 0;
        const int64_t end = level == 0 ? job_.end : table.size();
        for (int64_t i = begin; i < end; ++i) {
            chosen_[level] = table.points[static_cast<size_t>(i)];
            if (chosen_[level].valid()) {
                contract(level, i);
            }
            const int64_t next = row * table.size() + i;
            if (level + 1 < last_) {
                descend(level + 1, next);
            } else if (job_.sink == nullptr) {
                write_row(next * job_.tables[static_cast<size_t>(last_)]->size());
            } else {
                write_row(0);
                const Records &rows = job_.out;
                (*job_.sink)(job_.sink_first + next * job_.sink_stride,
                             {rows.data, rows.count, rows.width, rows.stride, rows.component_stride});
            }
        }
    }

    // Contracts axis `level` with the functions of its parameter i, over the stretches that are needed.
    void contract(int level, int64_t i) const {
        const auto at = static_cast<size_t>(level);
        const AxisSource &source = job_.sources[at];
        const int order = job_.shape.order;
        const int64_t length = job_.slabs.length[at];
        const int64_t before = level == 0 ? 0 : job_.slabs.length[at - 1];
        const double *net = level == 0 ? job_.net : job_.slabs.data[at - 1];
        const double *values = job_.tables[at]->values.data() + i * source.values_size(order);
        for_each_step(level, order, [&](int64_t from, int a, int64_t target) HWY_ATTR {
            const double *rows = net + from * before + chosen_[level].first * length;
            for (const Stretch &stretch : job_.stretches[at]) {
                contract_rows(values + static_cast<int64_t>(a) * source.lanes, source.degree + 1,
                              rows + stretch.offset, length, stretch.length,
                              job_.slabs.data[at] + target * length + stretch.offset);
            }
        });
    }

    // Evaluates all parameters of the last axis. `first`: the number of the grid point of the first of them.
    void write_row(int64_t first) const {
        for (int k = 0; k < last_; ++k) {
            if (!chosen_[k].valid()) {
                return write_nan_row(first);
            }
        }
        write_groups(first);
        for (const int64_t position : job_.exceptions) {
            mend(position, first);
        }
    }

    // The usual shapes of grids have loops of their own, with the same results.
    void write_groups(int64_t first) const {
        const bool rational = job_.quotient != nullptr && job_.shape.width == 4;
        const bool polynomial = job_.quotient == nullptr && job_.shape.width == 3;
        if (last_ == 1 && job_.shape.order == 0 && rational) {
            write_triples<1, 4>(first);
        } else if (last_ == 1 && job_.shape.order == 0 && polynomial) {
            write_triples<1, 3>(first);
        } else if (last_ == 1 && job_.shape.order == 1 && rational) {
            write_triples<2, 4>(first);
        } else if (last_ == 1 && job_.shape.order == 1 && polynomial) {
            write_triples<2, 3>(first);
        } else {
            write_any(first);
        }
    }

    [[nodiscard]] int64_t values_of_group() const {
        return static_cast<int64_t>(job_.shape.order + 1) *
               (job_.sources[static_cast<size_t>(last_)].degree + 1) * group_size;
    }

    HWY_NOINLINE void write_any(int64_t first) const {
        const double *values = job_.group_values;
        for (const GridGroup &group : job_.groups) {
            contract_group(group, values);
            if (job_.quotient != nullptr) {
                divide_group(job_.shape, *job_.quotient, job_.rows);
            }
            write_group(group, first);
            values += values_of_group();
        }
    }

    // Surfaces in space, polynomial (kWidth = 3) or rational (kWidth = 4): the sums stay in registers up to
    // the division.
    template <int kOrders, int kWidth>
    HWY_NOINLINE void write_triples(int64_t first) const {
        constexpr int slots = static_cast<int>(slot_count(2, kOrders - 1));
        using V = hn::Vec<Vec8>;
        const Vec8 d;
        const int functions = job_.sources[1].degree + 1;
        const int64_t size = values_of_group();
        const int64_t length = job_.slabs.length[0];
        const bool separate = job_.out.stride == 1;
        const bool packed = slots == 1 && job_.out.component_stride == 1 && job_.out.stride == 3;
        const double *values = job_.group_values;
        for (const GridGroup &group : job_.groups) {
            const double *slab = job_.slabs.data[0] + group.first * kWidth;
            const int64_t start = first + group.position[0];
            // What an incomplete group writes beyond its own points is overwritten later by these points.
            const bool whole =
                group.count == group_size || (job_.rising && start + group_size <= job_.out.count);
            const bool direct = group.consecutive && (separate || (packed && whole));
            for (int i = 0; i < group_size; i += vec8_lanes) {
                V sums[kWidth][slots];
                divided_slots<kOrders, kWidth>(values + i, functions, slab, length, sums);
                if (direct && packed) {
                    double *target = job_.out.data + 3 * (start + i);
                    hn::StoreInterleaved3(sums[0][0], sums[1][0], sums[2][0], d, target);
                } else if (direct && i < group.count) {
                    store_separate<slots>(sums, group.count - i, job_.out.data + start + i);
                } else {
                    store_rows<slots, kWidth>(sums, i);
                }
            }
            if (!direct) {
                write_group(group, first);
            }
            values += size;
        }
    }

    // The points and derivatives at a vector of parameters.
    template <int kOrders, int kWidth>
    static HWY_INLINE void divided_slots(const double *HWY_RESTRICT values, int functions,
                                         const double *HWY_RESTRICT slab, int64_t length,
                                         hn::Vec<Vec8> (*sums)[slot_count(2, kOrders - 1)]) {
        contract_slots<kOrders, kWidth>(values, functions, slab, length, sums);
        if (kWidth == 4) {
            const auto inverse = hn::Div(hn::Set(Vec8(), 1.0), sums[kWidth - 1][0]);
            for (int c = 0; c < 3; ++c) {
                divide<2, kOrders - 1>(sums[kWidth - 1], inverse, sums[c]);
            }
        }
    }

    // Stores the first `count` lanes to an array of the caller in which each component is an array of its
    // own.
    template <int kSlots>
    HWY_INLINE void store_separate(const hn::Vec<Vec8> (*sums)[kSlots], int count, double *target) const {
        for (int s = 0; s < kSlots; ++s) {
            for (int c = 0; c < 3; ++c) {
                store_some(sums[c][s], count, target + (s * 3 + c) * job_.out.component_stride);
            }
        }
    }

    // Stores lanes i, i + 1, ... of the group to the rows that write_group() reads.
    template <int kSlots, int kWidth>
    HWY_INLINE void store_rows(const hn::Vec<Vec8> (*sums)[kSlots], int i) const {
        for (int s = 0; s < kSlots; ++s) {
            for (int c = 0; c < 3; ++c) {
                hn::Store(sums[c][s], Vec8(), job_.rows + (s * kWidth + c) * group_size + i);
            }
        }
    }

    // contract_rows() for a vector of points: all components and slots at once.
    template <int kOrders, int kWidth>
    static HWY_INLINE void contract_slots(const double *HWY_RESTRICT values, int functions,
                                          const double *HWY_RESTRICT slab, int64_t length,
                                          hn::Vec<Vec8> (*sums)[slot_count(2, kOrders - 1)]) {
        add_function<kOrders, kWidth, true>(values, functions, slab, length, sums);
        for (int j = 1; j < functions; ++j) {
            add_function<kOrders, kWidth, false>(values + j * group_size, functions, slab + j * kWidth,
                                                 length, sums);
        }
    }

    template <int kOrders, int kWidth, bool kFirst>
    static HWY_INLINE void add_function(const double *HWY_RESTRICT values, int functions,
                                        const double *HWY_RESTRICT slab, int64_t length,
                                        hn::Vec<Vec8> (*sums)[slot_count(2, kOrders - 1)]) {
        using V = hn::Vec<Vec8>;
        const Vec8 d;
        for (int a = 0; a < kOrders; ++a) {
            for (int b = 0; a + b < kOrders; ++b) {
                const V value = hn::Load(d, values + b * functions * group_size);
                for (int c = 0; c < kWidth; ++c) {
                    const V row = hn::Set(d, slab[a * length + c]);
                    V &sum = sums[c][slot(2, a, b)];
                    sum = kFirst ? hn::Mul(value, row) : hn::MulAdd(value, row, sum);
                }
            }
        }
    }

    HWY_INLINE void contract_group(const GridGroup &group, const double *values) const {
        switch (job_.shape.width) {
        case 3:
            return contract_width<3>(group, values);
        case 4:
            return contract_width<4>(group, values);
        default:
            return contract_width<1>(group, values);
        }
    }

    // contract_rows() for a group of points: kWidth components at a time.
    template <int kWidth>
    HWY_INLINE void contract_width(const GridGroup &group, const double *HWY_RESTRICT values) const {
        const auto at = static_cast<size_t>(last_);
        const int width = job_.shape.width;
        const int functions = job_.sources[at].degree + 1;
        const double *slab = job_.slabs.data[at - 1] + group.first * width;
        const int64_t length = job_.slabs.length[at - 1];
        for_each_step(last_, job_.shape.order, [&](int64_t from, int a, int64_t target) HWY_ATTR {
            for (int c = 0; c < width; c += kWidth) {
                for (int i = 0; i < group_size; i += vec8_lanes) {
                    contract_components<kWidth>(values + static_cast<int64_t>(a) * functions * group_size + i,
                                                functions, slab + from * length + c, width,
                                                job_.rows + (target * width + c) * group_size + i);
                }
            }
        });
    }

    template <int kWidth>
    static HWY_INLINE void contract_components(const double *HWY_RESTRICT values, int functions,
                                               const double *HWY_RESTRICT rows, int width,
                                               double *HWY_RESTRICT out) {
        const Vec8 d;
        hn::Vec<Vec8> sums[kWidth];
        const auto start = hn::Load(d, values);
        for (int c = 0; c < kWidth; ++c) {
            sums[c] = hn::Mul(start, hn::Set(d, rows[c]));
        }
        for (int j = 1; j < functions; ++j) {
            const auto value = hn::Load(d, values + j * group_size);
            rows += width;
            for (int c = 0; c < kWidth; ++c) {
                sums[c] = hn::MulAdd(value, hn::Set(d, rows[c]), sums[c]);
            }
        }
        for (int c = 0; c < kWidth; ++c) {
            hn::Store(sums[c], d, out + c * group_size);
        }
    }

    HWY_INLINE void write_group(const GridGroup &group, int64_t first) const {
        if (group.consecutive) {
            return write_(first + group.position[0], group.count, job_.rows);
        }
        for (int i = 0; i < group.count; ++i) {
            write_.scatter(first + group.position[i], i, job_.rows);
        }
    }

    void write_nan_row(int64_t first) const {
        for (int64_t i = 0; i < job_.tables[static_cast<size_t>(last_)]->size(); ++i) {
            write_nan(job_.shape.values(), job_.out, first + i);
        }
    }

    // Corrects a grid point after its row was written: NaN if the parameter of the last axis gives NaN, or
    // the stored control point if its function is 1 on every axis.
    void mend(int64_t position, int64_t first) const {
        const AxisPoint &own = job_.tables[static_cast<size_t>(last_)]->points[static_cast<size_t>(position)];
        if (!own.valid()) {
            return write_nan(job_.shape.values(), job_.out, first + position);
        }
        int64_t index = 0;
        for (int k = 0; k <= last_; ++k) {
            const AxisPoint &point = k < last_ ? chosen_[k] : own;
            if (point.sole < 0) {
                return;
            }
            index = index * job_.spline.count(k) + point.first + point.sole;
        }
        write_control_point(job_.spline, index, job_.out, first + position);
    }

    const GridJob &job_;
    int last_;
    RowWriter write_;
    AxisPoint chosen_[max_axes];
};

void tabulate_axis(const AxisSource &source, int order, ConstRecords params, GridAxis &table) {
    double *values = table.values.data();
    for (int64_t i = 0; i < params.count; ++i, values += source.values_size(order)) {
        table.points[static_cast<size_t>(i)] = axis_values(source, order, params(i, 0), values);
    }
}

void run_grid(const GridJob &job) {
    GridKernel(job).run();
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(tabulate_axis);
NURBS_FORMS(run_grid);

void tabulate(const AxisSource &source, int order, ConstRecords params, GridAxis &table) noexcept {
    NURBS_BEST(tabulate_axis)(source, order, params, table);
}

void run(const GridJob &job) noexcept {
    NURBS_BEST(run_grid)(job);
}

} // namespace nrb::eval
#endif
