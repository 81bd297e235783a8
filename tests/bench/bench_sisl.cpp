// SISL: s1227 and s1421 with the span hints of the last call, s1506 on grids.
#include "bench/harness.h"
#include "bench/quotient.h"
#include "bench/rational.h"

#include <algorithm>
#include <memory>
#include <sisl.h>
#include <stdexcept>

namespace {

using namespace bench;
using Curve = std::shared_ptr<SISLCurve>;
using Surface = std::shared_ptr<SISLSurf>;
constexpr int rational_kind = 2; // coefficients (w x, w y, w z, w)
constexpr int copy_arrays = 1;

void require(int status) {
    if (status < 0) {
        throw std::runtime_error("SISL: status " + std::to_string(status));
    }
}

Curve make_curve(const support::SplineData &data) {
    std::vector<double> knots = data.knots[0], points = homogeneous(data);
    return {newCurve(static_cast<int>(data.counts[0]), data.degrees[0] + 1, knots.data(), points.data(),
                     rational_kind, data.dim, copy_arrays),
            freeCurve};
}

// SISL's first direction varies fastest: it is axis 1 here, and the second is axis 0.
Surface make_surface(const support::SplineData &data) {
    std::vector<double> u = data.knots[0], v = data.knots[1], points = homogeneous(data);
    return {newSurf(static_cast<int>(data.counts[1]), static_cast<int>(data.counts[0]), data.degrees[1] + 1,
                    data.degrees[0] + 1, v.data(), u.data(), points.data(), rational_kind, data.dim,
                    copy_arrays),
            freeSurf};
}

// With the two directions exchanged, derivatives of each order come in the opposite order, and normals point
// to the other side.
void exchange_directions(const Job &job, Output &output) {
    for (int order = 1, first = 1; order <= job.order; first += ++order) {
        std::reverse(output.places.begin() + first, output.places.begin() + first + order + 1);
    }
    if (job.normal) {
        output.places.back().sign = -1;
    }
}

Work curve_points(const Job &job, const Case &data, Output &output) {
    return [curve = make_curve(data.spline), order = job.order, &data, &output] {
        int span = 0, status = 0;
        double *out = output.values.data();
        for (const double t : data.params) {
            s1227(curve.get(), order, t, &span, out, &status);
            require(status);
            out += 3 * (order + 1);
        }
    };
}

Work surface_points(const Job &job, const Case &data, Output &output) {
    exchange_directions(job, output);
    return [surface = make_surface(data.spline), job, &data, &output] {
        int span[2] = {0, 0}, status = 0;
        double *out = output.values.data(), normal[3];
        const int slots = job.derivative_slots();
        for (int64_t i = 0; i < data.points(); ++i, out += 3 * job.vectors()) {
            double at[2] = {data.params[static_cast<size_t>(2 * i + 1)],
                            data.params[static_cast<size_t>(2 * i)]};
            s1421(surface.get(), job.order, at, &span[0], &span[1], out, normal, &status);
            require(status);
            if (job.normal) { // s1421 leaves its length as it comes
                normalize(normal, out + 3 * slots);
            }
        }
    };
}

// s1506 writes the normals to an array of their own.
Work surface_grid(const Job &job, const Case &data, Output &output) {
    const auto n = static_cast<size_t>(data.points()), slots = static_cast<size_t>(job.derivative_slots());
    for (size_t slot = 0; slot < slots; ++slot) {
        output.places[slot] = {3 * slot, 3 * slots};
    }
    if (job.normal) {
        output.places[slots] = {3 * slots * n, 3};
    }
    exchange_directions(job, output);
    return [surface = make_surface(data.spline), job, slots, n, &data, &output] {
        std::vector<double> params = data.params;
        double *out = output.values.data();
        const int count[2] = {static_cast<int>(data.grid[0]), static_cast<int>(data.grid[1])};
        int status = 0;
        s1506(surface.get(), job.order, count[1], params.data() + count[0], count[0], params.data(), out,
              job.normal ? out + 3 * slots * n : nullptr, &status);
        require(status);
    };
}

bool offers(const Job &job) {
    return job.group == Group::main && job.axes <= 2;
}

Work prepare(const Job &job, const Case &data, Output &output) {
    if (job.axes == 1) {
        return curve_points(job, data, output);
    }
    return job.params == Params::grid ? surface_grid(job, data, output) : surface_points(job, data, output);
}

} // namespace

int main(int argc, char **argv) {
    return run(argc, argv, {{"SISL", offers, prepare}}, peer_tolerance);
}
