// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/adjoint/net_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/adjoint/net_sums-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// A vector in the space of the control points, with each component in all lanes. The constructor is written
// out, because one added by the compiler would not be compiled for the instruction set.
template <int kDim>
struct Spread {
    Vector components[kDim < 0 ? 1 : kDim];
    double *memory; // [dim], used if kDim < 0
    int dim;

    HWY_INLINE Spread(const double *from, int64_t stride, int dimension, double *work)
        : memory(work), dim(dimension) {
        for (int c = 0; c < dim; ++c) {
            if constexpr (kDim < 0) {
                memory[c] = from[c * stride];
            } else {
                components[c] = hn::Set(Vec4(), from[c * stride]);
            }
        }
    }
    [[nodiscard]] HWY_INLINE Vector operator[](int c) const {
        if constexpr (kDim < 0) {
            return hn::Set(Vec4(), memory[c]);
        } else {
            return components[c];
        }
    }
};

// The factor that the functions of the axes before the last one contribute to a row of control points, and
// its derivatives along these axes.
struct RowFactors {
    double value = 1;
    double slopes[max_axes - 1] = {};
};

// The general kernel. kAxes, kDim and kFunctions (the number of functions on the last axis) stand for any
// number if they are negative. kProducts: gradients of weights or of parameters are wanted, which need the
// products d_i.
template <int kAxes, int kDim, int kFunctions, bool kRational, bool kProducts>
class NetKernel {
public:
    NetKernel(const NetJob &job, const ConstRecords &cotangents)
        : job_(job), cotangents_(cotangents), arrays_(job), lanes_(job.sources[last()].lanes),
          orders_(job.order + 1) {}

    void run(int64_t first, int64_t end) const {
        for (int64_t i = first; i < end; ++i) {
            if (valid(i)) {
                run_one(i);
            }
        }
    }

private:
    using Space = Spread<kDim>;

    // The index of the last axis.
    [[nodiscard]] HWY_INLINE size_t last() const {
        return static_cast<size_t>(kAxes < 0 ? job_.axes : kAxes) - 1;
    }
    [[nodiscard]] HWY_INLINE int dim() const { return kDim < 0 ? job_.dim : kDim; }
    [[nodiscard]] HWY_INLINE int functions() const {
        return kFunctions < 0 ? job_.sources[last()].degree + 1 : kFunctions;
    }
    [[nodiscard]] HWY_INLINE bool valid(int64_t i) const {
        bool all = true;
        for (size_t k = 0; k <= last(); ++k) {
            all = all && job_.points[k][i].valid();
        }
        return all;
    }
    [[nodiscard]] HWY_INLINE int64_t start_of(int64_t i) const {
        int64_t start = 0;
        for (size_t k = 0; job_.whole && k <= last(); ++k) {
            start += job_.points[k][i].first * job_.strides[k];
        }
        return start;
    }
    [[nodiscard]] HWY_INLINE const double *values(size_t k, int64_t i) const {
        return job_.values[k] + i * orders_ * job_.sources[k].lanes;
    }

    // One parameter with its cotangent g. The products are d_i = <P_i - P, g>, where P is an active control
    // point. So neither they nor the sums of derivatives, in which P cancels, depend on the position of the
    // shape.
    struct Place {
        int64_t i;
        int64_t start;
        const double *values; // of the last axis
        Space cotangent;
        Space base;
        double inverse = 1; // q
        double mean = 0;    // h, the mean of the products

        HWY_INLINE Place(const NetKernel &kernel, int64_t index, int64_t first)
            : i(index), start(first), values(kernel.values(kernel.last(), index)),
              cotangent(kernel.cotangents_.record(index), kernel.cotangents_.component_stride, kernel.dim(),
                        kernel.job_.work),
              base(kProducts ? kernel.arrays_.coordinates + kernel.base_of(index, first)
                             : kernel.cotangents_.record(index),
                   kProducts ? kernel.arrays_.size : 0, kernel.dim(), kernel.job_.work + kernel.dim()) {}
    };

    // P is the first active control point. Where weights are uneven, that one may have hardly any influence
    // and lie anywhere; then P is the active control point with the largest |w_i N_i|.
    [[nodiscard]] HWY_INLINE int64_t base_of(int64_t i, int64_t start) const {
        return kRational && !job_.even ? heaviest(i, start) : start;
    }
    [[nodiscard]] HWY_INLINE int64_t heaviest(int64_t i, int64_t start) const {
        const double *own = values(last(), i);
        double most = 0;
        int64_t found = start;
        for_each_row(i, start, [&](const RowFactors &factors, int64_t row) HWY_ATTR {
            for (int l = 0; l < functions(); ++l) {
                const double share = std::abs(factors.value * own[l] * arrays_.weights[row + l]);
                found = share > most ? row + l : found;
                most = std::max(most, share);
            }
        });
        return found;
    }

    HWY_INLINE void run_one(int64_t i) const {
        Place place(*this, i, start_of(i));
        finish_sums(place, [&](Totals &totals) HWY_ATTR {
            for_each_row(place.i, place.start, [&](const RowFactors &factors, int64_t row) HWY_ATTR {
                sum_row(place, factors, row, totals);
            });
        });
        for_each_row(place.i, place.start, [&](const RowFactors &factors, int64_t row) HWY_ATTR {
            add_row(place, factors.value, row);
        });
    }

    // Calls visit(factors, first control point) for each active row along the last axis.
    template <class Visit>
    HWY_INLINE void for_each_row(int64_t i, int64_t row, Visit &&visit) const {
        if (last() == 0) {
            return visit(RowFactors(), row);
        }
        const AxisSource *sources = job_.sources;
        const double *u = values(0, i), *du = u + (orders_ - 1) * sources[0].lanes;
        const int64_t stride = job_.strides[0];
        if (last() == 1) {
            for (int a = 0; a <= sources[0].degree; ++a, row += stride) {
                visit(RowFactors{u[a], {du[a], 0}}, row);
            }
            return;
        }
        const double *v = values(1, i), *dv = v + (orders_ - 1) * sources[1].lanes;
        for (int a = 0; a <= sources[0].degree; ++a, row += stride) {
            for (int b = 0; b <= sources[1].degree; ++b) {
                visit(RowFactors{u[a] * v[b], {du[a] * v[b], u[a] * dv[b]}}, row + b * job_.strides[1]);
            }
        }
    }

    // The sums of N_i w_i and N_i w_i d_i, and of the same with derivatives of N_i along each axis.
    struct Totals {
        Vector weight = hn::Zero(Vec4()), product = hn::Zero(Vec4());
        static constexpr size_t axes = kAxes < 0 ? max_axes : static_cast<size_t>(kAxes);
        Vector weight_slopes[axes], product_slopes[axes];

        HWY_INLINE Totals() {
            for (size_t k = 0; k < axes; ++k) {
                weight_slopes[k] = product_slopes[k] = hn::Zero(Vec4());
            }
        }
    };

    // Computes q = 1 / w, h, and the slopes q (sum of N_i' w_i (d_i - h)).
    template <class Sum>
    HWY_INLINE void finish_sums(Place &place, Sum &&sum) const {
        if constexpr (kRational || kProducts) {
            Totals totals;
            sum(totals);
            const Pair all = sums_of(totals.weight, totals.product);
            place.inverse = kRational ? 1 / all.first : 1;
            place.mean = kProducts ? all.second * place.inverse : 0;
            for (size_t k = 0; kProducts && job_.slopes != nullptr && k <= last(); ++k) {
                const Pair slopes = sums_of(totals.weight_slopes[k], totals.product_slopes[k]);
                const double moved = kRational ? place.mean * slopes.first : 0;
                job_.slopes[place.i * job_.axes + static_cast<int64_t>(k)] =
                    (slopes.second - moved) * place.inverse;
            }
        }
    }

    HWY_INLINE void sum_row(const Place &place, const RowFactors &factors, int64_t row,
                            Totals &totals) const {
        const Vec4 d;
        for (int l = 0; l < functions(); l += vec4_lanes) {
            const auto function = hn::LoadU(d, place.values + l);
            const auto weight = kRational ? hn::LoadU(d, arrays_.weights + row + l) : hn::Set(d, 1.0);
            const auto product = kProducts ? product_of(place, row + l) : weight;
            const auto share = weighted(hn::Mul(hn::Set(d, factors.value), function), weight);
            add<kRational>(l, share, totals.weight);
            add<kProducts>(l, share, product, totals.product);
            if (!kProducts || job_.slopes == nullptr) {
                continue;
            }
            for (size_t k = 0; k <= last(); ++k) {
                const auto derivative =
                    k < last() ? hn::Mul(hn::Set(d, factors.slopes[k]), function)
                               : hn::Mul(hn::Set(d, factors.value), hn::LoadU(d, place.values + lanes_ + l));
                const auto slope = weighted(derivative, weight);
                add<kRational>(l, slope, totals.weight_slopes[k]);
                add<true>(l, slope, product, totals.product_slopes[k]);
            }
        }
    }
    [[nodiscard]] static HWY_INLINE Vector weighted(Vector function, Vector weight) {
        return kRational ? hn::Mul(function, weight) : function;
    }
    template <bool kWanted>
    HWY_INLINE void add(int l, Vector value, Vector &sum) const {
        if constexpr (kWanted) {
            sum = masked(l, hn::Add(sum, value), sum);
        }
    }
    template <bool kWanted>
    HWY_INLINE void add(int l, Vector factor, Vector value, Vector &sum) const {
        if constexpr (kWanted) {
            sum = masked(l, hn::MulAdd(factor, value, sum), sum);
        }
    }

    // d_i = <P_i - P, g> for a vector of control points.
    [[nodiscard]] HWY_INLINE Vector product_of(const Place &place, int64_t at) const {
        const Vec4 d;
        auto sum = hn::Zero(d);
        for (int c = 0; c < dim(); ++c) {
            const auto point = hn::LoadU(d, arrays_.coordinates + c * arrays_.size + at);
            sum = hn::MulAdd(hn::Sub(point, place.base[c]), place.cotangent[c], sum);
        }
        return sum;
    }

    // `value` in the lanes of functions l, l + 1, ... that exist, `old` in the others.
    [[nodiscard]] HWY_INLINE Vector masked(int l, Vector value, Vector old) const {
        const int left = functions() - l;
        if (kFunctions == 4 || left >= vec4_lanes) {
            return value;
        }
        return hn::IfThenElse(hn::FirstN(Vec4(), static_cast<size_t>(left)), value, old);
    }

    // q N_i
    [[nodiscard]] HWY_INLINE Vector divided(const Place &place, Vector function) const {
        return kRational ? hn::Mul(function, hn::Set(Vec4(), place.inverse)) : function;
    }

    HWY_INLINE void add_row(const Place &place, double factor, int64_t row) const {
        const Vec4 d;
        for (int l = 0; l < functions(); l += vec4_lanes) {
            const int64_t at = row + l;
            const auto function = divided(place, hn::Mul(hn::Set(d, factor), hn::LoadU(d, place.values + l)));
            if (arrays_.grad_points != nullptr) {
                const auto share =
                    kRational ? hn::Mul(function, hn::LoadU(d, arrays_.weights + at)) : function;
                for (int c = 0; c < dim(); ++c) {
                    double *target = arrays_.grad_points + c * arrays_.size + at;
                    const auto old = hn::LoadU(d, target);
                    hn::StoreU(masked(l, hn::MulAdd(share, place.cotangent[c], old), old), d, target);
                }
            }
            if (kProducts && arrays_.grad_weights != nullptr) {
                double *target = arrays_.grad_weights + at;
                const auto old = hn::LoadU(d, target);
                const auto sum =
                    hn::MulAdd(function, hn::Sub(product_of(place, at), hn::Set(d, place.mean)), old);
                hn::StoreU(masked(l, sum, old), d, target);
            }
        }
    }

    const NetJob &job_;
    const ConstRecords &cotangents_;
    NetArrays arrays_;
    int lanes_;
    int orders_;
};

template <int kAxes, int kDim, int kFunctions>
HWY_INLINE void run_kernel(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t end) {
    const bool products = job.coordinates != nullptr;
    if (job.weights != nullptr) {
        products ? NetKernel<kAxes, kDim, kFunctions, true, true>(job, cotangents).run(first, end)
                 : NetKernel<kAxes, kDim, kFunctions, true, false>(job, cotangents).run(first, end);
    } else {
        products ? NetKernel<kAxes, kDim, kFunctions, false, true>(job, cotangents).run(first, end)
                 : NetKernel<kAxes, kDim, kFunctions, false, false>(job, cotangents).run(first, end);
    }
}

// The most frequent shapes have loops of their own, with the same results.
void add_cotangents(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) {
    const bool cubic = job.dim == 3 && job.sources[job.axes - 1].degree == 3;
    if (cubic && job.axes == 1) {
        run_kernel<1, 3, 4>(job, cotangents, first, first + count);
    } else if (cubic && job.axes == 2) {
        run_kernel<2, 3, 4>(job, cotangents, first, first + count);
    } else {
        run_kernel<-1, -1, -1>(job, cotangents, first, first + count);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(add_cotangents);

void add_to_net(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) noexcept {
    const bool cubic = job.axes == 1 && job.dim == 3 && job.sources[0].degree == 3;
    if (cubic && job.whole && (job.even || job.coordinates == nullptr)) {
        add_to_cubic(job, cotangents, first, count);
    } else {
        NURBS_BEST(add_cotangents)(job, cotangents, first, count);
    }
}

} // namespace nrb::eval
#endif
