// SPDX-License-Identifier: MIT
// Certified bounds of the deviation (maximum distance at equal parameters) of two splines over the same
// domain.
#pragma once

#include "pieces/bernstein_net.h"
#include "pieces/largest_quotient.h"

#include <memory>

namespace nrb::bounds {

// The difference of two splines f and g as quotients of Bernstein polynomials, piece by piece. With the
// homogeneous coordinates A, w of f and B, v of g about a common centre,
//     f - g = (A v - B w) / (w v) = ((A - B) v - B (w - v)) / (w v).
// Where the splines are close, the differences in the last form are small, and so are the rounding errors of
// the products. If the weights of a piece agree bit for bit (as in polynomial splines), the difference is
// (A - B) / w.
class DeviationPieces {
public:
    // Throws Status::incompatible unless axes, dimensions and domains agree; also overflow,
    // not_representable.
    DeviationPieces(const Spline &f, const Spline &g);
    // The same for the pieces in [lower, upper] of one axis only.
    DeviationPieces(const Spline &f, const Spline &g, int axis, Interval part);

    [[nodiscard]] int64_t pieces() const noexcept { return g_.pieces(); }
    [[nodiscard]] const pieces::BernsteinNet::Breaks &breaks() const noexcept { return breaks_; }
    // An upper bound for each piece.
    [[nodiscard]] std::vector<double> uppers() const;
    // Bounds of the largest distance.
    [[nodiscard]] pieces::Enclosure enclosure(std::span<const double> uppers,
                                              const pieces::SearchLimits &limits = {}) const;

private:
    friend class DeviationsFrom;
    struct Setting;
    class Difference;
    using NetPtr = std::shared_ptr<const pieces::BernsteinNet>;
    DeviationPieces(NetPtr f, const Spline &g, const Setting &setting);
    static NetPtr first_net(const Spline &f, const Setting &setting);

    pieces::BernsteinNet::Breaks breaks_;
    NetPtr f_;
    pieces::BernsteinNet g_;
};

// The deviation of one spline from others, one after another: its own pieces are only recomputed when the
// other spline leads to different pieces.
class DeviationsFrom {
public:
    // The spline must outlive this object.
    explicit DeviationsFrom(const Spline &f) noexcept;
    DeviationsFrom(const DeviationsFrom &) = delete;
    DeviationsFrom &operator=(const DeviationsFrom &) = delete;
    ~DeviationsFrom();

    DeviationPieces to(const Spline &g);

private:
    const Spline &f_;
    std::unique_ptr<DeviationPieces::Setting> setting_;
    DeviationPieces::NetPtr net_;
};

// sup |f(t) - g(t)| over the domain, including both limits at jumps. The bounds include rounding. Apart from
// rounding they differ by a factor of at most 5/4, unless the search ends at its limit of steps. The upper
// bound is infinite where a denominator cannot be shown to have no zero.
pieces::Enclosure deviation(const Spline &f, const Spline &g);
pieces::Enclosure deviation(const Spline &f, const Spline &g, int axis, Interval part);

// An upper bound of the deviation. If the bounds leave open whether it exceeds `limit`, the search goes on
// until they agree to a thousandth.
double deviation_below(const Spline &f, const Spline &g, double limit);

} // namespace nrb::bounds
