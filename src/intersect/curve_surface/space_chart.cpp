// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/space_chart.h"

#include "intersect/extent.h"
#include "numeric/vector3.h"

#include <cmath>

namespace nrb::intersect {

namespace {

using Rows = std::array<std::array<double, 3>, 3>;

Vector3 vector_of(const double *x) noexcept {
    return {x[0], x[1], x[2]};
}

// Sets the inverse of (c, -u, -v) and returns the determinant; 0 if that is too small to be certain.
double invert(const double *c, const double *u, const double *v, Rows &rows) noexcept {
    const Vector3 a = vector_of(c), b = vector_of(u), d = vector_of(v), across = cross(b, d);
    const double determinant = dot(a, across);
    if (!(std::abs(determinant) > 1e-12 * length(a) * length(b) * length(d))) {
        return 0;
    }
    const Vector3 of_u = cross(a, d), of_v = cross(b, a);
    const double factor = 1 / determinant;
    rows = {{{factor * across.x, factor * across.y, factor * across.z},
             {factor * of_u.x, factor * of_u.y, factor * of_u.z},
             {factor * of_v.x, factor * of_v.y, factor * of_v.z}}};
    return determinant;
}

Place<3> times(const Rows &rows, const double *x) noexcept {
    return {dot(rows[0].data(), x, 3), dot(rows[1].data(), x, 3), dot(rows[2].data(), x, 3)};
}

// The largest |row . d - wanted| of a vector d of the hull.
double deviation(const double *row, const pieces::Slopes &slopes, double wanted) noexcept {
    double most = 0;
    for (size_t i = 0; i < slopes.count(); ++i) {
        most = std::max(most, std::abs(dot(row, slopes.vector(i), 3) - wanted));
    }
    return most;
}

} // namespace

bool newton_step(const double *c, const double *u, const double *v, const double *difference,
                 Place<3> &step) noexcept {
    Rows rows;
    if (invert(c, u, v, rows) == 0) {
        return false;
    }
    step = times(rows, difference);
    return true;
}

void SpaceChart::set(const pieces::SlopedPiece &arc, const SlopedPatch &patch) {
    contraction_ = {};
    const double determinant = invert(arc.slopes->mean(), patch.mean(0), patch.mean(1), rows_);
    turn_ = determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
    if (turn_ == 0) {
        return;
    }
    for (const auto &row : rows_) {
        contraction_.norm = std::max(contraction_.norm, norm(row.data(), 3));
    }
}

void SpaceChart::prove(const pieces::SlopedPiece &arc, const SlopedPatch &patch) {
    if (turn_ == 0) {
        return;
    }
    contraction_.rho = least_rho(arc, patch);
    if (contraction_.proven()) {
        set_rho(arc, patch);
    }
}

// A lower bound on rho, from the ends of the curve and the corners of the surface, whose derivatives are in
// the hulls.
double SpaceChart::least_rho(const pieces::SlopedPiece &arc, const SlopedPatch &patch) noexcept {
    double most = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double *row = rows_[k].data();
        const auto off = [&](const double *slope, size_t column) {
            return std::abs(dot(row, slope, 3) - (k != column ? 0 : k == 0 ? 1 : -1));
        };
        const double of_curve =
            std::max(off(arc.slopes->vector(0), 0), off(arc.slopes->vector(arc.slopes->count() - 1), 0));
        double of_u = 0, of_v = 0;
        for (int i = 0; i < 4; ++i) {
            of_u = std::max(of_u, off(patch.slopes->corner(0, i), 1));
            of_v = std::max(of_v, off(patch.slopes->corner(1, i), 2));
        }
        if (of_curve + of_u + of_v > most) {
            most = of_curve + of_u + of_v;
            curve_bends_more_ = of_curve > of_u + of_v;
        }
    }
    return most;
}

void SpaceChart::set_rho(const pieces::SlopedPiece &arc, const SlopedPatch &patch) {
    const pieces::Slopes &c = *arc.slopes, &u = patch.along(0), &v = patch.along(1);
    const double errors = c.error() + u.error() + v.error(), sizes = c.largest() + u.largest() + v.largest();
    contraction_.rho = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double *row = rows_[k].data();
        const double of_curve = deviation(row, c, k == 0 ? 1 : 0),
                     of_surface = deviation(row, u, k == 1 ? -1 : 0) + deviation(row, v, k == 2 ? -1 : 0),
                     off = of_curve + of_surface + norm(row, 3) * (1.01 * errors + 8 * eps * sizes);
        if (off > contraction_.rho) {
            contraction_.rho = off;
            curve_bends_more_ = of_curve > of_surface;
        }
    }
}

bool SpaceChart::excludes(const pieces::SlopedPiece &arc, const SlopedPatch &patch,
                          double near) const noexcept {
    const double moved = arc.piece->moved() + patch.piece->moved();
    return std::any_of(rows_.begin(), rows_.end(), [&](const std::array<double, 3> &row) {
        const Interval c = extent_along(*arc.piece, row.data()), s = extent_along(*patch.piece, row.data());
        const double size =
            std::max({std::abs(c.lower), std::abs(c.upper), std::abs(s.lower), std::abs(s.upper)});
        const double gap = std::max(c.lower - s.upper, s.lower - c.upper);
        return gap > 1.0001 * contraction_.norm * (near + moved) + 12 * eps * (size + contraction_.norm);
    });
}

Place<3> SpaceChart::step(const double *difference) const noexcept {
    return times(rows_, difference);
}

} // namespace nrb::intersect
