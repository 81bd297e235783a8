// SPDX-License-Identifier: MIT
// Checks the values on both sides of the loops of a face.
#pragma once

#include "base/watch.h"
#include "face/trims/trim_map.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace nrb::face {

// Looks for places beside loops that are neither inside nor outside. Between cuts the values beside a loop do
// not change, so that a few samples are enough.
class BesideLoops {
public:
    // near: a distance in space; values are taken so far from a curve, and twice as far.
    BesideLoops(const Spline &surface, const Covering &covering, const TrimMap &trims, double near);

    // Cuts loops at a place of the plane that covers the domain at which curves meet.
    void cut(const Point2 &x);

    struct Astray {
        int loop;
        Point2 at; // in the domain
    };
    // A place of a loop beside which there is neither inside nor outside; none if no sample shows one. A loop
    // that is not cut is sampled at a few places, other loops at a few places of each piece.
    [[nodiscard]] std::optional<Astray> astray();

private:
    struct Cut {
        size_t piece;
        double share; // of the piece, along its longer side
        friend auto operator<=>(const Cut &, const Cut &) = default;
    };
    struct Part {
        size_t piece;
        Interval share;
        bool cut; // whether there is a cut where it begins
    };
    struct Sample {
        Point2 at, tangent;
    };
    [[nodiscard]] size_t longer_side(const TrimPiece &piece) const noexcept;
    [[nodiscard]] std::vector<Part> parts_of(size_t first, size_t last) const;
    [[nodiscard]] std::optional<Point2> astray_of(std::span<const Part> parts, Steps &steps) const;
    [[nodiscard]] std::optional<Point2> astray_of_uncut(std::span<const Part> parts) const;
    [[nodiscard]] std::optional<Point2> astray_in(const Part &part, const std::array<Point2, 2> &ends) const;
    [[nodiscard]] Sample sample(size_t number, double share) const noexcept;
    [[nodiscard]] bool is_astray(const Sample &sample) const;
    [[nodiscard]] bool is_wrong(const Point2 &x) const noexcept;
    [[nodiscard]] Point2 step_aside(const Sample &sample) const;

    const Spline &surface_;
    const Covering &covering_;
    const TrimMap &trims_;
    double near_;
    std::vector<Cut> cuts_;
};

} // namespace nrb::face
