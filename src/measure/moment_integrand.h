// SPDX-License-Identifier: MIT
// The integrands of moments, and the moments that follow from their integrals.
#pragma once

#include "measure/moments.h"

namespace nrb::measure {

// Moments of the shape itself: the density times 1, x and x x^T, where the density is the length, area or
// volume element.
class MomentIntegrand : public Integrand {
public:
    MomentIntegrand(int axes, int dim, MomentOrder order) : axes_(axes), dim_(dim), order_(order) {}

    [[nodiscard]] int64_t values() const noexcept override {
        const int64_t n = dim_;
        return 1 + (order_ >= MomentOrder::centroid ? n : 0) +
               (order_ == MomentOrder::inertia ? n * (n + 1) / 2 : 0);
    }
    [[nodiscard]] bool absolute() const noexcept override { return axes_ == dim_; }
    [[nodiscard]] bool metric() const noexcept override { return true; }
    [[nodiscard]] int degree(int places) const noexcept override {
        return axes_ == dim_ ? (dim_ + static_cast<int>(order_)) * places : -1;
    }
    void operator()(const double *x, const double *derivatives, double *out) const noexcept override;

protected:
    [[nodiscard]] virtual double density(const double *x, const double *derivatives) const noexcept;
    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] MomentOrder order() const noexcept { return order_; }

private:
    int axes_, dim_;
    MomentOrder order_;
};

// Moments of the region that a boundary encloses, by the divergence theorem: the density x . n, times
// 1, x and x x^T, and for surfaces the vector area element.
class BoundaryIntegrand : public MomentIntegrand {
public:
    BoundaryIntegrand(int dim, MomentOrder order) : MomentIntegrand(dim - 1, dim, order) {}

    [[nodiscard]] bool absolute() const noexcept override { return false; }
    [[nodiscard]] bool metric() const noexcept override { return false; }
    [[nodiscard]] int degree(int places) const noexcept override {
        return (dim() + static_cast<int>(order())) * places;
    }
    [[nodiscard]] int independent() const noexcept override { return dim() == 3 ? 3 : 0; }
    [[nodiscard]] int64_t values() const noexcept override {
        return MomentIntegrand::values() + independent();
    }
    void operator()(const double *place, const double *derivatives, double *out) const noexcept override;

protected:
    [[nodiscard]] double density(const double *x, const double *d) const noexcept override;
};

double determinant(const double *u, const double *v, const double *w) noexcept;

// The factors by which the integrals of the density times functions of degree 0, 1 and 2 are multiplied, and
// the dimension of the content.
struct Factors {
    double content = 1, first = 1, second = 1;
    int dimension;
};

// For what a boundary in n dimensions encloses: over the cone from the origin to an element of the boundary,
// the integral of a homogeneous function of degree k is 1 / (n + k) of that function times x . n on the
// element.
constexpr Factors enclosed_factors(int n) noexcept {
    return {1.0 / n, 1.0 / (n + 1), 1.0 / (n + 2), n};
}

// The moments from integrals in the frame of the model; the last `independent` ones are the vector area.
// Throws as moments().
Moments moments_from(const Integrals &sums, int independent, const Factors &factors,
                     const pieces::Frame &frame, MomentOrder order, double relative_tolerance);

} // namespace nrb::measure
