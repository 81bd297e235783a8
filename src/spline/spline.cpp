#include "spline/spline.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace nrb {

namespace {

// A common factor of the weights cancels. Weights that are all so small or so large that their products would
// leave double precision are brought near 1 by a power of two, which is exact.
int common_exponent(std::span<const double> weights) noexcept {
    constexpr int harmless = 256;
    const int exponent = std::ilogb(*std::max_element(weights.begin(), weights.end()));
    return std::abs(exponent) <= harmless ? 0 : exponent;
}

std::vector<double> homogeneous_records(std::span<const double> points, std::span<const double> weights,
                                        int dim) {
    const auto width = static_cast<size_t>(dim) + 1;
    const int exponent = common_exponent(weights);
    std::vector<double> records(weights.size() * width);
    for (size_t i = 0; i < weights.size(); ++i) {
        const double weight = std::ldexp(weights[i], -exponent);
        for (size_t c = 0; c + 1 < width; ++c) {
            records[i * width + c] = weight * points[i * (width - 1) + c];
        }
        records[i * width + width - 1] = weight;
    }
    return records;
}

} // namespace

Spline::Spline(Axes axes, int dim, Form form, std::vector<double> points,
               std::vector<double> weights) noexcept
    : axes_(std::move(axes)), dim_(dim), form_(form), points_(std::move(points)),
      weights_(std::move(weights)) {}

int64_t Spline::point_count() const noexcept {
    return std::accumulate(
        axes_.begin(), axes_.end(), int64_t{1},
        [](int64_t product, const KnotVectorPtr &axis) { return product * axis->count(); });
}

std::span<const double> Spline::records() const {
    if (form_ != Form::rational) {
        return points_;
    }
    return records_.get([this] { return homogeneous_records(points_, weights_, dim_); });
}

double Spline::weight(int64_t i) const noexcept {
    switch (form_) {
    case Form::polynomial:
        return 1;
    case Form::rational:
        return weights_[static_cast<size_t>(i)];
    case Form::homogeneous:
        break;
    }
    return points_[static_cast<size_t>(i * (dim_ + 1) + dim_)];
}

double Spline::coordinate(int64_t i, int c) const noexcept {
    const double stored = points_[static_cast<size_t>(i * stored_width() + c)];
    return form_ == Form::homogeneous ? stored / weight(i) : stored;
}

} // namespace nrb
