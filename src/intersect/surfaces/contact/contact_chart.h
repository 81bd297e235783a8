// SPDX-License-Identifier: MIT
// Charts for tangential contact: parts of two surfaces that touch along one curve and nowhere else.
#pragma once

#include "intersect/surfaces/contact/contact_point.h"

#include <array>

namespace nrb::intersect {

// Take the tangent plane at a place of contact, with normal n and coordinates x along the contact curve and y
// across it. Over this plane the two parts are graphs a(x, y) and b(x, y); let h = a - b. The second
// derivatives of a and b, and so of h, are bounded over both wide parts from derivatives of the surfaces: for
// a part with parameters q, let S(q) be its point, (x, y)(q) the foot of S in the plane and J = d(x, y) / dq.
// Then with q_i = J^-1 e_i
//     a_ij = n . S''(q_i, q_j) - (n . S') J^-1 (x, y)''(q_i, q_j).
// If h_yy has no zero, h has one least (or largest) value on each line along y. The places of these make a
// curve, the ridge. Along it h changes by (h_xx - h_xy^2 / h_yy) dx^2 / 2 between places where h and h_x are
// 0. If |h| <= d on all of the ridge, all common points of both parts are within sqrt(2 d / |h_yy|) of it.
class ContactChart {
public:
    explicit ContactChart(const ContactSolver &solver) : solver_(solver) {}

    enum class Verdict {
        contact, // h_yy has no zero, and at place() h is 0 to rounding
        // At a place of the ridge h is not 0, or it bends too much along the ridge, or too little across, for
        // a contact along a curve.
        apart,
        open, // neither is known
    };
    Verdict look(const CrossCell &a, const CrossCell &b);
    // A place of contact, in or beside the parts.
    [[nodiscard]] const ContactPoint &place() const noexcept { return place_; }
    // A bound of |h_xx - h_xy^2 / h_yy|.
    [[nodiscard]] double change() const noexcept;

private:
    bool set_bends(const CrossCell &a, const CrossCell &b);
    [[nodiscard]] bool is_near(const CrossCell &cell, size_t surface, const ContactPoint &point) const;

    const ContactSolver &solver_;
    ContactPoint place_;
    std::array<Interval, 3> bends_{}; // h_xx, h_xy, h_yy
};

} // namespace nrb::intersect
