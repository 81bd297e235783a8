// SPDX-License-Identifier: MIT
#include "eval/functions/basis_batch.h"

#include "base/numbers.h"
#include "basis/bspline.h"
#include "eval/functions/axis_basis.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::eval {

namespace {

void store_record(const std::vector<double> &values, Records out, int64_t i) noexcept {
    for (int64_t c = 0; c < out.width; ++c) {
        out(i, c) = values[static_cast<size_t>(c)];
    }
}

} // namespace

void find_spans(const KnotVector &axis, const AxisRule &rule, ConstRecords params, int64_t *spans) {
    const SpanTable &table = axis.spans();
    for (int64_t i = 0; i < params.count; ++i) {
        const double t = place(params(i, 0), rule, axis.domain());
        spans[i] = std::isnan(t) ? -1 : table.find(t, rule.left);
    }
}

void basis_functions(const KnotVector &axis, const AxisRule &rule, int order, ConstRecords params,
                     int64_t *spans, Records values) {
    const AxisEvaluator evaluate(axis, rule, order);
    std::vector<double> record(evaluate.values_size());
    AxisBasis basis{.values = record.data()};
    for (int64_t i = 0; i < params.count; ++i) {
        const bool valid = evaluate(params(i, 0), basis);
        if (!valid) {
            std::fill(record.begin(), record.end(), nan_value);
        }
        store_record(record, values, i);
        if (spans != nullptr) {
            spans[i] = valid ? basis.first + axis.degree() : -1;
        }
    }
}

void bernstein_polynomials(int degree, int order, ConstRecords params, Records values) {
    for (int64_t i = 0; i < params.count; ++i) {
        if (!std::isfinite(params(i, 0))) {
            fail(Status::parameter_not_finite, "params[%lld] = %s is not finite", static_cast<long long>(i),
                 Number(params(i, 0)).text);
        }
    }
    std::vector<double> record(static_cast<size_t>(values.width));
    for (int64_t i = 0; i < params.count; ++i) {
        bernstein_derivs(degree, params(i, 0), order, record.data());
        store_record(record, values, i);
    }
}

} // namespace nrb::eval
