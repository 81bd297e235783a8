// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/single_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/kernels/bernstein-inl.h"
#include "eval/kernels/finish-inl.h"
#include "eval/kernels/single_kernel.h"
#include "spline/spline.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

using V4 = hn::Vec<Vec4>;

// The entry of the table of spans for t, and its number; null unless t lies inside the domain.
HWY_INLINE const double *span_at(const SingleAxis &axis, double t, int64_t &number) {
    if (!(t > axis.domain.lower && t < axis.domain.upper)) {
        return nullptr;
    }
    number = axis.find.number_inside(t);
    return axis.power_spans + number * axis.power_span_size;
}
// The power span of t. Null unless t lies strictly inside a span with a power span, where no function can be
// 1 with all others 0.
HWY_INLINE const double *power_span_at(const SingleAxis &axis, double t, int64_t &number) {
    const double *span = span_at(axis, t, number);
    return span != nullptr && t > span[PowerSpan::lower] ? span : nullptr;
}

template <int kDegree>
HWY_INLINE V4 horner_at(const double *power_span, int degree, int lanes, int l, V4 x) {
    V4 y[1];
    horner_vector<1, kDegree>(Vec4(), Components(), power_span + PowerSpan::head_size + l, degree, lanes, x,
                              1, y);
    return y[0];
}

HWY_INLINE V4 local_parameter(const double *power_span, double t) {
    return hn::Set(Vec4(), (t - power_span[PowerSpan::middle]) * power_span[PowerSpan::scale]);
}

// Computes the components of a record vector by vector with component(l), which returns components l, l + 1,
// ..., and writes the point. A rational record is divided by component dim, the weight.
template <class Component>
HWY_INLINE void write_components(const SingleTables &tables, bool rational, const Component &component,
                                 double *point) {
    const Vec4 d;
    HWY_ALIGN double lanes[4];
    auto inverse = hn::Set(d, 1);
    V4 last = hn::Zero(d);
    const int last_part = tables.dim / vec4_lanes * vec4_lanes;
    if (rational) {
        last = component(last_part);
        hn::Store(last, d, lanes);
        inverse = hn::Set(d, 1 / lanes[tables.dim - last_part]);
    }
    for (int l = 0; l < tables.dim; l += vec4_lanes) {
        const V4 sum = rational && l == last_part ? last : component(l);
        hn::Store(rational ? hn::Mul(sum, inverse) : sum, d, lanes);
        for (int c = 0; c < vec4_lanes && l + c < tables.dim; ++c) {
            point[l + c] = lanes[c];
        }
    }
}

template <int kDegree>
HWY_INLINE bool single_of_curve(const SingleTables &tables, const double *params, double *point) {
    const SingleAxis &axis = tables.axes[0];
    const double t = params[0];
    int64_t number;
    const double *span = span_at(axis, t, number);
    if (span == nullptr) {
        return false;
    }
    if (t > span[PowerSpan::lower]) {
        const V4 x = local_parameter(span, t);
        const auto component = [&](int l) HWY_ATTR {
            return horner_at<kDegree>(span, axis.degree, tables.lanes, l, x);
        };
        write_components(tables, tables.width > tables.dim, component, point);
        return true;
    }
    if (!inside_bernstein_span(span, t)) {
        return false;
    }
    const BernsteinPlace place(span, axis.degree, tables.span_lanes, t);
    write_components(
        tables, true, [&](int l) HWY_ATTR { return place.components(axis.degree, l); }, point);
    return true;
}

constexpr int most_functions = PowerSpan::lanes(max_power_span_degree + 1);

// The functions of an axis at t and their derivatives of orders below kOrders. Advances `net` to the first
// active layer. Returns false unless t lies strictly inside a span with a power span.
template <int kOrders, int kDegree>
HWY_INLINE bool functions_at(const SingleAxis &axis, double t, double (*functions)[most_functions],
                             const double *&net) {
    int64_t number;
    const double *power_span = power_span_at(axis, t, number);
    if (power_span == nullptr) {
        return false;
    }
    const Vec4 d;
    const V4 x = local_parameter(power_span, t);
    const int lanes = kDegree == 3 ? 4 : PowerSpan::lanes(axis.degree + 1);
    for (int l = 0; l < lanes; l += vec4_lanes) {
        V4 y[kOrders];
        horner_vector<kOrders, kDegree>(d, Components(), power_span + PowerSpan::head_size + l, axis.degree,
                                        lanes, x, power_span[PowerSpan::scale], y);
        for (int k = 0; k < kOrders; ++k) {
            hn::Store(y[k], d, functions[k] + l);
        }
    }
    net += (axis.spans[number] - axis.degree) * axis.stride;
    return true;
}

// The sum of row(i), rows of the net or sums over another axis, times the functions of this axis, in rising
// order of i as everywhere.
template <int kDegree, class Row>
HWY_INLINE V4 contract_axis(const SingleAxis &axis, const double *functions, const Row &row) {
    const Vec4 d;
    const int degree = kDegree >= 0 ? kDegree : axis.degree;
    V4 sum = hn::Mul(hn::Set(d, functions[0]), row(0));
    for (int i = 1; i <= degree; ++i) {
        sum = hn::MulAdd(hn::Set(d, functions[i]), row(i), sum);
    }
    return sum;
}

template <int kDegree>
HWY_INLINE bool single_of_tensor(const SingleTables &tables, const double *params, double *point) {
    HWY_ALIGN double functions[max_axes][most_functions];
    const double *net = tables.net;
    for (int k = 0; k < tables.axis_count; ++k) {
        const auto at = static_cast<size_t>(k);
        if (!functions_at<1, kDegree>(tables.axes[at], params[k], functions + k, net)) {
            return false;
        }
    }
    const SingleAxis &u = tables.axes[0], &v = tables.axes[1], &w = tables.axes[2];
    const bool rational = tables.width > tables.dim;
    const auto column = [&](const double *from) HWY_ATTR {
        return contract_axis<kDegree>(u, functions[0],
                                      [&](int i) HWY_ATTR { return hn::LoadU(Vec4(), from + i * u.stride); });
    };
    const auto plane = [&](const double *from) HWY_ATTR {
        return contract_axis<kDegree>(v, functions[1],
                                      [&](int j) HWY_ATTR { return column(from + j * v.stride); });
    };
    if (tables.axis_count == 2) {
        write_components(
            tables, rational, [&](int l) HWY_ATTR { return plane(net + l); }, point);
    } else {
        const auto body = [&](int l) HWY_ATTR {
            return contract_axis<kDegree>(w, functions[2],
                                          [&](int k) HWY_ATTR { return plane(net + l + k * w.stride); });
        };
        write_components(tables, rational, body, point);
    }
    return true;
}

// The same sums as contract_surface() of tensor_kernel.cpp, for one vector of components.
template <int kDegree>
HWY_INLINE void contract_first_derivs(const SingleTables &tables,
                                      const double (*functions)[2][most_functions], const double *net,
                                      int part, V4 *HWY_RESTRICT slots) {
    const Vec4 d;
    const SingleAxis &u = tables.axes[0], &v = tables.axes[1];
    const int degree_v = kDegree >= 0 ? kDegree : v.degree;
    for (int j = 0; j <= degree_v; ++j) {
        const double *from = net + part * vec4_lanes + j * v.stride;
        const auto row = [&](int i) HWY_ATTR { return hn::LoadU(Vec4(), from + i * u.stride); };
        const V4 sum = contract_axis<kDegree>(u, functions[0][0], row);
        const V4 sum_u = contract_axis<kDegree>(u, functions[0][1], row);
        const V4 value = hn::Set(d, functions[1][0][j]);
        const V4 value_v = hn::Set(d, functions[1][1][j]);
        slots[0] = j == 0 ? hn::Mul(value, sum) : hn::MulAdd(value, sum, slots[0]);
        slots[1] = j == 0 ? hn::Mul(value, sum_u) : hn::MulAdd(value, sum_u, slots[1]);
        slots[2] = j == 0 ? hn::Mul(value_v, sum) : hn::MulAdd(value_v, sum, slots[2]);
    }
}

template <int kDegree>
HWY_INLINE bool first_derivs_of_surface(const SingleTables &tables, const double *params, double *derivs) {
    HWY_ALIGN double functions[2][2][most_functions];
    const double *net = tables.net;
    if (!functions_at<2, kDegree>(tables.axes[0], params[0], functions[0], net) ||
        !functions_at<2, kDegree>(tables.axes[1], params[1], functions[1], net)) {
        return false;
    }
    QuadRecord<3> record;
    for (int part = 0; part < QuadRecord<3>::parts; ++part) {
        contract_first_derivs<kDegree>(tables, functions, net, part, record.values[part]);
    }
    if (tables.width > tables.dim) {
        record.divide_by_weight<2, 1>(tables.dim);
    }
    for (int s = 0; s < 3; ++s, derivs += 3) {
        HWY_ALIGN double lanes[4];
        record.store(s, lanes);
        std::copy_n(lanes, 3, derivs);
    }
    return true;
}

HWY_INLINE bool is_cubic(const SingleTables &tables) {
    bool cubic = true;
    for (int k = 0; k < tables.axis_count; ++k) {
        cubic = cubic && tables.axes[static_cast<size_t>(k)].degree == 3;
    }
    return cubic;
}

bool single(const SingleTables &tables, const double *params, double *point) {
    const bool cubic = is_cubic(tables);
    if (tables.axis_count == 1) {
        return cubic ? single_of_curve<3>(tables, params, point) : single_of_curve<-1>(tables, params, point);
    }
    return cubic ? single_of_tensor<3>(tables, params, point) : single_of_tensor<-1>(tables, params, point);
}

bool single_derivs(const SingleTables &tables, const double *params, double *derivs) {
    return is_cubic(tables) ? first_derivs_of_surface<3>(tables, params, derivs)
                            : first_derivs_of_surface<-1>(tables, params, derivs);
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(single);
NURBS_FORMS(single_derivs);

namespace {

// The tables of axis k. Its power spans stay null if there are none yet.
SingleAxis axis_of(const Spline &spline, int k, const PowerSpans *power_spans) {
    SingleAxis single;
    if (power_spans != nullptr) {
        const KnotVector &axis = spline.axis(k);
        single.find = axis.spans().finder();
        single.domain = axis.domain();
        single.power_spans = (*power_spans)[0];
        single.power_span_size = power_spans->size();
        single.spans = axis.spans().indices().data();
        single.degree = axis.degree();
    }
    return single;
}

std::shared_ptr<const SingleTables> make_tables(const Spline &spline) {
    auto tables = std::make_shared<SingleTables>();
    tables->axis_count = spline.axes();
    tables->dim = spline.dim();
    tables->width = spline.width();
    tables->lanes = PowerSpan::lanes(spline.width());
    if (spline.axes() == 1) {
        tables->span_lanes = spline.span_lanes();
        tables->axes[0] = axis_of(spline, 0, spline.power_spans_after(0));
        return tables->axes[0].power_spans != nullptr ? tables : nullptr;
    }
    tables->net = spline.records_after(0);
    bool complete = tables->net != nullptr;
    int64_t stride = spline.width();
    for (int k = spline.axes() - 1; k >= 0 && complete; --k) {
        SingleAxis &axis = tables->axes[static_cast<size_t>(k)];
        axis = axis_of(spline, k, spline.has_power_spans(k) ? spline.axis(k).power_spans_after(0) : nullptr);
        axis.stride = stride;
        stride *= spline.count(k);
        complete = axis.power_spans != nullptr;
    }
    return complete ? tables : nullptr;
}

} // namespace

const SingleTables *single_tables(const Spline &spline) noexcept {
    const Spline::AnyCache *found = spline.slot(Spline::Cache::single).peek();
    return found == nullptr ? nullptr : static_cast<const SingleTables *>(found->get());
}

void keep_single_tables(const Spline &spline) {
    if (single_tables(spline) == nullptr) {
        if (std::shared_ptr<const SingleTables> tables = make_tables(spline)) {
            spline.slot(Spline::Cache::single).get([&] { return Spline::AnyCache(std::move(tables)); });
        }
    }
}

bool evaluate_single(const SingleTables &tables, const double *params, double *point) noexcept {
    return NURBS_BEST(single)(tables, params, point);
}

bool evaluate_single_derivs(const SingleTables &tables, const double *params, double *derivs) noexcept {
    return NURBS_BEST(single_derivs)(tables, params, derivs);
}

} // namespace nrb::eval
#endif
