// This library, through its C interface, as a user calls it.
#include "bench/nurbs_work.h"

#include "support/handle.h"

namespace bench {

namespace {

using SharedHandle = std::shared_ptr<nurbs>;

void require(nurbs_status status) {
    if (status != NURBS_OK) {
        support::require_ok(status);
    }
}

Work single_calls(const SharedHandle &g, const Case &data, Output &output) {
    return [g, &data, &output] {
        const double *param = data.params.data();
        double *point = output.values.data();
        const int dim = data.spline.dim;
        for (int64_t i = 0; i < data.points(); ++i, ++param, point += dim) {
            require(nurbs_eval(g.get(), 1, param, 0, 0, point, 0, 0, 0));
        }
    };
}

// Points, first derivatives and normals: four arrays of packed vectors.
Work frames(const SharedHandle &g, const Job &job, const Case &data, Output &output) {
    const auto size = static_cast<size_t>(3 * data.points());
    output.places = {{0, 3}, {size, 3}, {2 * size, 3}, {3 * size, 3}};
    double *const points = output.values.data();
    double *const du = points + size;
    double *const dv = du + size;
    double *const normals = dv + size;
    if (job.params == Params::grid) {
        return [=, &data] {
            require(nurbs_surface_eval_grid_frames(g.get(), data.grid.data(), data.params.data(), points, 0,
                                                   0, du, 0, 0, dv, 0, 0, normals, 0, 0, nullptr, 0));
        };
    }
    return [=, &data] {
        require(nurbs_surface_eval_frames(g.get(), data.points(), data.params.data(), 0, 0, points, 0, 0, du,
                                          0, 0, dv, 0, 0, normals, 0, 0, nullptr, 0));
    };
}

Work grid(const SharedHandle &g, const Case &data, Output &output) {
    return [g, &data, &output] {
        require(
            nurbs_eval_grid(g.get(), data.grid.data(), data.params.data(), output.values.data(), 0, 0, 0));
    };
}

Work scattered(const SharedHandle &g, const Job &job, const Case &data, Output &output) {
    const int64_t n = data.points();
    if (job.order > 0) {
        return [g, n, order = job.order, &data, &output] {
            require(nurbs_eval_derivs(g.get(), order, n, data.params.data(), 0, 0, output.values.data(), 0, 0,
                                      0));
        };
    }
    return [g, n, &data, &output] {
        require(nurbs_eval(g.get(), n, data.params.data(), 0, 0, output.values.data(), 0, 0, 0));
    };
}

} // namespace

Work nurbs_work(const Job &job, const Case &data, Output &output) {
    const SharedHandle g = support::create(data.spline);
    if (job.normal) {
        return frames(g, job, data, output);
    }
    switch (job.params) {
    case Params::single:
        return single_calls(g, data, output);
    case Params::grid:
        return grid(g, data, output);
    default:
        return scattered(g, job, data, output);
    }
}

} // namespace bench
