// SPDX-License-Identifier: MIT
// The division by the weight, and writers of records to the caller's array. Included once for every
// instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_FINISH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_FINISH_INL_H_
#undef NURBS_EVAL_KERNELS_FINISH_INL_H_
#else
#define NURBS_EVAL_KERNELS_FINISH_INL_H_
#endif

#include "eval/kernels/finish.h"
#include "eval/kernels/horner-inl.h"
#include "eval/kernels/quotient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// The quotient rule on one record of a shape whose terms are written out, in place.
template <int kAxes, int kOrder>
HWY_INLINE void divide_record(const RecordShape &shape, double *HWY_RESTRICT record) {
    constexpr int slots = static_cast<int>(slot_count(kAxes, kOrder));
    const Vec4 d;
    using V = hn::Vec<Vec4>;
    const int lanes = shape.lanes;
    const V inverse = hn::Set(d, 1 / record[shape.dim]);
    V weights[slots];
    for (int s = 1; s < slots; ++s) {
        weights[s] = hn::Set(d, record[s * lanes + shape.dim]);
    }
    for (int l = 0; l < lanes; l += vec4_lanes) {
        V values[slots];
        for (int s = 0; s < slots; ++s) {
            values[s] = hn::LoadU(d, record + s * lanes + l);
        }
        divide<kAxes, kOrder>(weights, inverse, values);
        for (int s = 0; s < slots; ++s) {
            hn::StoreU(values[s], d, record + s * lanes + l);
        }
    }
}

// A record of kSlots slots and kLanes lanes in registers. The constructor is written out, because one added
// by the compiler would not be compiled for the instruction set.
template <int kSlots, int kLanes = 4>
struct QuadRecord {
    static constexpr int parts = kLanes / vec4_lanes;
    hn::Vec<Vec4> values[parts][kSlots];

    HWY_INLINE QuadRecord() {}

    // Applies the quotient rule. The weight is component `dim`.
    template <int kAxes, int kOrder>
    HWY_INLINE void divide_by_weight(int dim) {
        static_assert(slot_count(kAxes, kOrder) == kSlots);
        const Vec4 d;
        hn::Vec<Vec4> weights[kSlots];
        for (int s = 1; s < kSlots; ++s) {
            weights[s] = hn::Set(d, component(s, dim));
        }
        const auto inverse = hn::Set(d, 1 / component(0, dim));
        for (int part = 0; part < parts; ++part) {
            divide<kAxes, kOrder>(weights, inverse, values[part]);
        }
    }

    [[nodiscard]] HWY_INLINE double component(int slot, int c) const {
        if (parts == 1 && c == 3) { // the weight in space: no detour through memory
            return hn::ExtractLane(values[0][slot], vec4_lanes - 1);
        }
        HWY_ALIGN double lanes[kLanes];
        store(slot, lanes);
        return lanes[c];
    }

    HWY_INLINE void store(int slot, double *target) const {
        for (int part = 0; part < parts; ++part) {
            hn::StoreU(values[part][slot], Vec4(), target + part * vec4_lanes);
        }
    }
};

// The quotient rule on one record for any order, in place. weights: [slots], working memory.
static HWY_NOINLINE void divide_record(const RecordShape &shape, const QuotientRule &rule,
                                       double *HWY_RESTRICT record, double *HWY_RESTRICT weights) {
    const Vec4 d;
    const int lanes = shape.lanes;
    const auto inverse = hn::Set(d, 1 / record[shape.dim]);
    for (int64_t s = 1; s < shape.slots; ++s) {
        weights[s] = record[s * lanes + shape.dim];
    }
    int64_t s = 0;
    for_each_slot(shape.axes, shape.order, [&](int i, int j, int k) HWY_ATTR {
        for (int l = 0; l < lanes; l += vec4_lanes) {
            double *const own = record + s * lanes + l;
            auto sum = hn::LoadU(d, own);
            rule.for_each_term(s, i, j, k, [&](const QuotientTerm &term) HWY_ATTR {
                const auto factor = hn::Set(d, term.binomial * weights[term.weight]);
                sum = without(sum, factor, hn::LoadU(d, record + term.value * lanes + l));
            });
            hn::StoreU(hn::Mul(sum, inverse), d, own);
        }
        ++s;
    });
}

// Stores the first `count` lanes of a vector. The memory after them may belong to another thread and is not
// written, except that, without masked stores, Highway's BlendedStore() may read it and write it back
// unchanged.
HWY_INLINE void store_some(hn::Vec<Vec8> values, int count, double *target) {
    const Vec8 d;
    if (count >= vec8_lanes) {
        return hn::StoreU(values, d, target);
    }
#if HWY_ARCH_X86
    hn::BlendedStore(values, hn::FirstN(d, static_cast<size_t>(count)), d, target);
#else
    HWY_ALIGN double lanes[vec8_lanes];
    hn::Store(values, d, lanes);
    std::copy_n(lanes, count, target);
#endif
}

// Writes records from registers, in rising order.
//
// Packed records are written with their weight and padding, which fall on the following slots and points;
// these are written later. Nothing after the last record is touched.
//
// If each component has a row of its own, records wait until there are enough for whole vectors of a row.
// Then skip() must be called for each missing record, whose place may be overwritten with anything, and
// finish() after the last one.
class QuadWriter {
public:
    QuadWriter(const RecordShape &shape, const Records &out)
        : out_(out.data), stride_(out.stride), component_stride_(out.component_stride),
          packed_count_(out.component_stride == 1 && out.stride == shape.values()
                            ? out.count - (shape.lanes - shape.dim + shape.values() - 1) / shape.values()
                            : 0),
          dim_(shape.dim), rows_(vec8_lanes > 1 && out.stride == 1 && out.component_stride > 1) {}

    template <int kSlots, int kLanes>
    HWY_INLINE void operator()(const QuadRecord<kSlots, kLanes> &record, int64_t i) {
        double *target = out_ + i * stride_;
        if (i < packed_count_) {
            for (int s = 0; s < kSlots; ++s, target += dim_) {
                record.store(s, target);
            }
        } else if (rows_) {
            wait(record, i);
        } else {
            write_values(record, target);
        }
    }

    // Whether records wait until there are enough for whole vectors of a row.
    [[nodiscard]] HWY_INLINE bool waits() const { return rows_; }

    // Call instead of writing record i.
    template <int kSlots, int kLanes = 4>
    HWY_INLINE void skip(int64_t i) {
        if (waiting_ && i % vec8_lanes + 1 == vec8_lanes) {
            write_rows<kSlots, kLanes>(i);
        }
    }

    // Call after the last record, written or skipped; `last` is its number.
    template <int kSlots, int kLanes = 4>
    HWY_INLINE void finish(int64_t last) {
        if (waiting_) {
            write_rows<kSlots, kLanes>(last);
        }
    }

private:
    template <int kSlots, int kLanes>
    HWY_INLINE void write_values(const QuadRecord<kSlots, kLanes> &record, double *target) const {
        for (int s = 0; s < kSlots; ++s) {
            HWY_ALIGN double lanes[kLanes];
            record.store(s, lanes);
            for (int c = 0; c < dim_; ++c, target += component_stride_) {
                *target = lanes[c];
            }
        }
    }

    // Stores a record among those that wait. Groups of four components of vec8_lanes records lie side by
    // side: [slot][group of four][vec8_lanes][4].
    template <int kSlots, int kLanes>
    HWY_INLINE void wait(const QuadRecord<kSlots, kLanes> &record, int64_t i) {
        static_assert(kSlots * kLanes <= most_waiting);
        const auto lane = static_cast<int>(i % vec8_lanes);
        for (int s = 0; s < kSlots; ++s) {
            for (int part = 0; part < record.parts; ++part) {
                const int l = part * vec4_lanes;
                double *quads = records_ + (s * kLanes + l / 4 * 4) * vec8_lanes;
                hn::Store(record.values[part][s], Vec4(), quads + lane * 4 + l % 4);
            }
        }
        waiting_ = true;
        if (lane + 1 == vec8_lanes) {
            write_rows<kSlots, kLanes>(i);
        }
    }

    template <int kSlots, int kLanes>
    HWY_INLINE void write_rows(int64_t last) {
        const Vec8 d;
        const auto count = static_cast<int>(last % vec8_lanes) + 1;
        double *target = out_ + (last + 1 - count);
        for (int s = 0; s < kSlots; ++s, target += dim_ * component_stride_) {
            for (int c = 0; c < dim_; c += 4) {
                hn::Vec<Vec8> rows[4];
                hn::LoadInterleaved4(d, records_ + (s * kLanes + c) * vec8_lanes, rows[0], rows[1], rows[2],
                                     rows[3]);
                for (int k = 0; k < std::min(4, dim_ - c); ++k) {
                    store_some(rows[k], count, target + (c + k) * component_stride_);
                }
            }
        }
        waiting_ = false;
    }

    static constexpr int most_waiting = 24; // the most doubles of a record
    double *out_;
    int64_t stride_;
    int64_t component_stride_;
    int64_t packed_count_;
    int dim_;
    bool rows_;
    bool waiting_ = false;
    HWY_ALIGN double records_[most_waiting * vec8_lanes];
};

HWY_INLINE void write_record(const RecordShape &shape, const double *record, const Records &out, int64_t i) {
    double *target = out.record(i);
    for (int64_t s = 0; s < shape.slots; ++s) {
        for (int c = 0; c < shape.dim; ++c) {
            *target = record[s * shape.lanes + c];
            target += out.component_stride;
        }
    }
}

// Writes a packed record of three coordinates per slot by stores of four doubles. The fourth falls on the
// next slot or point, which is written later. `last`: whether this is the last record, after which nothing
// may be touched.
HWY_INLINE void write_three(const RecordShape &shape, const double *record, double *target, bool last) {
    const Vec4 d;
    const int64_t whole = last ? shape.slots - 1 : shape.slots;
    for (int64_t s = 0; s < whole; ++s, target += 3) {
        for (int l = 0; l < 4; l += vec4_lanes) {
            hn::StoreU(hn::LoadU(d, record + s * 4 + l), d, target + l);
        }
    }
    if (last) {
        std::copy_n(record + whole * 4, 3, target);
    }
}

// Applies the quotient rule to records first, ..., first + count - 1 and writes them. records:
// [count][slots][lanes].
class RecordWriter {
public:
    RecordWriter(const RecordShape &shape, const QuotientRule *rule, double *weights, const Records &out)
        : shape_(shape), rule_(rule), weights_(weights), out_(out),
          packed_(shape.dim == 3 && shape.lanes == 4 && out.component_stride == 1 &&
                  out.stride == shape.values()) {}

    HWY_INLINE void operator()(int64_t first, int64_t count, double *records) const {
        for (int64_t i = 0; i < count; ++i, records += shape_.size()) {
            if (rule_ != nullptr) {
                divide(records);
            }
            if (packed_) {
                write_three(shape_, records, out_.record(first + i), first + i + 1 == out_.count);
            } else {
                write_record(shape_, records, out_, first + i);
            }
        }
    }

private:
    HWY_INLINE void divide(double *record) const {
        switch (10 * shape_.axes + shape_.order) {
        case 10:
        case 20:
        case 30:
            return divide_record<1, 0>(shape_, record);
        case 11:
            return divide_record<1, 1>(shape_, record);
        case 12:
            return divide_record<1, 2>(shape_, record);
        case 21:
            return divide_record<2, 1>(shape_, record);
        case 22:
            return divide_record<2, 2>(shape_, record);
        default:
            divide_record(shape_, *rule_, record, weights_);
        }
    }

    const RecordShape &shape_;
    const QuotientRule *rule_;
    double *weights_;
    const Records &out_;
    bool packed_;
};

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
