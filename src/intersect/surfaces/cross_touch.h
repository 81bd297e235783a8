// SPDX-License-Identifier: MIT
// Parts of two surfaces that are near each other all over.
#pragma once

#include "intersect/surfaces/cross_cell.h"

namespace nrb::intersect {

// Whether ranges of the parameters of two surfaces are a touch, and without what they are the same.
class TouchTest {
public:
    virtual ~TouchTest() = default;
    [[nodiscard]] virtual bool is_touch(const std::array<Interval, 4> &ranges) const = 0;
    virtual void narrow(std::array<Interval, 4> &ranges) const = 0;
    // Whether it is certain that ranges hold nothing: where nobody can tell it is not.
    [[nodiscard]] virtual bool is_apart(const std::array<Interval, 4> & /*ranges*/) const { return false; }
};

class CrossTouch final : public TouchTest {
public:
    // tolerance: in the frame of both.
    CrossTouch(CrossGround &a, CrossGround &b, double tolerance) : grounds_{&a, &b}, tolerance_(tolerance) {}

    // Whether all that both have in ranges of their parameters, which may run beyond domains that close, lies between two
    // planes no farther apart than the tolerance, or in a box no larger, and is a small part of both.
    [[nodiscard]] bool is_touch(const std::array<Interval, 4> &ranges) const override;

    // Whether it is no larger than what the tolerance does not tell apart where two sheets of a surface part.
    [[nodiscard]] bool is_spot(const std::array<Interval, 4> &ranges) const;

    // Takes away from ranges what has no common points with the other surface in its own, as boxes tell.
    void narrow(std::array<Interval, 4> &ranges) const override;
    // Whether boxes tell that there are no common points in ranges: for certain, if so.
    [[nodiscard]] bool is_apart(const std::array<Interval, 4> &ranges) const override;

private:
    using Cells = std::vector<CrossCell>;

    bool cut(size_t i, bool upper, const Cells &other, std::array<Interval, 4> &ranges) const;

    // Without what is known of wide parts.
    bool add_parts(size_t surface, const std::array<Interval, 4> &ranges, Cells &cells) const;
    static bool are_small(const Cells &cells, double most) noexcept;
    static double thickness(const Cells &cells, const Vector3 &unit) noexcept;

    std::array<CrossGround *, 2> grounds_;
    double tolerance_;
};

} // namespace nrb::intersect
