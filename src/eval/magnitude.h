// Models and knots so large or so small that products of derivatives leave the range of double precision: they
// are brought near 1 by powers of two, which changes no bit of what is then computed.
#pragma once

#include "eval/parameters.h"
#include "spline/scaled.h"

#include <functional>
#include <vector>

namespace nrb {

// Whether the largest number of control points that are active together is 0 or within 2^-64 and 2^64 everywhere, and
// every span too; found once for a spline, by reading all of it. Preconditions of all: 1 or 2 axes.
bool usual_magnitude(const Spline &spline);

// Parameters that follow each other and where the same powers of two make the numbers that are active usual, with what
// to evaluate in place of them: the spline itself at these parameters, or a copy. Where one copy serves the whole spline
// it is kept with it.
struct MagnitudeRun {
    const Spline &spline;
    const AxisRules &rules;
    ConstRecords params;
    int64_t first;
    int size; // the exponent of the factor by which the copy is larger
};
void for_each_magnitude(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const std::function<void(const MagnitudeRun &)> &body);

// The largest |coordinate| of a control point that has influence on the domain; found with it.
double active_size(const Spline &spline);

// Values that are written to an output when nothing can fail any more.
class Pending {
public:
    explicit Pending(const Records &out);
    // Those of the records from `first` on; not wanted if the output is not.
    [[nodiscard]] Records part(int64_t first, int64_t count) noexcept;
    void multiply(int64_t first, int64_t count, int exponent) noexcept; // by a power of two
    void write() const noexcept;

private:
    Records out_;
    std::vector<double> values_;
};

} // namespace nrb
