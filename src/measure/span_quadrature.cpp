// SPDX-License-Identifier: MIT
#include "measure/span_quadrature.h"

#include "base/checked.h"
#include "base/representable.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "measure/elements.h"
#include "measure/spanned.h"
#include "numeric/gauss_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace nrb::measure {

namespace {

constexpr int64_t work_of_a_point = 100;

} // namespace

SpanQuadrature::SpanQuadrature(const Spline &spline, int nodes) : spline_(spline) {
    for (int k = 0; k < spline.axes(); ++k) {
        const KnotVector &axis = spline.axis(k);
        add_axis(axis, nodes == 0 ? axis.degree() + 1 : nodes);
        size_ = checked_product(size_, std::ssize(nodes_.back()), "points");
    }
    checked_product(size_, spline.axes(), "params");
}

// Each node is computed from the nearer end of its span, and clamped to the span.
void SpanQuadrature::add_axis(const KnotVector &axis, int nodes) {
    const GaussRule rule = gauss_rule(nodes);
    std::vector<Node> &own = nodes_.emplace_back();
    per_span_.push_back(static_cast<size_t>(nodes));
    for (int64_t i = axis.degree(); i < axis.count(); ++i) {
        const double lower = axis[i], upper = axis[i + 1], length = upper - lower;
        if (!(lower < upper)) {
            continue;
        }
        const double last = std::nextafter(upper, lower);
        for (size_t j = 0; j < rule.places.size(); ++j) {
            const double place =
                rule.places[j] <= 0.5 ? lower + rule.places[j] * length : upper - rule.rests[j] * length;
            own.push_back({std::clamp(place, lower, last), rule.weights[j], length});
        }
        count_work(nodes);
    }
}

// Calls visit(nodes) with one node of each axis; axes that the spline lacks have the constant 1 as their
// rule.
template <class Visit>
void SpanQuadrature::for_each(Visit &&visit) const {
    static constexpr Node none{0, 1, 1};
    std::array<std::span<const Node>, max_axes> all;
    all.fill({&none, 1});
    std::array<size_t, max_axes> per{1, 1, 1};
    for (size_t k = 0; k < nodes_.size(); ++k) {
        all[k] = nodes_[k];
        per[k] = per_span_[k];
    }
    const auto spans = [&](size_t k) { return all[k].size() / per[k]; };
    for (size_t span = 0; span < spans(0) * spans(1) * spans(2); ++span) {
        const std::array<size_t, max_axes> first{span / (spans(1) * spans(2)) * per[0],
                                                 span / spans(2) % spans(1) * per[1],
                                                 span % spans(2) * per[2]};
        for (size_t node = 0; node < per[0] * per[1] * per[2]; ++node) {
            visit(std::array{&all[0][first[0] + node / (per[1] * per[2])],
                             &all[1][first[1] + node / per[2] % per[1]], &all[2][first[2] + node % per[2]]});
        }
        count_work(static_cast<int64_t>(per[0] * per[1] * per[2]));
    }
}

std::vector<double> SpanQuadrature::params() const {
    std::vector<double> found;
    found.reserve(static_cast<size_t>(size_ * spline_.axes()));
    for_each([&](const auto &nodes) {
        for (size_t k = 0; k < nodes_.size(); ++k) {
            found.push_back(nodes[k]->place);
        }
    });
    return found;
}

std::vector<double> SpanQuadrature::weights() const {
    std::vector<double> found;
    found.reserve(static_cast<size_t>(size_));
    for_each([&](const auto &nodes) {
        double weight = 1;
        for (const Node *node : nodes) {
            weight *= node->weight * node->length;
        }
        found.push_back(weight);
    });
    require_representable(found, "weights");
    return found;
}

// Derivatives are taken with respect to coordinates in [0, 1] of each span, in units of the spline's size,
// against overflow.
std::vector<double> SpanQuadrature::measures() const {
    constexpr int64_t at_once = 1024;
    const int axes = spline_.axes(), dim = spline_.dim(), exponent = integral_frame(spline_).exponent;
    const int64_t width = int64_t{axes + 1} * dim;
    const std::vector<double> all = params();
    std::vector<double> jets(static_cast<size_t>(at_once * width)), local(static_cast<size_t>(axes * dim));
    std::vector<double> found;
    found.reserve(static_cast<size_t>(size_));
    for_each([&](const auto &nodes) {
        const auto done = static_cast<int64_t>(found.size()), at = done % at_once;
        if (at == 0) {
            const int64_t count = std::min(at_once, size_ - done);
            count_work(work_of_a_point * count);
            eval::evaluate_points(spline_, {}, 1, {all.data() + done * axes, count, axes, axes, 1},
                                  {jets.data(), count, width, width, 1});
        }
        double weight = 1;
        for (int k = 0; k < axes; ++k) {
            const Node &node = *nodes[static_cast<size_t>(k)];
            weight *= node.weight;
            for (int c = 0; c < dim; ++c) {
                const double derivative = jets[static_cast<size_t>(at * width + (k + 1) * dim + c)];
                local[static_cast<size_t>(k * dim + c)] = std::ldexp(derivative * node.length, -exponent);
            }
        }
        found.push_back(std::ldexp(weight * spanned(local, axes, dim), axes * exponent));
    });
    require_representable(found, "measures");
    return found;
}

} // namespace nrb::measure
