// Groups of points side by side: one row of group_size doubles for each component, vectors across the points.
// Included once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_ROWS_INL_H_
#undef NURBS_EVAL_ROWS_INL_H_
#else
#define NURBS_EVAL_ROWS_INL_H_
#endif

#include "eval/finish.h"
#include "eval/horner-inl.h"
#include "eval/quotient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb {
namespace HWY_NAMESPACE {

// Row r of a group is rows[r * group_size]; component c of slot s is row s * width + c.
inline constexpr int group_size = 8;

// divide_record() for a group: the same operations on the same operands, point by point.
template <int kAxes, int kOrder>
HWY_INLINE void divide_rows(const RecordShape &shape, double *HWY_RESTRICT rows) {
    constexpr int slots = static_cast<int>(slot_count(kAxes, kOrder));
    const Wide d;
    using V = hn::Vec<Wide>;
    const int64_t slot_size = static_cast<int64_t>(shape.width) * group_size;
    for (int i = 0; i < group_size; i += wide_lanes) {
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

// The same for any order.
static HWY_NOINLINE void divide_rows(const RecordShape &shape, const QuotientRule &rule,
                                     double *HWY_RESTRICT rows) {
    const Wide d;
    using V = hn::Vec<Wide>;
    const int64_t slot_size = static_cast<int64_t>(shape.width) * group_size;
    for (int i = 0; i < group_size; i += wide_lanes) {
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

// Writes the rows of `count` points to records first, first + 1, ...
class RowWriter {
public:
    RowWriter(const RecordShape &shape, const Records &out)
        : shape_(shape), out_(out), separate_(out.stride == 1),
          triples_(shape.dim == 3 && out.component_stride == 1) {}

    HWY_INLINE void operator()(int64_t first, int count, const double *rows) const {
        if (count == group_size && separate_) {
            write_separate(first, rows);
        } else if (count == group_size && triples_) {
            write_triples(first, rows);
        } else {
            write_any(first, count, rows);
        }
    }

    // A point of the group to any record.
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
    HWY_INLINE void write_separate(int64_t first, const double *rows) const {
        const Wide d;
        double *target = out_.record(first);
        for (int64_t s = 0; s < shape_.slots; ++s) {
            for (int c = 0; c < shape_.dim; ++c, target += out_.component_stride) {
                const double *row = rows + (s * shape_.width + c) * group_size;
                for (int i = 0; i < group_size; i += wide_lanes) {
                    hn::StoreU(hn::Load(d, row + i), d, target + i);
                }
            }
        }
    }

    HWY_INLINE void write_triples(int64_t first, const double *rows) const {
        const Wide d;
        double *target = out_.record(first);
        if (shape_.slots == 1 && out_.stride == 3) {
            for (int i = 0; i < group_size; i += wide_lanes) {
                const double *x = rows + i;
                hn::StoreInterleaved3(hn::Load(d, x), hn::Load(d, x + group_size),
                                      hn::Load(d, x + 2 * group_size), d, target + 3 * i);
            }
            return;
        }
        for (int64_t s = 0; s < shape_.slots; ++s) {
            write_slot(rows + s * shape_.width * group_size, target + 3 * s, s + 1 == shape_.slots);
        }
    }

    // Four doubles at a time: the fourth falls on the next slot, which is written later.
    HWY_INLINE void write_slot(const double *x, double *target, bool last) const {
        const Wide wide;
        const Quad quad;
        HWY_ALIGN double records[4 * group_size];
        for (int i = 0; i < group_size; i += wide_lanes) {
            hn::StoreInterleaved4(hn::Load(wide, x + i), hn::Load(wide, x + group_size + i),
                                  hn::Load(wide, x + 2 * group_size + i), hn::Zero(wide), wide,
                                  records + 4 * i);
        }
        for (int i = 0; i < group_size; ++i, target += out_.stride) {
            if (last) {
                std::copy_n(records + 4 * i, 3, target);
                continue;
            }
            for (int l = 0; l < 4; l += quad_lanes) {
                hn::StoreU(hn::Load(quad, records + 4 * i + l), quad, target + l);
            }
        }
    }

    HWY_INLINE void write_any(int64_t first, int count, const double *rows) const {
        for (int i = 0; i < count; ++i) {
            scatter(first + i, i, rows);
        }
    }

    const RecordShape &shape_;
    const Records &out_;
    bool separate_;
    bool triples_;
};

} // namespace HWY_NAMESPACE
} // namespace nrb
HWY_AFTER_NAMESPACE();

#endif
