#include "bench/harness.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace bench {

double worst_error(const Case &data, const Output &output) {
    const auto dim = static_cast<size_t>(data.spline.dim);
    double worst = 0;
    size_t at = 0;
    for (const int64_t point : data.sample) {
        for (const Place &place : output.places) {
            const double *values = &output.values[place.start + static_cast<size_t>(point) * place.stride];
            for (size_t c = 0; c < dim; ++c, ++at) {
                const double error = std::abs(place.sign * values[c] - data.expected[at]) / data.bounds[at];
                worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(worst, error);
            }
        }
    }
    return worst;
}

Output packed_output(const Job &job, const Case &data) {
    const auto vectors = static_cast<size_t>(job.vectors()), dim = static_cast<size_t>(job.dim);
    Output output;
    for (size_t v = 0; v < vectors; ++v) {
        output.places.push_back({v * dim, vectors * dim});
    }
    // NaN: what is not written is an error, and writing it touches the memory before it is timed
    output.values.assign(static_cast<size_t>(data.points()) * vectors * dim,
                         std::numeric_limits<double>::quiet_NaN());
    return output;
}

namespace {

bool failed = false;

void fail(benchmark::State &state, const std::string &message) {
    failed = true;
    state.SkipWithError(message.c_str());
}

const Case &load(const std::filesystem::path &path) {
    static std::filesystem::path last;
    static Case data;
    if (last != path) {
        data = read(path);
        last = path;
    }
    return data;
}

void measure(benchmark::State &state, const Job &job, const Route &route, const std::filesystem::path &folder,
             double tolerance) {
    const Case &data = load(folder / (job.name + ".case"));
    Output output = packed_output(job, data);
    const Work work = route.prepare(job, data, output);
    work(); // once to warm up: tables, caches, branch predictors
    std::ranges::fill(output.values, std::numeric_limits<double>::quiet_NaN());
    for ([[maybe_unused]] auto iteration : state) {
        work();
        benchmark::ClobberMemory();
    }
    const double worst = worst_error(data, output);
    state.counters["points"] = static_cast<double>(data.points());
    state.counters["worst"] = worst;
    if (!(worst <= tolerance)) {
        fail(state, "wrong by " + std::to_string(worst) + " bounds");
    }
}

void guarded(benchmark::State &state, const Job &job, const Route &route, const std::filesystem::path &folder,
             double tolerance) {
    try {
        measure(state, job, route, folder, tolerance);
    } catch (const std::exception &error) {
        fail(state, error.what());
    }
}

void add(const Job &job, const Route &route, const std::filesystem::path &folder, double tolerance) {
    benchmark::RegisterBenchmark((job.name + "/" + route.name).c_str(), [=](benchmark::State &state) {
        guarded(state, job, route, folder, tolerance);
    })->MeasureProcessCPUTime();
}

} // namespace

int run(int argc, char **argv, const std::vector<Route> &routes, double tolerance) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s DATA_FOLDER [option of Google Benchmark...]\n", argv[0]);
        return 2;
    }
    for (const Job &job : jobs()) {
        for (const Route &route : routes) {
            if (route.offers(job)) {
                add(job, route, argv[1], tolerance);
            }
        }
    }
    argv[1] = argv[0];
    int rest = argc - 1;
    benchmark::Initialize(&rest, argv + 1);
    benchmark::RunSpecifiedBenchmarks();
    return failed ? 1 : 0;
}

} // namespace bench
