// SPDX-License-Identifier: MIT
#include "fit/constraints/shaped_fit.h"

#include "base/error.h"
#include "fit/constraints/inequalities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

    // Returns the trace of the influence matrix. Where rounding of the control points violates the shape, the
    // inequalities get a margin for it. Where the conditions leave no room for a margin, the control points
    // are what rounding makes of them.
    double impose(int c, Numbers &x) const {
        constexpr double margins[] = {0, 0x1p-51, 0x1p-48, 0x1p-45};
        const CoordinateShape shape(equations_.axes, equations_.dim, wishes_, c);
        std::optional<Attempt> best;
        for (const double margin : margins) {
            std::optional<Attempt> one = attempt(shape, c, coordinate_of(x, equations_.dim, c),
                                                 margin * (best ? largest_of(best->x) : 0), !best);
            if (!one) {
                break;
            }
            const bool holds = one->holds;
            if (!best || holds) {
                best = std::move(one);
            }
            if (holds) {
                break;
            }
        }
        for (size_t i = 0; i < best->x.size(); ++i) {
            x[i * static_cast<size_t>(equations_.dim) + static_cast<size_t>(c)] = best->x[i];
        }
        return best->freedom;
    }

private:
    struct Attempt {
        Numbers x; // rounded, as the control points of the spline will be
        double freedom;
        bool holds;
    };
    // Nothing where there is no room for the margin; in the first attempt, which has none,
    // Status::contradiction is thrown instead.
    std::optional<Attempt> attempt(const CoordinateShape &shape, int c, const Numbers &start, double margin,
                                   bool first) const {
        try {
            // Bounds far away are left out at first: they need not be looked at unless the solution gets
            // there, and would be large beside all that matters.
            constexpr double far = 0x1p10;
            const double limit = far * std::max(1.0, largest_of(start));
            Attempt near = solved(shape, c, start, margin, limit);
            return largest_of(near.x) <= limit
                       ? near
                       : solved(shape, c, start, margin, std::numeric_limits<double>::infinity());
        } catch (const Error &error) {
            if (first || error.status() != Status::contradiction) {
                throw;
            }
            return std::nullopt;
        }
    }
    Attempt solved(const CoordinateShape &shape, int c, const Numbers &start, double margin,
                   double limit) const {
        std::vector<LinearRow> rows = conditions_of(conditions_, c);
        const size_t equal = rows.size();
        std::ranges::move(shape.rows(margin, limit), std::back_inserter(rows));
        Inequalities problem(equations_of(equations_, matrix_, c), std::move(rows), equal);
        std::vector<double> points;
        for (const DoubleDouble &value : problem.minimum(start)) {
            points.push_back(value.high);
        }
        shape.settle(points);
        return {Numbers(points.begin(), points.end()), problem.freedom(data_.matrix), shape.holds(points)};
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
