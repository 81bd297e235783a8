// Splines and places for deformations.
#pragma once

#include "property/influences.h"
#include "reference/definition.h"

namespace support::deform {

inline Recipe calm_recipe(Random &random, int axes, int max_degree, int dim) {
    Recipe recipe;
    recipe.dim = dim;
    recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
    for (int k = 0; k < axes; ++k) {
        AxisRecipe axis = random_axis(random, random.whole(1, max_degree));
        axis.form = random.chance(60)   ? KnotForm::clamped
                    : random.chance(50) ? KnotForm::unclamped
                                        : KnotForm::periodic;
        axis.spacing = random.chance(50) ? Spacing::integers : Spacing::few_bits;
        axis.placement = Placement::origin;
        axis.spans = random.whole(1, 5);
        recipe.axes.push_back(axis);
    }
    return recipe;
}

inline std::vector<double> direction_of(Random &random, int dim) {
    std::vector<double> direction;
    for (int c = 0; c < dim; ++c) {
        direction.push_back(random.between(-1, 1));
    }
    direction[0] += 2;
    return direction;
}

inline std::vector<double> any_range(Random &random, const SplineData &data) {
    std::vector<double> range;
    for (int k = 0; k < data.axes(); ++k) {
        const double lower = data.lower(k), length = data.upper(k) - lower;
        const double a = random.chance(25) ? 0 : random.whole(1, 3) / 8.0,
                     b = random.chance(25) ? 1 : random.whole(5, 7) / 8.0;
        range.push_back(lower + a * length);
        range.push_back(b == 1 ? data.upper(k) : lower + b * length);
    }
    return range;
}

inline Point step_between(const nurbs *before, const nurbs *after, const std::vector<double> &param) {
    return minus(point_at(read_back(after), param), point_at(read_back(before), param));
}

} // namespace support::deform
