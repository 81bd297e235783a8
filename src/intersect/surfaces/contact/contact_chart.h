// SPDX-License-Identifier: MIT
// Parts of two surfaces that touch along one curve and nowhere else.
#pragma once

#include "intersect/surfaces/contact/contact_point.h"

#include <array>

namespace nrb::intersect {

// Over the plane of tangents at a place of contact, with the directions x along it and y across, both parts are graphs a(x, y) and
// b(x, y). Bounds of all second derivatives of h = a - b over both wide parts follow from those of the parts: with q the parameters,
// a part of which is at (x, y)(q) and J = d(x, y) / dq,
//     a_ij = n . S(q_i, q_j) - (n . S') J^-1 (x, y)''(q_i, q_j),   q_i = J^-1 e_i.
// If h_yy is nowhere 0, h has one least (or largest) value on each line along y: a curve, on which h changes by
// (h_xx - h_xy^2 / h_yy) dx^2 / 2 between places where h and h_x are 0. So where |h| <= d on all of it, all common points are
// within sqrt(2 d / |h_yy|) of it.
class ContactChart {
public:
    explicit ContactChart(const ContactSolver &solver) : solver_(solver) {}

    enum class Verdict {
        contact, // h_yy is nowhere 0, and at place() h is 0 to rounding
        apart,   // it is not 0 where it is least or largest in one place
        open,
    };
    Verdict look(const CrossCell &a, const CrossCell &b);
    // A place of contact, in or beside the parts.
    [[nodiscard]] const ContactPoint &place() const noexcept { return place_; }
    // The largest |h_xx - h_xy^2 / h_yy|.
    [[nodiscard]] double change() const noexcept;

private:
    bool set_bends(const CrossCell &a, const CrossCell &b);
    [[nodiscard]] bool is_near(const CrossCell &cell, size_t surface, const ContactPoint &point) const;

    const ContactSolver &solver_;
    ContactPoint place_;
    std::array<Interval, 3> bends_{}; // h_xx, h_xy, h_yy
};

} // namespace nrb::intersect
