// SPDX-License-Identifier: MIT
// Tensor products of nested quadrature rules on panels.
#pragma once

#include "face/integrals/panel.h"
#include "measure/tensor_integral.h"
#include "numeric/nested_rule.h"
#include "pieces/frame.h"

#include <array>
#include <vector>

namespace nrb::face {

// Evaluates integrals over single panels of a surface.
class PanelRule {
public:
    PanelRule(const Spline &surface, const TrimMap &trims, const pieces::Frame &frame,
              const measure::Integrand &integrand);

    // Integrates over a panel by the rules of two levels >= 1, along x and y, and estimates errors from the
    // rules one level lower along either axis. caution >= 1: a factor by which an error may exceed the
    // difference of the two rules.
    struct Sums {
        std::vector<double> values;                // times the factor of the panel
        std::array<std::vector<double>, 2> errors; // for x and y: what a higher rule is likely to change
        double magnitude = 0;                      // integral of the magnitude of the first value
        // The integral of |S_u| |S_v|: the area if both were perpendicular. Rounding is a few eps of it.
        double spread = 0;
    };
    Sums evaluate(const Panel &panel, const std::array<int, 2> &levels, double caution);

private:
    void fill_nodes(const Panel &panel, const std::array<int, 2> &levels);
    void visit_nodes();

    const Spline &surface_;
    const TrimMap &trims_;
    const pieces::Frame &frame_;
    const measure::Integrand &integrand_;
    size_t dim_, values_;
    std::vector<std::array<size_t, 2>> nodes_; // indices of nodes in both rules
    std::vector<Panel::Jet> jets_;
    std::vector<double> params_, derivatives_, out_, spreads_;
};

} // namespace nrb::face
