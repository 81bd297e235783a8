// SPDX-License-Identifier: MIT
#include "analysis/flatness.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "numeric/solvers/principal_axes.h"
#include "pieces/spline_pieces.h"
#include "refine/forms/homogeneous.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::analysis {

namespace {

constexpr pieces::SearchLimits fine{.ratio = 1e-3, .steps = 4000};

// The finite ones among the points, stored consecutively.
std::vector<double> finite_points(const std::vector<double> &points, int dim) {
    std::vector<double> result;
    const auto n = static_cast<size_t>(dim);
    for (size_t i = 0; i < points.size(); i += n) {
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(i), end = first + dim;
        if (std::all_of(first, end, [](double x) { return std::isfinite(x); })) {
            result.insert(result.end(), first, end);
        }
    }
    return result;
}

std::vector<double> mean_of(const std::vector<double> &points, int dim) {
    const auto n = static_cast<size_t>(dim);
    std::vector<double> mean(n);
    const size_t count = points.size() / n;
    for (size_t i = 0; i < points.size(); ++i) {
        mean[i % n] += points[i] / static_cast<double>(count);
    }
    return mean;
}

// The direction in which points spread most, by the power method on their covariance matrix; the first
// coordinate direction if they do not spread.
std::vector<double> main_direction(std::vector<double> points, int dim) {
    const auto n = static_cast<size_t>(dim);
    const std::vector<double> mean = mean_of(points, dim);
    size_t far = 0;
    double reach = 0;
    for (size_t i = 0; i < points.size(); i += n) {
        for (size_t c = 0; c < n; ++c) {
            points[i + c] -= mean[c];
        }
        const double size = norm(points.data() + i, dim);
        far = size > reach ? i : far;
        reach = std::max(reach, size);
    }
    std::vector<double> d(n);
    if (!(reach > 0) || !std::isfinite(reach)) {
        d[0] = 1;
        return d;
    }
    std::for_each(points.begin(), points.end(), [reach](double &x) { x /= reach; });
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(far), n, d.begin());
    for (int step = 0; step < 50; ++step) {
        std::vector<double> next(n);
        for (size_t i = 0; i < points.size(); i += n) {
            double product = 0;
            for (size_t c = 0; c < n; ++c) {
                product += points[i + c] * d[c];
            }
            for (size_t c = 0; c < n; ++c) {
                next[c] += product * points[i + c];
            }
        }
        const double size = norm(next.data(), dim);
        std::transform(next.begin(), next.end(), d.begin(), [size](double x) { return x / size; });
    }
    return d;
}

// Sample parameters in every span of an axis, so many that all axes together yield some thousands of points,
// and the end of the axis.
std::vector<double> places_on(const KnotVector &axis, int axes) {
    const std::vector<double> breaks = refine::breaks_of(axis);
    const double enough = std::pow(4096.0, 1.0 / axes);
    const auto spans = static_cast<double>(breaks.size() - 1);
    const int n = static_cast<int>(std::clamp(enough / spans, 1.0, 2.0 * axis.degree() + 2));
    std::vector<double> places;
    for (size_t e = 0; e + 1 < breaks.size(); ++e) {
        for (int i = 0; i < n; ++i) {
            const double share = static_cast<double>(i) / n;
            places.push_back(breaks[e] * (1 - share) + breaks[e + 1] * share);
        }
    }
    for (double &t : places) {
        t = std::clamp(t, breaks.front(), breaks.back());
    }
    places.push_back(breaks.back());
    return places;
}

// The orthogonal projection along d, 1 - d d^T / |d|^2.
std::vector<double> projection_across(const std::vector<double> &d) {
    const size_t n = d.size();
    double square = 0;
    for (const double x : d) {
        square += x * x;
    }
    std::vector<double> matrix(n * n);
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            matrix[i * n + j] = (i == j ? 1.0 : 0.0) - d[i] * d[j] / square;
        }
    }
    return matrix;
}

// An upper bound on |M (x - centre)| over the spline, for a matrix M of norm 1.
double largest_image(const Spline &spline, const std::vector<double> &centre,
                     const std::vector<double> &matrix, const pieces::SearchLimits &limits) {
    const pieces::SplinePieces pieces(spline, whole_domain(spline), centre);
    const pieces::PieceSource source = [&](int64_t i, pieces::QuotientPiece &out) {
        pieces.fill(i, matrix.data(), spline.dim(), 1, out);
    };
    const std::vector<double> uppers = pieces::quotient_uppers(pieces.count(), source);
    return pieces::largest_quotient(uppers, source, limits).upper;
}

double reach_from(const Spline &spline, const std::vector<double> &centre,
                  const pieces::SearchLimits &limits) {
    const size_t n = centre.size();
    std::vector<double> identity(n * n);
    for (size_t i = 0; i < n; ++i) {
        identity[i * n + i] = 1;
    }
    return largest_image(spline, centre, identity, limits);
}

// An upper bound on the distance from the line through `centre` along d. The entries of the projection M have
// errors of (n + 2) eps / 2 of d_i d_j / |d|^2, whose squares sum to 1, and of eps / 2 of their own sizes, the
// squares of which sum to n - 1: in all a matrix of norm (n + 2) eps at most.
double farthest_from_line(const Spline &spline, const std::vector<double> &centre,
                          const std::vector<double> &projection) {
    const double reach = reach_from(spline, centre, {.ratio = 1, .steps = 4000});
    return largest_image(spline, centre, projection, fine) + (spline.dim() + 2) * eps * reach;
}

void require_finite(double bound) {
    if (!std::isfinite(bound)) {
        fail(Status::not_representable, "bound: the spline is not bounded, or its size overflows");
    }
}

// An upper bound on direction . (x - c) over the spline, c being the centre of the pieces, that exceeds the
// maximum by at most `tolerance` if the search succeeds.
double reach_of(const pieces::SplinePieces &pieces, const std::vector<double> &direction, double tolerance) {
    const pieces::PieceSource source = [&](int64_t i, pieces::QuotientPiece &out) {
        pieces.fill(i, direction.data(), out);
    };
    return pieces::largest_value(pieces.count(), source, tolerance, 4000).bounds.upper;
}

} // namespace

std::vector<double> sample_points(const Spline &spline) {
    std::array<std::vector<double>, max_axes> places;
    std::array<ConstRecords, max_axes> params;
    int64_t count = 1;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        places[at] = places_on(spline.axis(k), spline.axes());
        params[at] = {places[at].data(), std::ssize(places[at]), 1, 1, 1};
        count *= std::ssize(places[at]);
    }
    std::vector<double> points(static_cast<size_t>(count * spline.dim()));
    eval::evaluate_grid(spline, eval::AxisRules{}, 0, params,
                        {points.data(), count, spline.dim(), spline.dim(), 1});
    return points;
}

std::vector<double> ball_centre(const std::vector<double> &points, int dim) {
    const std::vector<double> usable = finite_points(points, dim);
    const auto n = static_cast<size_t>(dim);
    if (usable.empty()) {
        return std::vector<double>(n, 0.0);
    }
    std::vector<double> centre(usable.begin(), usable.begin() + dim);
    const int steps = static_cast<int>(std::clamp(2e7 / static_cast<double>(usable.size()), 20.0, 300.0));
    for (int step = 1; step <= steps; ++step) {
        const double *far = usable.data();
        double reach = -1;
        for (size_t i = 0; i < usable.size(); i += n) {
            const double length = distance(usable.data() + i, centre.data(), dim);
            far = length > reach ? usable.data() + i : far;
            reach = std::max(reach, length);
        }
        for (size_t c = 0; c < n; ++c) {
            centre[c] += (far[c] - centre[c]) / (step + 1);
        }
    }
    return centre;
}

double farthest_from(const Spline &spline, const std::vector<double> &centre) {
    return reach_from(spline, centre, fine);
}

Flatness straightness(const Spline &spline) {
    const int dim = spline.dim();
    std::vector<double> points = finite_points(sample_points(spline), dim);
    points.resize(std::max(points.size(), static_cast<size_t>(dim)), 0.0);
    Flatness result{mean_of(points, dim), main_direction(points, dim), 0};
    if (spline.axes() == 1) {
        const std::vector<double> a = eval::end_point(spline, false), b = eval::end_point(spline, true);
        double along = 0;
        for (size_t c = 0; c < a.size(); ++c) {
            along += result.direction[c] * (b[c] - a[c]);
        }
        if (along < 0) {
            std::for_each(result.direction.begin(), result.direction.end(), [](double &x) { x = -x; });
        }
    }
    const std::vector<double> across = projection_across(result.direction);
    const auto n = static_cast<size_t>(dim);
    std::vector<double> images(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        const size_t first = i - i % n;
        for (size_t c = 0; c < n; ++c) {
            images[i] += across[i % n * n + c] * (points[first + c] - result.origin[c]);
        }
    }
    const std::vector<double> middle = ball_centre(images, dim);
    std::transform(middle.begin(), middle.end(), result.origin.begin(), result.origin.begin(), std::plus<>());
    result.bound = farthest_from_line(spline, result.origin, across);
    require_finite(result.bound);
    return result;
}

Flatness planarity(const Spline &spline) {
    const std::vector<double> axes = principal_axes(refine::cartesian_points(spline.effective()), 3);
    const pieces::SplinePieces pieces(spline, whole_domain(spline));
    std::vector<double> normal(axes.begin() + 6, axes.end());
    const auto largest = std::max_element(normal.begin(), normal.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (*largest < 0) {
        std::for_each(normal.begin(), normal.end(), [](double &x) { x = -x; });
    }
    std::vector<double> back = normal;
    std::for_each(back.begin(), back.end(), [](double &x) { x = -x; });
    const double tolerance = 1e-3 * (reach_of(pieces, normal, infinity) + reach_of(pieces, back, infinity));
    const double high = reach_of(pieces, normal, tolerance), low = -reach_of(pieces, back, tolerance);
    Flatness result{pieces.centre(), normal, 0};
    for (size_t c = 0; c < 3; ++c) {
        result.origin[c] += (high / 2 + low / 2) * normal[c];
    }
    const double moved = 8 * eps * (norm(result.origin.data(), 3) + std::abs(high) + std::abs(low));
    result.bound = (high / 2 - low / 2) * (1 + 8 * eps) + moved;
    require_finite(result.bound);
    return result;
}

} // namespace nrb::analysis
