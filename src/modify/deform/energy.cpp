// SPDX-License-Identifier: MIT
#include "modify/deform/energy.h"

#include "base/watch.h"
#include "modify/edit/net_editor.h"
#include "numeric/binomial.h"
#include "refine/knots/extraction.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace nrb::modify {

namespace {

// A banded matrix over the layers of an axis: entry (i, i + d) at [i][d + degree].
struct AxisMatrix {
    int degree;
    std::vector<double> values;

    explicit AxisMatrix(const KnotVector &axis)
        : degree(axis.degree()), values(static_cast<size_t>(axis.count() * (2 * degree + 1)), 0.0) {}
    [[nodiscard]] double &at(int64_t i, int64_t j) noexcept {
        return values[static_cast<size_t>(i * (2 * degree + 1) + j - i + degree)];
    }
    [[nodiscard]] double value(int64_t i, int64_t j) const noexcept {
        return values[static_cast<size_t>(i * (2 * degree + 1) + j - i + degree)];
    }
};

// The integrals of B_i B_j of degree m over an interval of length 1: [m + 1][m + 1].
std::vector<double> product_integrals(int m) {
    std::vector<double> integrals;
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= m; ++j) {
            integrals.push_back(binomial(m, i) * binomial(m, j) / (binomial(2 * m, i + j) * (2 * m + 1)));
        }
    }
    return integrals;
}

// Replaces the Bernstein coefficients of a polynomial on a span of a length by those of a derivative.
void differentiate(double *coefficients, int degree, int order, double length) noexcept {
    for (int r = 0; r < order; ++r, --degree) {
        for (int k = 0; k < degree; ++k) {
            coefficients[k] = degree * (coefficients[k + 1] - coefficients[k]) / length;
        }
    }
}

// The integrals of products of the functions of a span. `functions` holds their Bernstein coefficients,
// [degree + 1][degree + 1], of which the first m + 1 of a row count.
class SpanProducts {
public:
    explicit SpanProducts(int degree, int m)
        : width_(degree + 1), size_(m + 1), integrals_(product_integrals(m)),
          rows_(static_cast<size_t>(width_ * size_)) {}

    // Takes the functions, and multiplies them by the matrix of integrals.
    void set(const double *functions) {
        functions_ = functions;
        for (int j = 0; j < width_; ++j) {
            for (int k = 0; k < size_; ++k) {
                rows_[static_cast<size_t>(j * size_ + k)] =
                    dot(functions + int64_t{j} * width_, integrals_.data() + int64_t{k} * size_);
            }
        }
    }
    [[nodiscard]] double operator()(int i, int j) const noexcept {
        return dot(functions_ + int64_t{i} * width_, rows_.data() + int64_t{j} * size_);
    }

private:
    double dot(const double *a, const double *b) const noexcept {
        return std::inner_product(a, a + size_, b, 0.0);
    }

    int width_;
    int size_;
    std::vector<double> integrals_;
    std::vector<double> rows_;
    const double *functions_ = nullptr;
};

// The integrals of products of derivatives of the basis functions of one axis.
AxisMatrix axis_matrix(const KnotVector &axis, int order) {
    AxisMatrix matrix(axis);
    const int p = axis.degree(), width = p + 1;
    if (order > p) {
        return matrix;
    }
    std::vector<double> functions(static_cast<size_t>(width * width));
    SpanProducts products(p, p - order);
    for (const int64_t span : axis.spans().indices()) {
        const double length = axis[span + 1] - axis[span];
        count_work(int64_t{3} * width * width * width);
        refine::bezier_extraction(axis.knots().data(), p, span, functions.data());
        for (int i = 0; i <= p; ++i) {
            differentiate(functions.data() + int64_t{i} * width, p, order, length);
        }
        products.set(functions.data());
        for (int i = 0; i <= p; ++i) {
            for (int j = 0; j <= p; ++j) {
                matrix.at(span - p + i, span - p + j) += length * products(i, j);
            }
        }
    }
    return matrix;
}

// The layers of an axis whose functions overlap that of a layer.
struct Band {
    int64_t first;
    int64_t end;
};
Band band_of(const KnotVector &axis, int64_t layer) noexcept {
    return {std::max<int64_t>(0, layer - axis.degree()), std::min(axis.count(), layer + axis.degree() + 1)};
}

using Place = std::array<int64_t, max_axes>;

Place place_of(const Spline &spline, int64_t point) noexcept {
    Place place{};
    for (int k = spline.axes(); k-- > 0;) {
        place[static_cast<size_t>(k)] = point % spline.count(k);
        point /= spline.count(k);
    }
    return place;
}

class Assembly {
public:
    Assembly(const Spline &spline, int order) : spline_(spline) {
        for (int k = 0; k < spline.axes(); ++k) {
            masses_.push_back(axis_matrix(spline.axis(k), 0));
            bends_.push_back(axis_matrix(spline.axis(k), order));
        }
    }

    std::vector<Entry> entries() {
        const Phase phase(0.1);
        int64_t count = 1;
        for (int k = 0; k < spline_.axes(); ++k) {
            count *= entries_of_axis(spline_.axis(k));
        }
        entries_.reserve(static_cast<size_t>(count));
        Steps steps(spline_.point_count());
        for (int64_t i = 0; i < spline_.point_count();
             ++i, steps.next(work_of_an_entry * entries_of_a_row())) {
            add_row(0, i, place_of(spline_, i), 0, Factors{});
        }
        return std::move(entries_);
    }

private:
    static constexpr int64_t work_of_an_entry = 8;

    [[nodiscard]] int64_t entries_of_a_row() const noexcept {
        int64_t entries = 1;
        for (int k = 0; k < spline_.axes(); ++k) {
            entries *= 2 * spline_.axis(k).degree() + 1;
        }
        return entries;
    }

    [[nodiscard]] static int64_t entries_of_axis(const KnotVector &axis) noexcept {
        int64_t entries = 0;
        for (int64_t layer = 0; layer < axis.count(); ++layer) {
            const Band band = band_of(axis, layer);
            entries += band.end - band.first;
        }
        return entries;
    }

    // Products of entries of the axes so far: that of the masses (integrals of products of functions), and
    // the sum of those in which one factor is an integral of derivatives instead.
    struct Factors {
        double mass = 1;
        double bend = 0;
    };

    void add_row(int k, int64_t row, const Place &place, int64_t column, const Factors &factors) {
        if (k == spline_.axes()) {
            entries_.push_back({original_of(spline_, row), original_of(spline_, column), factors.bend});
            return;
        }
        const auto at = static_cast<size_t>(k);
        const Band band = band_of(spline_.axis(k), place[at]);
        for (int64_t j = band.first; j < band.end; ++j) {
            const double mass = masses_[at].value(place[at], j), bend = bends_[at].value(place[at], j);
            add_row(k + 1, row, place, column * spline_.count(k) + j,
                    {factors.mass * mass, factors.mass * bend + factors.bend * mass});
        }
    }

    const Spline &spline_;
    std::vector<AxisMatrix> masses_;
    std::vector<AxisMatrix> bends_;
    std::vector<Entry> entries_;
};

} // namespace

std::vector<Entry> energy_entries(const Spline &spline, int order) {
    return Assembly(spline, order).entries();
}

} // namespace nrb::modify
