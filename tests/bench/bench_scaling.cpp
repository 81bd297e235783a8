// How the time of this library grows: with the number of points in a call, and what the first calls on a new
// handle cost.
#include "bench/harness.h"
#include "support/handle.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <cstring>
#include <ctime>

namespace {

using namespace bench;
using support::Handle;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The first n points of a curve's case, repeating it if it has fewer.
struct Batch {
    Batch(const Case &data, int64_t n) : period(data.points()), params(static_cast<size_t>(n)) {
        for (size_t i = 0; i < params.size(); ++i) {
            params[i] = data.params[i % data.params.size()];
        }
        points.assign(params.size() * 3, 0.0);
    }
    void evaluate(const nurbs *g) {
        const auto n = static_cast<int64_t>(params.size());
        support::require_ok(nurbs_eval(g, n, params.data(), 0, 0, points.data(), 0, 0, 0));
    }

    int64_t period;
    std::vector<double> params;
    std::vector<double> points;
};

// The case with only those samples that come before point n.
Case head(Case data, int64_t n) {
    const auto kept = static_cast<size_t>(std::ranges::lower_bound(data.sample, n) - data.sample.begin());
    data.sample.resize(kept);
    data.expected.resize(3 * kept);
    data.bounds.resize(3 * kept);
    return data;
}

bool failed = false;

void check(benchmark::State &state, const Case &data, Batch &batch) {
    const auto n = static_cast<int64_t>(batch.params.size());
    Output output;
    output.values.swap(batch.points);
    for (int64_t from = 0; from < n; from += batch.period) {
        output.places = {{static_cast<size_t>(3 * from), 3}};
        if (!(worst_error(head(data, n - from), output) <= 1)) {
            failed = true;
            state.SkipWithError("wrong result");
        }
    }
    output.values.swap(batch.points);
}

void measure_batch(benchmark::State &state, const Case &data, int64_t n) {
    const Handle g = support::create(data.spline);
    Batch batch(data, n);
    batch.evaluate(g.get());
    for ([[maybe_unused]] auto iteration : state) {
        batch.evaluate(g.get());
    }
    check(state, data, batch);
    state.counters["points"] = static_cast<double>(n);
}

// One call on each of many handles, because one alone is shorter than the clock resolves. Handles that have
// answered a call with many points before are warm.
void measure_single(benchmark::State &state, const Case &data, bool warm) {
    Batch batch(data, 1), large(data, 1000);
    constexpr size_t handles = 32;
    for ([[maybe_unused]] auto iteration : state) {
        std::vector<Handle> fresh(handles);
        for (Handle &g : fresh) {
            g = support::create(data.spline);
            if (warm) {
                large.evaluate(g.get());
            }
        }
        const double start = cpu_seconds();
        for (const Handle &g : fresh) {
            batch.evaluate(g.get());
        }
        state.SetIterationTime(cpu_seconds() - start);
    }
    check(state, data, batch);
    state.counters["points"] = handles;
}

// A call with many points on a new handle, and the same call again.
void measure_large(benchmark::State &state, const Case &data, bool warm) {
    Batch batch(data, 100'000);
    for ([[maybe_unused]] auto iteration : state) {
        const Handle g = support::create(data.spline);
        if (warm) {
            batch.evaluate(g.get());
        }
        const double start = cpu_seconds();
        batch.evaluate(g.get());
        state.SetIterationTime(cpu_seconds() - start);
    }
    check(state, data, batch);
    state.counters["points"] = static_cast<double>(batch.params.size());
    state.counters["spans"] =
        static_cast<double>(data.spline.counts[0]) - static_cast<double>(data.spline.degrees[0]);
}

void add_batches(const Case &data, bool large) {
    for (int64_t n = 1000; n <= (large ? 100'000'000 : 10'000'000); n *= 10) {
        benchmark::RegisterBenchmark(("n=" + std::to_string(n)).c_str(), [=, &data](benchmark::State &state) {
            measure_batch(state, data, n);
        })->MeasureProcessCPUTime();
    }
}

void add_pair(const std::string &name, const Case &data, int64_t iterations,
              void (*measure)(benchmark::State &, const Case &, bool)) {
    for (const bool warm : {false, true}) {
        benchmark::RegisterBenchmark((name + (warm ? "_warm" : "_fresh")).c_str(),
                                     [=, &data](benchmark::State &state) { measure(state, data, warm); })
            ->Iterations(iterations)
            ->UseManualTime();
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s DATA_FOLDER [--large] [option of Google Benchmark...]\n", argv[0]);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const Case hundred = read(folder / "curve.case"), many = read(folder / "points_10000.case");
    const bool large = argc > 2 && std::strcmp(argv[2], "--large") == 0;
    add_batches(hundred, large);
    add_pair("single", hundred, 50, measure_single);
    add_pair("large", many, 10, measure_large);
    const int used = large ? 2 : 1;
    argv[used] = argv[0];
    int rest = argc - used;
    benchmark::Initialize(&rest, argv + used);
    benchmark::RunSpecifiedBenchmarks();
    return failed ? 1 : 0;
}
