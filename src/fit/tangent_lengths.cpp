// SPDX-License-Identifier: MIT
#include "fit/tangent_lengths.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "fit/length_energy.h"
#include "numeric/norm.h"
#include "numeric/solvers/conjugate_gradients.h"
#include "numeric/solvers/sparse/probed_band.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace nrb::fit {

namespace {

// The right-hand sides without those of the directions, translated so that the first point is 0: the energy
// does not depend on the position, but its rounding errors do.
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

// The linear equations of the minimum of the energy, solved by preconditioned conjugate gradients.
class LengthEquations {
public:
    LengthEquations(const LengthEnergy &energy, size_t size)
        : energy_(energy), size_(size),
          near_(probed_band(static_cast<int64_t>(size), reach,
                            [&](const std::vector<double> &u) { return energy.product(u); })),
          most_(static_cast<int>(std::min<size_t>(most_products, 2 * size + least_products))) {}

    // Throws Status::rank if the matrix is singular. Right-hand sides that come from a curve may be
    // consistent even then, and so do not reveal it; a pseudo-random one, which is no curve's, does.
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

    // Conjugate gradients stop at a residual of 1e-6 of the right-hand side; then they solve for the residual
    // again (iterative refinement).
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
    static constexpr int64_t reach = 24; // how many tangents apart they still interact

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
    std::optional<SparseLdlt> near_; // the preconditioner: factors of the band of near tangents
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
