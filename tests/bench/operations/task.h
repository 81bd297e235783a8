// What is measured: operations on curves, one list that every program follows.
#pragma once

#include "support/spline_data.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

enum class Operation { refine, elevate, decompose, remove, compatible };

struct Task {
    std::string name;
    std::string title;
    Operation operation;
    std::vector<support::SplineData> inputs; // one, but for Operation::compatible
    std::vector<double> knots;               // to insert or to remove
    double tolerance = 0;
    bool ours_only = false; // growth with the number of points
};

const std::vector<Task> &tasks();

// One way of using a library: `run` does the whole task once and drops what it made; `results` does it once
// more and gives what was made: the curve, its pieces, or one curve for each input.
struct Work {
    std::function<void()> run;
    std::function<std::vector<support::SplineData>()> results;
};
using Prepare = std::function<Work(const Task &)>; // a Work without functions: not offered

// Names benchmarks task/library and checks every result: the shape within the tolerance of the task, the
// degree, and for removal and compatible curves the number of knots. The result is the exit status.
int run(int argc, char **argv, const std::string &library, const Prepare &prepare);

} // namespace bench
