// SPDX-License-Identifier: MIT
// Shapes of any size for calls that once ran for very long.
#pragma once

#include <nurbs/nurbs.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

namespace ends {

struct Destroy {
    void operator()(nurbs *g) const noexcept { nurbs_destroy(g); }
};
using Shape = std::unique_ptr<nurbs, Destroy>;

// Ends the program with the library's message unless the call went well.
void good(nurbs_status status);

// The coordinates, and the weight if the shape is rational, at the Greville abscissae.
using Net = std::function<void(const double *at, double *point, double *weight)>;
Shape make(int axes, int degree, int64_t count, int dim, bool rational, const Net &net);

double random_number(); // in [-1, 1], the same ones in every run

Shape noise(int axes, int degree, int64_t count, int dim,
            double weights = 1);                         // weights: the ratio of the largest
Shape wave(int degree, int64_t count, double shift = 0); // a curve in space
Shape hill(int degree, int64_t count);
Shape block(int degree, int64_t count, double weights = 1);
Shape circle(double radius);
Shape repeated(const nurbs *curve, int64_t times); // a closed curve run several times
Shape coils(int64_t turns);                        // over each other, a little apart
Shape sphere(double radius);
Shape refined(const nurbs *g, int64_t parts); // of each span, on every axis
Shape moved(const nurbs *g, double scale, std::array<double, 3> by);

} // namespace ends
