// SPDX-License-Identifier: MIT
#include "base/numbers.h"
#include "bounds/box.h"

#include "numeric/norm.h"
#include "numeric/solvers/principal_axes.h"
#include "refine/forms/homogeneous.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::bounds {

namespace {

// axes . (x - centre) of every point x lies in [lower, upper].
struct Extents {
    std::vector<double> lower;
    std::vector<double> upper;
};

Extents extents(const pieces::SplinePieces &pieces, const std::vector<double> &axes, double tolerance) {
    const size_t dim = pieces.centre().size();
    Extents found;
    std::vector<double> direction(dim);
    const auto largest = [&](double sign, size_t row) {
        std::transform(axes.begin() + static_cast<std::ptrdiff_t>(row * dim),
                       axes.begin() + static_cast<std::ptrdiff_t>((row + 1) * dim), direction.begin(),
                       [sign](double x) { return sign * x; });
        const pieces::PieceSource source = [&](int64_t i, pieces::QuotientPiece &out) {
            pieces.fill(i, direction.data(), out);
        };
        return pieces::largest_value(pieces.count(), source, tolerance, pieces::default_budget).bounds.upper;
    };
    for (size_t r = 0; r < dim; ++r) {
        found.lower.push_back(-largest(-1, r));
        found.upper.push_back(largest(1, r));
    }
    return found;
}

// The largest entry of A A^T - 1, including its own rounding.
double skewness(const std::vector<double> &axes, size_t dim) {
    double largest = 0;
    for (size_t i = 0; i < dim; ++i) {
        for (size_t j = 0; j < dim; ++j) {
            const double product = std::inner_product(axes.data() + i * dim, axes.data() + (i + 1) * dim,
                                                      axes.data() + j * dim, i == j ? -1.0 : 0.0);
            largest = std::max(largest, std::abs(product));
        }
    }
    return largest + static_cast<double>(dim + 2) * eps;
}

// The box about the middle m of the extents. With A A^T = 1 + E, x - c = A^T z gives A (x - c) = (1 + E) z.
// So z - m lies in [-half, half], apart from E z and the rounding of c + A^T m.
OrientedBox box_of(const pieces::SplinePieces &pieces, std::vector<double> axes, const Extents &found) {
    const size_t dim = pieces.centre().size();
    OrientedBox box{pieces.centre(), std::move(axes), {}};
    double reach = 0;
    std::vector<double> middle(dim);
    for (size_t r = 0; r < dim; ++r) {
        middle[r] = found.lower[r] / 2 + found.upper[r] / 2;
        reach += std::max(std::abs(found.lower[r]), std::abs(found.upper[r]));
    }
    for (size_t c = 0; c < dim; ++c) {
        for (size_t r = 0; r < dim; ++r) {
            box.center[c] += middle[r] * box.axes[r * dim + c];
        }
    }
    const double n = static_cast<double>(dim);
    const double pad = 1.1 * skewness(box.axes, dim) * reach * n +
                       eps * (n + 2) *
                           (n * reach + norm(box.center.data(), static_cast<int>(dim)) +
                            norm(pieces.centre().data(), static_cast<int>(dim)));
    for (size_t r = 0; r < dim; ++r) {
        box.half.push_back((found.upper[r] / 2 - found.lower[r] / 2) * (1 + 2 * eps) + pad);
    }
    return box;
}

// The binary logarithm of the volume. A side shorter than rounding counts as of that length, so that boxes of
// flat shapes are compared by their other sides.
double content(const Extents &found) {
    double longest = 0, product = 0;
    for (size_t r = 0; r < found.lower.size(); ++r) {
        longest = std::max(longest, found.upper[r] - found.lower[r]);
    }
    for (size_t r = 0; r < found.lower.size() && longest > 0; ++r) {
        const double side = found.upper[r] - found.lower[r];
        product += std::log2(std::max(side / longest, 256 * eps));
    }
    return product + static_cast<double>(found.lower.size()) * std::log2(longest);
}

} // namespace

OrientedBox oriented_box(const Spline &spline, double tolerance) {
    const int dim = spline.dim();
    if (dim > max_box_dimension) {
        fail(Status::dimension, "dimension %d, expected at most %d", dim, max_box_dimension);
    }
    const pieces::SplinePieces pieces(spline, whole_domain(spline));
    std::vector<double> plain(static_cast<size_t>(dim) * static_cast<size_t>(dim));
    for (size_t r = 0; r < static_cast<size_t>(dim); ++r) {
        plain[r * static_cast<size_t>(dim) + r] = 1;
    }
    std::vector<double> turned = principal_axes(refine::cartesian_points(spline.effective()), dim);
    const Extents straight = extents(pieces, plain, tolerance), oblique = extents(pieces, turned, tolerance);
    const bool better = content(oblique) < content(straight);
    OrientedBox box =
        better ? box_of(pieces, std::move(turned), oblique) : box_of(pieces, std::move(plain), straight);
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(box.half.begin(), box.half.end(), finite) ||
        !std::all_of(box.center.begin(), box.center.end(), finite)) {
        fail(Status::not_representable, "the box is not bounded, or overflows");
    }
    return box;
}

} // namespace nrb::bounds
