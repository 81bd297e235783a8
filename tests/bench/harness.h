// Timing one library on the jobs that it offers, and checking what it computed.
#pragma once

#include "bench/case.h"
#include "bench/jobs.h"

#include <functional>

namespace bench {

// Where one vector of the result stands: vector of point i begins at values[start + i * stride], and has to
// be multiplied by `sign`.
struct Place {
    size_t start = 0;
    size_t stride = 0;
    double sign = 1;
};

// Results in the layout that suits the library. It begins as packed records of job.vectors() vectors.
struct Output {
    std::vector<double> values;
    std::vector<Place> places;
};

using Work = std::function<void()>; // computes the whole job once

// One way of using a library. `prepare` builds its objects and may change the layout of the output.
struct Route {
    std::string name;
    bool (*offers)(const Job &);
    Work (*prepare)(const Job &, const Case &, Output &);
};

// The largest error in units of the bounds of nurbs.h; infinite for NaN.
double worst_error(const Case &data, const Output &output);

Output packed_output(const Job &job, const Case &data);

// Reads the data folder from argv[1] and gives the rest to Google Benchmark. Benchmarks are named
// job/route. An error above `tolerance` makes the benchmark an error, not a time. The result is the exit
// status.
int run(int argc, char **argv, const std::vector<Route> &routes, double tolerance);

// For libraries that promise no bounds: far above their rounding errors, far below any mistake.
constexpr double peer_tolerance = 1e3;

} // namespace bench
