// SPDX-License-Identifier: MIT
// Groups of group_size points, computed by vectors across the points: each component has a row of group_size
// doubles. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_ROWS_INL_H_
#undef NURBS_EVAL_KERNELS_ROWS_INL_H_
#else
#define NURBS_EVAL_KERNELS_ROWS_INL_H_
#endif

#include "eval/kernels/finish-inl.h"

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// Row r of a group begins at rows[r * group_size]. Component c of slot s is row s * width + c.
inline constexpr int group_size = 8;

// divide_record() for a group: for each point, the same operations on the same operands.
template <int kAxes, int kOrder>
HWY_INLINE void divide_rows(const RecordShape &shape, double *HWY_RESTRICT rows) {
    constexpr int slots = static_cast<int>(slot_count(kAxes, kOrder));
    const Vec8 d;
    using V = hn::Vec<Vec8>;
    const int64_t slot_size = static_cast<int64_t>(shape.width) * group_size;
    for (int i = 0; i < group_size; i += vec8_lanes) {
        V weights[slots];
        for (int s = 0; s < slots; ++s) {
            weights[s] = hn::Load(d, rows + s * slot_size + shape.dim * group_size + i);
        }
        const V inverse = hn::Div(hn::Set(d, 1.0), weights[0]);
        for (int c = 0; c < shape.dim; ++c) {
            double *const row = rows + c * group_size + i;
            V values[slots];
            for (int s = 0; s < slots; ++s) {
                values[s] = hn::Load(d, row + s * slot_size);
            }
            divide<kAxes, kOrder>(weights, inverse, values);
            for (int s = 0; s < slots; ++s) {
                hn::Store(values[s], d, row + s * slot_size);
            }
        }
    }
}

// The same for any order of derivatives.
static HWY_NOINLINE void divide_rows(const RecordShape &shape, const QuotientRule &rule,
                                     double *HWY_RESTRICT rows) {
    const Vec8 d;
    using V = hn::Vec<Vec8>;
    const int64_t slot_size = static_cast<int64_t>(shape.width) * group_size;
    for (int i = 0; i < group_size; i += vec8_lanes) {
        const double *weights = rows + shape.dim * group_size + i;
        const V inverse = hn::Div(hn::Set(d, 1.0), hn::Load(d, weights));
        int64_t s = 0;
        for_each_slot(shape.axes, shape.order, [&](int a, int b, int c) HWY_ATTR {
            for (int component = 0; component < shape.dim; ++component) {
                double *const row = rows + component * group_size + i;
                V sum = hn::Load(d, row + s * slot_size);
                rule.for_each_term(s, a, b, c, [&](const QuotientTerm &term) HWY_ATTR {
                    const V weight = hn::Load(d, weights + term.weight * slot_size);
                    const V factor = hn::Mul(hn::Set(d, term.binomial), weight);
                    sum = without(sum, factor, hn::Load(d, row + term.value * slot_size));
                });
                hn::Store(hn::Mul(sum, inverse), d, row + s * slot_size);
            }
            ++s;
        });
    }
}

HWY_INLINE void divide_group(const RecordShape &shape, const QuotientRule &rule, double *HWY_RESTRICT rows) {
    switch (10 * shape.axes + shape.order) {
    case 10:
    case 20:
    case 30:
        return divide_rows<1, 0>(shape, rows);
    case 11:
        return divide_rows<1, 1>(shape, rows);
    case 12:
        return divide_rows<1, 2>(shape, rows);
    case 21:
        return divide_rows<2, 1>(shape, rows);
    case 22:
        return divide_rows<2, 2>(shape, rows);
    default:
        divide_rows(shape, rule, rows);
    }
}

// Stores at most vec8_lanes points as packed records, `stride` doubles apart. next() returns the row of the
// next component. Four components are transposed at a time.
template <class NextRow>
HWY_INLINE void store_records(NextRow &&next, int64_t components, int count, double *target, int64_t stride) {
    const Vec8 d;
    const Vec4 quad;
    HWY_ALIGN double records[4 * vec8_lanes];
    if (components == 3 && stride == 3 && count == vec8_lanes) {
        const auto x = hn::LoadU(d, next());
        const auto y = hn::LoadU(d, next());
        return hn::StoreInterleaved3(x, y, hn::LoadU(d, next()), d, target);
    }
    int64_t c = 0;
    for (; c + 4 <= components; c += 4, target += 4) {
        const auto first = hn::LoadU(d, next());
        const auto second = hn::LoadU(d, next());
        const auto third = hn::LoadU(d, next());
        hn::StoreInterleaved4(first, second, third, hn::LoadU(d, next()), d, records);
        for (int i = 0; i < count; ++i) {
            for (int l = 0; l < 4; l += vec4_lanes) {
                hn::StoreU(hn::Load(quad, records + 4 * i + l), quad, target + i * stride + l);
            }
        }
    }
    for (; c < components; ++c, ++target) {
        const double *row = next();
        for (int i = 0; i < count; ++i) {
            target[i * stride] = row[i];
        }
    }
}

// Writes the first `count` points of a group to the caller's records first, first + 1, ...
class RowWriter {
public:
    RowWriter(const RecordShape &shape, const Records &out) : shape_(shape), out_(out) {}

    HWY_INLINE void operator()(int64_t first, int count, const double *rows) const {
        if (out_.stride == 1) {
            write_separate(first, count, rows);
        } else if (out_.component_stride == 1) {
            write_packed(first, count, rows);
        } else {
            for (int i = 0; i < count; ++i) {
                scatter(first + i, i, rows);
            }
        }
    }

    // Writes point i of the group to any record.
    HWY_INLINE void scatter(int64_t record, int i, const double *rows) const {
        double *target = out_.record(record);
        for (int64_t s = 0; s < shape_.slots; ++s) {
            for (int c = 0; c < shape_.dim; ++c) {
                *target = rows[(s * shape_.width + c) * group_size + i];
                target += out_.component_stride;
            }
        }
    }

private:
    // Iterates over the rows of a group in the order of the caller's components, skipping the weight.
    class Rows {
    public:
        Rows(const RecordShape &shape, const double *rows)
            : row_(rows), dim_(shape.dim), skipped_(shape.width - shape.dim) {}
        HWY_INLINE const double *operator()() {
            if (used_ == dim_) {
                row_ += static_cast<int64_t>(skipped_) * group_size;
                used_ = 0;
            }
            ++used_;
            return std::exchange(row_, row_ + group_size);
        }

    private:
        const double *row_;
        int dim_;
        int skipped_;
        int used_ = 0;
    };

    HWY_INLINE void write_separate(int64_t first, int count, const double *rows) const {
        double *target = out_.record(first);
        Rows next(shape_, rows);
        for (int64_t c = 0; c < shape_.values(); ++c, target += out_.component_stride) {
            const double *row = next();
            for (int i = 0; i < count; i += vec8_lanes) {
                store_some(hn::Load(Vec8(), row + i), count - i, target + i);
            }
        }
    }

    HWY_INLINE void write_packed(int64_t first, int count, const double *rows) const {
        for (int i = 0; i < count; i += vec8_lanes) {
            store_records(Rows(shape_, rows + i), shape_.values(), std::min(vec8_lanes, count - i),
                          out_.record(first + i), out_.stride);
        }
    }

    const RecordShape &shape_;
    const Records &out_;
};

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
