// The last step of every evaluation: from contracted records to the caller's record.
#pragma once

#include "base/records.h"
#include "eval/axis_basis.h"
#include "eval/quotient.h"
#include "eval/slots.h"

#include <array>
#include <limits>
#include <optional>

namespace nrb {

using Bases = std::array<AxisBasis, max_axes>;

class Finisher {
public:
    [[nodiscard]] static size_t scratch_size(const Spline &spline, int order) noexcept;
    Finisher(const Spline &spline, int order, Scratch &scratch) noexcept;

    // Divides, replaces the point by the stored control point where it is the only active one, and writes
    // record i.
    void write(const double *contracted, const Bases &bases, Records out, int64_t i) const noexcept;
    void write_nan(Records out, int64_t i) const noexcept;

private:
    [[nodiscard]] int64_t sole_point(const Bases &bases) const noexcept;

    const Spline &spline_;
    std::optional<QuotientRule> quotient_;
    int64_t values_;
    double *cartesian_;
};

} // namespace nrb
