// SPDX-License-Identifier: MIT
// Closest points of a curve.
#pragma once

#include "closest/curve/curve_search.h"
#include "closest/locator.h"

namespace nrb::closest {

class CurveLocator final : public Locator {
public:
    explicit CurveLocator(const Spline &curve);

    [[nodiscard]] Foot nearest(const Query &query) const override;
    [[nodiscard]] Foot local(const double *point, const double *guess) const override;

    [[nodiscard]] CriticalSet critical(const Query &query) const override;
    [[nodiscard]] CriticalSet minima(const Query &query) const override;

private:
    [[nodiscard]] Foot foot_of(const CurvePlace &place, const Interval *range) const noexcept;
    [[nodiscard]] bool at_end(double t, const Interval *range) const noexcept;

    [[nodiscard]] CriticalSet critical(const Query &query, double apart, double within) const;

    const Spline &curve_; // owns the locator
    CurveTree tree_;
    Interval domain_;
    bool periodic_;
};

} // namespace nrb::closest
