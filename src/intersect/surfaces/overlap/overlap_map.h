// SPDX-License-Identifier: MIT
// Proves that a part of a surface lies along a piece of another surface: an approximate foot map, verified by
// a Krawczyk contraction.
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <map>

namespace nrb::intersect {

using PlaceBox = std::array<Interval, 2>;

inline bool have_common(const PlaceBox &a, const PlaceBox &b) noexcept {
    return a[0].lower <= b[0].upper && b[0].lower <= a[0].upper && a[1].lower <= b[1].upper &&
           b[1].lower <= a[1].upper;
}

// Over a part of surface A, let psi be a polynomial map to places (s, t) on a piece of B, which interpolates
// feet along a normal of B. Take a box of places that contains the image of psi. Let n be the normal of B in
// the middle of the box, M the inverse of the derivative B' there across n (M n = 0), and rho < 1 a bound of
// |I - M B'| on the box, which is widened. If |M (A - B(psi))| <= g, each place of the part has exactly one
// foot along n in the box. This foot is no farther from psi than r = g / (1 - rho) (R. Krawczyk 1969), and
// its distance in space from the point of A is at most |n . (A - B(psi))| + r (|n . B_s| + |n . B_t|).
//
// Times both weights, A - B(psi) is a polynomial of the place on A. Of degrees m and n it is at most twice as
// large as at (2 m + 1) (2 n + 1) Chebyshev points (see CrossFitter).
class OverlapMap {
public:
    // tolerance: in the frame.
    explicit OverlapMap(double tolerance);

    enum class Verdict {
        // Each place of the part has one foot in feet(), no farther than the tolerance, and no other in
        // `with`.
        along,
        // Each place of the part has one foot in feet(), which does not meet `with`.
        beside,
        // The same, but feet() may meet what is within half of the tolerance from side() of `with`.
        touching,
        open, // none of these is proven
    };
    // Looks for a foot map from the part of A to B, which is continued as a polynomial beyond its piece.
    // start: a place on B near the part. with: a box of B to which the verdict refers; null: none, and the
    // verdict is along or open.
    Verdict look(const CrossPiece &a, const PlaceBox &part, const CrossPiece &b,
                 const std::array<double, 2> &start, const PlaceBox *with);
    [[nodiscard]] const PlaceBox &feet() const noexcept { return feet_; }
    // Whether feet() are beyond one of the sides of a box, except for what is within half of the tolerance
    // from that side; sets side().
    bool set_side(const PlaceBox &with);
    // The axis and the end of the side.
    [[nodiscard]] const std::array<size_t, 2> &side() const noexcept { return side_; }
    // The distance of places along an axis of a piece that are taken for one: at most near / 8 in space, in
    // the piece and a little beyond it.
    [[nodiscard]] double room_on(const CrossPiece &piece, size_t axis, double near);

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
    [[nodiscard]] const std::array<double, 2> &speeds_of(const CrossPiece &piece);

    double tolerance_;
    const CrossPiece *a_ = nullptr, *b_ = nullptr;
    PlaceBox part_{}, hull_{}, feet_{};
    double weight_of_a_ = 1;           // the least one in the part
    int degree_ = 1;                   // of psi
    std::array<double, 16> inverse_{}; // of the Bernstein functions at the places of cubic interpolation
    std::array<std::array<double, 16>, 2> psi_{}; // Bernstein coefficients
    // Of B in the box, where places are in lengths of the box.
    std::array<double, 2> lengths_{};
    std::array<Vector3, 2> rows_{}; // of M
    Vector3 normal_;
    double rho_ = 1, weight_of_b_ = 1, beyond_ = 1;
    std::array<double, 2> slopes_{}; // bounds of |n . B_s| and |n . B_t|
    double off_ = 0, height_ = 0;
    std::array<size_t, 2> side_{};
    std::map<const CrossPiece *, std::array<double, 2>> speeds_; // bounds of the derivatives along both axes
};

} // namespace nrb::intersect
