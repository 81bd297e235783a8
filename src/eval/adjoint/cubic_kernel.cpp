// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/adjoint/cubic_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/adjoint/net_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// The sums of the gradients for cubic curves in space, with the symbols of net_kernel.h. A block is computed
// in three passes, so that no parameter waits for the divisions and the sums across lanes of another one: the
// sums of each parameter; q, h and the slope of each; the sums for the control points. As long as consecutive
// parameters share a span, its data and its sums stay in registers.
template <bool kRational, bool kProducts>
class CubicKernel {
public:
    CubicKernel(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t end)
        : job_(job), cotangents_(cotangents), arrays_(job), points_(job.points[0]), values_(job.values[0]),
          values_size_(4 * (job.order + 1)), first_(first), end_(end) {}

    void run() {
        if constexpr (kProducts) {
            sum_products();
            finish();
        } else if constexpr (kRational) {
            sum_weights();
        }
        if (arrays_.grad_points != nullptr || (kProducts && arrays_.grad_weights != nullptr)) {
            add();
        }
    }

private:
    static constexpr int parts = 4 / vec4_lanes;

    // Four numbers, one for each active control point, in one vector or more.
    struct Quad {
        Vector values[parts];

        HWY_INLINE Quad() : Quad(0.0) {}
        HWY_INLINE explicit Quad(double value) {
            for (int part = 0; part < parts; ++part) {
                values[part] = hn::Set(Vec4(), value);
            }
        }
        HWY_INLINE explicit Quad(const double *from) {
            for (int part = 0; part < parts; ++part) {
                values[part] = hn::LoadU(Vec4(), from + part * vec4_lanes);
            }
        }
        HWY_INLINE void store(double *to) const {
            for (int part = 0; part < parts; ++part) {
                hn::StoreU(values[part], Vec4(), to + part * vec4_lanes);
            }
        }
    };
    // The sum of the vectors of a quad, or of the products of two quads, lane by lane. It begins with 0 or
    // with a product added to 0.
    static HWY_INLINE Vector lanes_of(const Quad &a) {
        auto sum = hn::Add(hn::Zero(Vec4()), a.values[0]);
        for (int part = 1; part < parts; ++part) {
            sum = hn::Add(sum, a.values[part]);
        }
        return sum;
    }
    static HWY_INLINE Vector lanes_of(const Quad &a, const Quad &b) {
        auto sum = hn::MulAdd(a.values[0], b.values[0], hn::Zero(Vec4()));
        for (int part = 1; part < parts; ++part) {
            sum = hn::MulAdd(a.values[part], b.values[part], sum);
        }
        return sum;
    }
    static HWY_INLINE Quad times(const Quad &a, const Quad &b) {
        Quad result;
        for (int part = 0; part < parts; ++part) {
            result.values[part] = hn::Mul(a.values[part], b.values[part]);
        }
        return result;
    }
    static HWY_INLINE void add_product(const Quad &a, Vector b, Quad &sum) {
        for (int part = 0; part < parts; ++part) {
            sum.values[part] = hn::MulAdd(a.values[part], b, sum.values[part]);
        }
    }

    // The weights of the active control points, and their positions relative to P, the first of them, by
    // coordinates.
    struct Active {
        Quad weights;
        Quad offsets[3];

        HWY_INLINE Active(const NetArrays &arrays, int64_t start) {
            if constexpr (kRational) {
                weights = Quad(arrays.weights + start);
            }
            for (int c = 0; kProducts && c < 3; ++c) {
                const double *own = arrays.coordinates + c * arrays.size + start;
                offsets[c] = Quad(own);
                for (int part = 0; part < parts; ++part) {
                    offsets[c].values[part] = hn::Sub(offsets[c].values[part], hn::Set(Vec4(), own[0]));
                }
            }
        }
    };

    // Calls visit(i, first) for each run of consecutive parameters with the same first active control point,
    // `first`. visit returns the first parameter after the run. Parameters that give NaN are skipped.
    template <class Visit>
    HWY_INLINE void for_each_run(Visit &&visit) const {
        for (int64_t i = first_; i < end_;) {
            i = points_[i].valid() ? visit(i, points_[i].first) : i + 1;
        }
    }
    [[nodiscard]] HWY_INLINE bool goes_on(int64_t i, int64_t start) const {
        return i < end_ && points_[i].first == start;
    }

    [[nodiscard]] HWY_INLINE const double *values(int64_t i) const { return values_ + i * values_size_; }

    // Computes d_i = <P_i - P, g> for each active control point, and the sums of N_i w_i and N_i w_i d_i, and
    // of the same with N_i' for N_i.
    HWY_NOINLINE void sum_products() {
        const ConstRecords cotangents = cotangents_;
        const bool slopes = job_.slopes != nullptr;
        const double *const values = values_;
        const int64_t size = values_size_;
        for_each_run([&](int64_t i, int64_t start) HWY_ATTR {
            const Active active(arrays_, start);
            do {
                Quad products;
                const double *g = cotangents.record(i);
                for (int c = 0; c < 3; ++c) {
                    add_product(active.offsets[c], hn::Set(Vec4(), g[c * cotangents.component_stride]),
                                products);
                }
                products.store(products_ + 4 * i);
                const Quad functions = weighted(Quad(values + i * size), active);
                const Quad derivatives = slopes ? weighted(Quad(values + i * size + 4), active) : functions;
                store_sums(lanes_of(functions, products), lanes_of(derivatives, products), functions,
                           derivatives, sums_ + 4 * i);
            } while (goes_on(++i, start));
            return i;
        });
    }
    // Adds up the lanes: the sums with d_i and, if the spline is rational, the sums of weights.
    static HWY_INLINE void store_sums(Vector products, Vector slopes, const Quad &functions,
                                      const Quad &derivatives, double *HWY_RESTRICT out) {
        if constexpr (kRational) {
            sums_of_four(products, slopes, lanes_of(functions), lanes_of(derivatives), out);
        } else {
            const Pair pair = sums_of(products, slopes);
            out[0] = pair.first;
            out[1] = pair.second;
        }
    }
    static HWY_INLINE Quad weighted(const Quad &functions, const Active &active) {
        return kRational ? times(functions, active.weights) : functions;
    }

    // Computes q, h and the slopes q (sum of N_i' w_i (d_i - h)).
    HWY_NOINLINE void finish() {
        for (int64_t i = first_; i < end_; ++i) {
            if (points_[i].valid()) {
                const double *sums = sums_ + 4 * i;
                inverses_[i] = kRational ? 1 / sums[2] : 1;
                means_[i] = sums[0] * inverses_[i];
                if (job_.slopes != nullptr) {
                    const double moved = kRational ? means_[i] * sums[3] : 0;
                    job_.slopes[i] = (sums[1] - moved) * inverses_[i];
                }
            }
        }
    }

    // Computes q = 1 / (sum of N_i w_i) for each parameter, if no d_i are needed.
    HWY_NOINLINE void sum_weights() {
        for_each_run([&](int64_t i, int64_t start) HWY_ATTR {
            const Quad weights(arrays_.weights + start);
            do {
                hn::StoreU(lanes_of(times(Quad(values(i)), weights)), Vec4(), products_ + vec4_lanes * i);
            } while (goes_on(++i, start));
            return i;
        });
        std::fill_n(products_ + vec4_lanes * end_, 4 * vec4_lanes, 0.0);
        for (int64_t i = first_; i < end_; i += 4) {
            const auto at = [&](int64_t n)
                                HWY_ATTR { return hn::LoadU(Vec4(), products_ + vec4_lanes * (i + n)); };
            sums_of_four(at(0), at(1), at(2), at(3), sums_ + i);
            for (int64_t n = i; n < i + 4; ++n) {
                inverses_[n] = 1 / sums_[n];
            }
        }
    }

    struct Sums {
        Quad points[3];
        Quad weights;

        HWY_INLINE Sums() {}
    };
    // Adds the contributions of all parameters to the gradients of the control points.
    HWY_NOINLINE void add() {
        const ConstRecords cotangents = cotangents_;
        const double *const values = values_;
        const int64_t size = values_size_;
        for_each_run([&](int64_t i, int64_t start) HWY_ATTR {
            const Quad weights = kRational ? Quad(arrays_.weights + start) : Quad();
            Sums sums;
            load(start, sums);
            do {
                add_one(i, Quad(values + i * size), weights, cotangents, sums);
            } while (goes_on(++i, start));
            store(start, sums);
            return i;
        });
    }
    HWY_INLINE void load(int64_t start, Sums &sums) const {
        for (int c = 0; c < 3; ++c) {
            sums.points[c] = arrays_.grad_points != nullptr
                                 ? Quad(arrays_.grad_points + c * arrays_.size + start)
                                 : Quad();
        }
        sums.weights =
            kProducts && arrays_.grad_weights != nullptr ? Quad(arrays_.grad_weights + start) : Quad();
    }
    HWY_INLINE void store(int64_t start, const Sums &sums) const {
        for (int c = 0; arrays_.grad_points != nullptr && c < 3; ++c) {
            sums.points[c].store(arrays_.grad_points + c * arrays_.size + start);
        }
        if (kProducts && arrays_.grad_weights != nullptr) {
            sums.weights.store(arrays_.grad_weights + start);
        }
    }
    HWY_INLINE void add_one(int64_t i, const Quad &functions, const Quad &weights,
                            const ConstRecords &cotangents, Sums &sums) const {
        const Vec4 d;
        const Quad divided = kRational ? times(functions, Quad(inverses_[i])) : functions;
        const Quad shares = kRational ? times(divided, weights) : divided;
        const double *g = cotangents.record(i);
        for (int c = 0; c < 3; ++c) {
            add_product(shares, hn::Set(d, g[c * cotangents.component_stride]), sums.points[c]);
        }
        if constexpr (kProducts) {
            const Quad products(products_ + 4 * i);
            for (int part = 0; part < parts; ++part) {
                sums.weights.values[part] =
                    hn::MulAdd(divided.values[part], hn::Sub(products.values[part], hn::Set(d, means_[i])),
                               sums.weights.values[part]);
            }
        }
    }

    const NetJob &job_;
    const ConstRecords &cotangents_;
    NetArrays arrays_;
    const AxisPoint *points_;
    const double *values_;
    int64_t values_size_;
    int64_t first_;
    int64_t end_;
    alignas(64) double products_[4 * (axis_block_size + 4)]; // d_i, or N_i w_i
    alignas(64) double sums_[4 * (axis_block_size + 4)];
    double inverses_[axis_block_size + 4]; // q
    double means_[axis_block_size];        // h
};

void add_cubic(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) {
    const bool products = job.coordinates != nullptr;
    if (job.weights != nullptr) {
        products ? CubicKernel<true, true>(job, cotangents, first, first + count).run()
                 : CubicKernel<true, false>(job, cotangents, first, first + count).run();
    } else {
        products ? CubicKernel<false, true>(job, cotangents, first, first + count).run()
                 : CubicKernel<false, false>(job, cotangents, first, first + count).run();
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(add_cubic);

void add_to_cubic(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) noexcept {
    NURBS_BEST(add_cubic)(job, cotangents, first, count);
}

} // namespace nrb::eval
#endif
