// SPDX-License-Identifier: MIT
// Places where two surfaces touch along curves.
#pragma once

#include "intersect/surfaces/cross_cell.h"
#include "intersect/surfaces/cross_chart.h"

#include <optional>

namespace nrb::intersect {

// The height of a surface over another one is h = (A - B) . n at the foot of A on B, n the normal there. Its second derivatives
// along the surface are the difference of both second fundamental forms (X. Ye & T. Maekawa, CAGD 16 (1999)). Along a curve of
// contact h = 0, its gradient is 0, and one of these forms' directions is that of the curve.
struct ContactPoint {
    CrossPlace at{}; // parameters of both, which may run beyond the domain where this closes
    Vector3 a, b;    // points
    Vector3 normal;  // of length 1
    double height = 0;
    Vector3 along, across;              // of length 1: where h bends least and most
    CrossPlace along_on{}, across_on{}; // the same in the parameters
    double least = 0, most = 0;         // second derivatives of h there
    double slope = 0;                   // of h across
};

class ContactSolver {
public:
    ContactSolver(CrossGround &a, CrossGround &b) : grounds_{&a, &b} {}

    [[nodiscard]] CrossGround &ground(size_t surface) const noexcept { return *grounds_[surface]; }
    // Of points of both surfaces, of the pieces that have been looked at.
    [[nodiscard]] double error() const noexcept { return errors_[0] + errors_[1]; }
    // The place near one where h is least or largest across, to rounding; none: it is not found.
    [[nodiscard]] std::optional<ContactPoint> ridge(CrossPlace at) const;

    // Along the ridge to where both surfaces are, if it is beyond their ends.
    [[nodiscard]] std::optional<ContactPoint> in_domain(const ContactPoint &point) const;
    // From the middle of a part to the foot on another one; none: it is not found.
    [[nodiscard]] std::optional<CrossPlace> from_middle(const CrossCell &part, size_t surface,
                                                        const CrossCell &other) const;

    // The piece of a surface with a parameter, of which those beyond domains that close are moved by periods.
    [[nodiscard]] const CrossPiece *piece_at(size_t surface, const double *at) const;
    // The places of parameters in a piece, or beyond it.
    [[nodiscard]] std::array<double, 2> place_in(size_t surface, const CrossPiece &piece,
                                                 const double *at) const;

private:
    struct Jet {
        Vector3 at;
        std::array<Vector3, 2> first;
        std::array<Vector3, 3> second; // by both parameters: 00, 01, 11
    };
    [[nodiscard]] std::optional<Jet> jet(size_t surface, const double *at) const;
    static bool set(const Jet &a, const Jet &b, ContactPoint &point) noexcept;

    std::array<CrossGround *, 2> grounds_;
    mutable std::array<double, 2> errors_{};
};

// Heights that are no larger are 0 as far as errors of points let it be seen.
constexpr double zero_height(double error) noexcept {
    return 64 * error;
}

// How fast parameters go where a point goes along a vector of the plane of tangents.
std::array<double, 2> parameters_along(const std::array<Vector3, 2> &slope, const Vector3 &vector) noexcept;

} // namespace nrb::intersect
