// SPDX-License-Identifier: MIT
// Fits by SISL: s1356 and s1536 interpolate, s1961 fits to a tolerance.     bench_fits_sisl FOLDER JOB
#include "bench/fits/job.h"

#include <cmath>
#include <map>
#include <sisl.h>

namespace {

using namespace bench::fits;

void good(int status) {
    if (status < 0) {
        std::fprintf(stderr, "SISL: status %d\n", status);
        std::exit(1);
    }
}

void curve(const std::string &folder, const std::string &name, int count) {
    std::vector<double> points = read(folder, name);
    std::vector<int> types(static_cast<size_t>(count), 1);
    tell(milliseconds([&] {
             double end = 0, *params = nullptr;
             SISLCurve *made = nullptr;
             int params_count = 0, status = 0;
             s1356(points.data(), count, 3, types.data(), 0, 0, 1, 4, 0, &end, &made, &params, &params_count,
                   &status);
             good(status);
             freeCurve(made);
             std::free(params);
         }),
         count);
}

void surface(const std::string &folder, const std::string &name, int count) {
    std::vector<double> points = read(folder, name);
    tell(milliseconds([&] {
             SISLSurf *made = nullptr;
             int status = 0;
             s1536(points.data(), count, count, 3, 1, 0, 0, 0, 0, 4, 4, 0, 0, &made, &status);
             good(status);
             freeSurf(made);
         }),
         int64_t{count} * count);
}

// The tolerance is one for each coordinate: that of the distance, divided by the root of 3.
void tolerance(const std::string &folder, const std::string &name, double within) {
    std::vector<double> points = read(folder, name + "_values"), params = read(folder, name + "_params");
    std::vector<double> each(3, within / std::sqrt(3.0)), errors(3);
    const auto n = static_cast<int>(params.size());
    SISLCurve *made = nullptr;
    const double ms = milliseconds([&] {
        if (made != nullptr) {
            freeCurve(made);
        }
        int status = 0;
        s1961(points.data(), n, 3, 3, params.data(), each.data(), 0, 0, 1, 1e-9, 20, 4, &made, errors.data(),
              &status);
        good(status);
    });
    int left = 0;
    const double error = largest_distance(params, points, [&](double t, double *at) {
        int status = 0;
        s1221(made, 0, t, &left, at, &status);
    });
    tell(ms, made->in, error);
    freeCurve(made);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_fits_sisl FOLDER JOB\n");
        return 2;
    }
    const std::string folder = argv[1], job = argv[2];
    const std::map<std::string, std::function<void()>> jobs{
        {"curve_1e3", [&] { curve(folder, "spiral_1000", 1000); }},
        {"curve_1e5", [&] { curve(folder, "spiral_100000", 100000); }},
        {"surface_100", [&] { surface(folder, "heights_100", 100); }},
        {"surface_300", [&] { surface(folder, "heights_300", 300); }},
        {"tolerance_1e5", [&] { tolerance(folder, "flower_100000", 1e-4); }},
    };
    const auto found = jobs.find(job);
    if (found == jobs.end()) {
        return 77;
    }
    found->second();
    return 0;
}
