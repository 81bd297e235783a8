// SPDX-License-Identifier: MIT
// Knot generators.
#include "checks.h"
#include "guard.h"

#include "base/checked.h"
#include "basis/generators.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

std::span<double> knot_span(double *knots, int64_t knot_count) {
    if (knot_count < 0) {
        fail(Status::size, "knot_count = %lld, expected the number of knots of the rule",
             static_cast<long long>(knot_count));
    }
    checked_array(knot_count, "knots");
    require(knots, "knots");
    return {knots, static_cast<size_t>(knot_count)};
}

// An input array of n >= 0 values. Throws NURBS_ERROR_OVERLAP if the knots, which are written, overlap it.
template <class T>
std::span<const T> source_span(const T *values, int64_t n, const char *name, std::span<double> knots) {
    check_overlap("knots", knots.data(), static_cast<int64_t>(knots.size_bytes()), name, values,
                  checked_array(n, name) * static_cast<int64_t>(sizeof(T)));
    return {values, static_cast<size_t>(n)};
}

void check_bezier_count(int32_t degree, int64_t pieces, int64_t knot_count) {
    check_degree(degree, -1);
    if (pieces >= 1) {
        check_size(knot_count, bezier_knot_count(degree, pieces), "knot_count");
    }
}

} // namespace

nurbs_status nurbs_knots_uniform(int32_t degree, int64_t count, double a, double b, int64_t knot_count,
                                 double *knots) {
    return guard([&] { uniform_knots(degree, count, a, b, knot_span(knots, knot_count)); });
}

nurbs_status nurbs_knots_open_uniform(int32_t degree, int64_t count, double a, double b, int64_t knot_count,
                                      double *knots) {
    return guard([&] { open_uniform_knots(degree, count, a, b, knot_span(knots, knot_count)); });
}

nurbs_status nurbs_knots_bezier(int32_t degree, int64_t pieces, const double *breaks, int64_t knot_count,
                                double *knots) {
    return guard([&] {
        const std::span<double> target = knot_span(knots, knot_count);
        check_bezier_count(degree, pieces, knot_count);
        if (breaks != nullptr && pieces >= 1) {
            source_span(breaks, pieces + 1, "breaks", target);
        }
        bezier_knots(degree, pieces, breaks, target);
    });
}

nurbs_status nurbs_knots_averaged(int32_t degree, int64_t count, const double *params, int64_t knot_count,
                                  double *knots) {
    return guard([&] {
        const std::span<double> target = knot_span(knots, knot_count);
        require(params, "params");
        check_degree(degree, -1);
        check_count(degree, count, -1);
        check_knot_total(knot_count, degree, count);
        averaged_knots(degree, source_span(params, count, "params", target), target);
    });
}

nurbs_status nurbs_knots_periodic(int32_t degree, int64_t n, const double *breaks,
                                  const int32_t *multiplicities, int64_t knot_count, double *knots) {
    return guard([&] {
        const std::span<double> target = knot_span(knots, knot_count);
        require(breaks, "breaks");
        check_degree(degree, -1);
        if (n < 2 || n > knot_count) {
            fail(n < 2 ? Status::count : Status::size, "n = %lld breaks, expected 2 to knot_count = %lld",
                 static_cast<long long>(n), static_cast<long long>(knot_count));
        }
        if (multiplicities != nullptr) {
            source_span(multiplicities, n, "multiplicities", target);
        }
        periodic_knots(degree, source_span(breaks, n, "breaks", target), multiplicities, target);
    });
}
