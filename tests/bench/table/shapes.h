// SPDX-License-Identifier: MIT
// The curves and surfaces of the table, for all libraries.
#pragma once

#include "bench/table/textbook.h"

#include <nurbs/nurbs.h>
#include <sisl.h>
#include <unsupported/Eigen/Splines>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

namespace bench {

inline void require_ok(nurbs_status status) {
    if (status != NURBS_OK) {
        std::abort();
    }
}

struct Destroy {
    void operator()(nurbs *g) const noexcept { nurbs_destroy(g); }
};
using Handle = std::unique_ptr<nurbs, Destroy>;

// The weights of a curve: within a factor of 2, one of ten times the others, a sixth of them wild, or all.
enum class Weights { mild, one, some, all };

struct Net {
    int32_t axes = 1, degree = 3;
    int64_t count = 100; // along each axis
    std::vector<double> knots, points, weights;

    Net(int32_t of_axes, int32_t of_degree, int64_t of_count, Weights kind = Weights::mild)
        : axes(of_axes), degree(of_degree), count(of_count) {
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int64_t i = 0; i < count + degree + 1; ++i) {
            knots.push_back(static_cast<double>(std::min(std::max<int64_t>(i - degree, 0), count - degree)));
        }
        const int64_t total = axes == 1 ? count : count * count;
        for (int64_t i = 0; i < total; ++i) {
            const double u = static_cast<double>(i / (axes == 1 ? 1 : count)),
                         v = static_cast<double>(i % count);
            points.insert(points.end(), {u, axes == 1 ? unit(engine) : v,
                                         2 * std::sin(u / 2) * std::cos(v / 3) + unit(engine) / 4});
            const bool wild = kind == Weights::all || (kind == Weights::some && i % 6 == 0) ||
                              (kind == Weights::one && i == total / 2);
            weights.push_back(wild ? std::pow(10, 4 * unit(engine) - 2) : 0.8 + 0.4 * unit(engine));
        }
    }

    [[nodiscard]] double length() const { return static_cast<double>(count - degree); }
    [[nodiscard]] std::vector<double> records() const {
        std::vector<double> values;
        for (size_t i = 0; i < weights.size(); ++i) {
            for (size_t c = 0; c < 3; ++c) {
                values.push_back(weights[i] * points[3 * i + c]);
            }
            values.push_back(weights[i]);
        }
        return values;
    }
    [[nodiscard]] Handle make() const {
        const int32_t degrees[] = {degree, degree};
        const int64_t counts[] = {count, count};
        std::vector<double> all = knots;
        all.insert(all.end(), knots.begin(), axes == 1 ? knots.begin() : knots.end());
        nurbs *out = nullptr;
        require_ok(nurbs_create(axes, degrees, counts, all.data(), static_cast<int64_t>(all.size()), 3,
                                points.data(), 0, 0, weights.data(), 0, 0, &out));
        return Handle(out);
    }
    [[nodiscard]] std::shared_ptr<SISLCurve> sisl_curve() const {
        std::vector<double> t = knots, p = records();
        return {newCurve(static_cast<int>(count), degree + 1, t.data(), p.data(), 2, 3, 1), freeCurve};
    }
    // Its first direction is the second one here.
    [[nodiscard]] std::shared_ptr<SISLSurf> sisl_surface() const {
        std::vector<double> t = knots, p = records();
        const int n = static_cast<int>(count), order = degree + 1;
        return {newSurf(n, n, order, order, t.data(), t.data(), p.data(), 2, 3, 1), freeSurf};
    }
    template <int kDegree>
    [[nodiscard]] Eigen::Spline<double, 4, kDegree> eigen() const {
        using Curve = Eigen::Spline<double, 4, kDegree>;
        using Knots = typename Curve::KnotVectorType;
        using Points = typename Curve::ControlPointVectorType;
        const std::vector<double> p = records();
        return {Knots(Eigen::Map<const Knots>(knots.data(), static_cast<Eigen::Index>(knots.size()))),
                Points(Eigen::Map<const Points>(p.data(), 4, static_cast<Eigen::Index>(count)))};
    }
    [[nodiscard]] TextbookSurface textbook() const {
        return {degree, static_cast<int>(count), knots, records()};
    }
    [[nodiscard]] std::vector<double> params(size_t n) const {
        std::mt19937 engine(7);
        std::uniform_real_distribution<double> inside(0, length());
        std::vector<double> values(n * static_cast<size_t>(axes));
        for (double &t : values) {
            t = inside(engine);
        }
        return values;
    }
};

// The largest difference of two arrays, over the largest magnitude.
inline double apart(const std::vector<double> &a, const std::vector<double> &b) {
    double difference = 0, size = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        difference = std::max(difference, std::abs(a[i] - b[i]));
        size = std::max(size, std::abs(a[i]));
    }
    return difference / size;
}

template <int kDegree>
void eigen_points(const Eigen::Spline<double, 4, kDegree> &curve, const double *params, size_t n,
                  double *out) {
    for (size_t i = 0; i < n; ++i, out += 3) {
        const Eigen::Array4d record = curve(params[i]);
        for (int c = 0; c < 3; ++c) {
            out[c] = record[c] / record[3];
        }
    }
}

// Points of a curve by both, and how much they differ.
template <int kDegree>
struct CurvePoints {
    Handle ours;
    Eigen::Spline<double, 4, kDegree> other;
    std::vector<double> params, found, expected;

    CurvePoints(const Net &net, size_t n)
        : ours(net.make()), other(net.eigen<kDegree>()), params(net.params(n)), found(3 * n),
          expected(3 * n) {}
    void run(uint32_t flags = 0) {
        require_ok(nurbs_eval(ours.get(), static_cast<int64_t>(params.size()), params.data(), 0, 0,
                              found.data(), 0, 0, flags));
    }
    void run_alone() {
        for (size_t i = 0; i < params.size(); ++i) {
            require_ok(nurbs_eval(ours.get(), 1, params.data() + i, 0, 0, found.data() + 3 * i, 0, 0, 0));
        }
    }
    void run_other() { eigen_points<kDegree>(other, params.data(), params.size(), expected.data()); }
    double difference() {
        run();
        run_other();
        return apart(expected, found);
    }
};

} // namespace bench
