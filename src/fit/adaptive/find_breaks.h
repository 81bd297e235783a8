// SPDX-License-Identifier: MIT
// Where data are not smooth.
#pragma once

#include "fit/adaptive/fit_domain.h"
#include "fit/statistics/gather.h"

#include <vector>

namespace nrb::fit {

// Of data that a smooth fit over even spans misses here and there by more than the tolerance, and data of a curve in the order
// of their parameters: places between two data such that one polynomial is within the tolerance on the data of some spans
// before, and another one on those after. At a kink the place is where the two are nearest to each other, within the
// tolerance.
class BreakSearch {
public:
    // `distances` of the data from the fit.
    BreakSearch(const Data &sorted, std::vector<double> distances, int degree, double span, double tolerance);

    // Jumps are located with all data, of which the sorted ones are some.
    [[nodiscard]] std::vector<Break> breaks(const Data &all) const;

private:
    struct Cluster {
        int64_t first, last; // data
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
