// SPDX-License-Identifier: MIT
// Whether parts of two surfaces touch, that is, are near each other all over, and which parts are certainly
// apart.
#pragma once

#include "intersect/surfaces/cross_cell.h"

namespace nrb::intersect {

// Decides whether ranges of the parameters of two surfaces are a touch, and cuts off what holds no common
// points.
class TouchTest {
public:
    virtual ~TouchTest() = default;
    [[nodiscard]] virtual bool is_touch(const std::array<Interval, 4> &ranges) const = 0;
    virtual void narrow(std::array<Interval, 4> &ranges) const = 0;
    // Whether ranges certainly hold no common points; false where that cannot be decided.
    [[nodiscard]] virtual bool is_apart(const std::array<Interval, 4> & /*ranges*/) const { return false; }
};

class CrossTouch final : public TouchTest {
public:
    // tolerance: in the frame that both surfaces share.
    CrossTouch(CrossGround &a, CrossGround &b, double tolerance) : grounds_{&a, &b}, tolerance_(tolerance) {}

    // Whether the parts of both surfaces over ranges of their parameters, which may run beyond domains that
    // close, lie between two planes no farther apart than the tolerance, or in a box that is no larger, and
    // are small compared with the surfaces.
    [[nodiscard]] bool is_touch(const std::array<Interval, 4> &ranges) const override;

    // Whether these parts lie in a box with sides of at most 16 sqrt(tolerance): where two sheets of a
    // surface part, the tolerance does not separate them within such a box.
    [[nodiscard]] bool is_spot(const std::array<Interval, 4> &ranges) const;

    // Cuts off ends of ranges that have no common points with the other surface in its ranges, as bounding
    // boxes prove.
    void narrow(std::array<Interval, 4> &ranges) const override;
    // Whether bounding boxes prove that there are no common points in ranges.
    [[nodiscard]] bool is_apart(const std::array<Interval, 4> &ranges) const override;

private:
    using Cells = std::vector<CrossCell>;

    bool cut(size_t i, bool upper, const Cells &other, std::array<Interval, 4> &ranges) const;

    // Adds the cells of a surface over its ranges; they are not prepared.
    bool add_parts(size_t surface, const std::array<Interval, 4> &ranges, Cells &cells) const;
    static bool are_small(const Cells &cells, double most) noexcept;
    static double thickness(const Cells &cells, const Vector3 &unit) noexcept;

    std::array<CrossGround *, 2> grounds_;
    double tolerance_;
};

} // namespace nrb::intersect
