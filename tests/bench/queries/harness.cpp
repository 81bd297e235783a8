#include "bench/queries/question.h"
#include "support/handle.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bench {

namespace {

using support::Handle;
using support::SplineData;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool failed = false;

double distance(const double *a, const double *b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Parameters inside every span of an axis, and its ends.
std::vector<double> dense(const SplineData &data, int axis, int in_span) {
    const std::vector<double> &knots = data.knots[static_cast<size_t>(axis)];
    std::vector<double> params = {knots.back()};
    for (size_t k = 0; k + 1 < knots.size(); ++k) {
        for (int i = 0; i < in_span && knots[k] < knots[k + 1]; ++i) {
            params.push_back(knots[k] + (knots[k + 1] - knots[k]) * i / in_span);
        }
    }
    return params;
}

// Distances by brute force: the nearest of many points, and where a descent from it ends.
std::vector<double> sampled_distances(const Question &question, const nurbs *g) {
    const bool surface = question.shape.axes() == 2;
    std::vector<double> params = dense(question.shape, 0, surface ? 16 : 128);
    if (surface) {
        const std::vector<double> u = params, v = dense(question.shape, 1, 16);
        params.clear();
        for (const double s : u) {
            for (const double t : v) {
                params.insert(params.end(), {s, t});
            }
        }
    }
    const std::vector<double> samples = support::eval(g, params);
    const auto axes = static_cast<size_t>(question.shape.axes());
    std::vector<double> found;
    for (size_t i = 0; i < question.points.size(); i += 3) {
        size_t best = 0;
        double nearest = infinity;
        for (size_t k = 0; k < samples.size(); k += 3) {
            const double d = distance(&question.points[i], &samples[k]);
            if (d < nearest) {
                nearest = d;
                best = k / 3;
            }
        }
        double local = infinity;
        support::require_ok(nurbs_closest_local(g, 1, &question.points[i], 0, 0, &params[axes * best], 0, 0,
                                                nullptr, 0, 0, nullptr, 0, 0, &local, 0, nullptr, 0));
        found.push_back(std::min(nearest, local));
    }
    return found;
}

// The smallest distances known: brute force, and ours where they are smaller.
std::vector<double> true_distances(const Question &question, const nurbs *g) {
    std::vector<double> best = sampled_distances(question, g), ours(best.size());
    support::require_ok(nurbs_closest_points(g, std::ssize(best), question.points.data(), 0, 0, nullptr, 0, 0,
                                             nullptr, 0, 0, nullptr, 0, 0, ours.data(), 0, nullptr, 0));
    std::ranges::transform(best, ours, best.begin(), [](double a, double b) { return std::min(a, b); });
    return best;
}

double wrong_part(const Question &question, const std::vector<double> &params) {
    const Handle g = support::create(question.shape);
    const std::vector<double> best = true_distances(question, g.get());
    const auto axes = static_cast<size_t>(question.shape.axes());
    if (params.size() != axes * best.size()) {
        throw std::runtime_error("not one answer for each point");
    }
    int64_t wrong = 0;
    for (size_t i = 0; i < best.size(); ++i) {
        const std::vector<double> param(params.begin() + static_cast<std::ptrdiff_t>(axes * i),
                                        params.begin() + static_cast<std::ptrdiff_t>(axes * (i + 1)));
        const bool none = std::ranges::any_of(param, [](double t) { return !(t >= 0 && t <= 1); });
        wrong += none || !(distance(support::eval(g.get(), param).data(), &question.points[3 * i]) <=
                           best[i] + allowed);
    }
    return static_cast<double>(wrong) / static_cast<double>(best.size());
}

// By a rule of high order on many parts of each span.
double true_length(const SplineData &data) {
    const Handle g = support::create(data);
    constexpr int parts = 32;
    const auto speed = [&](double t) {
        double d[2][3];
        support::require_ok(nurbs_eval_derivs(g.get(), 1, 1, &t, 0, 0, d[0], 0, 0, 0));
        return std::hypot(d[1][0], d[1][1], d[1][2]);
    };
    std::vector<double> ends = dense(data, 0, parts);
    std::ranges::sort(ends);
    long double length = 0;
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
        length += boost::math::quadrature::gauss<double, 20>::integrate(speed, ends[i], ends[i + 1]);
    }
    return static_cast<double>(length);
}

void judge(benchmark::State &state, const Question &question, const std::vector<double> &answer, bool ours) {
    const bool closest = question.kind == Kind::closest;
    double miss = 0;
    if (closest) {
        miss = wrong_part(question, answer);
    } else {
        const double length = true_length(question.shape);
        miss = std::abs(answer.at(0) - length) / length;
    }
    state.counters[closest ? "wrong" : "error"] = miss;
    if (ours && !(miss <= question.tolerance)) {
        throw std::runtime_error("wrong by " + std::to_string(miss));
    }
}

void measure(benchmark::State &state, const Question &question, const Route &route) {
    try {
        const Ask ask = route.prepare(question);
        std::vector<double> answer = ask();
        for ([[maybe_unused]] auto iteration : state) {
            answer = ask();
        }
        state.SetLabel(question.title);
        const size_t points = question.points.size() / 3;
        state.counters["answers"] = points == 0 ? 1.0 : static_cast<double>(points);
        judge(state, question, answer, route.name == "libnurbs");
    } catch (const std::exception &error) {
        failed = true;
        state.SkipWithError(error.what());
    }
}

} // namespace

int run(int argc, char **argv, const std::vector<Route> &routes) {
    for (const Question &question : questions()) {
        for (const Route &route : routes) {
            if (route.prepare(question)) {
                benchmark::RegisterBenchmark(
                    (question.name + "/" + route.name).c_str(),
                    [&](benchmark::State &state) { measure(state, question, route); })
                    ->MeasureProcessCPUTime()
                    ->Unit(benchmark::kMicrosecond);
            }
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return failed ? 1 : 0;
}

} // namespace bench
