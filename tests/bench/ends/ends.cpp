// SPDX-License-Identifier: MIT
// Calls that once ran for very long, and what they may take: each in a process of its own, which is ended after a while.
//   ends [REGEX [SECONDS]]: the time of each call, the limit, what it returned and its peak of memory.
#include "rows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <regex>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace ends {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Clock = std::chrono::steady_clock;

void products() {
    for (const int degree : {3, 9, 15, 23}) {
        row(numbered("compose/line/degree=", degree), 1e-3, [=] {
            const Shape curve = noise(1, degree, 100, 3),
                        line = make(1, 1, 2, 1, false,
                                    [](const double *at, double *x, double *) { x[0] = 0.1 + 0.8 * at[0]; });
            return made([&](nurbs **out) { return nurbs_compose(curve.get(), line.get(), out); });
        });
    }
    row("product/surfaces of 33^2/degree=15", 0.5, [] {
        const Shape surface = noise(2, 15, 33, 3);
        return made(
            [&](nurbs **out) { return nurbs_product(surface.get(), surface.get(), NURBS_PRODUCT_DOT, out); });
    });
    for (const int degree : {3, 7}) {
        row(numbered("product/volumes of 17^3/degree=", degree), 5, [=] {
            const Shape volume = noise(3, degree, 17, 3);
            return made([&](nurbs **out) {
                return nurbs_product(volume.get(), volume.get(), NURBS_PRODUCT_DOT, out);
            });
        });
    }
    row("sum/curves of degree 15 and 31, 1000 points", 1, [] {
        const Shape low = noise(1, 15, 1000, 3), high = noise(1, 31, 1000, 3);
        return made([&](nurbs **out) { return nurbs_sum(low.get(), 1, high.get(), 1, out); });
    });
    for (const int degree : {3, 9, 15}) {
        row(numbered("derivative/rational, 1000 points/degree=", degree), degree == 3 ? 0.01 : 0.1, [=] {
            const Shape curve = noise(1, degree, 1000, 3, 2);
            return made([&](nurbs **out) { return nurbs_derivative(curve.get(), 0, 1, out); });
        });
    }
}

Found constrained(int64_t conditions, int64_t points) {
    const Shape curve = wave(3, points);
    std::vector<double> params, targets;
    for (int64_t i = 0; i < conditions; ++i) {
        params.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(conditions));
        for (int c = 0; c < 3; ++c) {
            targets.push_back(random_number());
        }
    }
    return made([&](nurbs **out) {
        return nurbs_constrain(curve.get(), conditions, nullptr, nullptr, params.data(), targets.data(),
                               nullptr, nullptr, nullptr, 1e-9, nullptr, nullptr, nullptr, nullptr, out);
    });
}

Found bent(const Shape &shape, double tolerance) {
    const std::array<double, 3> origin{}, along{1, 0, 0}, across{0, 0, 1};
    double deviation = 0;
    int32_t proven = 0;
    Found found = made([&](nurbs **out) {
        return nurbs_bend(shape.get(), origin.data(), along.data(), across.data(), 0.5, 0.2, 0.8, tolerance,
                          &deviation, &proven, out);
    });
    found.what += " proven " + std::to_string(proven);
    return found;
}

Found divided(const Shape &curve, int64_t parts) {
    std::vector<double> params(static_cast<size_t>(parts + 1));
    double size = 0;
    return called([&] {
        return nurbs_curve_divide(curve.get(), nullptr, parts, 1e-9, NURBS_EQUAL_CHORDS, params.data(),
                                  &size);
    });
}

void shaping() {
    row("constrain/1000 conditions, 10000 points", 0.05, [] { return constrained(1000, 10000); });
    row("constrain/10000 conditions, 20000 points", 1, [] { return constrained(10000, 20000); });
    for (const int64_t count : {50, 100, 200}) {
        row("fair/surface/points=" + std::to_string(count) + "^2", 2, [=] {
            const Shape surface = noise(2, 3, count, 3);
            return made([&](nurbs **out) {
                return nurbs_fair(surface.get(), 2, nullptr, 1e-2, nullptr, nullptr, out);
            });
        });
    }
    for (const double tolerance : {1e-4, 1e-3, 1e-2}) {
        row("fair/hill of 200^2 with noise/tolerance=" + std::to_string(tolerance), 2, [=] {
            const Shape hill = make(2, 3, 200, 3, false, [](const double *at, double *point, double *) {
                point[0] = at[0];
                point[1] = at[1];
                point[2] = 0.2 * std::sin(9 * at[0]) * std::sin(7 * at[1]) + 1e-3 * random_number();
            });
            return made([&](nurbs **out) {
                return nurbs_fair(hill.get(), 2, nullptr, tolerance, nullptr, nullptr, out);
            });
        });
    }
    row("fair/line of degree 31, 1000 points", 2, [] {
        const Shape line = make(1, 31, 1000, 3, false,
                                [](const double *at, double *x, double *) { x[0] = x[1] = x[2] = at[0]; });
        return made(
            [&](nurbs **out) { return nurbs_fair(line.get(), 2, nullptr, 1e-3, nullptr, nullptr, out); });
    });
    row("bend/surface of 100^2 at 1e-3", 1, [] { return bent(hill(3, 100), 1e-3); });
    for (const double tolerance : {1e-12, 1e-17}) {
        row("bend/strip of 10 x 2/tolerance=" +
                (tolerance < 1e-15 ? std::string("1e-17") : std::string("1e-12")),
            0.1, [=] {
                const Shape strip = make(2, 1, 2, 3, false, [](const double *at, double *x, double *) {
                    x[0] = 10 * at[0];
                    x[1] = 2 * at[1];
                    x[2] = 0;
                });
                return bent(strip, tolerance);
            });
    }
    row("free form/wild curve of 100 points", 2, [] {
        const Shape curve = make(1, 3, 100, 3, true, [](const double *, double *x, double *w) {
            for (int c = 0; c < 3; ++c) {
                x[c] = 0.5 + 0.4 * random_number();
            }
            *w = std::pow(100, random_number());
        });
        const Shape volume = block(2, 4);
        const std::array<double, 3> lower{0, 0, 0}, upper{1, 1, 1};
        return made([&](nurbs **out) {
            return nurbs_free_form_deform(curve.get(), volume.get(), lower.data(), upper.data(), 1e-6,
                                          nullptr, nullptr, out);
        });
    });
    row("chords/100 parts of 1000 points", 0.05, [] { return divided(wave(3, 1000), 100); });
    row("chords/100 parts of noise, 1000 points", 1, [] { return divided(noise(1, 3, 1000, 3), 100); });
    row("chords/100 parts of noise of degree 31, 100 points", 2,
        [] { return divided(noise(1, 31, 100, 3), 100); });
    row("chords/100 parts of a wild curve, 100 points", 2,
        [] { return divided(noise(1, 3, 100, 3, 1e4), 100); });
}

Found moments(const Shape &shape, double tolerance) {
    double content = 0, error = 0;
    std::array<double, 3> centroid{};
    Found found = called(
        [&] { return nurbs_moments(shape.get(), tolerance, &content, centroid.data(), nullptr, &error); });
    found.what += told(0, " %.3g +- %.1g", content, error).what;
    return found;
}

void contents() {
    row("moments/volume of 4^3, weights 10, tolerance 0", 0.1, [] { return moments(block(2, 4, 10), 0); });
    row("moments/volume of 4^3, weights 0.1, tolerance 0", 0.1, [] { return moments(block(2, 4, 0.1), 0); });
    for (const int degree : {1, 3, 5}) {
        row(numbered("moments/volume of 20^3 at 1e-9/degree=", degree), 1,
            [=] { return moments(block(degree, 20), 1e-9); });
    }
    row("moments/circle of 1e5 points, tolerance 0", 1,
        [] { return moments(refined(circle(1).get(), 12500), 0); });
    row("area/3^2 points in a plane", 0.1, [] {
        const Shape flat = make(2, 2, 3, 2, true, [](const double *at, double *x, double *w) {
            x[0] = at[0] + 0.1 * random_number();
            x[1] = at[1] + 0.1 * random_number();
            *w = 1 + 0.5 * random_number();
        });
        double area = 0, error = 0;
        Found found = called([&] { return nurbs_surface_area(flat.get(), nullptr, 0, &area, &error); });
        found.what += told(0, " %.3g +- %.1g", area, error).what;
        return found;
    });
    row("area/surface of 200^2 at 1e-6", 2, [] {
        const Shape surface = noise(2, 3, 200, 3);
        double area = 0, error = 0;
        return called([&] { return nurbs_surface_area(surface.get(), nullptr, 1e-6, &area, &error); });
    });
    row("enclosed volume/wild surface, any error", 0.1, [] {
        const Shape surface = noise(2, 3, 20, 3, 1e4);
        const nurbs *const surfaces[] = {surface.get()};
        double volume = 0, open = 0, error = 0;
        return called([&] {
            return nurbs_enclosed_volume(1, surfaces, infinity, &volume, nullptr, nullptr, &open, &error);
        });
    });
    for (const int64_t count : {10, 20}) {
        row("fold test/volume of degree 5, points=" + std::to_string(count) + "^3", 1, [=] {
            const Shape volume = block(5, count);
            int32_t result = 0;
            return called([&] { return nurbs_fold_test(volume.get(), nullptr, &result, nullptr, nullptr); });
        });
    }
    for (const int dim : {2, 3}) {
        row(numbered("features/curve of 1e5 points/dim=", dim), dim == 2 ? 2 : 6, [=] {
            const Shape curve = noise(1, 3, 100000, dim);
            int64_t count = 0;
            int32_t complete = 0;
            Found found = called([&] {
                return nurbs_curve_features(curve.get(),
                                            NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CURVATURE_MAXIMUM, 0,
                                            nullptr, nullptr, nullptr, &count, &complete);
            });
            found.what += told(0, " %.0f, complete %.0f", static_cast<double>(count), complete).what;
            return found;
        });
    }
}

Found hausdorff(const Shape &a, const Shape &b, double tolerance) {
    std::array<double, 3> low{}, high{};
    int32_t status = 0;
    const double time = seconds([&] {
        good(nurbs_hausdorff_distance(a.get(), b.get(), tolerance, 0, low.data(), high.data(), nullptr,
                                      nullptr, &status));
    });
    Found found = told(time, "[%.9g, %.9g]", low[0], high[0]);
    found.what += " status " + std::to_string(status);
    return found;
}

Found distance(const Shape &a, const Shape &b, double tolerance) {
    double low = 0, high = 0;
    int32_t status = 0;
    const double time = seconds([&] {
        good(nurbs_distance(a.get(), b.get(), tolerance, 0, &low, &high, nullptr, nullptr, &status));
    });
    Found found = told(time, "[%.12g, %.12g]", low, high);
    found.what += " status " + std::to_string(status);
    return found;
}

// The first point, and one more.
Found nearest(const Shape &shape, std::array<double, 3> point, double tolerance) {
    std::array<double, 2> distances{};
    std::array<int32_t, 2> status{};
    std::array<double, 2> times{};
    for (size_t i = 0; i < 2; ++i) {
        times[i] = seconds([&] {
            good(nurbs_closest_points(shape.get(), 1, point.data(), 0, 0, nullptr, tolerance, 0, nullptr, 0,
                                      0, nullptr, 0, 0, &distances[i], 0, &status[i], 0));
        });
    }
    Found found = told(times[0], "again %.3g s, distance %.9g", times[1], distances[0]);
    found.what += " status " + std::to_string(status[0]);
    return found;
}

Found all_nearest(const Shape &shape, std::array<double, 3> point) {
    int64_t count = 0;
    int32_t status = 0;
    const double time = seconds([&] {
        good(nurbs_closest_all(shape.get(), point.data(), nullptr, 1e-9, 0, 0, nullptr, nullptr, &count,
                               &status));
    });
    Found found = told(time, "%.0f", static_cast<double>(count));
    found.what += " status " + std::to_string(status);
    return found;
}

void queries() {
    row("hausdorff/circle of 1e5 points with itself", 0.1, [] {
        const Shape fine = refined(circle(1).get(), 12500);
        return hausdorff(fine, fine, 1e-6);
    });
    row("hausdorff/noise of 1e5 points with a copy", 0.1, [] {
        const Shape one = noise(1, 3, 100000, 3), other = moved(one.get(), 1, {});
        return hausdorff(one, other, 1e-6);
    });
    row("hausdorff/curves 0.01 apart, 1e4 points", 0.2,
        [] { return hausdorff(wave(3, 10000), wave(3, 10000, 0.01), 1e-6); });
    row("hausdorff/volumes of 27 points at 1e-3", 1,
        [] { return hausdorff(noise(3, 2, 3, 3), noise(3, 2, 3, 3), 1e-3); });
    row("hausdorff/line of degree 31, 1000 points", 2, [] {
        const Net net = [](const double *at, double *x, double *) { x[0] = x[1] = x[2] = at[0]; };
        return hausdorff(make(1, 31, 1000, 3, false, net), make(1, 31, 1000, 3, false, net), 1e-6);
    });
    row("hausdorff/noise of degree 31, 1000 points", 2,
        [] { return hausdorff(noise(1, 31, 1000, 3), noise(1, 31, 1000, 3), 1e-6); });
    row("hausdorff/circle of radius 1e-8 at 1e8", 2, [] {
        const Shape one = moved(circle(1e-8).get(), 1, {1e8, 1e8, 0}),
                    other = moved(circle(2e-8).get(), 1, {1e8, 1e8, 0});
        return hausdorff(one, other, 0);
    });
    row("hausdorff/circle run 1000 times with one half as large", 2, [] {
        const Shape one = circle(1), run = repeated(one.get(), 1000);
        return hausdorff(run, circle(0.5), 1e-6);
    });
    for (const int64_t parts : {2, 20, 50}) {
        row("all nearest/centre of a sphere/parts=" + std::to_string(parts), 0.5, [=] {
            return all_nearest(refined(sphere(1).get(), parts), {0, 0, 0});
        });
    }
    row("all nearest/noise of 300^2", 2, [] { return all_nearest(noise(2, 3, 300, 3), {0, 0, 0}); });
    row("nearest/centre of a circle of 1e5 points", 1, [] {
        return nearest(refined(circle(1).get(), 12500), {0, 0, 0}, 1e-9);
    });
    row("nearest/centre of a circle run 1000 times", 1, [] {
        return nearest(repeated(circle(1).get(), 1000), {0, 0, 0}, 1e-9);
    });
    row("nearest/centre of a sphere of 200^2", 1, [] {
        return nearest(refined(sphere(1).get(), 50), {0, 0, 0}, 1e-9);
    });
    for (const int64_t turns : {100, 1000, 10000}) {
        row(numbered("nearest/coils over each other/turns=", turns), 1, [=] {
            return nearest(coils(turns), {1.3, 0.2, 0.0005}, 1e-9);
        });
    }
    for (const int exponent : {-160, 0, 160}) {
        const double scale = std::pow(10, exponent);
        row(numbered("nearest/surface times 10^", exponent), 1, [=] {
            return nearest(moved(hill(3, 20).get(), scale, {}), {0.3 * scale, 0.4 * scale, scale}, 0);
        });
        row(numbered("hausdorff/curves times 10^", exponent), 1, [=] {
            return hausdorff(moved(wave(3, 100).get(), scale, {}), moved(wave(3, 100, 0.01).get(), scale, {}),
                             1e-6 * scale);
        });
    }
    row("distance/sphere and torus", 1, [] {
        nurbs *torus = nullptr;
        good(nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 2 * std::acos(-1.0), 0,
                                 2 * std::acos(-1.0), 0, &torus));
        return distance(sphere(1), Shape(torus), 1e-9);
    });
    row("distance/circle run 1000 times and a concentric one", 1,
        [] { return distance(repeated(circle(1).get(), 1000), circle(1.1), 1e-9); });
    row("critical/noise of degree 31, one patch", 2, [] {
        const Shape patch = noise(2, 31, 32, 3);
        const std::array<double, 3> point{};
        int64_t count = 0;
        int32_t status = 0;
        return called([&] {
            return nurbs_critical_points(patch.get(), point.data(), nullptr, 1e-9, 0, 0, nullptr, nullptr,
                                         nullptr, &count, &status);
        });
    });
}

void memory() {
    row("memory/helix of 1e6 turns", 60, [] {
        return made([](nurbs **out) {
            return nurbs_curve_helix(3, nullptr, nullptr, nullptr, 1, 0, 1, 0, 1e6, 1e-3, nullptr, out);
        });
    });
    row("memory/Coons with 3000 knots a side", 60, [] {
        const std::array<Net, 4> sides{
            [](const double *at, double *x, double *) { x[0] = 0, x[1] = at[0], x[2] = at[0] * (1 - at[0]); },
            [](const double *at, double *x, double *) { x[0] = 1, x[1] = at[0], x[2] = at[0] * (1 - at[0]); },
            [](const double *at, double *x, double *) { x[0] = at[0], x[1] = 0, x[2] = at[0] * (1 - at[0]); },
            [](const double *at, double *x, double *) {
                x[0] = at[0], x[1] = 1, x[2] = at[0] * (1 - at[0]);
            }};
        std::array<Shape, 4> curves;
        std::array<const nurbs *, 4> edges{};
        for (size_t i = 0; i < 4; ++i) {
            curves[i] = make(1, 3, 3000, 3, false, sides[i]);
            edges[i] = curves[i].get();
        }
        return made([&](nurbs **out) { return nurbs_surface_coons(edges.data(), 1e-9, out); });
    });
}

// In a process of its own; false if it ran too long, took too long or failed.
bool run(const Row &row, double most) {
    std::fflush(stdout);
    const auto start = Clock::now();
    const pid_t child = fork();
    if (child == 0) {
        const rlimit limit{static_cast<rlim_t>(std::ceil(most)), static_cast<rlim_t>(std::ceil(most)) + 1};
        setrlimit(RLIMIT_CPU, &limit);
        const Found found = row.run();
        std::printf("%-58s %9.4f s of %6.3f %s  %s\n", row.name.c_str(), found.time, row.limit,
                    found.time <= row.limit ? "  " : "!!", found.what.c_str());
        std::fflush(stdout);
        std::_Exit(found.time <= row.limit ? 0 : 1);
    }
    int status = 0;
    rusage use{};
    wait4(child, &status, 0, &use);
    if (!WIFEXITED(status)) {
        std::printf("%-58s no end in %.0f s (limit %.3f)  !!\n", row.name.c_str(),
                    std::chrono::duration<double>(Clock::now() - start).count(), row.limit);
    }
    if (row.name.starts_with("memory")) {
        std::printf("    peak %.0f MB\n", static_cast<double>(use.ru_maxrss) / 1024);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int main_of(int argc, char **argv) {
    products();
    shaping();
    contents();
    queries();
    meets();
    memory();
    const std::regex wanted(argc > 1 ? argv[1] : ".");
    const double most = argc > 2 ? std::atof(argv[2]) : 20;
    int64_t missed = 0;
    for (const Row &row : all_rows()) {
        if (std::regex_search(row.name, wanted)) {
            missed += run(row, std::max(most, 2 * row.limit)) ? 0 : 1;
        }
    }
    std::printf("%lld of them beyond their limit\n", static_cast<long long>(missed));
    return missed == 0 ? 0 : 1;
}

} // namespace
} // namespace ends

int main(int argc, char **argv) {
    return ends::main_of(argc, argv);
}
