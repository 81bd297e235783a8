// SPDX-License-Identifier: MIT
// Splines through points.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

#include <cmath>

namespace bench {

namespace {

// Points along a spiral, or heights on a square, and chord lengths.
struct Points {
    std::vector<int64_t> counts;
    std::vector<int32_t> degrees;
    std::vector<double> points, params;
    std::vector<int> types; // of SISL: ordinary points

    Points(int axes, int64_t count)
        : counts(static_cast<size_t>(axes), count), degrees(counts.size(), 3),
          params(static_cast<size_t>(axes * count)), types(static_cast<size_t>(count), 1) {
        const int64_t total = axes == 1 ? count : count * count;
        for (int64_t i = 0; i < total; ++i) {
            const double x = axes == 1 ? 0.01 * static_cast<double>(i) : static_cast<double>(i / count);
            const double y = axes == 1 ? x * std::sin(x) : static_cast<double>(i % count);
            points.insert(points.end(),
                          {axes == 1 ? x * std::cos(x) : x, y, std::sin(0.1 * x) * std::cos(0.2 * y)});
        }
        require_ok(nurbs_parametrize(axes, counts.data(), 3, points.data(), 0, 0, NURBS_PARAMS_CHORD, 0, 0,
                                     params.data()));
    }

    void interpolate() const {
        nurbs *out = nullptr;
        require_ok(nurbs_interpolate(static_cast<int32_t>(counts.size()), degrees.data(), counts.data(),
                                     params.data(), 3, points.data(), 0, 0, nullptr, 0, nullptr, &out));
        nurbs_destroy(out);
    }
    void sisl_curve() {
        double end = 0, *params_of_sisl = nullptr;
        SISLCurve *curve = nullptr;
        int count = 0, status = 0;
        s1356(points.data(), static_cast<int>(counts[0]), 3, types.data(), 0, 0, 1, 4, 0, &end, &curve,
              &params_of_sisl, &count, &status);
        freeCurve(curve);
        std::free(params_of_sisl);
    }
    void sisl_surface() {
        SISLSurf *surface = nullptr;
        int status = 0;
        const auto n = static_cast<int>(counts[0]);
        s1536(points.data(), n, n, 3, 1, 0, 0, 0, 0, 4, 4, 0, 0, &surface, &status);
        freeSurf(surface);
    }
};

} // namespace

void add_fits(Rows &rows) {
    for (const int64_t count : {1000, 100000}) {
        const auto data = std::make_shared<Points>(1, count);
        rows.add({"cubic through " + std::to_string(count) + " points of space",
                  "SISL",
                  1,
                  [=] { data->interpolate(); },
                  [=] { data->sisl_curve(); },
                  {}});
    }
    for (const int64_t count : {100, 300}) {
        const auto data = std::make_shared<Points>(2, count);
        rows.add({"bicubic through " + std::to_string(count) + "^2 points of space",
                  "SISL",
                  1,
                  [=] { data->interpolate(); },
                  [=] { data->sisl_surface(); },
                  {}});
    }
}

} // namespace bench
