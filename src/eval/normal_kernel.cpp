#include "eval/normal_kernel.h"

#include "eval/blocks.h"
#include "eval/vector3.h"

#include <bit>
#include <cmath>

namespace nrb {

namespace {

constexpr int64_t y = block_size;
constexpr int64_t z = 2 * block_size;

double square(const double *rows, int64_t i) noexcept {
    return rows[i] * rows[i] + rows[y + i] * rows[y + i] + rows[z + i] * rows[z + i];
}

} // namespace

// (a + b)^2 <= 2 (a^2 + b^2) spares the roots of |S_u| and |S_v|. No branches and no early end, so that
// compilers turn the loops into vector instructions; each operation is rounded as in scalar code.
bool unit_normals(const double *du, const double *dv, int64_t count, double error_u, double error_v,
                  double *__restrict normals, double *__restrict doubtful) noexcept {
    const double factor_u = 2 * error_v * error_v;
    const double factor_v = 2 * error_u * error_u;
    for (int64_t i = 0; i < count; ++i) {
        const double nx = du[y + i] * dv[z + i] - du[z + i] * dv[y + i];
        const double ny = du[z + i] * dv[i] - du[i] * dv[z + i];
        const double nz = du[i] * dv[y + i] - du[y + i] * dv[i];
        const double squared = nx * nx + ny * ny + nz * nz;
        const double inverse = 1 / std::sqrt(squared);
        normals[i] = nx * inverse;
        normals[y + i] = ny * inverse;
        normals[z + i] = nz * inverse;
        const double noise = square(du, i) * factor_u + square(dv, i) * factor_v;
        const double bound = noise <= least_square ? least_square : noise; // NaN stays
        doubtful[i] = (squared > bound) & (squared < largest_square) ? 0.0 : 1.0;
    }
    uint64_t any = 0; // an integer, because doubles are added in their order
    for (int64_t i = 0; i < count; ++i) {
        any |= std::bit_cast<uint64_t>(doubtful[i]);
    }
    return any != 0;
}

} // namespace nrb
