// SPDX-License-Identifier: MIT
// The arithmetic of patches, vectorised.
#pragma once

#include "pieces/tree/patch_shape.h"

namespace nrb::pieces {

// Q = A - w x, with x = (x, y, ..., 0, ...) padded to the lanes.
void shift_patch(const PatchShape &shape, const double *patch, const double *x, double *out) noexcept;

// All derivatives up to `order` <= 2 at a place in [0, 1]^axes, as records of `lanes` in graded order
// (eval/kernels/slots.h). work: [evaluation_work()].
void evaluate_patch(const PatchShape &shape, const double *patch, const AxisValues &at, int order,
                    double *work, double *out) noexcept;
int64_t evaluation_work(const PatchShape &shape) noexcept;

// The part of a patch between two parameters of an axis, by blossoming; matrix: [degree + 1][degree + 1],
// from part_matrix(). `out` does not overlap `patch`.
void part_matrix(int degree, double lower, double upper, double *matrix) noexcept;
void apply_matrix(const PatchShape &shape, int axis, const double *matrix, const double *patch,
                  double *out) noexcept;

// The records of a larger net that act on a patch: rows along its first axis, `stride` apart, each of
// `middle` runs of `run` doubles, `middle_stride` apart.
struct NetPart {
    const double *first = nullptr;
    int64_t stride = 0;
    int64_t middle = 1, middle_stride = 0;
    int64_t run = 0;
};
// Applies the matrix [n][n] to the rows of a net, which gives those of a patch.
void apply_to_part(const NetPart &net, int n, const double *matrix, double *out) noexcept;

// The Bernstein coefficients of |Q|^2 and of w^2 (not written unless weighted), [products]. work:
// [product_work()].
struct SquareTables {
    const double *binomials = nullptr; // [coefficients] of the patch
    const double *inverses = nullptr;  // [products] reciprocals of the binomials of the product
    const int32_t *offsets = nullptr;  // [coefficients] positions in the net of the product
};
int64_t product_work(const PatchShape &shape) noexcept;
void square_patch(const PatchShape &shape, const SquareTables &tables, const double *patch, double *work,
                  double *squares, double *weights) noexcept;

// out = sign (squares - rho2 weights); returns the least of out - margin weights. weights null: all 1.
double gap_coefficients(int64_t count, const double *squares, const double *weights, double sign, double rho2,
                        double margin, double *out) noexcept;

} // namespace nrb::pieces
