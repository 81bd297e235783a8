// SPDX-License-Identifier: MIT
#include "eval/functions/basis_gradients.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/active_points.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::eval {

namespace {

// The QR factorisation of the Jacobian of a spline: an orthonormal basis of the space that its columns (the
// derivatives, [axes][dim]) span, and the components of each column in this basis. By the Gram-Schmidt method
// with one reorthogonalisation ("twice is enough", L. Giraud, J. Langou, M. Rozloznik, 2005).
class Tangents {
public:
    Tangents(int axes, int dim)
        : axes_(static_cast<size_t>(axes)), dim_(static_cast<size_t>(dim)), across_(axes_ * dim_) {}

    // Factorises the derivatives. Returns false if they are linearly dependent up to rounding. noise: a bound
    // of the rounding error of each derivative.
    bool set(const std::vector<double> &derivatives, const std::array<double, max_axes> &noise) noexcept {
        across_ = derivatives;
        parts_ = {};
        for (size_t k = 0; k < axes_; ++k) {
            double *own = across_.data() + k * dim_;
            const double size = length(own);
            if (!(size > 0) || !std::isfinite(size)) {
                return false;
            }
            sizes_[k] = size;
            std::for_each(own, own + dim_, [size](double &x) { x /= size; });
            for (int pass = 0; pass < 2; ++pass) {
                take_off(k, own);
            }
            const double rest = length(own);
            if (!(rest * size > noise[k])) {
                return false;
            }
            parts_[k][k] = rest;
            std::for_each(own, own + dim_, [rest](double &x) { x /= rest; });
        }
        return true;
    }

    // Passes the components of the vector in the span of the derivatives whose scalar product with derivative
    // k is slopes[k] to put(c, x).
    template <class Put>
    void gradient(std::array<double, max_axes> slopes, Put &&put) const noexcept {
        for (size_t k = 0; k < axes_; ++k) {
            slopes[k] /= sizes_[k];
            for (size_t j = 0; j < k; ++j) {
                slopes[k] -= parts_[k][j] * slopes[j];
            }
            slopes[k] /= parts_[k][k];
        }
        for (size_t c = 0; c < dim_; ++c) {
            double sum = 0;
            for (size_t k = 0; k < axes_; ++k) {
                sum += slopes[k] * across_[k * dim_ + c];
            }
            put(c, sum);
        }
    }

private:
    [[nodiscard]] double length(const double *x) const noexcept { return norm(x, static_cast<int>(dim_)); }
    // Subtracts the projections of `own` onto the basis vectors before k, and adds their lengths to row k of
    // the components.
    void take_off(size_t k, double *own) noexcept {
        for (size_t j = 0; j < k; ++j) {
            const double *other = across_.data() + j * dim_;
            double product = 0;
            for (size_t c = 0; c < dim_; ++c) {
                product += own[c] * other[c];
            }
            parts_[k][j] += product;
            for (size_t c = 0; c < dim_; ++c) {
                own[c] -= product * other[c];
            }
        }
    }

    size_t axes_, dim_;
    std::vector<double> across_;
    std::array<double, max_axes> sizes_{};
    std::array<std::array<double, max_axes>, max_axes> parts_{}; // R transposed, for columns of length 1
};

// Computes the gradients at one parameter after the other, with memory that is allocated once.
class GradientBatch {
public:
    GradientBatch(const Spline &spline, const AxisRules &rules)
        : spline_(spline), axes_(static_cast<size_t>(spline.axes())), dim_(static_cast<size_t>(spline.dim())),
          active_(spline.knot_vectors(), rules, highest(spline.axes())),
          tangents_(spline.axes(), spline.dim()), slopes_(axes_ * static_cast<size_t>(active_.size())),
          slope_noise_(slopes_.size()), points_(static_cast<size_t>(active_.size())), values_(points_.size()),
          derivatives_(axes_ * dim_) {}

    // The work of one parameter, in multiply-adds.
    [[nodiscard]] int64_t work() const noexcept {
        return active_.size() * static_cast<int64_t>(8 * axes_ * dim_);
    }

    void evaluate(const ConstRecords &params, int64_t i, int64_t *spans, const Records &out) {
        const bool valid = active_.locate(params, i);
        for (size_t k = 0; k < axes_ && spans != nullptr; ++k) {
            spans[k] = valid ? active_.span(k) : -1;
        }
        if (!valid || !set_slopes() || !tangents_.set(derivatives_, noise_)) {
            for (int64_t c = 0; c < out.width; ++c) {
                out(i, c) = nan_value;
            }
            return;
        }
        for (size_t j = 0; j < points_.size(); ++j) {
            std::array<double, max_axes> own{};
            for (size_t k = 0; k < axes_; ++k) {
                own[k] = spline_.weight(points_[j]) * slope(k, j);
            }
            tangents_.gradient(own,
                               [&](size_t c, double x) { out(i, static_cast<int64_t>(j * dim_ + c)) = x; });
        }
    }

private:
    static Orders highest(int axes) noexcept {
        Orders orders{};
        std::fill_n(orders.begin(), axes, 1);
        return orders;
    }
    [[nodiscard]] double &slope(size_t k, size_t j) noexcept { return slopes_[k * points_.size() + j]; }
    [[nodiscard]] double &slope_noise(size_t k, size_t j) noexcept {
        return slope_noise_[k * points_.size() + j];
    }

    // Computes the slopes (N_j,k - N_j w,k / w) / w of all active functions j along all axes k, and the
    // derivatives of the spline. The products of the slopes with the weights w_j sum to 0 over j. So the
    // derivatives can be summed over the differences of control points from one of them, and the position of
    // the spline does not enter their rounding errors. Returns false if w is not finite.
    bool set_slopes() noexcept {
        double weight = 0, size = 0; // the sum of N_j w_j, and that of the magnitudes
        size_t j = 0;
        active_.for_each([&](int64_t point, double value) {
            points_[j] = point;
            values_[j++] = value;
            weight += value * spline_.weight(point);
            size += std::abs(value) * std::abs(spline_.weight(point));
        });
        weight = spline_.rational() ? weight : 1;
        for (size_t k = 0; k < axes_; ++k) {
            set_slopes(k, weight, size);
        }
        set_derivatives();
        return std::isfinite(weight);
    }
    void set_slopes(size_t k, double weight, double size) noexcept {
        Orders orders{};
        orders[k] = 1;
        double change = 0, change_noise = 0;
        size_t j = 0;
        set_terms(k);
        active_.for_each(orders, [&](int64_t point, double value) {
            slope_noise(k, j) = terms(k, j);
            change_noise += slope_noise(k, j) * std::abs(spline_.weight(point));
            slope(k, j++) = value;
            change += value * spline_.weight(point);
        });
        const double rate = spline_.rational() ? change / weight : 0;
        const double rate_noise =
            spline_.rational() ? (change_noise + std::abs(rate) * size) / std::abs(weight) : 0;
        for (j = 0; j < points_.size(); ++j) {
            slope(k, j) = (slope(k, j) - values_[j] * rate) / weight;
            slope_noise(k, j) =
                64 * eps * ((slope_noise(k, j) + std::abs(values_[j]) * rate_noise) / std::abs(weight));
        }
    }
    // The derivative of a basis function of axis k is the difference N'_i = c_i - c_(i+1) of two functions of
    // the lower degree, times their factors. It has an error of a few eps of c_i + c_(i+1), which neighbouring
    // derivatives give: c_(i+1) is minus the sum of N'_0, ..., N'_i.
    void set_terms(size_t k) noexcept {
        const double *derivatives = active_.functions(k, 1);
        double before = 0;
        for (int i = 0; i <= active_.degree(k); ++i) {
            const double after = before - derivatives[i];
            terms_[static_cast<size_t>(i)] = std::abs(before) + std::abs(after) + std::abs(derivatives[i]);
            before = after;
        }
    }
    // The same for the product over the axes that belongs to active point j.
    [[nodiscard]] double terms(size_t k, size_t j) const noexcept {
        double product = 1;
        for (size_t m = axes_; m-- > 0;) {
            const auto functions = static_cast<size_t>(active_.degree(m)) + 1, i = j % functions;
            product *= m == k ? terms_[i] : std::abs(active_.functions(m, 0)[i]);
            j /= functions;
        }
        return product;
    }
    void set_derivatives() noexcept {
        const auto first = std::ranges::find_if(points_, [&](int64_t i) { return spline_.weight(i) > 0; });
        std::ranges::fill(derivatives_, 0);
        noise_ = {};
        for (size_t c = 0; c < dim_; ++c) {
            const double origin =
                first == points_.end() ? 0 : spline_.coordinate(*first, static_cast<int>(c));
            for (size_t j = 0; j < points_.size(); ++j) {
                const double away = difference(points_[j], static_cast<int>(c), origin);
                for (size_t k = 0; k < axes_; ++k) {
                    derivatives_[k * dim_ + c] += slope(k, j) * away;
                    noise_[k] += slope_noise(k, j) * std::abs(away);
                }
            }
        }
    }
    // w (x - origin); for a control point at infinity, w x as stored.
    [[nodiscard]] double difference(int64_t point, int c, double origin) const noexcept {
        const double weight = spline_.weight(point);
        if (spline_.form() == Form::homogeneous && weight == 0) {
            return spline_.points()[static_cast<size_t>(point * (spline_.dim() + 1) + c)];
        }
        return weight * (spline_.coordinate(point, c) - origin);
    }

    const Spline &spline_;
    size_t axes_, dim_;
    ActivePoints active_;
    Tangents tangents_;
    std::vector<double> slopes_, slope_noise_; // [axes][active points]; bounds of their errors
    std::vector<int64_t> points_;
    std::vector<double> values_, derivatives_; // derivatives_: [axes][dim]
    std::array<double, max_basis> terms_{};
    std::array<double, max_axes> noise_{}; // bounds of the errors of derivatives
};

} // namespace

void basis_gradients(const Spline &spline, const AxisRules &rules, ConstRecords params, int64_t *spans,
                     Records gradients) {
    GradientBatch batch(spline, rules);
    for (int64_t i = 0; i < params.count; ++i) {
        batch.evaluate(params, i, spans == nullptr ? nullptr : spans + i * spline.axes(), gradients);
        count_work(batch.work());
    }
}

} // namespace nrb::eval
