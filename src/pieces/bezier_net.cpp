// SPDX-License-Identifier: MIT
#include "pieces/bezier_net.h"

#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <limits>

namespace nrb::pieces {

namespace {

BernsteinNet::Breaks all_breaks(const Spline &spline, const BernsteinNet::Breaks &more) {
    BernsteinNet::Breaks breaks;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        std::vector<double> &ends = breaks[at];
        ends = refine::breaks_of(spline.axis(k));
        ends.insert(ends.end(), more[at].begin(), more[at].end());
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    }
    return breaks;
}

CentredRecords records_of(const Spline &spline, const std::vector<double> &centre) {
    return centred_records(spline, centre, spline.rational(),
                           spline.rational() ? weight_exponent(spline) : 0);
}

} // namespace

BezierNet::BezierNet(const Spline &spline, Frame frame, const BernsteinNet::Breaks &more)
    : frame_(std::move(frame)), breaks_(all_breaks(spline, more)),
      records_(records_of(spline, frame_.centre)), net_(spline, records_, breaks_, degrees_of(spline)),
      shape_(net_.shape()) {
    shape_.width = spline.dim() + 1;
    const auto count = static_cast<size_t>(shape_.coefficients());
    points_.resize(count * static_cast<size_t>(spline.dim()));
    weights_.assign(count, 1.0);
}

std::array<Interval, max_axes> BezierNet::part(int64_t piece) const noexcept {
    std::array<Interval, max_axes> result{};
    for (size_t k = breaks_.size(); k-- > 0;) {
        const std::vector<double> &ends = breaks_[k];
        if (!ends.empty()) {
            const auto n = std::ssize(ends) - 1, at = piece % n;
            result[k] = {ends[static_cast<size_t>(at)], ends[static_cast<size_t>(at) + 1]};
            piece /= n;
        }
    }
    return result;
}

void BezierNet::copy(int64_t piece, double *out, int64_t stride) {
    const int dim = shape_.width - 1;
    net_.copy(piece, points_.data(), weighted() ? weights_.data() : nullptr);
    const double *point = points_.data();
    for (const double weight : weights_) {
        for (int c = 0; c < dim; ++c) {
            out[c] = frame_.scaled(*point++);
        }
        out[dim] = weight;
        out += stride;
    }
}

Rounding BezierNet::absolute() const noexcept {
    return {0, error() * frame_.scaled(net_.largest_record()), error() * net_.largest_weight()};
}

// From |A - A*| <= error H w and |w - w*| <= error w, where H is the size.
Rounding BezierNet::rounding(int64_t piece, double more) const noexcept {
    const double apart = 1.01 * (2 * error() + more) * frame_.scaled(size(piece));
    return positive() ? Rounding{apart, 0, 0} : absolute();
}

Rounding BezierNet::rounding_of_all(double radius) const noexcept {
    return positive() ? Rounding{(weighted() ? 2.02 : 1.01) * error() * radius, 0, 0} : absolute();
}

} // namespace nrb::pieces
