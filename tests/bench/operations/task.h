// What is measured: operations on curves, and shapes made of them; one list that every program follows.
#pragma once

#include "support/spline_data.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

enum class Operation { refine, elevate, decompose, remove, compatible, circle, revolve, ruled, coons };

// The circle about this point in the plane through it that is parallel to x and y.
constexpr double circle_center[3] = {1, 2, 3};
constexpr double circle_radius = 1.5;

struct Task {
    std::string name;
    std::string title;
    Operation operation;
    // None for a circle; the profile, turned about the z axis; the two ends of a ruled surface; the
    // boundaries of a Coons surface at u = 0, u = 1, v = 0, v = 1; many curves to be made compatible;
    // otherwise one.
    std::vector<support::SplineData> inputs;
    std::vector<double> knots; // to insert or to remove
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

// Throws std::runtime_error unless the circle or surface is what its defining formula says, to within
// rounding. How the angle of a circle or a surface of revolution is parametrised, and how rulings are
// divided, is free.
void check_made(const Task &task, const support::SplineData &result);

// Names benchmarks task/library and checks every result: what is made by its formula, else the shape within
// the tolerance of the task, the degree, and for removal and compatible curves the number of knots. The
// result is the exit status.
int run(int argc, char **argv, const std::string &library, const Prepare &prepare);

} // namespace bench
