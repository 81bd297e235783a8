// SPDX-License-Identifier: MIT
// A part of a surface that lies along a piece of another one.
#pragma once

#include "intersect/surfaces/cross_cell.h"

namespace nrb::intersect {

using PlaceBox = std::array<Interval, 2>;

inline bool have_common(const PlaceBox &a, const PlaceBox &b) noexcept {
    return a[0].lower <= b[0].upper && b[0].lower <= a[0].upper && a[1].lower <= b[1].upper &&
           b[1].lower <= a[1].upper;
}

// Over the part of A a polynomial psi of places on B, by interpolation between feet along the normal n of B in the middle of a
// box that holds psi. Let M be the inverse of the derivative of B across n there, |I - M B'| <= rho < 1 on the box,
// which is widened. If |M (A - B(psi))| <= g, each place of the part has just one foot along n in the box, no farther from psi than
// r = g / (1 - rho) (R. Krawczyk 1969), and no farther from it in space than |n . (A - B(psi))| + r (|n . B_s| + |n . B_t|).
// Times both weights these differences are polynomials of the place on A: of degrees m and n they are at most twice as
// large as at (2 m + 1) (2 n + 1) Chebyshev points (see CrossFitter).
class OverlapMap {
public:
    // tolerance: in the frame.
    explicit OverlapMap(double tolerance);

    enum class Verdict {
        along, // each place has one foot in feet(), no farther than the tolerance, and B holds no other one in `with`
        beside,   // each place has one foot in feet(), which has nothing in common with `with`
        touching, // or no more than what is within half of the tolerance from side()
        open,
    };
    // start: a place on B beside the part; with: of B, to be told about, too; null: nothing is beside. B goes on as a polynomial.
    Verdict look(const CrossPiece &a, const PlaceBox &part, const CrossPiece &b,
                 const std::array<double, 2> &start, const PlaceBox *with);
    [[nodiscard]] const PlaceBox &feet() const noexcept { return feet_; }
    // Whether feet() are beyond one of the sides of a box, but for what is within half of the tolerance from that side().
    bool set_side(const PlaceBox &with);
    // The axis and the end.
    [[nodiscard]] const std::array<size_t, 2> &side() const noexcept { return side_; }
    // How far apart places on a piece may be along an axis that are taken for one, which are near / 32 apart in space.
    [[nodiscard]] static double room_on(const CrossPiece &piece, size_t axis, double near) noexcept;

private:
    using Homogeneous = std::array<double, 4>;
    struct Gap {
        double across[2]{}; // |M F|
        double height = 0;  // |n . F|
    };

    bool interpolate(int degree, std::array<double, 2> start);
    bool find_foot(const Vector3 &of, const Vector3 &normal, std::array<double, 2> &place) const;
    bool set_chart(const PlaceBox *with);
    [[nodiscard]] std::array<double, 2> foot(const std::array<double, 2> &at) const;
    void add_gap(const Homogeneous &a, const std::array<double, 2> &foot, Gap &gap) const;
    [[nodiscard]] Gap estimate() const;
    [[nodiscard]] bool can_be_sampled() const noexcept;
    void set_bounds(const Gap &gap, double factor, double noise);
    Verdict verdict(const PlaceBox *with);
    Verdict verdict_of_samples(const PlaceBox *with);
    [[nodiscard]] std::array<double, 2> place_on_a(const std::array<double, 2> &at) const noexcept;
    [[nodiscard]] std::array<int, 2> degrees_of_gap() const noexcept;

    double tolerance_;
    const CrossPiece *a_ = nullptr, *b_ = nullptr;
    PlaceBox part_{}, hull_{}, feet_{};
    double weight_of_a_ = 1;           // the least one
    int degree_ = 1;                   // of psi
    std::array<double, 16> inverse_{}; // of the Bernstein functions at the places of cubic interpolation
    std::array<std::array<double, 16>, 2> psi_{}; // Bernstein coefficients
    // Of B in the box.
    std::array<double, 2> lengths_{};
    std::array<Vector3, 2> rows_{};
    Vector3 normal_;
    double rho_ = 1, weight_of_b_ = 1, beyond_ = 1;
    std::array<double, 2> slopes_{}; // |n . B'|
    double off_ = 0, height_ = 0;
    std::array<size_t, 2> side_{};
};

} // namespace nrb::intersect
