// SPDX-License-Identifier: MIT
// Calculus: polar forms (blossoms), derivatives, integrals, products, compositions and sums.
#include "checks.h"
#include "evaluation_flags.h"
#include "guard.h"

#include "eval/parameters.h"
#include "refine/algebra/antiderivative.h"
#include "refine/algebra/derivative.h"
#include "refine/algebra/knot_derivative.h"
#include "refine/algebra/product.h"
#include "refine/algebra/quotient_rule.h"
#include "refine/algebra/sum.h"
#include "refine/compose/compose.h"
#include "refine/knots/blossom.h"

#include <array>
#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

int64_t degree_total(const Spline &spline) noexcept {
    int64_t total = 0;
    for (const KnotVectorPtr &axis : spline.knot_vectors()) {
        total += axis->degree();
    }
    return total;
}

void check_finite(const double *values, int64_t n, const char *name) {
    for (int64_t i = 0; i < n; ++i) {
        if (!std::isfinite(values[i])) {
            fail(Status::parameter_not_finite, "%s[%lld] = %s is not finite", name, static_cast<long long>(i),
                 Number(values[i]).text);
        }
    }
}

// The span of each axis in which the parameter of that axis lies, by the evaluation flags.
std::array<int64_t, max_axes> spans_at(const Spline &spline, const double *params, uint32_t flags) {
    const eval::AxisRules rules = decode_rules(flags, spline.axes());
    std::array<int64_t, max_axes> spans{};
    for (size_t k = 0; k < static_cast<size_t>(spline.axes()); ++k) {
        if (rules[k].nan) {
            fail(Status::flags, "flags = 0x%x: NURBS_NAN has no meaning for the choice of a piece", flags);
        }
        const KnotVector &axis = spline.axis(static_cast<int>(k));
        eval::check_axis_parameters(axis, rules[k], {params + k, 1}, static_cast<int64_t>(k));
        spans[k] = axis.find_span(eval::place(params[k], rules[k], axis.domain()), rules[k].left);
    }
    return spans;
}

refine::ProductKind kind_of(uint32_t flags) {
    if ((flags & ~(NURBS_PRODUCT_DOT | NURBS_PRODUCT_CROSS)) != 0 ||
        flags == (NURBS_PRODUCT_DOT | NURBS_PRODUCT_CROSS)) {
        fail(Status::flags, "flags = 0x%x, expected NURBS_PRODUCT_DOT, NURBS_PRODUCT_CROSS or 0", flags);
    }
    return flags == NURBS_PRODUCT_DOT     ? refine::ProductKind::dot
           : flags == NURBS_PRODUCT_CROSS ? refine::ProductKind::cross
                                          : refine::ProductKind::components;
}

} // namespace

nurbs_status nurbs_blossom(const nurbs *g, const double *params, int64_t count, const double *args,
                           double *values, uint32_t flags) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        require(params, "params");
        check_size(count, degree_total(spline), "count");
        if (count > 0) {
            require(args, "args");
        }
        require(values, "values");
        const auto spans = spans_at(spline, params, flags);
        check_finite(args, count, "args");
        check_apart({memory("values", values, spline.width())},
                    {memory("params", params, spline.axes()), memory("args", args, count)});
        refine::blossom(spline, spans.data(), {args, static_cast<size_t>(count)}, values);
    });
}

nurbs_status nurbs_derivative(const nurbs *g, int32_t axis, int32_t order, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        check_order(order);
        give(order > 0 && g->spline->rational() ? refine::rational_derivative(*g->spline, axis, order)
                                                : refine::polynomial_derivative(g->spline, axis, order),
             out);
    });
}

nurbs_status nurbs_eval_knot_derivative(const nurbs *g, int32_t axis, int64_t knot, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        const int64_t last = std::ssize(g->spline->axis(axis).knots()) - 1;
        if (knot < 0 || knot > last) {
            fail(Status::index, "knot = %lld, expected 0 to %lld", static_cast<long long>(knot),
                 static_cast<long long>(last));
        }
        give(g->spline->rational() ? refine::rational_knot_derivative(*g->spline, axis, knot)
                                   : refine::polynomial_knot_derivative(g->spline, axis, knot),
             out);
    });
}

nurbs_status nurbs_antiderivative(const nurbs *g, int32_t axis, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::antiderivative(*g->spline, axis), out);
    });
}

nurbs_status nurbs_product(const nurbs *a, const nurbs *b, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(a, "a");
        require(b, "b");
        give(refine::product(*a->spline, *b->spline, kind_of(flags)), out);
    });
}

nurbs_status nurbs_compose(const nurbs *g, const nurbs *f, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        require(f, "f");
        give(refine::compose(g->spline, f->spline), out);
    });
}

nurbs_status nurbs_sum(const nurbs *a, double alpha, const nurbs *b, double beta, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(a, "a");
        require(b, "b");
        check_factor(alpha, "alpha");
        check_factor(beta, "beta");
        give(refine::sum(a->spline, alpha, b->spline, beta), out);
    });
}
