// SPDX-License-Identifier: MIT
// What moments are integrals of, and how they follow from these.
#pragma once

#include "measure/moments.h"

namespace nrb::measure {

// A density times 1, x and x x^T.
class MomentIntegrand : public Integrand {
public:
    MomentIntegrand(int axes, int dim, MomentOrder order) : axes_(axes), dim_(dim), order_(order) {}

    [[nodiscard]] int values() const noexcept override {
        return 1 + (order_ >= MomentOrder::centroid ? dim_ : 0) +
               (order_ == MomentOrder::inertia ? dim_ * (dim_ + 1) / 2 : 0);
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

double determinant(const double *u, const double *v, const double *w) noexcept;

// What the integrals of the density times functions of degree 0, 1 and 2 are multiplied by, and the dimension
// of the content.
struct Factors {
    double content = 1, first = 1, second = 1;
    int dimension;
};

// From integrals in the frame of the model, of which the last `independent` ones are a vector area. Throws as moments().
Moments moments_from(const Integrals &sums, int independent, const Factors &factors,
                     const pieces::Frame &frame, MomentOrder order, double relative_tolerance);

} // namespace nrb::measure
