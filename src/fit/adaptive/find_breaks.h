// SPDX-License-Identifier: MIT
// Breaks of data: kinks and jumps.
#pragma once

#include "fit/adaptive/fit_domain.h"
#include "fit/statistics/gather.h"

#include <vector>

namespace nrb::fit {

// Finds the breaks of curve data that a smooth fit over uniform spans misses here and there by more than the
// tolerance; the data are in the order of their parameters. A break is a place between two data such that one
// polynomial is within the tolerance of the data of some spans before it, and another one of those after it.
// At a kink it is the place near there at which the two polynomials are closest to each other, within the
// tolerance.
class BreakSearch {
public:
    // `distances`: those of the data from the fit. `span`: the length of its spans.
    BreakSearch(const Data &sorted, std::vector<double> distances, int degree, double span, double tolerance);

    // `all`: all data, of which the sorted ones are some; the breaks are located among these.
    [[nodiscard]] std::vector<Break> breaks(const Data &all) const;

private:
    struct Cluster {
        int64_t first, last; // indices of data
    };
    [[nodiscard]] std::vector<Cluster> clusters() const;
    [[nodiscard]] bool find(const Cluster &cluster, const Cluster &room, double window, const Data &all,
                            Break &found) const;
    [[nodiscard]] bool meet(const Spline &a, const Spline &b, const ConstRecords &params, int64_t at,
                            Break &found) const;
    [[nodiscard]] int64_t first_from(double t, int64_t from, int64_t end) const noexcept;
    [[nodiscard]] int64_t end_at(double t, int64_t first, int64_t end) const noexcept;
    [[nodiscard]] double param(int64_t i) const noexcept { return data_.params(i, 0); }

    const Data &data_;
    std::vector<double> distances_;
    int degree_;
    double span_;
    double tolerance_;
};

} // namespace nrb::fit
