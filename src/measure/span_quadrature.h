// SPDX-License-Identifier: MIT
// Quadrature points and weights on the spans of a spline, for integrands of the caller.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::measure {

// Tensor products of Gauss-Legendre rules on all non-empty spans of the domain. The last axis is the fastest,
// for the spans and for the nodes within a span. Each node lies in the half-open span, which does not include
// its last knot.
class SpanQuadrature {
public:
    // nodes: per span and axis; 0: degree + 1. Throws Status::overflow if the product is too large.
    SpanQuadrature(const Spline &spline, int nodes);

    [[nodiscard]] int64_t size() const noexcept { return size_; }
    // [size][axes].
    [[nodiscard]] std::vector<double> params() const;
    // [size]: for integrals over the parameters. Throws Status::not_representable.
    [[nodiscard]] std::vector<double> weights() const;
    // [size]: for integrals over the length, area or volume of the shape. Throws Status::not_representable.
    [[nodiscard]] std::vector<double> measures() const;

private:
    struct Node {
        double place, weight, length; // length: of the span
    };
    template <class Visit>
    void for_each(Visit &&visit) const;
    void add_axis(const KnotVector &axis, int nodes);

    const Spline &spline_;
    int64_t size_ = 1;
    std::vector<std::vector<Node>> nodes_; // for each axis, span by span
    std::vector<size_t> per_span_;
};

} // namespace nrb::measure
