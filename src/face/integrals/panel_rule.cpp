// SPDX-License-Identifier: MIT
#include "face/integrals/panel_rule.h"

#include "base/numbers.h"
#include "eval/evaluate.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// The difference of two rules is the error of the lower one, unless both are equally wrong. The error of the
// higher rule is about the square of that. As in QUADPACK (R. Piessens, E. de Doncker-Kapenga, C. Ueberhuber,
// D. Kahaner, 1983), only a power of 1.5 is relied on, here with the magnitude instead of the mean deviation.
double likely_error(double difference, double magnitude, double caution) noexcept {
    if (!(magnitude > 0)) {
        return difference;
    }
    return std::min(caution * difference, magnitude * std::pow(200 * difference / magnitude, 1.5));
}

// The weight of a node in the rule of a level; 0 for nodes that only higher levels have.
double weight_at(int level, size_t place) noexcept {
    return place < static_cast<size_t>(rule_size(level)) ? rule_weights(level)[place] : 0;
}

} // namespace

PanelRule::PanelRule(const Spline &surface, const TrimMap &trims, const pieces::Frame &frame,
                     const measure::Integrand &integrand)
    : surface_(surface), trims_(trims), frame_(frame), integrand_(integrand),
      dim_(static_cast<size_t>(surface.dim())), values_(static_cast<size_t>(integrand.values())) {}

void PanelRule::fill_nodes(const Panel &panel, const std::array<int, 2> &levels) {
    nodes_.clear();
    jets_.clear();
    params_.clear();
    const auto size = [&](size_t k) { return static_cast<size_t>(rule_size(levels[k])); };
    for (size_t i = 0; i < size(0); ++i) {
        for (size_t j = 0; j < size(1); ++j) {
            if (rule_weights(levels[0])[i] != 0 && rule_weights(levels[1])[j] != 0) {
                nodes_.push_back({i, j});
                jets_.push_back(panel.jet(trims_.pieces(), rule_places()[i], rule_places()[j]));
                for (const int k : {0, 1}) {
                    const Interval domain = surface_.axis(k).domain();
                    params_.push_back(
                        std::clamp(jets_.back().place[static_cast<size_t>(k)], domain.lower, domain.upper));
                }
            }
        }
    }
}

// Evaluates the integrand at all nodes.
void PanelRule::visit_nodes() {
    const auto count = std::ssize(nodes_);
    const auto width = static_cast<int64_t>(3 * dim_);
    derivatives_.resize(static_cast<size_t>(count * width));
    out_.resize(nodes_.size() * values_);
    eval::evaluate_points(surface_, {}, 1, {params_.data(), count, 2, 2, 1},
                          {derivatives_.data(), count, width, width, 1});
    spreads_.resize(nodes_.size());
    std::vector<double> place(dim_), along(2 * dim_);
    const double scale = frame_.scaled(1);
    for (size_t i = 0; i < nodes_.size(); ++i) {
        const double *jet = derivatives_.data() + i * static_cast<size_t>(width);
        const Panel::Jet &by = jets_[i];
        const double part = std::abs(by.by_x[0] * by.by_y[1] - by.by_x[1] * by.by_y[0]); // area of the domain
        double u = 0, v = 0;
        for (size_t c = 0; c < dim_; ++c) {
            place[c] = frame_.coordinate(c, jet[c]);
            along[c] = jet[dim_ + c] * scale * part;
            along[dim_ + c] = jet[2 * dim_ + c] * scale;
            u += along[c] * along[c];
            v += along[dim_ + c] * along[dim_ + c];
        }
        spreads_[i] = std::sqrt(u * v);
        double *out = out_.data() + i * values_;
        integrand_(place.data(), along.data(), out);
        if (integrand_.absolute() && out[0] < 0) {
            std::transform(out, out + values_, out, [](double x) { return -x; });
        }
    }
}

PanelRule::Sums PanelRule::evaluate(const Panel &panel, const std::array<int, 2> &levels, double caution) {
    fill_nodes(panel, levels);
    visit_nodes();
    Sums sums;
    sums.values.assign(values_, 0);
    sums.errors.fill(std::vector<double>(values_, 0));
    std::vector<double> magnitudes(values_, 0);
    for (size_t i = 0; i < nodes_.size(); ++i) {
        const auto [a, b] = nodes_[i];
        const double x = weight_at(levels[0], a), y = weight_at(levels[1], b);
        const double lower_x = weight_at(levels[0] - 1, a), lower_y = weight_at(levels[1] - 1, b);
        for (size_t j = 0; j < values_; ++j) {
            const double value = out_[i * values_ + j];
            sums.values[j] += x * y * value;
            magnitudes[j] += x * y * std::abs(value);
            sums.errors[0][j] += (x - lower_x) * y * value;
            sums.errors[1][j] += x * (y - lower_y) * value;
        }
        sums.spread += x * y * spreads_[i];
    }
    for (size_t j = 0; j < values_; ++j) {
        sums.values[j] *= panel.factor;
        for (std::vector<double> &errors : sums.errors) {
            errors[j] = std::abs(panel.factor) * likely_error(std::abs(errors[j]), magnitudes[j], caution);
        }
    }
    sums.magnitude = std::abs(panel.factor) * magnitudes[0];
    sums.spread *= std::abs(panel.factor);
    return sums;
}

} // namespace nrb::face
