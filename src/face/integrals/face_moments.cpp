// SPDX-License-Identifier: MIT
#include "face/integrals/face_moments.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "face/integrals/panel_rule.h"
#include "measure/elements.h"
#include "measure/moment_integrand.h"
#include "numeric/sum.h"
#include "pieces/spline_pieces.h"

#include <algorithm>
#include <queue>

namespace nrb::face {

namespace {

constexpr int first_level = 1, last_level = 3;
constexpr int64_t work_of_a_node = 300;
constexpr int64_t least_work = 1500000000;
constexpr int64_t rules_for_a_panel = 24;
constexpr int most_panel_halvings = 40;

struct PanelPart {
    Panel panel;
    std::array<int, 2> levels{first_level, first_level};
    PanelRule::Sums sums;
    int halvings = 0;
    double error = 0; // the largest of its errors, relative to what each value is relative to

    bool operator<(const PanelPart &other) const noexcept { return error < other.error; }
};

class FaceIntegral {
public:
    // eps_off: how many eps of their sizes derivatives may be off.
    FaceIntegral(PanelRule &rule, const measure::Integrand &integrand, int eps_off)
        : rule_(rule), values_(static_cast<size_t>(integrand.values())), off_(eps_off * eps) {}

    measure::Integrals integrate(const std::vector<Panel> &panels, double tolerance) {
        left_ = least_work;
        for (const Panel &panel : panels) {
            PanelPart part;
            part.panel = panel;
            evaluate(part);
            left_ += rules_for_a_panel * 64 * work_of_a_node;
            queue_.push(std::move(part));
        }
        const double goal = std::max(tolerance * size_, 16 * eps * magnitude_ + off_ * spread_);
        while (!queue_.empty() && error_ > goal && left_ > 0) {
            refine();
        }
        measure::Integrals result = sum();
        result.converged = tolerance == 0 || error_ <= std::max(goal, tolerance * std::abs(result.values[0]));
        return result;
    }

private:
    // Coordinates are at most about 1, so that the area is what all values are relative to.
    void evaluate(PanelPart &part) {
        part.sums = rule_.evaluate(part.panel, part.levels);
        const int64_t work = (int64_t{4} << part.levels[0]) * (int64_t{4} << part.levels[1]) * work_of_a_node;
        count_work(work);
        left_ -= work;
        part.error = 0;
        for (size_t j = 0; j < values_; ++j) {
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
    [[nodiscard]] static double worst(const std::vector<double> &errors) {
        return *std::max_element(errors.begin(), errors.end());
    }

    // The part with the largest error: a higher rule along the worse axis, or both halves. A part that cannot be halved further is
    // not tried again.
    void refine() {
        PanelPart part = queue_.top();
        queue_.pop();
        forget(part);
        const size_t axis = worst(part.sums.errors[0]) >= worst(part.sums.errors[1]) ? 0 : 1;
        if (part.levels[axis] < last_level) {
            ++part.levels[axis];
            add(part);
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
        PanelPart lower;
        lower.panel = part.panel.halve(axis);
        lower.halvings = ++part.halvings;
        lower.levels = part.levels;
        lower.levels[axis] = part.levels[axis] = first_level + 1;
        add(lower);
        add(part);
    }
    void add(PanelPart &part) {
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
        error_ = result.errors[0];
        result.size = magnitude_;
        result.rounding = 64 * eps * magnitude_ + off_ * spread_;
        return result;
    }

    PanelRule &rule_;
    size_t values_;
    double off_;
    std::priority_queue<PanelPart> queue_;
    int64_t left_ = 0;
    double error_ = 0, size_ = 0, magnitude_ = 0, spread_ = 0;
};

} // namespace

measure::Moments moments(const Face &face, measure::MomentOrder order, double relative_tolerance) {
    const Spline &surface = *face.surface();
    const pieces::Frame frame = measure::integral_frame(surface);
    const measure::MomentIntegrand integrand(2, surface.dim(), order);
    PanelRule rule(surface, face.trims(), frame, integrand);
    const std::vector<Panel> panels =
        panels_of(face.trims(), pieces::breaks_in(surface.axis(0), surface.axis(0).domain()),
                  pieces::breaks_in(surface.axis(1), surface.axis(1).domain()));
    const int eps_off = 4 * (surface.axis(0).degree() + surface.axis(1).degree() + 2);
    const measure::Integrals sums =
        FaceIntegral(rule, integrand, eps_off).integrate(panels, relative_tolerance);
    return measure::moments_from(sums, 0, {1, 1, 1, 2}, frame, order, relative_tolerance);
}

} // namespace nrb::face
