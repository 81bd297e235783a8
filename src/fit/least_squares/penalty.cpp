// SPDX-License-Identifier: MIT
#include "fit/least_squares/penalty.h"

#include "base/watch.h"
#include "numeric/binomial.h"
#include "refine/knots/extraction.h"

#include <algorithm>

namespace nrb::fit {

namespace {

// The integrals of products of derivatives of the basis functions of an axis; those of functions i and i + d
// are at [i][d].
class AxisForm {
public:
    AxisForm(const KnotVector &axis, int order)
        : width_(axis.degree() + 1), values_(static_cast<size_t>(axis.count() * width_)) {
        if (order <= axis.degree()) {
            integrals_ = products(axis.degree() - order);
            for (const int64_t span : axis.spans().indices()) {
                add_span(axis, order, span);
            }
        }
    }
    [[nodiscard]] const DoubleDouble &operator()(int64_t i, int64_t j) const noexcept {
        return values_[static_cast<size_t>(std::min(i, j) * width_ + std::abs(i - j))];
    }

private:
    void add_span(const KnotVector &axis, int order, int64_t span) {
        const int p = axis.degree(), m = p - order;
        const auto width = static_cast<size_t>(width_);
        std::vector<DoubleDouble> functions(width * width), moved(width);
        refine::bezier_extraction(axis.knots().data(), p, span, functions.data());
        const DoubleDouble length = DoubleDouble::sum(axis[span + 1], -axis[span]) /
                                    DoubleDouble::sum(axis.domain().upper, -axis.domain().lower);
        for (size_t i = 0; i < width; ++i) {
            differentiate(functions.data() + i * width, p, order, length);
        }
        for (int i = 0; i <= p; ++i) {
            for (int j = i; j <= p; ++j) {
                DoubleDouble sum;
                for (int k = 0; k <= m; ++k) {
                    for (int l = 0; l <= m; ++l) {
                        sum = sum + integrals_[static_cast<size_t>(k * (m + 1) + l)] *
                                        (functions[static_cast<size_t>(i * width_ + k)] *
                                         functions[static_cast<size_t>(j * width_ + l)]);
                    }
                }
                DoubleDouble &value = values_[static_cast<size_t>((span - p + i) * width_ + j - i)];
                value = value + length * sum;
            }
        }
        count_work(12 * width_ * width_ * (m + 1) * (m + 1));
    }
    static void differentiate(DoubleDouble *coefficients, int degree, int order,
                              const DoubleDouble &length) noexcept {
        for (int r = 0; r < order; ++r, --degree) {
            for (int k = 0; k < degree; ++k) {
                coefficients[k] = DoubleDouble(degree) * (coefficients[k + 1] - coefficients[k]) / length;
            }
        }
    }
    // The integrals of products of Bernstein polynomials of degree m over an interval of length 1,
    // [m + 1][m + 1].
    static std::vector<DoubleDouble> products(int m) {
        std::vector<DoubleDouble> result = precise_product_factors(m);
        for (DoubleDouble &value : result) {
            value = value / DoubleDouble(2 * m + 1);
        }
        return result;
    }

    int64_t width_;
    std::vector<DoubleDouble> integrals_;
    std::vector<DoubleDouble> values_;
};

class PenaltyAssembly {
public:
    PenaltyAssembly(const std::vector<KnotVectorPtr> &axes, int order, const Index &least_reach)
        : axes_(axes), made_(axes, least_reach) {
        for (const KnotVectorPtr &axis : axes) {
            bends_.emplace_back(*axis, order);
            if (axes.size() > 1) {
                masses_.emplace_back(*axis, 0);
            }
        }
    }

    StencilMatrix form() {
        if (axes_.size() == 1) {
            add_curve();
        } else {
            add(0, {}, {}, Factors{});
        }
        return std::move(made_);
    }

private:
    // The product of the masses (integrals of products of functions) of the axes so far, and the sum of those
    // products in which one factor is an integral of derivatives instead.
    struct Factors {
        DoubleDouble mass = 1;
        DoubleDouble bend = 0;
    };

    void add_curve() {
        const KnotVector &axis = *axes_[0];
        for (int64_t i = 0; i < axis.count(); ++i) {
            for (int64_t j = i; j < std::min(axis.count(), i + axis.degree() + 1); ++j) {
                made_.add({i, 0, 0}, {j, 0, 0}, bends_[0](i, j));
            }
        }
    }

    void add(size_t k, Index first, Index second, const Factors &factors) {
        if (k == axes_.size()) {
            if (first <= second) {
                made_.add(first, second, factors.bend);
            }
            return;
        }
        const KnotVector &axis = *axes_[k];
        count_work(k + 1 == axes_.size() ? 48 * axis.count() * (axis.degree() + 1) : 0);
        for (int64_t i = 0; i < axis.count(); ++i) {
            const int64_t end = std::min(axis.count(), i + axis.degree() + 1);
            for (int64_t j = std::max<int64_t>(0, i - axis.degree()); j < end; ++j) {
                first[k] = i;
                second[k] = j;
                const DoubleDouble mass = masses_[k](i, j), bend = bends_[k](i, j);
                add(k + 1, first, second, {factors.mass * mass, factors.mass * bend + factors.bend * mass});
            }
        }
    }

    const std::vector<KnotVectorPtr> &axes_;
    StencilMatrix made_;
    std::vector<AxisForm> masses_, bends_;
};

} // namespace

StencilMatrix penalty(const std::vector<KnotVectorPtr> &axes, int order, const Index &least_reach) {
    return PenaltyAssembly(axes, order, least_reach).form();
}

int highest_degree(const std::vector<KnotVectorPtr> &axes) noexcept {
    int highest = 0;
    for (const KnotVectorPtr &axis : axes) {
        highest = std::max(highest, axis->degree());
    }
    return highest;
}

} // namespace nrb::fit
