// SPDX-License-Identifier: MIT
#include "measure/tensor_integral.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "measure/element_shape.h"
#include "measure/tensor_rule.h"
#include "measure/tolerance_ladder.h"
#include "numeric/sum.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

constexpr int most_halvings_of_cell = 200;

// By the number of axes: the level of the rules to begin with, and the highest one.
constexpr std::array<int, max_axes> first_levels = {2, 2, 1}, last_levels = {4, 4, 3};
// The limit of work of a search: a fixed number of multiply-adds, about a second, plus that of this many
// rules of the first level for each element.
constexpr int64_t least_work = 2500000000;
constexpr int64_t rules_for_an_element = 24;

// What is known of the whole integral before a search.
struct Goal {
    std::vector<double> tolerances; // absolute, for each value
    double size = 0;
    double fraction = 0; // every element may have this fraction of the tolerances, however small it is
};

class TensorSearch {
public:
    TensorSearch(const std::vector<Elements> &splines, const Integrand &integrand)
        : splines_(splines), integrand_(integrand), values_(static_cast<size_t>(integrand.values())) {
        for (const Elements &elements : splines) {
            count_ += elements.size();
        }
    }

    // A first estimate: rules of the first level on all elements.
    Integrals rough() {
        const Phase phase(0.25);
        start();
        Steps splines(std::ssize(splines_));
        for (const Elements &elements : splines_) {
            TensorRule rule(elements, integrand_);
            Element element;
            Steps steps(elements.size());
            for (int64_t e = 0; e < elements.size(); ++e, steps.next()) {
                elements.load(e, element);
                add_rounding(elements, element);
                count_work(work_of_rule(elements, first(elements)));
                rule.evaluate(element.net.data(), element.origin, first(elements));
                accept(rule, elements.axes(), true);
            }
            splines.next();
        }
        return finish();
    }

    // One adaptive search, which may do 1 / `shares` of the work of a call.
    Integrals run(const Goal &goal, int shares) {
        start();
        left_ = least_work / shares;
        for (const Elements &elements : splines_) {
            left_ +=
                rules_for_an_element * elements.size() * work_of_rule(elements, first(elements)) / shares;
        }
        Steps splines(std::ssize(splines_));
        for (const Elements &elements : splines_) {
            TensorRule rule(elements, integrand_);
            ElementShape shape(elements);
            Element element;
            Steps steps(elements.size());
            for (int64_t e = 0; e < elements.size(); ++e) {
                elements.load(e, element);
                add_rounding(elements, element);
                run_element(elements, element, rule, shape, goal);
                steps.next();
            }
            splines.next();
        }
        return finish();
    }

    [[nodiscard]] int64_t count() const noexcept { return count_; }
    [[nodiscard]] bool spent() const noexcept { return left_ < 0; }

private:
    static size_t axis_index(const Elements &elements) noexcept {
        return static_cast<size_t>(elements.axes() - 1);
    }
    static Levels first(const Elements &elements) noexcept {
        Levels levels{};
        levels.fill(first_levels[axis_index(elements)]);
        return levels;
    }

    // The multiply-adds of a rule: the value and derivatives at each node, axis by axis, and the integrand.
    [[nodiscard]] int64_t work_of_rule(const Elements &elements, const Levels &levels) const noexcept {
        int64_t nodes = 1, degrees = 0;
        for (int k = 0; k < elements.axes(); ++k) {
            nodes *= rule_size(levels[static_cast<size_t>(k)]);
            degrees += elements.degree(k) + 1;
        }
        constexpr int work_of_a_value = 24, work_of_a_node = 80;
        return nodes * ((elements.axes() + 1) * elements.width() * degrees +
                        work_of_a_value * integrand_.values() + work_of_a_node);
    }

    void start() {
        sums_.assign(values_, {});
        errors_.assign(values_, {});
        size_ = {};
        rounding_ = 0;
    }

    Integrals finish() const {
        Integrals result;
        for (size_t j = 0; j < values_; ++j) {
            result.values.push_back(sums_[j].value());
            result.errors.push_back(errors_[j].value());
        }
        result.size = size_.value();
        result.rounding = rounding_;
        return result;
    }

    struct Verdict {
        int axis = -1;      // the axis to refine, or -1
        bool raise = false; // by a rule of a higher level instead of halving
    };

    // The axis whose error exceeds the allowed one by the largest factor.
    [[nodiscard]] Verdict judge(const TensorRule &rule, const Levels &levels, int axes,
                                const Goal &goal) const {
        Verdict verdict;
        double worst = 1;
        const double part = std::max(goal.fraction, goal.size > 0 ? rule.magnitude(0) / goal.size / 2 : 1);
        for (int k = 0; k < axes; ++k) {
            const int higher = last_levels[static_cast<size_t>(axes - 1)] - levels[static_cast<size_t>(k)];
            bool promising = higher > 0;
            double most = 0;
            for (size_t j = 0; j < values_; ++j) {
                const double allowed = part * goal.tolerances[j];
                const double error = rule.error(k, j) * axes;
                if (error > allowed) {
                    most = std::max(most, error / allowed);
                    const RuleDecay &decay = rule.decay(k, j);
                    const double left = higher > 1 ? decay.two_higher() : decay.one_higher();
                    promising = promising && left * rule.magnitude(j) <= allowed;
                }
            }
            if (most > worst) {
                worst = most;
                verdict = {k, promising};
            }
        }
        return verdict;
    }

    void run_element(const Elements &elements, const Element &element, TensorRule &rule, ElementShape &shape,
                     const Goal &goal) {
        const int axes = elements.axes();
        const size_t size = element.net.size();
        nets_.assign(element.net.begin(), element.net.end());
        depths_.assign(1, 0);
        while (!depths_.empty()) {
            Levels levels = first(elements);
            Verdict verdict;
            do {
                const int64_t work = work_of_rule(elements, levels);
                count_work(work);
                left_ -= work;
                rule.evaluate(nets_.data() + nets_.size() - size, element.origin, levels);
                verdict = judge(rule, levels, axes, goal);
            } while (verdict.axis >= 0 && verdict.raise && ++levels[static_cast<size_t>(verdict.axis)] > 0);
            if (verdict.axis < 0 && depths_.back() < most_halvings_of_cell / 2 && matters(rule, goal)) {
                verdict.axis = shape.uneven_axis(nets_.data() + nets_.size() - size, element.spread,
                                                 integrand_.metric());
            }
            const bool good = verdict.axis < 0;
            if (good || depths_.back() >= most_halvings_of_cell || spent() || !std::isfinite(rule.value(0))) {
                accept(rule, axes, good);
                nets_.resize(nets_.size() - size);
                depths_.pop_back();
                continue;
            }
            halve_top(elements, size, verdict.axis);
        }
    }

    // Whether an element is neither integrated exactly nor negligible.
    [[nodiscard]] static bool matters(const TensorRule &rule, const Goal &goal) noexcept {
        return !rule.exact() && rule.magnitude(0) > goal.fraction * goal.tolerances[0];
    }

    // Adds the rounding of derivatives: a few eps of the spread for each degree.
    void add_rounding(const Elements &elements, const Element &element) noexcept {
        int degrees = 0;
        double product = 1;
        for (int k = 0; k < elements.axes(); ++k) {
            degrees += elements.degree(k) + 1;
            product *= element.spread;
        }
        rounding_ += 4 * degrees * eps * product;
    }

    void halve_top(const Elements &elements, size_t size, int axis) {
        int64_t outer = elements.width(), inner = elements.coefficients();
        for (int k = 0; k <= axis; ++k) {
            inner /= elements.degree(k) + 1;
            outer *= k < axis ? elements.degree(k) + 1 : 1;
        }
        nets_.resize(nets_.size() + size);
        double *top = nets_.data() + nets_.size() - 2 * size;
        subdivide({outer, elements.degree(axis), inner}, 0.5, top, top + size);
        ++depths_.back();
        depths_.push_back(depths_.back());
    }

    // Adds the integrals of an element. If the element is not good enough, the last difference of its rules
    // is taken as the error.
    void accept(const TensorRule &rule, int axes, bool good) {
        for (size_t j = 0; j < values_; ++j) {
            sums_[j].add(rule.value(j));
            double error = 4 * eps * rule.magnitude(j);
            for (int k = 0; k < axes; ++k) {
                error += good ? rule.error(k, j) : rule.decay(k, j).last;
            }
            errors_[j].add(std::isfinite(error) ? error : infinity);
        }
        size_.add(rule.magnitude(0));
    }

    const std::vector<Elements> &splines_;
    const Integrand &integrand_;
    size_t values_;
    int64_t count_ = 0;
    int64_t left_ = 0; // work that is left
    std::vector<double> nets_;
    std::vector<int> depths_;
    std::vector<CompensatedSum> sums_, errors_;
    CompensatedSum size_;
    double rounding_ = 0;
};

Goal goal_of(const Integrals &known, const Integrand &integrand, double tolerance, double fraction) {
    Goal goal{{}, known.size, fraction};
    const size_t dependent = known.values.size() - static_cast<size_t>(integrand.independent());
    for (size_t j = 0; j < known.values.size(); ++j) {
        const double own = j < dependent ? std::abs(known.values[0]) : known.size;
        goal.tolerances.push_back(std::max(tolerance * own, 16 * eps * known.size + known.rounding / 4));
    }
    return goal;
}

// Decides whether the errors are within the goal.
void judge(Integrals &known, const Integrand &integrand, double tolerance) {
    const Goal goal = goal_of(known, integrand, tolerance, 1);
    known.converged = true;
    for (size_t j = 0; j < known.values.size(); ++j) {
        const double rounding = 4 * eps * known.size + known.rounding;
        known.converged = known.converged && known.errors[j] <= 2 * (goal.tolerances[j] + rounding);
    }
}

Integrals integrate_to(TensorSearch &search, const Integrand &integrand, double tolerance, int shares,
                       Integrals known) {
    double fraction = 1 / (32.0 * static_cast<double>(std::max<int64_t>(search.count(), 1)));
    for (int attempt = 0; attempt < 3; ++attempt) {
        const Phase phase(0.75);
        known = search.run(goal_of(known, integrand, tolerance, fraction), shares);
        judge(known, integrand, tolerance);
        if (known.converged || search.spent()) {
            break;
        }
        fraction /= 64;
    }
    return known;
}

} // namespace

Integrals integrate(const std::vector<Elements> &splines, const Integrand &integrand,
                    double relative_tolerance) {
    TensorSearch search(splines, integrand);
    const Integrals rough = search.rough();
    ToleranceLadder ladder(relative_tolerance);
    Integrals result = integrate_to(search, integrand, ladder.tolerance(), ladder.shares(), rough);
    while (!result.converged && ladder.loosen()) {
        result = integrate_to(search, integrand, ladder.tolerance(), ladder.shares(), rough);
    }
    return result;
}

} // namespace nrb::measure
