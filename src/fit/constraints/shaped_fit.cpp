// SPDX-License-Identifier: MIT
#include "fit/constraints/shaped_fit.h"

#include "base/error.h"
#include "base/watch.h"
#include "fit/constraints/inequalities.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

using Numbers = std::vector<DoubleDouble>;

Numbers coordinate_of(const Numbers &x, int dim, int c) {
    Numbers result;
    for (size_t i = static_cast<size_t>(c); i < x.size(); i += static_cast<size_t>(dim)) {
        result.push_back(x[i]);
    }
    return result;
}

NormalEquations equations_of(const NormalEquations &all, const StencilMatrix &matrix, int c) {
    return {all.axes,
            matrix,
            coordinate_of(all.right, all.dim, c),
            {all.squares[static_cast<size_t>(c)]},
            all.support,
            all.weight,
            all.data_count,
            1};
}

std::vector<LinearRow> conditions_of(const std::vector<LinearRow> &conditions, int c) {
    std::vector<LinearRow> rows = conditions;
    for (LinearRow &row : rows) {
        row.target = {row.target[static_cast<size_t>(c)]};
    }
    return rows;
}

class ShapedFit {
public:
    ShapedFit(const NormalEquations &data, const NormalEquations &equations, const StencilMatrix *penalty,
              double lambda, const std::vector<LinearRow> &conditions, const ShapeWishes &wishes)
        : data_(data), equations_(equations), matrix_(equations.matrix), conditions_(conditions),
          wishes_(wishes) {
        if (penalty != nullptr && lambda > 0) {
            matrix_.add_multiple(lambda, *penalty);
        }
    }

    // Returns the trace of the influence matrix.
    double impose(int c, Numbers &x) const {
        constexpr double first_margin = 0x1p-48, growth = 8;
        constexpr int attempts = 5;
        const CoordinateShape shape(equations_.axes, equations_.dim, wishes_, c);
        const Numbers start = coordinate_of(x, equations_.dim, c);
        double margin = first_margin * largest_of(start);
        for (int i = 0; i < attempts; ++i, margin *= growth) {
            std::vector<LinearRow> rows = conditions_of(conditions_, c);
            const size_t equal = rows.size();
            std::ranges::move(shape.rows(margin), std::back_inserter(rows));
            Inequalities problem(equations_of(equations_, matrix_, c), std::move(rows), equal);
            if (take(problem.minimum(start), shape, c, x)) {
                return problem.freedom(data_.matrix);
            }
        }
        fail(Status::not_converged,
             "coordinate %d: rounding of the control points is larger than what the shape leaves", c);
    }

private:
    // As the control points that the spline will have.
    bool take(const Numbers &found, const CoordinateShape &shape, int c, Numbers &x) const {
        std::vector<double> points;
        for (const DoubleDouble &value : found) {
            points.push_back(value.high);
        }
        shape.settle(points);
        if (!shape.holds(points)) {
            return false;
        }
        for (size_t i = 0; i < points.size(); ++i) {
            x[i * static_cast<size_t>(equations_.dim) + static_cast<size_t>(c)] = points[i];
        }
        return true;
    }

    const NormalEquations &data_, &equations_;
    StencilMatrix matrix_;
    const std::vector<LinearRow> &conditions_;
    const ShapeWishes &wishes_;
};

} // namespace

void impose_shape(const NormalEquations &data, const NormalEquations &equations, const StencilMatrix *penalty,
                  double lambda, const std::vector<LinearRow> &conditions, const ShapeWishes &wishes,
                  Smoothed &found) {
    const ShapedFit fit(data, equations, penalty, lambda, conditions, wishes);
    double freedom = 0;
    for (int c = 0; c < equations.dim; ++c) {
        const bool free = CoordinateShape(equations.axes, equations.dim, wishes, c).empty();
        freedom += free ? found.freedom : fit.impose(c, found.x);
    }
    found.freedom = freedom / equations.dim;
    found.squares = PenalisedSystem(data, nullptr).remaining_squares(found.x);
}

} // namespace nrb::fit
