#include "closest/patch/patch_pieces.h"

#include "numeric/norm.h"
#include "pieces/bernstein_net.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double infinite = std::numeric_limits<double>::infinity();

int64_t multiplicity(const KnotVector &axis, double t) noexcept {
    const auto knots = axis.knots();
    const auto [first, last] = std::equal_range(knots.begin(), knots.end(), t);
    return last - first;
}

// The middle of the box of the control points that have influence, but for those at infinity.
std::vector<double> middle_of(const Spline &given) {
    const Spline &spline = given.effective();
    std::vector<double> centre;
    for (int c = 0; c < spline.dim(); ++c) {
        double low = infinite, high = -infinite;
        for (int64_t i = 0; i < spline.point_count(); ++i) {
            const double x = spline.coordinate(i, c);
            if (spline.weight(i) != 0 && std::isfinite(x)) {
                low = std::min(low, x);
                high = std::max(high, x);
            }
        }
        centre.push_back(low <= high ? low / 2 + high / 2 : 0.0);
    }
    return centre;
}

int exponent_of(double x) noexcept {
    return x > 0 && std::isfinite(x) ? std::ilogb(x) : 0;
}

} // namespace

PatchPieces::PatchPieces(const Spline &spline) : axes_(spline.axes()), centre_(middle_of(spline)) {
    set_axes(spline);
    squares_ = std::make_unique<PatchSquares>(shape_);
    copy(spline);
}

void PatchPieces::set_axes(const Spline &spline) {
    shape_.dim = spline.dim();
    shape_.lanes = (spline.dim() + 1 + 3) / 4 * 4;
    shape_.weighted = spline.rational();
    int steps = 0;
    value_error_ = eps;
    for (int k = 0; k < axes_; ++k) {
        const KnotVector &axis = spline.axis(k);
        const auto at = static_cast<size_t>(k);
        breaks_[at] = refine::breaks_of(axis);
        periodic_[at] = axis.periodic();
        for (const double t : breaks_[at]) {
            jumps_[at].push_back(multiplicity(axis, t) > axis.degree() ? 1 : 0);
        }
        count_ *= count(k);
        steps += axis.degree() + 1;
        value_error_ += axis.degree() > 0 ? (2 * axis.degree() + 1) * eps : 0;
        if (axis.degree() > 0) {
            map_[static_cast<size_t>(shape_.axes)] = k;
            shape_.degrees[static_cast<size_t>(shape_.axes++)] = axis.degree();
        }
    }
    allowance_ = 64 * steps * eps;
}

void PatchPieces::copy(const Spline &spline) {
    const pieces::CentredRecords records = pieces::centred_records(
        spline, centre_, shape_.weighted, shape_.weighted ? pieces::weight_exponent(spline) : 0);
    std::array<int, max_axes> degrees{};
    for (int k = 0; k < axes_; ++k) {
        degrees[static_cast<size_t>(k)] = spline.axis(k).degree();
    }
    const pieces::BernsteinNet net(spline, records, breaks_, degrees);
    double largest = 0;
    for (const double size : records.sizes) {
        largest = std::max(largest, size);
    }
    const bool overflows =
        !std::isfinite(largest) && spline.form() != Form::homogeneous; // norms, no coordinates
    exponent_ = overflows ? std::numeric_limits<double>::max_exponent : exponent_of(largest);
    const auto count = static_cast<size_t>(shape_.coefficients()), dim = static_cast<size_t>(shape_.dim);
    const auto lanes = static_cast<size_t>(shape_.lanes);
    std::vector<double> points(count * dim), weights(net.weighted() ? count : 0);
    values_.assign(static_cast<size_t>(count_) * count * lanes, 0.0);
    double *out = values_.data();
    for (int64_t e = 0; e < count_; ++e) {
        net.copy(e, points.data(), weights.data());
        if (!weights.empty() && weights.front() < 0) { // of one sign they may be > 0 as well
            const auto negate = [](double &x) { x = -x; };
            std::for_each(points.begin(), points.end(), negate);
            std::for_each(weights.begin(), weights.end(), negate);
        }
        for (size_t i = 0; i < count; ++i, out += lanes) {
            for (size_t c = 0; c < dim; ++c) {
                out[c] = std::ldexp(points[i * dim + c], -exponent_);
            }
            out[dim] = weights.empty() ? 1.0 : weights[i];
        }
    }
    positive_ = net.positive();
    set_sizes(spline.effective(), records.sizes);
    if (positive_) { // |A - A*| <= error H w and |w - w*| <= error w
        moved_ = (net.weighted() ? 2.02 : 1.01) * net.error() * radius_;
    } else {
        record_error_ = net.error() * std::ldexp(net.largest_record(), -exponent_);
        weight_error_ = net.error() * net.largest_weight();
    }
}

// The radius is that of the control points, to whose magnitudes the net's errors are relative.
void PatchPieces::set_sizes(const Spline &spline, const std::vector<double> &sizes) {
    double smallest = infinite, largest = 0;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const double w = spline.weight(i);
        smallest = std::min(smallest, w > 0 ? w : infinite);
        largest = std::max(largest, std::abs(w));
        const double point = norm_of(spline.dim(), [&](int c) {
            return std::ldexp(spline.coordinate(i, c) - centre_[static_cast<size_t>(c)], -exponent_);
        });
        const double whole =
            norm_of(spline.dim(), [&](int c) { return std::ldexp(spline.coordinate(i, c), -exponent_); });
        if (w != 0 && std::isfinite(point) && std::isfinite(whole)) {
            radius_ = std::max(radius_, point * (1 + 8 * eps));
            size_ = std::max(size_, whole);
        }
    }
    if (!positive_) {
        radius_ = std::ldexp(*std::max_element(sizes.begin(), sizes.end()), -exponent_);
    }
    ratio_ = positive_ ? 1 : largest / smallest;
}

PatchPieces::Index PatchPieces::index(int64_t piece) const noexcept {
    Index result{};
    for (int k = axes_; k-- > 0; piece /= count(k)) {
        result[static_cast<size_t>(k)] = piece % count(k);
    }
    return result;
}

int64_t PatchPieces::piece(const Index &index) const noexcept {
    int64_t result = 0;
    for (int k = 0; k < axes_; ++k) {
        result = result * count(k) + index[static_cast<size_t>(k)];
    }
    return result;
}

int64_t PatchPieces::neighbour(int axis, int64_t i, bool up) const noexcept {
    const int64_t n = count(axis), next = up ? i + 1 : i - 1;
    const bool wraps = (next < 0 || next == n) && periodic(axis);
    if ((next < 0 || next == n) && !wraps) {
        return -1;
    }
    const bool jump = wraps ? jumps(axis, 0) || jumps(axis, n) : jumps(axis, std::max(i, next));
    return jump ? -1 : (next + n) % n;
}

int64_t PatchPieces::find(int axis, double t) const noexcept {
    const auto &breaks = breaks_[static_cast<size_t>(axis)];
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
    return above - breaks.begin() - 1;
}

void PatchPieces::place(const double *x, double *out) const noexcept {
    std::fill_n(out, shape_.lanes, 0.0);
    for (int c = 0; c < shape_.dim; ++c) {
        out[c] = std::ldexp(x[c], -exponent_) - std::ldexp(centre_[static_cast<size_t>(c)], -exponent_);
    }
}

double PatchPieces::scaled(double length) const noexcept {
    return std::ldexp(length, -exponent_);
}

double PatchPieces::unscaled(double length) const noexcept {
    return std::ldexp(length, exponent_);
}

double PatchPieces::magnitude(const double *x) const noexcept {
    return norm_of(shape_.dim, [&](int c) { return std::ldexp(x[c], -exponent_); });
}

} // namespace nrb::closest
