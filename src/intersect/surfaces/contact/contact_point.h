// SPDX-License-Identifier: MIT
// Places where two surfaces touch along a curve, by Newton's method.
#pragma once

#include "intersect/surfaces/cross_cell.h"
#include "intersect/surfaces/cross_chart.h"

#include <optional>

namespace nrb::intersect {

// The height of surface A over surface B is h = (A - B) . n, where B is the foot of A and n the normal of B
// there. Where both are tangent, the second derivatives of h are the difference of both second fundamental
// forms (X. Ye & T. Maekawa, CAGD 16 (1999)). Along a contact curve h and its gradient are 0, and the
// direction of the curve is a principal direction of that difference, with second derivative 0.
struct ContactPoint {
    CrossPlace at{}; // parameters of both; they may leave the domain where a surface closes
    Vector3 a, b;    // points of both
    Vector3 normal;  // of B, of length 1
    double height = 0;
    Vector3 along, across;              // unit vectors along which h bends least and most
    CrossPlace along_on{}, across_on{}; // the same in the parameters of both
    double least = 0, most = 0;         // second derivatives of h along and across
    double slope = 0;                   // derivative of h across
};

class ContactSolver {
public:
    ContactSolver(CrossGround &a, CrossGround &b) : grounds_{&a, &b} {}

    [[nodiscard]] CrossGround &ground(size_t surface) const noexcept { return *grounds_[surface]; }
    // The error of points of both surfaces, over the pieces that were evaluated so far.
    [[nodiscard]] double error() const noexcept { return errors_[0] + errors_[1]; }
    // The place of the ridge near another place: B is the foot of A there, and the derivative of h across is
    // 0, both to rounding. None: it is not found.
    [[nodiscard]] std::optional<ContactPoint> ridge(CrossPlace at) const;

    // Moves a place that is beyond the ends of a surface along the ridge into the domains of both.
    [[nodiscard]] std::optional<ContactPoint> in_domain(const ContactPoint &point) const;
    // The middle of a part of surface `surface`, with its foot on the other surface, which is searched from
    // the middle of `other`; none: it is not found.
    [[nodiscard]] std::optional<CrossPlace> from_middle(const CrossCell &part, size_t surface,
                                                        const CrossCell &other) const;

    // The piece of a surface with these parameters, which are moved by periods where the surface closes.
    [[nodiscard]] const CrossPiece *piece_at(size_t surface, const double *at) const;
    // Parameters as a place in a piece, or beyond it.
    [[nodiscard]] std::array<double, 2> place_in(size_t surface, const CrossPiece &piece,
                                                 const double *at) const;

private:
    struct Jet {
        Vector3 at;
        std::array<Vector3, 2> first;
        std::array<Vector3, 3> second; // by parameters: 00, 01, 11
    };
    // The point with its first and second derivatives; none: weights are not positive, a degree is 0, or it
    // is far beyond the domain.
    [[nodiscard]] std::optional<Jet> jet(size_t surface, const double *at) const;
    static bool set(const Jet &a, const Jet &b, ContactPoint &point) noexcept;

    std::array<CrossGround *, 2> grounds_;
    mutable std::array<double, 2> errors_{};
};

// Heights that are no larger are taken for 0; error: of points.
constexpr double zero_height(double error) noexcept {
    return 64 * error;
}

// The derivative of the parameters as the point moves along a vector of the tangent plane (least squares).
std::array<double, 2> parameters_along(const std::array<Vector3, 2> &slope, const Vector3 &vector) noexcept;

} // namespace nrb::intersect
