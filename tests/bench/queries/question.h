// What is asked: closest points and lengths; one list that every program follows.
#pragma once

#include "support/spline_data.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

enum class Kind { closest, length };

struct Question {
    std::string name;
    std::string title;
    Kind kind;
    support::SplineData shape;  // in space
    std::vector<double> points; // [n][3], of closest points
    double tolerance = 0;       // of a length, relative
};

const std::vector<Question> &questions();

// The answer: the parameters of closest points [n][axes], NaN where none was found; or the length.
using Ask = std::function<std::vector<double>()>;

// One way of using a library; an Ask without a function: not offered.
struct Route {
    std::string name;
    std::function<Ask(const Question &)> prepare;
};

// Names benchmarks question/route. Of closest points `wrong` counts, as a part of all, those for which
// another point is nearer by more than `allowed`; of lengths `error` is the relative one. Neither stops
// others, ours have to be right. The result is the exit status.
constexpr double allowed = 1e-6;
int run(int argc, char **argv, const std::vector<Route> &routes);

} // namespace bench
