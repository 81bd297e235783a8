// SPDX-License-Identifier: MIT
#include "measure/elements.h"

#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"
#include "refine/knots/extraction.h"
#include "spline/contract.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::measure {

pieces::Frame integral_frame(std::span<const Spline *const> splines) {
    pieces::Frame frame = pieces::frame_of(splines);
    frame.exponent = std::max(frame.exponent, -1000);
    return frame;
}

namespace {

// For curves of low degree, whose rows take longer to loop over than to compute.
template <int kSize>
void contract_rows(const double *in, int64_t outer, const double *matrix, double *out) noexcept {
    for (int64_t o = 0; o < outer; ++o, in += kSize, out += kSize) {
        double sums[kSize] = {};
        for (int j = 0; j < kSize; ++j) {
            for (int k = 0; k < kSize; ++k) {
                sums[k] += matrix[j * kSize + k] * in[j];
            }
        }
        std::copy_n(sums, kSize, out);
    }
}

} // namespace

void contract(const double *in, int64_t outer, int terms, int64_t inner, const double *matrix, int stride,
              int count, double *out) noexcept {
    if (inner == 1 && terms == 4 && count == 4 && stride == 4) {
        return contract_rows<4>(in, outer, matrix, out);
    }
    for (int64_t o = 0; o < outer; ++o, in += terms * inner) {
        if (inner == 1) {
            spline::contract(in, terms, matrix, stride, count, out);
            out += count;
            continue;
        }
        for (int k = 0; k < count; ++k, out += inner) {
            double column[max_product_degree + 1];
            for (int j = 0; j < terms; ++j) {
                column[j] = matrix[j * stride + k];
            }
            spline::contract(column, terms, in, inner, inner, out);
        }
    }
}

Elements::Elements(const Spline &spline, const pieces::Frame &frame, const Part &part)
    : spline_(spline.effective()), frame_(frame), scale_(std::ldexp(1.0, -frame.exponent)) {
    for (int k = 0; k < spline.axes(); ++k) {
        const KnotVector &axis = spline.axis(k);
        const auto at = static_cast<size_t>(k);
        coefficients_ *= axis.degree() + 1;
        const auto spans = static_cast<size_t>(axis.count() - axis.degree());
        axes_[at].matrices.reserve(spans * static_cast<size_t>((axis.degree() + 1) * (axis.degree() + 1)));
        axes_[at].firsts.reserve(spans);
        axes_[at].intervals.reserve(spans);
        for (int64_t span = axis.degree(); span < axis.count(); ++span) {
            if (axis[span] < axis[span + 1] && axis[span] < part[at].upper &&
                axis[span + 1] > part[at].lower) {
                add_span(axes_[at], axis, span, part[at]);
            }
        }
    }
}

void Elements::add_span(AxisElements &elements, const KnotVector &axis, int64_t span, Interval range) {
    const int n = axis.degree() + 1;
    count_work(8 * n * n * n);
    const size_t start = elements.matrices.size();
    elements.matrices.resize(start + static_cast<size_t>(n * n));
    double *matrix = elements.matrices.data() + start;
    refine::bezier_extraction(axis.knots().data(), axis.degree(), span, matrix);
    const double length = axis[span + 1] - axis[span];
    const Interval part{std::max(range.lower, axis[span]), std::min(range.upper, axis[span + 1])};
    const double lower = (part.lower - axis[span]) / length, upper = (part.upper - axis[span]) / length;
    for (int j = 0; j < n; ++j) {
        restrict_to(axis.degree(), lower, upper, matrix + j * n);
    }
    elements.firsts.push_back(span - axis.degree());
    elements.intervals.push_back(part);
}

int64_t Elements::size() const noexcept {
    int64_t total = 1;
    for (int k = 0; k < axes(); ++k) {
        total *= std::ssize(axes_[static_cast<size_t>(k)].firsts);
    }
    return total;
}

std::array<size_t, max_axes> Elements::places(int64_t element) const noexcept {
    std::array<size_t, max_axes> at{};
    for (auto k = static_cast<size_t>(axes()); k-- > 0;) {
        const int64_t n = std::ssize(axes_[k].firsts);
        at[k] = static_cast<size_t>(element % n);
        element /= n;
    }
    return at;
}

Interval Elements::interval(int64_t element, int axis) const noexcept {
    const auto k = static_cast<size_t>(axis);
    return axes_[k].intervals[places(element)[k]];
}

// Calls visit(index of the control point, its position among the active ones).
template <class Visit>
void Elements::for_each_active(const std::array<int64_t, max_axes> &first, Visit &&visit) const {
    std::array<int64_t, max_axes> counts{1, 1, 1}, active{1, 1, 1};
    for (int k = 0; k < axes(); ++k) {
        counts[static_cast<size_t>(k)] = spline_.count(k);
        active[static_cast<size_t>(k)] = degree(k) + 1;
    }
    int64_t at = 0;
    for (int64_t i = 0; i < active[0]; ++i) {
        for (int64_t j = 0; j < active[1]; ++j) {
            for (int64_t k = 0; k < active[2]; ++k) {
                visit(((first[0] + i) * counts[1] + first[1] + j) * counts[2] + first[2] + k, at++);
            }
        }
    }
}

int64_t Elements::origin_point(const std::array<int64_t, max_axes> &first) const noexcept {
    int64_t best = -1;
    double most = 0;
    for_each_active(first, [&](int64_t index, int64_t) {
        const double w = std::abs(spline_.weight(index));
        if (w > most) {
            most = w;
            best = index;
        }
    });
    return best;
}

void Elements::add_point(int64_t index, int64_t at, Element &out) const {
    const int dim = this->dim();
    const double *point = spline_.points().data() + index * spline_.stored_width();
    const double w = rational() ? out.net[static_cast<size_t>(dim * coefficients_ + at)] : 1;
    const double scale = scale_;
    double largest = 0;
    for (int c = 0; c < dim; ++c) {
        double &x = out.net[static_cast<size_t>(c * coefficients_ + at)];
        const double from = out.origin[static_cast<size_t>(c)];
        if (spline_.form() == Form::homogeneous) {
            const double factor = spline_.weight(index) != 0 ? w / spline_.weight(index) : out.weight_scale;
            x = point[c] * scale * factor - w * from * scale;
            largest = std::max(largest, w != 0 ? std::abs(x / w) : 0.0);
        } else {
            x = point[c] * scale - from * scale;
            largest = w != 0 ? std::max(largest, std::abs(x)) : largest;
            x *= w;
        }
    }
    out.spread = std::max(out.spread, largest);
}

void Elements::gather(const std::array<int64_t, max_axes> &first, Element &out) const {
    const int64_t origin = origin_point(first);
    out.weight_scale = origin < 0 ? 1 : std::ldexp(1.0, -std::ilogb(spline_.weight(origin)));
    for (int c = 0; c < dim(); ++c) {
        out.origin[static_cast<size_t>(c)] =
            origin < 0 ? frame_.centre[static_cast<size_t>(c)] : spline_.coordinate(origin, c);
    }
    out.spread = 0;
    for_each_active(first, [&](int64_t index, int64_t at) {
        if (rational()) {
            out.net[static_cast<size_t>(dim() * coefficients_ + at)] =
                spline_.weight(index) * out.weight_scale;
        }
        add_point(index, at, out);
    });
}

void Elements::load(int64_t element, Element &out) const {
    const std::array<size_t, max_axes> at = places(element);
    std::array<int64_t, max_axes> first{};
    for (size_t k = 0; k < static_cast<size_t>(axes()); ++k) {
        first[k] = axes_[k].firsts[at[k]];
    }
    out.net.resize(static_cast<size_t>(width() * coefficients_));
    out.work.resize(out.net.size());
    out.origin.resize(static_cast<size_t>(dim()));
    gather(first, out);
    int64_t inner = coefficients_, outer = width();
    for (int k = 0; k < axes(); ++k) {
        const int n = degree(k) + 1;
        inner /= n;
        const double *matrix = axes_[static_cast<size_t>(k)].matrices.data() +
                               at[static_cast<size_t>(k)] * static_cast<size_t>(n * n);
        contract(out.net.data(), outer, n, inner, matrix, n, n, out.work.data());
        std::swap(out.net, out.work);
        outer *= n;
    }
    const double scale = scale_;
    for (int c = 0; c < dim(); ++c) {
        double &x = out.origin[static_cast<size_t>(c)];
        x = x * scale - frame_.centre[static_cast<size_t>(c)] * scale;
    }
}

} // namespace nrb::measure
