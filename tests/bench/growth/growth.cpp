// SPDX-License-Identifier: MIT
// How the time of a call grows with the number of control points, for curves of some degrees.
//   growth [SECONDS]: lines "family,function,degree,points,seconds"; a line ends where a call takes more than so long (2)
#include "bench/ends/shapes.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace {

using ends::good;
using ends::Shape;

struct Function {
    std::string family, name;
    std::function<void(const nurbs *)> call;
};

// The time of one call, on a handle that has had none.
double time_of(const Function &function, int degree, int64_t points) {
    double best = 1e300;
    for (int repeat = 0; repeat < (points < 100000 ? 3 : 1); ++repeat) {
        const Shape shape = ends::wave(degree, points);
        const auto start = std::chrono::steady_clock::now();
        function.call(shape.get());
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

template <class Make>
void made(Make &&make) {
    nurbs *out = nullptr;
    good(make(&out));
    nurbs_destroy(out);
}

std::vector<double> params_for(const nurbs *g) {
    int64_t count = 0;
    double domain[2];
    good(nurbs_point_count(g, &count));
    good(nurbs_domain(g, 0, domain));
    std::vector<double> params(static_cast<size_t>(count));
    for (size_t i = 0; i < params.size(); ++i) {
        params[i] =
            domain[0] + (domain[1] - domain[0]) * static_cast<double>(i) / static_cast<double>(params.size());
    }
    return params;
}

void evaluate(const nurbs *g, int order) {
    const std::vector<double> params = params_for(g);
    std::vector<double> values(params.size() * 3 * static_cast<size_t>(order + 1));
    good(nurbs_eval_derivs(g, order, static_cast<int64_t>(params.size()), params.data(), 0, 0, values.data(),
                           0, 0, 0));
}

void refine(const nurbs *g) {
    const std::vector<double> knots = params_for(g);
    made([&](nurbs **out) {
        return nurbs_refine(g, 0, static_cast<int64_t>(knots.size()) - 1, knots.data() + 1, out);
    });
}

void decompose(const nurbs *g) {
    nurbs_list *list = nullptr;
    good(nurbs_decompose(g, &list));
    nurbs_list_destroy(list);
}

void reduce(const nurbs *g) {
    double bound = 0;
    made([&](nurbs **out) { return nurbs_reduce_knots(g, 0, 1e-6, &bound, out); });
}

void nearest(const nurbs *g) {
    const double point[] = {0.2, 0.3, 0.4};
    double param = 0;
    int32_t status = 0;
    good(nurbs_closest_points(g, 1, point, 0, 0, nullptr, 1e-9, 0, &param, 0, 0, nullptr, 0, 0, nullptr, 0,
                              &status, 0));
}

void move_weights(const nurbs *g) {
    const int64_t index = 3;
    const double weight = 2;
    made([&](nurbs **out) { return nurbs_set_weights(g, 1, &index, &weight, out); });
}

std::vector<Function> functions() {
    static double values[16];
    return {{"evaluation", "points", [](const nurbs *g) { evaluate(g, 0); }},
            {"evaluation", "second derivatives", [](const nurbs *g) { evaluate(g, 2); }},
            {"knots and degrees", "refine", refine},
            {"knots and degrees", "elevate",
             [](const nurbs *g) { made([&](nurbs **out) { return nurbs_elevate(g, 0, 1, out); }); }},
            {"knots and degrees", "decompose", decompose},
            {"knots and degrees", "remove knots", reduce},
            {"measures", "length",
             [](const nurbs *g) { good(nurbs_curve_length(g, nullptr, 1e-6, values, nullptr)); }},
            {"measures", "box",
             [](const nurbs *g) { good(nurbs_box(g, nullptr, 1e-6, values, values + 3, nullptr)); }},
            {"queries", "nearest point", nearest},
            {"algebra", "derivative",
             [](const nurbs *g) { made([&](nurbs **out) { return nurbs_derivative(g, 0, 1, out); }); }},
            {"algebra", "product",
             [](const nurbs *g) {
                 made([&](nurbs **out) { return nurbs_product(g, g, NURBS_PRODUCT_DOT, out); });
             }},
            {"modification", "set a weight", move_weights}};
}

} // namespace

int main(int argc, char **argv) {
    const double most = argc > 1 ? std::atof(argv[1]) : 2;
    for (const Function &function : functions()) {
        for (const int degree : {1, 3, 9,
                                 function.name == "elevate"   ? 30
                                 : function.name == "product" ? 15
                                                              : 31}) {
            double time = 0;
            for (int64_t points = 10; points <= 1000000 && time <= most; points *= 10) {
                if (points > degree) {
                    time = time_of(function, degree, points);
                    std::printf("%s,%s,%d,%lld,%.4g\n", function.family.c_str(), function.name.c_str(),
                                degree, static_cast<long long>(points), time);
                    std::fflush(stdout);
                }
            }
        }
    }
    return 0;
}
