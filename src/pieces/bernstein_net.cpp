// SPDX-License-Identifier: MIT
#include "pieces/bernstein_net.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "pieces/extraction.h"
#include "refine/knots/axis_table.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>

namespace nrb::pieces {

namespace {

constexpr int64_t work_of_a_record = 16; // for moving and measuring it

double length(const double *x, int n) noexcept {
    double largest = 0;
    for (int c = 0; c < n; ++c) {
        largest = std::max(largest, std::abs(x[c]));
    }
    return largest * std::sqrt(n); // an upper bound of the Euclidean norm
}

LayerTable elevation_rows(int low, int high, int64_t first_piece, int64_t end) {
    LayerTable table;
    table.reserve((end - first_piece) * (high + 1));
    for (int64_t e = first_piece; e < end; ++e) {
        count_work(int64_t{high + 1} * (high - low + 1));
        for (int i = 0; i <= high; ++i) {
            const int first = std::max(0, i - (high - low)), last = std::min(low, i);
            double row[max_degree + 1];
            for (int j = first; j <= last; ++j) {
                row[j - first] = elevation_coefficient(low, high, i, j);
            }
            table.add_row(e * (low + 1) + first, row, last - first + 1);
        }
    }
    return table;
}

// The Bezier points of all pieces along an axis, elevated to the degree `high`.
SplinePtr separated(const SplinePtr &net, int axis, const std::vector<double> &breaks, int high) {
    const int p = net->axis(axis).degree();
    const PieceRows source(net->axis(axis), breaks);
    SplinePtr pieces = refine::with_axis(
        *net, axis, refine::bezier_knots(p, breaks), p + 1,
        [&](int64_t first, int64_t end) { return source.rows(first / (p + 1), end / (p + 1)); });
    if (p == high) {
        return pieces;
    }
    return refine::with_axis(*pieces, axis, refine::bezier_knots(high, breaks), high + 1,
                             [=](int64_t first, int64_t end) {
                                 return elevation_rows(p, high, first / (high + 1), end / (high + 1));
                             });
}

// Replaces the layers of an axis by the maxima over the layers that are active on each piece.
std::vector<double> active_maxima(const std::vector<double> &sizes, const AxisView &view,
                                  const KnotVector &axis, const std::vector<double> &breaks) {
    const int64_t pieces = std::ssize(breaks) - 1;
    std::vector<double> result(static_cast<size_t>(view.outer * pieces * view.inner), 0.0);
    const std::vector<int64_t> first = first_layers(axis, breaks);
    for (int64_t e = 0; e < pieces; ++e) {
        count_work(2 * view.outer * view.inner * (axis.degree() + 1));
        const int64_t low = first[static_cast<size_t>(e)], high = low + axis.degree();
        for (int64_t o = 0; o < view.outer; ++o) {
            double *target = result.data() + (o * pieces + e) * view.inner;
            for (int64_t layer = low; layer <= high; ++layer) {
                const double *from = sizes.data() + (o * view.count + layer) * view.inner;
                std::transform(from, from + view.inner, target, target,
                               [](double a, double b) { return std::max(a, b); });
            }
        }
    }
    return result;
}

} // namespace

std::array<int, max_axes> degrees_of(const Spline &spline) noexcept {
    std::array<int, max_axes> degrees{};
    for (int k = 0; k < spline.axes(); ++k) {
        degrees[static_cast<size_t>(k)] = spline.axis(k).degree();
    }
    return degrees;
}

std::vector<double> centre_of(const Spline &given) {
    const Spline &spline = given.effective();
    const auto dim = static_cast<size_t>(spline.dim());
    std::vector<double> centre(dim);
    if (spline.form() == Form::homogeneous) {
        return centre;
    }
    for (size_t c = 0; c < dim; ++c) {
        double low = spline.points()[c], high = low;
        count_work(spline.point_count());
        for (size_t i = c; i < spline.points().size(); i += dim) {
            low = std::min(low, spline.points()[i]);
            high = std::max(high, spline.points()[i]);
        }
        centre[c] = low / 2 + high / 2;
    }
    return centre;
}

int weight_exponent(const Spline &given) {
    const Spline &spline = given.effective();
    double largest = 0;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        largest = std::max(largest, std::abs(spline.weight(i)));
    }
    return std::ilogb(largest) + 1;
}

CentredRecords centred_records(const Spline &given, const std::vector<double> &centre, bool weighted,
                               int exponent) {
    const Spline &spline = given.effective();
    const int dim = spline.dim(), stored = spline.stored_width();
    const double reach = length(centre.data(), dim);
    CentredRecords records{dim + (weighted ? 1 : 0), weighted, true, {}, {}};
    const int64_t count = spline.point_count();
    grow_watched(records.values, static_cast<size_t>(count * records.width));
    records.sizes.reserve(static_cast<size_t>(count));
    double *out = records.values.data();
    for (int64_t i = 0; i < count; ++i, out += records.width) {
        count_work(work_of_a_record);
        const double *point = spline.points().data() + i * stored;
        const double w = weighted ? std::ldexp(spline.weight(i), -exponent) : 1.0;
        if (spline.form() != Form::homogeneous) {
            for (int c = 0; c < dim; ++c) {
                out[c] = point[c] - centre[static_cast<size_t>(c)];
            }
            records.sizes.push_back(length(out, dim));
            std::for_each_n(out, dim, [w](double &x) { x *= w; });
        } else {
            const double size = std::ldexp(length(point, dim), -exponent);
            records.positive = records.positive && w > 0;
            records.sizes.push_back(w != 0 ? size / std::abs(w) + reach : reach);
            for (int c = 0; c < dim; ++c) {
                out[c] = std::ldexp(point[c], -exponent) - w * centre[static_cast<size_t>(c)];
            }
        }
        if (weighted) {
            out[dim] = w;
        }
    }
    return records;
}

BernsteinNet::BernsteinNet(const Spline &spline, const CentredRecords &records, const Breaks &breaks,
                           std::span<const int> degrees)
    : weighted_(records.weighted), positive_(records.positive) {
    SplinePtr net =
        std::make_shared<const Spline>(spline.knot_vectors(), records.width, Form::polynomial,
                                       copied_watched<double>(records.values), std::vector<double>());
    std::vector<double> sizes = records.sizes;
    AxisView view = axis_view(spline, 0, 1);
    double steps = 2;
    for (int k = 0; k < spline.axes(); ++k) {
        const KnotVector &axis = spline.axis(k);
        const auto at = static_cast<size_t>(k);
        const int p = axis.degree(), n = degrees[at];
        const auto padded = static_cast<size_t>(max_axes - spline.axes()) + at;
        shape_.degrees[padded] = n;
        counts_[padded] = std::ssize(breaks[at]) - 1;
        sizes = active_maxima(sizes, view, axis, breaks[at]);
        if (k + 1 < spline.axes()) {
            view = {view.outer * counts_[padded], spline.count(k + 1), view.inner / spline.count(k + 1)};
        }
        net = separated(net, k, breaks[at], n);
        steps += 4 * p + 2 + (n > p ? n + 4 : 0); // coefficients 3 p, sums (p + 2) / 2
    }
    shape_.width = records.width;
    net_ = std::move(net);
    sizes_ = std::move(sizes);
    error_ = steps * eps;
    const auto width = static_cast<size_t>(records.width);
    const int dim = spline.dim();
    largest_weight_ = weighted_ ? 0 : 1;
    for (size_t i = 0; i < records.values.size(); i += width) {
        largest_record_ = std::max(largest_record_, length(records.values.data() + i, dim));
        if (weighted_) {
            largest_weight_ = std::max(largest_weight_, std::abs(records.values[i + width - 1]));
        }
    }
    if (!positive_) { // a weighted centre was subtracted from records of any size
        largest_record_ += *std::max_element(sizes_.begin(), sizes_.end()) * largest_weight_;
    }
}

void BernsteinNet::copy(int64_t piece, double *coordinates, double *weights) const noexcept {
    std::array<int64_t, max_axes> first{};
    for (size_t k = counts_.size(); k-- > 0; piece /= counts_[k]) {
        first[k] = piece % counts_[k] * (shape_.degrees[k] + 1);
    }
    const int64_t rows = counts_[1] * (shape_.degrees[1] + 1), row = counts_[2] * (shape_.degrees[2] + 1);
    const int dim = shape_.width - (weighted_ ? 1 : 0);
    for (int i = 0; i <= shape_.degrees[0]; ++i) {
        for (int j = 0; j <= shape_.degrees[1]; ++j) {
            const double *from = net_->points().data() +
                                 (((first[0] + i) * rows + first[1] + j) * row + first[2]) * shape_.width;
            for (int k = 0; k <= shape_.degrees[2]; ++k, from += shape_.width, coordinates += dim) {
                std::copy_n(from, dim, coordinates);
                if (weighted_) {
                    *weights++ = from[dim];
                }
            }
        }
    }
}

} // namespace nrb::pieces
