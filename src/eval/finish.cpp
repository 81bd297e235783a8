#include "eval/finish.h"

#include <algorithm>

namespace nrb {

namespace {

int64_t record_size(const Spline &spline, int order) noexcept {
    return slot_count(spline.axes(), order) * spline.dim();
}

} // namespace

size_t Finisher::scratch_size(const Spline &spline, int order) noexcept {
    return static_cast<size_t>(record_size(spline, order)) + QuotientRule::scratch_size(order);
}

Finisher::Finisher(const Spline &spline, int order, Scratch &scratch) noexcept
    : spline_(spline), values_(record_size(spline, order)),
      cartesian_(scratch.take(static_cast<size_t>(values_))) {
    if (spline.rational()) {
        quotient_.emplace(spline.axes(), spline.dim(), order, scratch);
    }
}

// Index of the control point that is alone at the parameter, or -1.
int64_t Finisher::sole_point(const Bases &bases) const noexcept {
    int64_t index = 0;
    for (int k = 0; k < spline_.axes(); ++k) {
        const AxisBasis &basis = bases[static_cast<size_t>(k)];
        if (basis.sole < 0) {
            return -1;
        }
        index = index * spline_.count(k) + basis.first + basis.sole;
    }
    return index;
}

void Finisher::write(const double *contracted, const Bases &bases, Records out, int64_t i) const noexcept {
    const double *values = contracted;
    if (quotient_) {
        (*quotient_)(contracted, cartesian_);
        values = cartesian_;
    }
    double *record = out.record(i);
    for (int64_t c = 0; c < values_; ++c) {
        record[c * out.component_stride] = values[c];
    }
    const int64_t sole = sole_point(bases);
    if (sole >= 0) {
        for (int c = 0; c < spline_.dim(); ++c) {
            record[c * out.component_stride] = spline_.coordinate(sole, c);
        }
    }
}

void Finisher::write_nan(Records out, int64_t i) const noexcept {
    for (int64_t c = 0; c < values_; ++c) {
        out(i, c) = std::numeric_limits<double>::quiet_NaN();
    }
}

} // namespace nrb
