// The C API for tests: handles that free themselves, calls that must succeed, results as vectors.
#pragma once

#include "support/spline_data.h"

#include <memory>
#include <nurbs/nurbs.h>
#include <vector>

namespace support {

struct Destroy {
    void operator()(nurbs *g) const noexcept { nurbs_destroy(g); }
};
using Handle = std::unique_ptr<nurbs, Destroy>;

// Throws std::runtime_error with the status' name and the message of nurbs_last_error() unless status is
// NURBS_OK.
void require_ok(nurbs_status status);
std::string last_error();

// What a call makes that is given the place of its handle.
template <class Call>
Handle made(Call &&call) {
    nurbs *out = nullptr;
    require_ok(call(&out));
    return Handle(out);
}

nurbs_status try_create(const SplineData &data, Handle &out);
Handle create(const SplineData &data);
SplineData read_back(const nurbs *g);
std::vector<double> homogeneous_points(const nurbs *g);

// Packed params of n = params.size() / axes points; packed results.
std::vector<double> eval(const nurbs *g, const std::vector<double> &params, uint32_t flags = 0);
std::vector<double> eval_derivs(const nurbs *g, int order, const std::vector<double> &params,
                                uint32_t flags = 0);
std::vector<double> hull_sizes(const nurbs *g, const std::vector<double> &params, uint32_t flags = 0);
std::vector<double> rational_basis(const nurbs *g, const std::vector<double> &params, uint32_t flags = 0);
std::vector<double> eval_grid(const nurbs *g, const std::vector<std::vector<double>> &params,
                              uint32_t flags = 0);
std::vector<double> eval_grid_derivs(const nurbs *g, int order,
                                     const std::vector<std::vector<double>> &params, uint32_t flags = 0);
Handle insert(const nurbs *g, int axis, double knot, int times);
Handle elevate(const nurbs *g, int axis, int times);
Handle iso(const nurbs *g, int axis, double param, uint32_t flags = 0);

// Equal as 64-bit patterns, so that -0 differs from 0 and a NaN equals itself.
bool same_bits(double a, double b);
bool same_bits(const std::vector<double> &a, const std::vector<double> &b);

} // namespace support
