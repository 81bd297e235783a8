// Closest points of the curves and surfaces of real CAD files: no sample is nearer.
#include "property/real_files.h"

#include <limits>

namespace closest_real_test {

using namespace support;

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

struct Extent {
    std::vector<double> lower, upper;
    double size = 0; // the largest coordinate
};

Extent extent_of(const SplineData &data) {
    Extent extent;
    for (int c = 0; c < data.dim; ++c) {
        double lower = data.coordinate(0, c), upper = lower;
        for (int64_t i = 0; i < data.point_count(); ++i) {
            lower = std::min(lower, data.coordinate(i, c));
            upper = std::max(upper, data.coordinate(i, c));
        }
        extent.lower.push_back(lower);
        extent.upper.push_back(upper);
        extent.size = std::max({extent.size, std::fabs(lower), std::fabs(upper)});
    }
    return extent;
}

std::vector<double> samples(Random &random, const RealSpline &spline, int n) {
    std::vector<double> params;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < spline.data.axes(); ++k) {
            params.push_back(random.between(spline.data.lower(k), spline.data.upper(k)));
        }
    }
    return eval(spline.handle.get(), params);
}

// In a box that is half as large again, and beside points of the shape.
std::vector<double> queries(Random &random, const RealSpline &spline, const Extent &extent, int n) {
    std::vector<double> points = samples(random, spline, n);
    for (size_t i = 0; i < points.size(); ++i) {
        const size_t c = i % extent.lower.size();
        const double width = extent.upper[c] - extent.lower[c];
        if (i / extent.lower.size() % 2 == 0) {
            points[i] = random.between(extent.lower[c] - width / 4, extent.upper[c] + width / 4);
        } else {
            points[i] += width * random.magnitude(1e-12, 0.1) * (random.chance(50) ? 1 : -1);
        }
    }
    return points;
}

double distance(const double *a, const double *b, int dim) {
    double square = 0;
    for (int c = 0; c < dim; ++c) {
        square += (a[c] - b[c]) * (a[c] - b[c]);
    }
    return std::sqrt(square);
}

void expect_nearest(const RealSpline &spline, Random &random) {
    constexpr int n = 40;
    const int dim = spline.data.dim;
    const Extent extent = extent_of(spline.data);
    const std::vector<double> points = queries(random, spline, extent, n),
                              all = samples(random, spline, 2000);
    std::vector<double> distances(n);
    std::vector<int32_t> status(n);
    require_ok(nurbs_closest_points(spline.handle.get(), n, points.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                    nullptr, 0, 0, distances.data(), 0, status.data(), 0));
    for (size_t q = 0; q < n; ++q) {
        const bool proven = (status[q] & (NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_COARSE)) != 0;
        EXPECT_TRUE(proven) << spline.name << ", query " << q;
        const double *x = points.data() + q * static_cast<size_t>(dim);
        for (size_t i = 0; i < all.size(); i += static_cast<size_t>(dim)) {
            ASSERT_GE(distance(all.data() + i, x, dim), distances[q] - 4096 * unit * extent.size)
                << spline.name << ", query " << q;
        }
    }
}

TEST_F(RealFiles, no_sample_is_nearer_than_the_closest_point) {
    Random random(0x6011);
    for (const auto *splines : {&iges(), &json()}) {
        for (const RealSpline &spline : *splines) {
            expect_nearest(spline, random);
        }
    }
}

} // namespace

} // namespace closest_real_test
