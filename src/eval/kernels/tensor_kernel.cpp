// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/tensor_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/kernels/axis-inl.h"
#include "eval/kernels/contract-inl.h"
#include "eval/kernels/finish-inl.h"
#include "eval/kernels/tensor_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// Evaluates a surface or a volume block by block. Points at which a parameter gives NaN or a control point is
// interpolated are corrected after each block by mend().
class TensorKernel {
public:
    TensorKernel(const TensorJob &job, const ConstRecords &params, const Records &out)
        : job_(job), params_(params), out_(out), axes_(job.spline.axes()),
          write_(job.shape, job.quotient, job.weights, out) {
        int64_t stride = job.shape.width;
        for (int k = axes_ - 1; k >= 0; --k) {
            strides_[k] = stride;
            stride *= job.spline.count(k);
        }
    }

    void run() {
        switch (job_.shape.order) {
        case 0:
            return run_order<1>();
        case 1:
            return run_order<2>();
        case 2:
            return run_order<3>();
        default:
            return run_blocks<most_orders, -1>();
        }
    }

private:
    // The most frequent shapes have loops of their own, with the same results.
    template <int kOrders>
    void run_order() {
        bool cubic = true;
        for (int k = 0; k < axes_; ++k) {
            cubic = cubic && job_.sources[k].degree == 3;
        }
        if (cubic && job_.shape.lanes == 4 && (axes_ == 2 || kOrders <= 2)) {
            run_blocks<kOrders, 3>();
        } else {
            run_blocks<kOrders, -1>();
        }
    }

    template <int kOrders, int kDegree>
    HWY_NOINLINE void run_blocks() {
        for (int64_t first = 0; first < params_.count; first += job_.block) {
            const int64_t count = std::min(job_.block, params_.count - first);
            bool special = false;
            for (int k = 0; k < axes_; ++k) {
                const auto at = static_cast<size_t>(k);
                const double *params = params_.record(first) + k * params_.component_stride;
                special |=
                    axis_block<kOrders, kDegree>(job_.sources[at], job_.shape.order, params, params_.stride,
                                                 count, job_.points[at], job_.values[at]);
            }
            if constexpr (kDegree == 3) {
                job_.shape.width == 4 ? contract_quads<kOrders, 4>(first, count, special)
                                      : contract_quads<kOrders, -1>(first, count, special);
            } else if (kOrders < most_orders && axes_ == 2 && job_.shape.lanes == 4) {
                contract_surfaces<std::min(kOrders, 3)>(first, count, special);
            } else {
                contract_all(first, count, special);
            }
            if (special) {
                mend(first, count);
            }
        }
    }

    HWY_NOINLINE void contract_all(int64_t first, int64_t count, bool special) {
        for (int64_t i = 0; i < count; ++i) {
            if (!special || valid(i)) {
                contract(i);
            }
        }
        write_(first, count, job_.records);
    }

    // Surfaces with records of at most four components: axis 0 is contracted in wide vectors, axis 1 in
    // registers, from which the result goes to the caller's array.
    template <int kOrders>
    HWY_NOINLINE void contract_surfaces(int64_t first, int64_t count, bool special) {
        QuadWriter write(job_.shape, out_);
        const AxisSource &u = job_.sources[0];
        const AxisSource &v = job_.sources[1];
        const int width = job_.shape.width;
        const int64_t row = padded(job_.slabs.length[0]);
        double *slab = job_.slabs.data[0];
        constexpr int slots = static_cast<int>(slot_count(2, kOrders - 1));
        for (int64_t i = 0; i < count; ++i) {
            if (special && !valid(i)) {
                write.template skip<slots>(first + i);
                continue;
            }
            const QuadWindow from = quad_window(i);
            contract_rows_of_orders<kOrders>(job_.values[0] + i * kOrders * u.lanes, u.lanes, u.degree + 1,
                                             from.records, from.stride, row, slab);
            QuadRecord<slots> record;
            const double *values = job_.values[1] + i * kOrders * v.lanes;
            for (int a = 0; a < kOrders; ++a) {
                for (int b = 0; a + b < kOrders; ++b) {
                    for (int part = 0; part < record.parts; ++part) {
                        record.values[part][slot(2, a, b)] =
                            contracted<-1>(Vec4(), values + b * v.lanes, v.degree + 1,
                                           slab + a * row + part * vec4_lanes, width);
                    }
                }
            }
            finish<2, kOrders>(record, write, first + i);
        }
        write.template finish<slots>(first + count - 1);
    }

    // Cubic nets with records of at most four components, in registers from the net to the caller's array.
    // The sums are those of contract(), one column of the last axis at a time.
    template <int kOrders, int kWidth>
    HWY_NOINLINE void contract_quads(int64_t first, int64_t count, bool special) {
        QuadWriter write(job_.shape, out_);
        constexpr int surface_slots = static_cast<int>(slot_count(2, kOrders - 1));
        constexpr int volume_slots = static_cast<int>(slot_count(3, kOrders - 1));
        const bool surface = axes_ == 2;
        const std::array<double *, max_axes> tables = job_.values;
        for (int64_t i = 0; i < count; ++i) {
            if (special && !valid(i)) {
                if (surface) {
                    write.template skip<surface_slots>(first + i);
                } else if constexpr (kOrders <= 2) {
                    write.template skip<volume_slots>(first + i);
                }
                continue;
            }
            const QuadWindow from = quad_window(i);
            const int64_t at = i * kOrders * 4;
            const double *values[max_axes] = {tables[0] + at, tables[1] + at,
                                              surface ? nullptr : tables[2] + at};
            if (surface) {
                QuadRecord<surface_slots> record;
                contract_surface<kOrders, kWidth>(from, values, record);
                finish<2, kOrders>(record, write, first + i);
            } else if constexpr (kOrders <= 2) {
                QuadRecord<volume_slots> record;
                contract_volume<kOrders>(from, values, record);
                finish<3, kOrders>(record, write, first + i);
            }
        }
        if (surface) {
            write.template finish<surface_slots>(first + count - 1);
        } else if constexpr (kOrders <= 2) {
            write.template finish<volume_slots>(first + count - 1);
        }
    }

    template <int kAxes, int kOrders, class Record>
    HWY_INLINE void finish(Record &record, QuadWriter &write, int64_t i) const {
        if (job_.quotient != nullptr) {
            record.template divide_by_weight<kAxes, kOrders - 1>(job_.shape.dim);
        }
        write(record, i);
    }

    // The active records of one point: in the net, or copied.
    struct QuadWindow {
        const double *records;
        int64_t stride; // between rows of axis 0
        int64_t inner;  // between rows of axis 1, of a volume
    };

    HWY_INLINE QuadWindow quad_window(int64_t i) const {
        const AxisPoint *const *points = job_.points.data();
        int64_t start = points[0][i].first * strides_[0] + points[1][i].first * strides_[1];
        start += axes_ == 2 ? 0 : points[2][i].first * strides_[2];
        if (HWY_UNLIKELY(job_.net == nullptr)) {
            copy_window(i);
            return {job_.window, job_.slabs.length[0], job_.slabs.length[1]};
        }
        return {job_.net + start, strides_[0], strides_[1]};
    }

    // sums[a] = the column of four records that begins at `rows`, contracted with derivative a of the
    // functions of axis 0.
    template <int kOrders>
    HWY_INLINE void contract_column(const double *HWY_RESTRICT values, const double *HWY_RESTRICT rows,
                                    int64_t stride, int part, hn::Vec<Vec4> *HWY_RESTRICT sums) const {
        const Vec4 d;
        std::fill_n(sums, kOrders, hn::Zero(d));
        for (int i = 0; i <= 3; ++i, rows += stride) {
            const auto row = hn::LoadU(d, rows + part * vec4_lanes);
            for (int a = 0; a < kOrders; ++a) {
                const auto value = hn::Set(d, values[a * 4 + i]);
                sums[a] = i == 0 ? hn::Mul(value, row) : hn::MulAdd(value, row, sums[a]);
            }
        }
    }

#if HWY_MAX_BYTES >= 64
    // contract_column() for two columns of four components each, in one vector.
    template <int kOrders>
    HWY_INLINE void contract_pair(const double *HWY_RESTRICT values, const double *HWY_RESTRICT rows,
                                  int64_t stride, hn::Vec<Vec4> (*HWY_RESTRICT sums)[kOrders]) const {
        const Vec8 d;
        hn::Vec<Vec8> both[kOrders];
        for (int i = 0; i <= 3; ++i, rows += stride) {
            const auto row = hn::LoadU(d, rows);
            for (int a = 0; a < kOrders; ++a) {
                const auto value = hn::Set(d, values[a * 4 + i]);
                both[a] = i == 0 ? hn::Mul(value, row) : hn::MulAdd(value, row, both[a]);
            }
        }
        for (int a = 0; a < kOrders; ++a) {
            sums[0][a] = hn::LowerHalf(both[a]);
            sums[1][a] = hn::UpperHalf(Vec4(), both[a]);
        }
    }
#endif

    // contract_column() for all four columns of a window.
    template <int kOrders, int kWidth>
    HWY_INLINE void contract_columns(const double *HWY_RESTRICT values, const QuadWindow &from, int part,
                                     hn::Vec<Vec4> (*HWY_RESTRICT sums)[kOrders]) const {
#if HWY_MAX_BYTES >= 64
        if constexpr (kWidth == 4) {
            contract_pair<kOrders>(values, from.records, from.stride, sums);
            contract_pair<kOrders>(values, from.records + 8, from.stride, sums + 2);
            return;
        }
#endif
        for (int j = 0; j <= 3; ++j) {
            contract_column<kOrders>(values, from.records + j * job_.shape.width, from.stride, part, sums[j]);
        }
    }

    template <int kOrders, int kWidth, class Record>
    HWY_INLINE void contract_surface(const QuadWindow &from, const double *const *values,
                                     Record &record) const {
        const Vec4 d;
        for (int part = 0; part < record.parts; ++part) {
            hn::Vec<Vec4> columns[4][kOrders];
            contract_columns<kOrders, kWidth>(values[0], from, part, columns);
            for (int j = 0; j <= 3; ++j) {
                const auto *sums = columns[j];
                for (int b = 0; b < kOrders; ++b) {
                    const auto value = hn::Set(d, values[1][b * 4 + j]);
                    for (int a = 0; a + b < kOrders; ++a) {
                        auto &sum = record.values[part][slot(2, a, b)];
                        sum = j == 0 ? hn::Mul(value, sums[a]) : hn::MulAdd(value, sums[a], sum);
                    }
                }
            }
        }
    }

    template <int kOrders, class Record>
    HWY_INLINE void contract_volume(const QuadWindow &from, const double *const *values,
                                    Record &record) const {
        const Vec4 d;
        constexpr int kept = static_cast<int>(slot_count(2, kOrders - 1));
        for (int part = 0; part < record.parts; ++part) {
            for (int k = 0; k <= 3; ++k) {
                hn::Vec<Vec4> planes[kept];
                contract_plane<kOrders>(from, values, from.records + k * job_.shape.width, part, planes);
                for (int c = 0; c < kOrders; ++c) {
                    const auto value = hn::Set(d, values[2][c * 4 + k]);
                    for (int b = 0; b + c < kOrders; ++b) {
                        for (int a = 0; a + b + c < kOrders; ++a) {
                            auto &sum = record.values[part][slot(3, a, b, c)];
                            const auto &plane = planes[slot(2, a, b)];
                            sum = k == 0 ? hn::Mul(value, plane) : hn::MulAdd(value, plane, sum);
                        }
                    }
                }
            }
        }
    }

    // Contracts axes 0 and 1 of a volume for the columns with the same index along the last axis.
    template <int kOrders>
    HWY_INLINE void contract_plane(const QuadWindow &from, const double *const *values, const double *records,
                                   int part, hn::Vec<Vec4> *HWY_RESTRICT planes) const {
        const Vec4 d;
        std::fill_n(planes, slot_count(2, kOrders - 1), hn::Zero(d));
        for (int j = 0; j <= 3; ++j) {
            hn::Vec<Vec4> sums[kOrders];
            contract_column<kOrders>(values[0], records + j * from.inner, from.stride, part, sums);
            for (int b = 0; b < kOrders; ++b) {
                const auto value = hn::Set(d, values[1][b * 4 + j]);
                for (int a = 0; a + b < kOrders; ++a) {
                    auto &plane = planes[slot(2, a, b)];
                    plane = j == 0 ? hn::Mul(value, sums[a]) : hn::MulAdd(value, sums[a], plane);
                }
            }
        }
    }

    [[nodiscard]] bool valid(int64_t i) const {
        bool all = true;
        for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
            all = all && job_.points[k][i].valid();
        }
        return all;
    }

    // The rows of axis 0 that are active at a point. They are a window of the net: only segments along the
    // last axis are contiguous.
    struct Window {
        const double *rows;
        int64_t stride;   // between rows of axis 0
        int64_t segments; // of each row
        int64_t segment_stride;
        int64_t segment; // length
    };

    HWY_INLINE Window window(int64_t i) const {
        const QuadWindow from = quad_window(i);
        const int64_t row = job_.slabs.length[0];
        if (axes_ == 2 || job_.net == nullptr) {
            return {from.records, from.stride, 1, row, row};
        }
        const int64_t segment = job_.slabs.length[1];
        return {from.records, from.stride, row / segment, from.inner, segment};
    }

    // Copies the active records of point i, for a spline that has no table of records yet.
    HWY_NOINLINE void copy_window(int64_t i) const {
        const Spline &spline = job_.spline;
        const bool volume = axes_ == 3;
        const int64_t middles = volume ? job_.sources[1].degree + 1 : 1;
        const int64_t middle = volume ? job_.points[1][i].first : 0, breadth = volume ? spline.count(1) : 1;
        const auto last = static_cast<size_t>(axes_ - 1);
        const int64_t length = job_.sources[last].degree + 1;
        double *next = job_.window;
        for (int64_t a = 0; a <= job_.sources[0].degree; ++a) {
            for (int64_t b = 0; b < middles; ++b, next += length * job_.shape.width) {
                const int64_t row = (job_.points[0][i].first + a) * breadth + middle + b;
                spline.copy_records(row * spline.count(axes_ - 1) + job_.points[last][i].first, length, next);
            }
        }
    }

    HWY_INLINE void contract(int64_t i) const {
        const int order = job_.shape.order;
        const Window from = window(i);
        const double *values = job_.values[0] + i * job_.sources[0].values_size(order);
        for (int a = 0; a <= order; ++a) {
            double *slab = job_.slabs.data[0] + a * job_.slabs.length[0];
            for (int64_t s = 0; s < from.segments; ++s) {
                contract_rows(values + static_cast<int64_t>(a) * job_.sources[0].lanes,
                              job_.sources[0].degree + 1, from.rows + s * from.segment_stride, from.stride,
                              from.segment, slab + s * from.segment);
            }
        }
        if (axes_ == 3) {
            contract_level(1, i, job_.slabs.length[1], job_.slabs.length[1], job_.slabs.data[1]);
        }
        // Records are read with their padding, which is the beginning of the next record.
        contract_level(axes_ - 1, i, job_.shape.lanes, job_.shape.lanes,
                       job_.records + i * job_.shape.size());
    }

    // Contracts axis `level` of the slab before it: the first `length` doubles of each row. The results are
    // `stride` apart.
    HWY_INLINE void contract_level(int level, int64_t i, int64_t length, int64_t stride, double *out) const {
        const auto at = static_cast<size_t>(level);
        const AxisSource &source = job_.sources[at];
        const int order = job_.shape.order;
        const double *values = job_.values[at] + i * source.values_size(order);
        const double *slab = job_.slabs.data[at - 1];
        for_each_step(level, order, [&](int64_t from, int a, int64_t target) HWY_ATTR {
            contract_rows(values + static_cast<int64_t>(a) * source.lanes, source.degree + 1,
                          slab + from * job_.slabs.length[at - 1], job_.slabs.length[at], length,
                          out + target * stride);
        });
    }

    // Writes NaN for parameters that give it, and stored control points where they are interpolated.
    HWY_NOINLINE void mend(int64_t first, int64_t count) const {
        for (int64_t i = 0; i < count; ++i) {
            if (!valid(i)) {
                write_nan(job_.shape.values(), out_, first + i);
                continue;
            }
            const int64_t sole = sole_point(i);
            if (sole >= 0) {
                write_control_point(job_.spline, sole, out_, first + i);
            }
        }
    }

    // The index of the control point whose function is 1 at the parameter, all others being 0; -1 if there is
    // none.
    [[nodiscard]] int64_t sole_point(int64_t i) const {
        int64_t index = 0;
        for (int k = 0; k < axes_; ++k) {
            const AxisPoint &point = job_.points[static_cast<size_t>(k)][i];
            if (point.sole < 0) {
                return -1;
            }
            index = index * job_.spline.count(k) + point.first + point.sole;
        }
        return index;
    }

    const TensorJob &job_;
    const ConstRecords &params_;
    const Records &out_;
    int axes_;
    int64_t strides_[max_axes] = {}; // of the net, between layers of each axis
    RecordWriter write_;
};

void run_tensor(const TensorJob &job, const ConstRecords &params, const Records &out) {
    TensorKernel(job, params, out).run();
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(run_tensor);

void run(const TensorJob &job, const ConstRecords &params, const Records &out) noexcept {
    NURBS_BEST(run_tensor)(job, params, out);
}

} // namespace nrb::eval
#endif
