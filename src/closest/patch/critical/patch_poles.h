// SPDX-License-Identifier: MIT
// Poles of a surface, edges that collapse to a point as at the ends of a globe, and how the distance behaves
// there.
#pragma once

#include "closest/patch/critical/critical_points.h"
#include "closest/patch/critical/patch_face.h"
#include "closest/patch/critical/patch_slopes.h"

#include <vector>

namespace nrb::closest {

class PatchPoles {
public:
    // minima: only poles that are minima are wanted. Critical poles are added to `points`.
    PatchPoles(const CriticalQuery &query, bool minima, CriticalPoints &points, CriticalGaps &gaps)
        : query_(query), minima_(minima), points_(points), gaps_(gaps) {}

    void find();
    // Whether a face is a collapsed edge or an end of one.
    [[nodiscard]] bool holds(const PatchFace &face) const noexcept;
    // Whether a part of a piece, or a point of it, belongs to a critical pole: it is within the tolerance of
    // the pole or, if distances in it agree to rounding, within the radius in which rounding leaves distances
    // undecided.
    [[nodiscard]] bool absorbs(const PatchSlopes &slopes, bool flat, int64_t piece);
    [[nodiscard]] bool absorbs(const std::vector<double> &point, int64_t piece);
    // Whether a point of a piece is at a critical pole, or at any pole.
    [[nodiscard]] bool critical_at(const std::vector<double> &point, int64_t piece) const noexcept;
    [[nodiscard]] bool any_at(const std::vector<double> &point, int64_t piece) const noexcept;
    // Records that rounding has left a part open at a pole that is not critical: the pole becomes an
    // undecided point.
    void leave_open(const std::vector<double> &point, int64_t piece);

private:
    // Kind: a critical_ constant; 0 if the pole is not known to be critical.
    struct Pole {
        std::vector<double> point;
        double radius; // within it, distances do not tell points apart
        double height; // parameter width of a strip within `radius` of the pole
        int axis;      // the edge is at an end of this axis of the domain, or of the range
        int64_t piece;
        AxisValues at;
        int32_t kind;
    };
    void find(const PatchFace &face);
    [[nodiscard]] bool collapses(const PatchFace &face, const PatchItem &whole,
                                 std::vector<double> &point) const;
    bool set_kind(const PatchFace &face, const std::vector<int64_t> &pieces, Pole &pole) const;
    [[nodiscard]] std::vector<double> point_near(const PatchFace &face, const PatchItem &whole, double along,
                                                 Pole &pole) const;
    [[nodiscard]] bool proven(const std::vector<int64_t> &pieces, const Pole &pole) const;
    void add(Pole pole, const std::vector<int64_t> &pieces);
    void add_point(const Pole &pole);
    // Whether the piece is adjacent to the pole. Where sheets coincide, only the one with the pole counts.
    [[nodiscard]] bool is_beside(const Pole &pole, int64_t piece) const noexcept;
    [[nodiscard]] bool at(const Pole &pole, const std::vector<double> &point, int64_t piece) const noexcept {
        return is_beside(pole, piece) && query_.apart(point, pole.point) <= pole.radius;
    }
    bool absorb(double apart);

    const CriticalQuery &query_;
    bool minima_;
    CriticalPoints &points_;
    CriticalGaps &gaps_;
    std::vector<Pole> poles_;
};

} // namespace nrb::closest
