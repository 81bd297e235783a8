#include "bench/operations/task.h"
#include "support/handle.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <stdexcept>

namespace bench {

namespace {

using support::SplineData;

bool failed = false;

void require(bool condition, const std::string &what) {
    if (!condition) {
        throw std::runtime_error(what);
    }
}

// Parameters well inside, between the knots of the data.
std::vector<double> sample(const SplineData &data) {
    std::vector<double> params;
    const double lower = data.lower(0), upper = data.upper(0);
    const int samples = 999;
    for (int i = 0; i < samples; ++i) {
        params.push_back(lower + (upper - lower) * (i + 0.5) / samples);
    }
    return params;
}

// Largest distance of two curves where the second is defined.
double difference(const nurbs *g, const SplineData &part) {
    const std::vector<double> params = sample(part);
    const std::vector<double> a = support::eval(g, params);
    const std::vector<double> b = support::eval(support::create(part).get(), params);
    double worst = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return worst;
}

// Every piece of many is not looked at, for the sake of time.
void check_shape(const SplineData &input, const std::vector<SplineData> &parts, double tolerance) {
    const support::Handle g = support::create(input);
    const size_t step = parts.size() / 50 + 1;
    for (size_t i = 0; i < parts.size(); i += step) {
        const double worst = difference(g.get(), parts[i]);
        require(worst <= tolerance, "the shape moved by " + std::to_string(worst));
    }
}

// Whether something new is made, which is not the shape of the input.
bool makes(Operation operation) {
    return operation == Operation::circle || operation == Operation::revolve ||
           operation == Operation::ruled || operation == Operation::coons;
}

void check(const Task &task, const std::vector<SplineData> &results) {
    constexpr double rounding = 1e-11; // far above what rounding can do, far below any mistake
    require(!results.empty(), "no result");
    if (makes(task.operation)) {
        return check_made(task, results[0]);
    }
    const double tolerance = std::max(task.tolerance, rounding);
    if (task.operation != Operation::compatible) {
        check_shape(task.inputs[0], results, tolerance);
    }
    const size_t knots = task.inputs[0].knots[0].size();
    switch (task.operation) {
    case Operation::refine:
        return require(results[0].knots[0].size() == knots + task.knots.size(), "knots are missing");
    case Operation::elevate:
        return require(results[0].degrees[0] == task.inputs[0].degrees[0] + 1, "not elevated");
    case Operation::remove:
        return require(results[0].knots[0].size() == knots - task.knots.size(), "knots are left");
    case Operation::decompose:
        return require(std::ssize(results) == 1 || std::ssize(results) == task.inputs[0].counts[0] - 3,
                       "pieces are missing");
    default: // compatible curves
        break;
    }
    for (size_t i = 0; i < results.size(); ++i) {
        require(results[i].knots[0] == results[0].knots[0], "knots differ");
        check_shape(task.inputs[i], {results[i]}, tolerance);
    }
}

void measure(benchmark::State &state, const Task &task, const Prepare &prepare) {
    try {
        const Work work = prepare(task);
        work.run();
        for ([[maybe_unused]] auto iteration : state) {
            work.run();
        }
        state.SetLabel(task.title);
        state.counters["points"] = task.inputs.empty() ? 1.0 : static_cast<double>(task.inputs[0].counts[0]);
        check(task, work.results());
    } catch (const std::exception &error) {
        failed = true;
        state.SkipWithError(error.what());
    }
}

} // namespace

int run(int argc, char **argv, const std::string &library, const Prepare &prepare) {
    for (const Task &task : tasks()) {
        if ((!task.ours_only || library == "libnurbs") && prepare(task).run) {
            benchmark::RegisterBenchmark((task.name + "/" + library).c_str(),
                                         [&](benchmark::State &state) { measure(state, task, prepare); })
                ->MeasureProcessCPUTime()
                ->Unit(benchmark::kMicrosecond);
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return failed ? 1 : 0;
}

} // namespace bench
