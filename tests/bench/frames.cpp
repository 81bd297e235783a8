#include "bench/frames.h"

#include "bench/quotient.h"

namespace bench {

namespace {

constexpr int64_t record = 12;

void add_normals(int64_t n, double *out) {
    for (int64_t i = 0; i < n; ++i, out += record) {
        unit_normal(out + 3, out + 6, out + 9);
    }
}

} // namespace

nurbs_status frames(const nurbs *g, int64_t n, const double *params, double *out) {
    const nurbs_status status = nurbs_eval_derivs(g, 1, n, params, 0, 0, out, record, 0, 0);
    if (status == NURBS_OK) {
        add_normals(n, out);
    }
    return status;
}

nurbs_status grid_frames(const nurbs *g, const int64_t *counts, const double *params, double *out) {
    const nurbs_status status = nurbs_eval_grid_derivs(g, 1, counts, params, out, record, 0, 0);
    if (status == NURBS_OK) {
        add_normals(counts[0] * counts[1], out);
    }
    return status;
}

} // namespace bench
