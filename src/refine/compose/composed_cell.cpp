// SPDX-License-Identifier: MIT
#include "refine/compose/composed_cell.h"

#include "base/watch.h"
#include "numeric/binomial.h"
#include "refine/knots/blossom.h"
#include "spline/contract.h"

namespace nrb::refine {

ComposedCell::ComposedCell(std::span<const KnotVectorPtr> axes, int inner_degree, int width)
    : axes_(axes), inner_degree_(inner_degree), width_(width) {
    for (const KnotVectorPtr &axis : axes) {
        choices_.push_back(choices(axis->degree(), inner_degree));
    }
}

// The next choice raises the last number that can be raised, and makes those after it as large.
std::vector<ComposedCell::Choice> ComposedCell::choices(int degree, int inner_degree) {
    std::vector<Choice> all;
    std::array<int, max_basis> numbers{};
    const auto last = static_cast<size_t>(degree);
    for (;;) {
        Choice choice{numbers, 0, 1};
        for (size_t i = 0, run = 0; i < last; ++i) {
            run = i > 0 && numbers[i] == numbers[i - 1] ? run + 1 : 1;
            choice.sum += numbers[i];
            // (i + 1)! / (product of run!), an integer after each run.
            choice.ways *=
                binomial(inner_degree, numbers[i]) * static_cast<double>(i + 1) / static_cast<double>(run);
        }
        all.push_back(choice);
        size_t at = last;
        while (at > 0 && numbers[at - 1] == inner_degree) {
            --at;
        }
        if (at == 0) {
            return all;
        }
        const int next = numbers[at - 1] + 1;
        std::fill(numbers.begin() + static_cast<std::ptrdiff_t>(at) - 1, numbers.begin() + degree, next);
    }
}

const std::vector<double> &ComposedCell::make(const double *block, std::span<const int64_t> spans,
                                              const CellArguments &arguments) {
    length_ = width_;
    for (const KnotVectorPtr &axis : axes_) {
        length_ *= axis->degree() + 1;
    }
    states_.assign(block, block + length_);
    for (size_t k = 0; k < axes_.size(); ++k) {
        take_axis(k, spans[k], arguments);
    }
    const auto n = static_cast<int>(std::ssize(states_) / width_) - 1;
    for (int i = 0; i <= n; ++i) {
        for (int c = 0; c < width_; ++c) {
            states_[static_cast<size_t>(i * width_ + c)] /= binomial(n, i);
        }
    }
    return states_;
}

void ComposedCell::take_axis(size_t k, int64_t span, const CellArguments &arguments) {
    const KnotVector &axis = *axes_[k];
    const int p = axis.degree();
    const int64_t states = std::ssize(states_) / length_, rest = length_ / (p + 1);
    const int64_t more = states + int64_t{p} * inner_degree_;
    sums_.assign(static_cast<size_t>(more * rest), {});
    contracted_.resize(static_cast<size_t>(rest));
    double values[max_basis];
    for (const Choice &choice : choices_[k]) {
        count_work(4 * states * length_);
        double factor = choice.ways;
        for (int i = 0; i < p; ++i) {
            const auto number = static_cast<size_t>(choice.numbers[static_cast<size_t>(i)]);
            values[i] = arguments.values[k][number];
            factor *= arguments.weights[k][number];
        }
        const BlossomRow row = blossom_row(axis, span, {values, static_cast<size_t>(p)});
        for (int64_t s = 0; s < states; ++s) {
            contract(row.coefficients, row.size, states_.data() + s * length_ + (row.first - span + p) * rest,
                     rest, rest, contracted_.data());
            CompensatedSum *const sum = sums_.data() + (s + choice.sum) * rest;
            for (int64_t i = 0; i < rest; ++i) {
                sum[i].add(factor * contracted_[static_cast<size_t>(i)]);
            }
        }
    }
    length_ = rest;
    states_.clear();
    for (const CompensatedSum &sum : sums_) {
        states_.push_back(sum.value());
    }
}

} // namespace nrb::refine
