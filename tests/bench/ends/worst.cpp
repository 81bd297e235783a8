// SPDX-License-Identifier: MIT
// Each query for many shapes, so that no cliff hides behind an average: the median time, the longest, and its shape.
//   worst [QUERY [SECONDS]]: the queries whose names contain the word; a call is ended after so many seconds (10)
#include "shapes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace ends {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Subject {
    std::string name;
    std::function<Shape()> make;
};

// A curve by its coordinates at a part of the way.
Subject curve(const std::string &name, int degree, int64_t count,
              const std::function<void(double, double *)> &at) {
    return {name, [=] {
                return make(1, degree, count, 3, false,
                            [=](const double *u, double *x, double *) { at(u[0], x); });
            }};
}

Subject weighted(const std::string &name, int axes, double ratio) {
    return {name, [=] {
                return make(
                    axes, 3, axes == 1 ? 1000 : 20, 3, true, [=](const double *u, double *x, double *w) {
                        x[0] = u[0], x[1] = axes == 1 ? std::sin(9 * u[0]) : u[1], x[2] = random_number();
                        *w = random_number() > 0 ? 1 : ratio;
                    });
            }};
}

void add_curves(std::vector<Subject> &all) {
    all.push_back({"circle", [] { return circle(1); }});
    all.push_back({"circle 1000 times", [] { return repeated(circle(1).get(), 1000); }});
    all.push_back({"circle refined to 1e5 points", [] { return refined(circle(1).get(), 25000); }});
    all.push_back({"coils", [] { return coils(1000); }});
    all.push_back(curve("helix of 1000 turns", 3, 10000, [](double u, double *x) {
        x[0] = std::cos(6283 * u), x[1] = std::sin(6283 * u), x[2] = u;
    }));
    all.push_back({"noise of degree 3", [] { return noise(1, 3, 1000, 3); }});
    all.push_back({"noise of degree 3, 1e4 points", [] { return noise(1, 3, 10000, 3); }});
    all.push_back({"noise of degree 31", [] { return noise(1, 31, 1000, 3); }});
    all.push_back({"noise, one piece of degree 31", [] { return noise(1, 31, 32, 3); }});
    all.push_back(curve("line", 1, 2, [](double u, double *x) { x[0] = u, x[1] = u, x[2] = 0; }));
    all.push_back(
        curve("line of degree 31", 31, 1000, [](double u, double *x) { x[0] = u, x[1] = u, x[2] = 0; }));
    all.push_back(
        curve("steps", 3, 1000, [](double u, double *x) { x[0] = u, x[1] = std::floor(20 * u), x[2] = 0; }));
    all.push_back(curve("cusps", 3, 1000,
                        [](double u, double *x) { x[0] = u, x[1] = std::abs(std::sin(30 * u)), x[2] = 0; }));
    all.push_back(curve("a point", 3, 100, [](double, double *x) { x[0] = x[1] = x[2] = 1; }));
    all.push_back(curve("a way there and back", 3, 1000,
                        [](double u, double *x) { x[0] = std::abs(u - 0.5), x[1] = x[0], x[2] = 0; }));
    all.push_back(weighted("weights 1 and 1e-12", 1, 1e-12));
    all.push_back(weighted("weights 1 and 1e12", 1, 1e12));
    all.push_back({"a wave of size 1e160", [] { return moved(wave(3, 1000).get(), 1e160, {}); }});
    all.push_back({"a wave of size 1e-160", [] { return moved(wave(3, 1000).get(), 1e-160, {}); }});
    all.push_back({"a wave far away", [] { return moved(wave(3, 1000).get(), 1, {1e8, 1e8, 1e8}); }});
    all.push_back({"a wave of 1e5 points", [] { return wave(3, 100000); }});
    all.push_back({"a wave of degree 9", [] { return wave(9, 1000); }});
}

void add_surfaces(std::vector<Subject> &all) {
    all.push_back({"sphere", [] { return sphere(1); }});
    all.push_back({"sphere refined", [] { return refined(sphere(1).get(), 12); }});
    all.push_back({"hill", [] { return hill(3, 20); }});
    all.push_back({"hill of degree 9", [] { return hill(9, 20); }});
    all.push_back({"hill of 100 x 100", [] { return hill(3, 100); }});
    all.push_back({"noise surface", [] { return noise(2, 3, 20, 3); }});
    all.push_back({"noise surface of degree 9", [] { return noise(2, 9, 20, 3); }});
    all.push_back({"noise surface with weights", [] { return noise(2, 3, 20, 3, 100); }});
    all.push_back(weighted("surface with weights 1 and 1e-12", 2, 1e-12));
    all.push_back({"fold", [] {
                       return make(2, 3, 20, 3, false, [](const double *u, double *x, double *) {
                           x[0] = std::abs(u[0] - 0.5), x[1] = u[1], x[2] = 0;
                       });
                   }});
    all.push_back({"plane", [] {
                       return make(2, 3, 20, 3, false, [](const double *u, double *x, double *) {
                           x[0] = u[0], x[1] = u[1], x[2] = 0;
                       });
                   }});
    all.push_back({"hill of size 1e160", [] { return moved(hill(3, 20).get(), 1e160, {}); }});
    all.push_back({"hill of size 1e-160", [] { return moved(hill(3, 20).get(), 1e-160, {}); }});
}

void add_volumes(std::vector<Subject> &all) {
    all.push_back({"block", [] { return block(3, 8); }});
    all.push_back({"block of degree 5", [] { return block(5, 10); }});
    all.push_back({"block with weights", [] { return block(2, 6, 10); }});
    all.push_back({"noise volume", [] { return noise(3, 2, 6, 3); }});
}

struct Query {
    std::string name;
    int axes; // that it is for; 0: any
    std::function<nurbs_status(const nurbs *)> ask;
};

struct Answers {
    double values[4096];
    int32_t states[1024];
    int64_t count;
};
Answers out;

// The parts of the answers that the caller does not want cost nothing.
nurbs_status freed(nurbs_status status, nurbs_meet *meet) {
    nurbs_meet_destroy(meet);
    return status;
}

// Where a shape meets others and itself.
std::vector<Query> meets() {
    static const double plane[] = {0.3, 0.5, 1, -0.2}, up[] = {0.3, 0.5, 1}, level[] = {0.2},
                        from[] = {0.1, 0.2, 9}, down[] = {0.01, 0.02, -1}, light[] = {0, 0, 5};
    return {
        {"plane across a curve", 1,
         [](const nurbs *g) {
             return nurbs_curve_level(g, 1, plane, 1e-9, 0, nullptr, nullptr, nullptr, &out.count,
                                      out.states);
         }},
        {"self-intersections", 1,
         [](const nurbs *g) {
             return nurbs_curve_self_intersections(g, 1e-9, 0, nullptr, nullptr, nullptr, nullptr, nullptr,
                                                   &out.count, out.states);
         }},
        {"curve with a moved copy", 1,
         [](const nurbs *g) {
             const Shape other = moved(g, 1, {0.01, 0.02, 0.03});
             return nurbs_curve_intersections(g, other.get(), 1e-9, 0, nullptr, nullptr, nullptr, nullptr,
                                              nullptr, &out.count, out.states);
         }},
        {"ray", 2,
         [](const nurbs *g) {
             return nurbs_surface_rays(g, 1, from, 0, 0, down, 0, 0, out.values, out.values + 2, out.states);
         }},
        {"line through a surface", 2,
         [](const nurbs *g) {
             const Shape line = make(1, 1, 2, 3, false, [](const double *at, double *x, double *) {
                 for (int c = 0; c < 3; ++c) {
                     x[c] = from[c] + 20 * at[0] * down[c];
                 }
             });
             return nurbs_curve_surface_intersections(line.get(), g, 1e-9, 0, nullptr, nullptr, nullptr,
                                                      nullptr, nullptr, &out.count, out.states);
         }},
        {"section", 2,
         [](const nurbs *g) {
             nurbs_meet *meet = nullptr;
             return freed(nurbs_surface_sections(g, up, 1, level, 1e-6, &meet), meet);
         }},
        {"silhouette", 2,
         [](const nurbs *g) {
             nurbs_meet *meet = nullptr;
             return freed(nurbs_surface_contours(g, NURBS_CONTOUR_SILHOUETTE, up, 0, nullptr, 1e-6, &meet),
                          meet);
         }},
        {"reflection line", 2,
         [](const nurbs *g) {
             nurbs_meet *meet = nullptr;
             return freed(
                 nurbs_surface_reflections(g, NURBS_REFLECTION_ALONG, down, up, 1, light, 0, 0, 1e-6, &meet),
                 meet);
         }},
    };
}

std::vector<Query> queries() {
    static const double origin[] = {0.1, 0.2, 0.3}, up[] = {0.3, 0.5, 1};
    const auto nearest = [](const nurbs *g) {
        return nurbs_closest_points(g, 1, origin, 0, 0, nullptr, 1e-9, 0, out.values, 0, 0, nullptr, 0, 0,
                                    nullptr, 0, out.states, 0);
    };
    const auto farthest = [](const nurbs *g) {
        return nurbs_farthest_points(g, 1, origin, 0, 0, nullptr, 1e-9, 0, out.values, 0, 0, nullptr, 0, 0,
                                     nullptr, 0, out.states, 0);
    };
    const auto minima = [](const nurbs *g) {
        return nurbs_closest_all(g, origin, nullptr, 1e-9, 0, 100, out.values, nullptr, &out.count,
                                 out.states);
    };
    const auto critical = [](const nurbs *g) {
        return nurbs_critical_points(g, origin, nullptr, 1e-9, 0, 100, out.values, nullptr, nullptr,
                                     &out.count, out.states);
    };
    const auto copy = [](const nurbs *g) { return moved(g, 1, {0.01, 0.02, 0.03}); };
    const auto distance = [=](const nurbs *g) {
        const Shape other = copy(g);
        return nurbs_distance(g, other.get(), 1e-6, 0, out.values, out.values + 1, nullptr, nullptr,
                              out.states);
    };
    const auto hausdorff = [=](const nurbs *g) {
        const Shape other = copy(g);
        return nurbs_hausdorff_distance(g, other.get(), 1e-6, 0, out.values, out.values + 2, nullptr, nullptr,
                                        out.states);
    };
    const auto features = [](const nurbs *g) {
        return nurbs_curve_features(g, 0x7f, 0, nullptr, nullptr, nullptr, &out.count, out.states);
    };
    const auto continuity = [](const nurbs *g) {
        return nurbs_continuity(g, 0, 0, 0, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                                nullptr, &out.count);
    };
    const auto extreme = [](const nurbs *g) {
        return nurbs_extreme_point(g, up, nullptr, 1e-9, out.values, out.values + 3, out.values + 4);
    };
    const auto recognized = [](const nurbs *g) {
        return nurbs_recognize(g, 1e-6, out.states, out.values, out.values + 100, out.values + 200);
    };
    return {
        {"nearest point", 0, nearest},
        {"farthest point", 0, farthest},
        {"all minima", 0, minima},
        {"critical points", 0, critical},
        {"distance of two", 0, distance},
        {"Hausdorff distance", 0, hausdorff},
        {"length", 1,
         [](const nurbs *g) { return nurbs_curve_length(g, nullptr, 0, out.values, out.values + 1); }},
        {"area", 2,
         [](const nurbs *g) { return nurbs_surface_area(g, nullptr, 0, out.values, out.values + 1); }},
        {"moments", 0,
         [](const nurbs *g) {
             return nurbs_moments(g, 0, out.values, out.values + 1, out.values + 4, out.values + 20);
         }},
        {"box", 0,
         [](const nurbs *g) { return nurbs_box(g, nullptr, 0, out.values, out.values + 3, out.values + 6); }},
        {"oriented box", 0,
         [](const nurbs *g) {
             return nurbs_oriented_box(g, 1e-6, out.values, out.values + 3, out.values + 12);
         }},
        {"extreme point", 0, extreme},
        {"tangent cone", 0,
         [](const nurbs *g) { return nurbs_tangent_cone(g, 0, nullptr, 0.01, out.values, out.values + 3); }},
        {"normal cone", 2,
         [](const nurbs *g) { return nurbs_normal_cone(g, nullptr, 0.01, out.values, out.values + 3); }},
        {"features", 1, features},
        {"fold test", 2,
         [](const nurbs *g) { return nurbs_fold_test(g, nullptr, out.states, out.values, out.values + 3); }},
        {"fold test of volumes", 3,
         [](const nurbs *g) { return nurbs_fold_test(g, nullptr, out.states, out.values, out.values + 3); }},
        {"continuity", 0, continuity},
        {"recognize", 0, recognized}};
}

// Seconds of the call, in a process of its own; infinite if it did not end.
double time_of(const Query &query, const Subject &subject, double most) {
    static auto *const shared = static_cast<double *>(
        mmap(nullptr, sizeof(double), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    *shared = infinity;
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const Shape shape = subject.make();
        int32_t axes = 0;
        good(nurbs_axes(shape.get(), &axes));
        if (query.axes != 0 && axes != query.axes) {
            *shared = -1;
            std::_Exit(0);
        }
        const rlimit limit{static_cast<rlim_t>(std::ceil(most)) + 5,
                           static_cast<rlim_t>(std::ceil(most)) + 6};
        setrlimit(RLIMIT_CPU, &limit);
        const auto start = std::chrono::steady_clock::now();
        const nurbs_status status = query.ask(shape.get());
        const double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        *shared = status < 0 || status >= 900 ? infinity : time; // a defect
        std::_Exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return *shared;
}

// Prints a row; whether all calls ended in time.
bool measure(const Query &query, const std::vector<Subject> &subjects, double most) {
    std::vector<double> times;
    double longest = -1;
    std::string worst;
    for (const Subject &subject : subjects) {
        const double time = time_of(query, subject, most);
        if (time < 0) {
            continue;
        }
        times.push_back(time);
        if (time > longest) {
            longest = time;
            worst = subject.name;
        }
    }
    std::sort(times.begin(), times.end());
    std::printf("| %s | %zu | %.3g | %.3g | %s |\n", query.name.c_str(), times.size(),
                1e3 * times[times.size() / 2], 1e3 * longest, worst.c_str());
    std::fflush(stdout);
    return longest <= most;
}

int main_of(int argc, char **argv) {
    std::vector<Subject> subjects;
    add_curves(subjects);
    add_surfaces(subjects);
    add_volumes(subjects);
    const std::string word = argc > 1 ? argv[1] : "";
    const double most = argc > 2 ? std::atof(argv[2]) : 10;
    std::printf("| milliseconds, first call | shapes | median | worst | worst shape |\n| --- | ---: | ---: | "
                "---: | --- |\n");
    bool in_time = true;
    std::vector<Query> all = queries();
    std::ranges::move(meets(), std::back_inserter(all));
    for (const Query &query : all) {
        if (query.name.find(word) != std::string::npos) {
            in_time = measure(query, subjects, most) && in_time;
        }
    }
    return in_time ? 0 : 1;
}

} // namespace
} // namespace ends

int main(int argc, char **argv) {
    return ends::main_of(argc, argv);
}
