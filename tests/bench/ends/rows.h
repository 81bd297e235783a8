// SPDX-License-Identifier: MIT
// Calls with the time that they may take.
#pragma once

#include "shapes.h"

#include <functional>
#include <string>
#include <vector>

namespace ends {

double seconds(const std::function<void()> &call);

struct Found {
    double time;
    std::string what;
};

// format: a constant with at most two %g.
Found told(double time, const char *format, double a = 0, double b = 0);
// A call that returns a status: what it was.
Found called(const std::function<nurbs_status()> &call);
Found made(const std::function<nurbs_status(nurbs **)> &call);

struct Row {
    std::string name;
    double limit; // seconds
    std::function<Found()> run;
};
const std::vector<Row> &all_rows();
void row(std::string name, double limit, std::function<Found()> run);
std::string numbered(const char *name, int64_t number);

void meets(); // rows of meets.cpp

} // namespace ends
