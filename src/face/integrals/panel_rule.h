// SPDX-License-Identifier: MIT
// Tensor products of nested rules on panels.
#pragma once

#include "face/integrals/panel.h"
#include "measure/tensor_integral.h"
#include "numeric/nested_rule.h"
#include "pieces/frame.h"

#include <array>
#include <vector>

namespace nrb::face {

class PanelRule {
public:
    PanelRule(const Spline &surface, const TrimMap &trims, const pieces::Frame &frame,
              const measure::Integrand &integrand);

    // The integrals by the rules of two levels >= 1 along x and y, and how far those of one level less along either are away; caution >= 1:
    // how much farther away than these the integrals may be themselves.
    struct Sums {
        std::vector<double> values;                // times the factor of the panel
        std::array<std::vector<double>, 2> errors; // what a higher rule is likely to change
        double magnitude = 0;                      // of the first value
        double spread = 0; // the same if derivatives were at right angles; they are off by a few eps of it
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
    std::vector<std::array<size_t, 2>> nodes_; // places in the rules
    std::vector<Panel::Jet> jets_;
    std::vector<double> params_, derivatives_, out_, spreads_;
};

} // namespace nrb::face
