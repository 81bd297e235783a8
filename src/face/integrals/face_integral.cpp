// SPDX-License-Identifier: MIT
#include "face/integrals/face_integral.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "face/integrals/panel_rule.h"
#include "numeric/sum.h"
#include "pieces/spline_pieces.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>

namespace nrb::face {

namespace {

constexpr int first_level = 1, last_level = 3;
constexpr int64_t work_of_a_node = 300;
constexpr int64_t least_work = 1500000000;
constexpr int64_t rules_for_a_panel = 24;
constexpr int most_panel_halvings = 40;
// The rules of few nodes on a whole panel may agree by chance; those on many small parts do not.
constexpr double caution_with_whole_panels = 10;

struct PanelPart {
    Panel panel;
    size_t rule; // index of the rule of its surface
    std::array<int, 2> levels{first_level, first_level};
    PanelRule::Sums sums{};
    int halvings = 0;
    double error = 0; // the largest one of its values, relative to what the value is relative to

    bool operator<(const PanelPart &other) const noexcept { return error < other.error; }
};

// Adaptive cubature: a queue of panels, the one with the largest error first.
class FaceIntegral {
public:
    FaceIntegral(const measure::Integrand &integrand, const pieces::Frame &frame)
        : integrand_(integrand), frame_(frame), values_(static_cast<size_t>(integrand.values())),
          dependent_(values_ - static_cast<size_t>(integrand.independent())) {}

    void add(const TrimmedSurface &own) {
        const Spline &surface = *own.surface;
        rules_.emplace_back(surface, *own.trims, frame_, integrand_);
        off_ = std::max(off_, 4 * eps * (surface.axis(0).degree() + surface.axis(1).degree() + 2));
        for (const Panel &panel : panels_of(*own.trims, breaks_of(surface, 0), breaks_of(surface, 1))) {
            PanelPart part{panel, rules_.size() - 1};
            part.panel.factor *= own.other_side ? -1 : 1;
            left_ += rules_for_a_panel * 64 * work_of_a_node;
            push(part);
        }
    }

    measure::Integrals integrate(double tolerance) {
        const double goal = std::max(tolerance * std::abs(size_), 16 * eps * magnitude_ + off_ * spread_);
        while (!queue_.empty() && error_ > goal && left_ > 0) {
            refine();
        }
        measure::Integrals result = sum();
        result.converged = tolerance == 0 || error_ <= std::max(goal, tolerance * std::abs(result.values[0]));
        return result;
    }

private:
    [[nodiscard]] static std::vector<double> breaks_of(const Spline &surface, int k) {
        return pieces::breaks_in(surface.axis(k), surface.axis(k).domain());
    }
    // Coordinates are at most about 1, so that all values are relative to the first one.
    void evaluate(PanelPart &part) {
        part.sums = rules_[part.rule].evaluate(part.panel, part.levels,
                                               part.halvings == 0 ? caution_with_whole_panels : 1);
        const int64_t work = (int64_t{4} << part.levels[0]) * (int64_t{4} << part.levels[1]) * work_of_a_node;
        count_work(work);
        left_ -= work;
        part.error = 0;
        for (size_t j = 0; j < dependent_; ++j) {
            part.error = std::max(part.error, part.sums.errors[0][j] + part.sums.errors[1][j]);
        }
        error_ += part.error;
        size_ += part.sums.values[0];
        magnitude_ += part.sums.magnitude;
        spread_ += part.sums.spread;
    }
    void forget(const PanelPart &part) noexcept {
        error_ -= part.error;
        size_ -= part.sums.values[0];
        magnitude_ -= part.sums.magnitude;
        spread_ -= part.sums.spread;
    }
    [[nodiscard]] double worst(const std::vector<double> &errors) const {
        return *std::max_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(dependent_));
    }

    // Takes the part with the largest error, and uses a higher rule along the worse axis, or halves the part.
    // A part that cannot be halved further is not tried again.
    void refine() {
        PanelPart part = queue_.top();
        queue_.pop();
        forget(part);
        const size_t axis = worst(part.sums.errors[0]) >= worst(part.sums.errors[1]) ? 0 : 1;
        if (part.levels[axis] < last_level) {
            ++part.levels[axis];
            push(part);
        } else if (part.halvings < most_panel_halvings) {
            halve(part, axis);
        } else {
            part.error = 0;
            size_ += part.sums.values[0];
            magnitude_ += part.sums.magnitude;
            spread_ += part.sums.spread;
            queue_.push(std::move(part));
        }
    }
    void halve(PanelPart &part, size_t axis) {
        PanelPart lower{part.panel.halve(axis), part.rule};
        lower.halvings = ++part.halvings;
        lower.levels = part.levels;
        lower.levels[axis] = part.levels[axis] = first_level + 1;
        push(lower);
        push(part);
    }
    void push(PanelPart &part) {
        evaluate(part);
        queue_.push(std::move(part));
    }

    measure::Integrals sum() {
        std::vector<CompensatedSum> values(values_), errors(values_);
        const auto count_part = [&](const PanelPart &part) {
            for (size_t j = 0; j < values_; ++j) {
                values[j].add(part.sums.values[j]);
                errors[j].add(part.sums.errors[0][j] + part.sums.errors[1][j]);
            }
        };
        for (; !queue_.empty(); queue_.pop()) {
            count_part(queue_.top());
        }
        measure::Integrals result;
        for (size_t j = 0; j < values_; ++j) {
            result.values.push_back(values[j].value());
            result.errors.push_back(errors[j].value());
        }
        error_ = worst(result.errors);
        result.size = magnitude_;
        result.rounding = 64 * eps * magnitude_ + off_ * spread_;
        return result;
    }

    const measure::Integrand &integrand_;
    const pieces::Frame &frame_;
    size_t values_, dependent_;
    std::deque<PanelRule> rules_;
    double off_ = 0; // errors of derivatives, relative to their sizes
    std::priority_queue<PanelPart> queue_;
    int64_t left_ = least_work;
    double error_ = 0, size_ = 0, magnitude_ = 0, spread_ = 0;
};

} // namespace

measure::Integrals integrate(std::span<const TrimmedSurface> surfaces, const measure::Integrand &integrand,
                             const pieces::Frame &frame, double relative_tolerance) {
    FaceIntegral integral(integrand, frame);
    for (const TrimmedSurface &surface : surfaces) {
        integral.add(surface);
    }
    return integral.integrate(relative_tolerance);
}

} // namespace nrb::face
