// SPDX-License-Identifier: MIT
// Points and weights on the spans of a spline, for integrands of others.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::measure {

// Tensor products of rules of Gauss on all spans of the domain that are not empty, last axis fastest in spans and in the nodes of
// one; each node lies in its span, whose last knot is not of it.
class SpanQuadrature {
public:
    // nodes: on each span of each axis; 0: one more than the degree. Throws Status::overflow if there are too many.
    SpanQuadrature(const Spline &spline, int nodes);

    [[nodiscard]] int64_t size() const noexcept { return size_; }
    // [size][axes].
    [[nodiscard]] std::vector<double> params() const;
    // [size]: of the parameters. Throws Status::not_representable.
    [[nodiscard]] std::vector<double> weights() const;
    // [size]: of the length, area or volume. Throws Status::not_representable.
    [[nodiscard]] std::vector<double> measures() const;

private:
    struct Node {
        double place, weight, length; // of the span
    };
    template <class Visit>
    void for_each(Visit &&visit) const;
    void add_axis(const KnotVector &axis, int nodes);

    const Spline &spline_;
    int64_t size_ = 1;
    std::vector<std::vector<Node>> nodes_; // of each axis, span by span
    std::vector<size_t> per_span_;
};

} // namespace nrb::measure
