/* SPDX-License-Identifier: MIT */
// Calls every function with random arguments, good and hostile ones, for a while. No call may end the program, take more
// than 2 seconds of the processor (a search of nearest or farthest points, or of levels: for each of them), or hold more than
// three times its result and 500 MB.
//
//     capi_random_calls [--seconds S] [--chunks C] [--seed N] [--steps K] [--verbose]
//
// Chunks of steps run in processes of their own, each with a seed, until S seconds are over or C chunks are done;
// "--seed N --steps K" makes the first K steps of a chunk
// again. At the end it tells how often each function was called and answered, and its longest call.
#include "random/caller.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace random_calls;

constexpr int64_t steps_of_a_chunk = 400;
constexpr double most_seconds = 8, patience = 120;
constexpr int64_t most_held = 500000000, large_result = 100000000;

struct Options {
    double seconds = 60;
    int64_t chunks = 0; // 0: any number
    uint64_t seed = 1;
    int64_t steps = 0; // 0: chunk after chunk
    bool verbose = false;
};

struct Tally {
    int64_t calls, good, refused;
    double longest;
    uint64_t longest_seed;
    int64_t longest_step;
};

// What the processes share.
struct Shared {
    int64_t step;
    size_t call;
    int64_t begun, failures; // steps that have begun; calls that took too much
    Tally tallies[1024];
};

// How many answers a call looks for.
int64_t searches(const char *name, int64_t batch) {
    constexpr std::array each{"closest_points", "closest_local", "farthest_points", "signed_distances",
                              "contours",       "sections",      "reflections"};
    const bool many =
        std::ranges::any_of(each, [name](const char *part) { return std::strstr(name, part) != nullptr; });
    return many ? batch : 1;
}

// Whether it took no more than it may.
bool moderate(const Clock &clock, int64_t searches) {
    return clock.left > large_result || (clock.seconds <= most_seconds * static_cast<double>(searches) &&
                                         clock.peak <= 3 * std::max<int64_t>(clock.left, 0) + most_held);
}

void add(Shared &shared, const Clock &clock, nurbs_status status, uint64_t seed, int64_t step) {
    Tally &tally = shared.tallies[shared.call];
    ++tally.calls;
    ++(status == NURBS_OK ? tally.good : tally.refused);
    if (clock.seconds > tally.longest) {
        tally.longest = clock.seconds;
        tally.longest_seed = seed;
        tally.longest_step = step;
    }
}

// A chunk, in its own process.
void run_chunk(Shared &shared, const Options &options, uint64_t seed) {
    const std::span<const RandomCall> table = random_calls::random_calls();
    const calls::Inputs in = calls::make_inputs();
    Source source;
    Random random(seed);
    const int64_t steps = options.steps > 0 ? options.steps : steps_of_a_chunk;
    for (int64_t step = 1; step <= steps; ++step) {
        const auto call = static_cast<size_t>(random.below(static_cast<int>(table.size())));
        shared.step = step;
        shared.call = call;
        ++shared.begun;
        source.tells = options.verbose && step == options.steps;
        source.begin(seed * 1000003 + static_cast<uint64_t>(step));
        Clock clock;
        const nurbs_status status = table[call].run(source, in, clock);
        add(shared, clock, status, seed, step);
        const bool good = moderate(clock, searches(table[call].name, source.batch()));
        shared.failures += good ? 0 : 1;
        if (!good || source.tells) {
            std::printf("%s: %s, %.3f s, %.0f MB held, %.0f MB left: --seed %llu --steps %lld\n",
                        table[call].name, nurbs_status_name(status), clock.seconds,
                        1e-6 * static_cast<double>(clock.peak), 1e-6 * static_cast<double>(clock.left),
                        static_cast<unsigned long long>(seed), static_cast<long long>(step));
            std::fflush(stdout);
        }
    }
    calls::destroy(in);
}

// Whether the process ended by itself. It is ended when a step takes more than `patience` seconds.
bool ended_well(pid_t child, const Shared &shared, uint64_t seed) {
    int64_t step = -1;
    double waited = 0;
    for (int state = 0;; usleep(20000), waited += 0.02) {
        if (shared.begun != step) {
            step = shared.begun;
            waited = 0;
        }
        if (waitpid(child, &state, WNOHANG) == child) {
            if (state != 0) {
                std::printf("%s ends the program (state %d): --seed %llu --steps %lld\n",
                            random_calls::random_calls()[shared.call].name, state,
                            static_cast<unsigned long long>(seed), static_cast<long long>(shared.step));
            }
            return state == 0;
        }
        if (waited > patience) {
            std::printf("%s does not end in %.0f s: --seed %llu --steps %lld\n",
                        random_calls::random_calls()[shared.call].name, patience,
                        static_cast<unsigned long long>(seed), static_cast<long long>(shared.step));
            kill(child, SIGKILL);
            waitpid(child, &state, 0);
            return false;
        }
    }
}

int64_t run_chunks(Shared &shared, const Options &options) {
    int64_t failures = 0;
    timespec start{}, now{};
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (uint64_t seed = options.seed;; ++seed) {
        std::fflush(stdout);
        const pid_t child = fork();
        if (child == 0) {
            run_chunk(shared, options, seed);
            std::fflush(stdout);
            _exit(0);
        }
        failures += ended_well(child, shared, seed) ? 0 : 1;
        clock_gettime(CLOCK_MONOTONIC, &now);
        const auto chunks = static_cast<int64_t>(seed - options.seed + 1);
        if (options.steps > 0 || chunks == options.chunks ||
            static_cast<double>(now.tv_sec - start.tv_sec) >= options.seconds) {
            return failures + shared.failures;
        }
    }
}

// By the names of functions, since some have several calls. Returns how many were called and never answered.
int64_t tell(const Shared &shared, bool enough) {
    const std::span<const RandomCall> table = random_calls::random_calls();
    int64_t silent = 0;
    Tally total{};
    for (size_t i = 0; i < table.size(); ++i) {
        const Tally &tally = shared.tallies[i];
        total.calls += tally.calls;
        total.good += tally.good;
        total.longest = std::max(total.longest, tally.longest);
        std::printf("%-44s %7lld calls, %7lld good, longest %8.3f ms (--seed %llu --steps %lld)\n",
                    table[i].name, static_cast<long long>(tally.calls), static_cast<long long>(tally.good),
                    1e3 * tally.longest, static_cast<unsigned long long>(tally.longest_seed),
                    static_cast<long long>(tally.longest_step));
        if (enough && tally.good == 0) {
            std::printf("%s has never answered\n", table[i].name);
            ++silent;
        }
    }
    std::printf("random calls: %lld calls, %lld good, longest %.3f s\n", static_cast<long long>(total.calls),
                static_cast<long long>(total.good), total.longest);
    return silent;
}

bool read(int argc, char **argv, Options &options) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--verbose") {
            options.verbose = true;
        } else if (i + 1 < argc && word == "--seconds") {
            options.seconds = std::atof(argv[++i]);
        } else if (i + 1 < argc && word == "--chunks") {
            options.chunks = std::atoll(argv[++i]);
        } else if (i + 1 < argc && word == "--seed") {
            options.seed = std::strtoull(argv[++i], nullptr, 10);
        } else if (i + 1 < argc && word == "--steps") {
            options.steps = std::atoll(argv[++i]);
        } else {
            return false;
        }
    }
    return true;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    if (!read(argc, argv, options)) {
        std::fprintf(
            stderr,
            "usage: capi_random_calls [--seconds S] [--chunks C] [--seed N] [--steps K] [--verbose]\n");
        return 2;
    }
    void *memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    constexpr const char *file = "capi_random_calls.igs"; // which some calls read
    if (memory == MAP_FAILED || !calls::write_files(file)) {
        std::perror("capi_random_calls");
        return 2;
    }
    auto &shared = *static_cast<Shared *>(memory);
    const int64_t failures = run_chunks(shared, options);
    const int64_t silent = tell(shared, options.steps == 0 && shared.begun > 100000);
    calls::remove_files();
    return failures + silent == 0 ? 0 : 1;
}
