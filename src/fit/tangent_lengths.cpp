// SPDX-License-Identifier: MIT
#include "fit/tangent_lengths.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "fit/least_squares/penalty.h"
#include "numeric/direction.h"
#include "numeric/norm.h"
#include "numeric/solvers/conjugate_gradients.h"
#include "numeric/solvers/sparse/probed_band.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace nrb::fit {

namespace {

// Half of the derivatives of the energy by layers of control points: a banded matrix, times these.
class Bending {
public:
    explicit Bending(const KnotVectorPtr &knots) {
        const StencilMatrix form = penalty({knots}, 2);
        std::vector<int64_t> order(static_cast<size_t>(form.size()));
        std::iota(order.begin(), order.end(), 0);
        columns_ = form.columns(order);
    }

    [[nodiscard]] std::vector<double> operator()(const std::vector<double> &layers, int64_t width) const {
        std::vector<double> result(layers.size());
        for (int64_t j = 0; j < columns_.size(); ++j) {
            const auto from = static_cast<size_t>(columns_.starts[static_cast<size_t>(j)]),
                       end = static_cast<size_t>(columns_.starts[static_cast<size_t>(j) + 1]);
            for (size_t e = from; e < end; ++e) {
                const double factor = columns_.values[e].value();
                const double *const source = layers.data() + int64_t{columns_.rows[e]} * width;
                std::transform(source, source + width, result.begin() + j * width, result.begin() + j * width,
                               [factor](double x, double sum) { return sum + factor * x; });
            }
        }
        return result;
    }

private:
    ColumnsOf<DoubleDouble> columns_;
};

// The energy as a function of unknowns u, the lengths of tangents in units of what a tangent of length 1 adds to it, as far as
// that can be told from the conditions beside it.
class LengthEnergy {
public:
    LengthEnergy(const AxisInterpolation &axis, std::span<const int64_t> directions, int dim,
                 const std::vector<double> &targets)
        : axis_(axis), where_(directions), dim_(dim), bending_(axis.knots()) {
        const Interval domain = axis.knots()->domain();
        const double length = domain.upper - domain.lower;
        for (const int64_t i : directions) {
            const std::vector<double> unit = unit_vector(targets.data() + i * dim, dim);
            units_.insert(units_.end(), unit.begin(), unit.end());
            scales_.push_back(1 / (length * std::sqrt(length * stiffness_at(i))));
        }
    }

    // Half of the derivatives by the unknowns, of the curve with right sides values[n][dim].
    [[nodiscard]] std::vector<double> slope(std::vector<double> values) const {
        axis_.solve(values, dim_);
        values = bending_(values, dim_);
        axis_.solve_transposed(values, dim_);
        std::vector<double> result;
        for (size_t j = 0; j < where_.size(); ++j) {
            result.push_back(scales_[j] * dot(unit(j), values.data() + where_[j] * dim_, dim_));
        }
        return result;
    }
    // Of the curve that unknowns alone determine.
    [[nodiscard]] std::vector<double> product(const std::vector<double> &u) const {
        std::vector<double> values(static_cast<size_t>(axis_.conditions() * dim_));
        for (size_t j = 0; j < where_.size(); ++j) {
            std::transform(unit(j), unit(j) + dim_, values.begin() + where_[j] * dim_,
                           [factor = u[j] * scales_[j]](double x) { return x * factor; });
        }
        return slope(std::move(values));
    }
    [[nodiscard]] double scale(size_t j) const noexcept { return scales_[j]; }

private:
    // The sum of 1 / h over the nearest other parameters on both sides, at distances h.
    [[nodiscard]] double stiffness_at(int64_t i) const noexcept {
        const double t = axis_.sites().param(i);
        int64_t before = i, after = i;
        while (before >= 0 && axis_.sites().param(before) == t) {
            --before;
        }
        while (after < axis_.conditions() && axis_.sites().param(after) == t) {
            ++after;
        }
        const double sum = (before >= 0 ? 1 / (t - axis_.sites().param(before)) : 0) +
                           (after < axis_.conditions() ? 1 / (axis_.sites().param(after) - t) : 0);
        const Interval domain = axis_.knots()->domain();
        return std::max(sum, 1 / (domain.upper - domain.lower));
    }
    [[nodiscard]] const double *unit(size_t j) const noexcept {
        return units_.data() + j * static_cast<size_t>(dim_);
    }

    const AxisInterpolation &axis_;
    std::span<const int64_t> where_;
    int dim_;
    Bending bending_;
    std::vector<double> units_; // [directions][dim]
    std::vector<double> scales_;
};

// Right sides without those of the directions, moved so that the first point is 0: the energy does not depend on the place, but
// its rounding errors do.
std::vector<double> fixed_part(const AxisInterpolation &axis, std::span<const int64_t> directions, int dim,
                               std::vector<double> targets) {
    std::vector<double> place;
    for (int64_t i = 0; i < axis.conditions(); ++i) {
        double *const own = targets.data() + i * dim;
        if (axis.sites().order(i) == 0) {
            place = place.empty() ? std::vector<double>(own, own + dim) : place;
            std::transform(own, own + dim, place.begin(), own, std::minus<>());
        }
    }
    for (const int64_t i : directions) {
        std::fill_n(targets.begin() + i * dim, dim, 0.0);
    }
    return targets;
}

// The equations of the least energy.
class LengthEquations {
public:
    LengthEquations(const LengthEnergy &energy, size_t size)
        : energy_(energy), size_(size),
          near_(probed_band(static_cast<int64_t>(size), reach,
                            [&](const std::vector<double> &u) { return energy.product(u); })),
          most_(static_cast<int>(std::min<size_t>(most_products, 2 * size + least_products))) {}

    // Equations that do not determine lengths may well have solutions for the right sides that curves make, so that these do not
    // tell: a right side that is no curve's does.
    void check_rank() const {
        std::vector<double> any(size_);
        uint64_t state = 1;
        for (double &x : any) {
            state =
                state * 6364136223846793005U + 1442695040888963407U; // D. Knuth, "Seminumerical Algorithms"
            x = (state >> 63U) != 0 ? 1 : -1;
        }
        if (largest_magnitude(solved(any)) == 0) {
            fail(Status::rank, "targets: the least energy does not determine the lengths of the tangents");
        }
    }

    // Conjugate gradients end at 1e-6 of the right side; what they leave is solved for again.
    [[nodiscard]] std::vector<double> solution(const std::vector<double> &right) const {
        constexpr double enough = 0x1p-26;
        constexpr int rounds = 3;
        std::vector<double> u(size_), rest = right;
        for (int round = 0; round < rounds; ++round) {
            const std::vector<double> step = solved(rest);
            std::transform(u.begin(), u.end(), step.begin(), u.begin(), std::plus<>());
            const std::vector<double> image = energy_.product(u);
            std::transform(right.begin(), right.end(), image.begin(), rest.begin(), std::minus<>());
        }
        const double left = length(rest), whole = length(right);
        if (!(left <= enough * whole)) {
            fail(Status::not_converged,
                 "targets: the lengths of the tangents are found to %s of themselves only",
                 Number(left / whole).text);
        }
        return u;
    }

private:
    static constexpr size_t most_products = 2000, least_products = 50;
    static constexpr double least = 0x1p-40;
    static constexpr int64_t reach = 24; // of tangents that matter to each other, in tangents

    [[nodiscard]] std::vector<double> solved(const std::vector<double> &right) const {
        return conjugate_gradients([this](const std::vector<double> &u) { return energy_.product(u); }, right,
                                   least, most_,
                                   [this](std::vector<double> x) {
                                       if (near_) {
                                           near_->solve(x.data(), 1);
                                       }
                                       return x;
                                   });
    }
    [[nodiscard]] static double length(const std::vector<double> &x) noexcept { return std::sqrt(dot(x, x)); }

    const LengthEnergy &energy_;
    size_t size_;
    std::optional<SparseLdlt> near_; // factors of the equations without those of tangents far apart
    int most_;
};

} // namespace

std::vector<double> tangent_lengths(const AxisInterpolation &axis, std::span<const int64_t> directions,
                                    int dim, const std::vector<double> &targets) {
    std::vector<double> lengths(static_cast<size_t>(axis.conditions()), 1.0);
    if (directions.empty()) {
        return lengths;
    }
    const LengthEnergy energy(axis, directions, dim, targets);
    std::vector<double> right = energy.slope(fixed_part(axis, directions, dim, targets));
    require_representable(right, "energies of tangents");
    const double largest = largest_magnitude(right);
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    std::ranges::for_each(right, [exponent](double &x) { x = -std::ldexp(x, -exponent); });
    const LengthEquations equations(energy, right.size());
    equations.check_rank();
    const std::vector<double> u = equations.solution(right);
    for (size_t j = 0; j < u.size(); ++j) {
        const double *const target = targets.data() + directions[j] * dim;
        lengths[static_cast<size_t>(directions[j])] =
            std::ldexp(u[j] * energy.scale(j), exponent) / norm(target, dim);
    }
    require_representable(lengths, "lengths of tangents");
    return lengths;
}

void check_along(std::span<const int64_t> directions, int dim, const std::vector<double> &targets,
                 const std::vector<double> &lengths) {
    constexpr double least = 0x1p-40;
    const auto length = [&](int64_t i) {
        return lengths[static_cast<size_t>(i)] * norm(targets.data() + i * dim, dim);
    };
    double longest = 0;
    for (const int64_t i : directions) {
        longest = std::max(longest, std::abs(length(i)));
    }
    for (const int64_t i : directions) {
        if (!(length(i) > least * longest)) {
            fail(Status::tangent,
                 "targets[%lld]: the tangent of least energy has the length %s along its direction, "
                 "expected a positive one",
                 static_cast<long long>(i), Number(length(i)).text);
        }
    }
}

} // namespace nrb::fit
