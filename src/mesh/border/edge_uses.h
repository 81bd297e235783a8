// SPDX-License-Identifier: MIT
// The uses of edges by the curves of faces, and the places where the edges must have vertices.
#pragma once

#include "face/border_pieces.h"
#include "mesh/border/curve_pairing.h"
#include "mesh/border/snap_lines.h"
#include "model/model.h"
#include "model/sections/shared_borders.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace nrb::mesh {

// Where the curve of a face crosses a seam, into the next copy of the domain, or a line at which the surface
// may have a kink.
struct FixedPlace {
    double curve, edge; // parameters
    face::Point2 place; // in the domain
};

// The use of an edge by a face: a curve of a loop or, where the loop has a gap, the segment of the domain
// that closes it.
struct EdgeUse {
    int64_t face = 0;
    int32_t loop = 0, index = 0; // of the curve, or of the one that the segment follows
    size_t line = 0;             // the edge that is used
    SplinePtr own{};             // the segment; null for a curve of the loop
    std::unique_ptr<CurvePairing> pairing{};
    std::vector<FixedPlace> fixed{};
};

// Collects all uses. A 'line' is the number of an edge: the edges of the model come first, in their order,
// then those that a single face has for itself, such as those that close gaps.
class EdgeUses {
public:
    // `chord`: the chord error of the mesh.
    EdgeUses(const model::Model &model, double chord);

    [[nodiscard]] double chord() const noexcept { return chord_; }

    [[nodiscard]] const std::vector<EdgeUse> &all() const noexcept { return uses_; }
    [[nodiscard]] const EdgeUse &operator[](size_t use) const noexcept { return uses_[use]; }
    [[nodiscard]] size_t line_count() const noexcept { return curves_.size(); }
    [[nodiscard]] const Spline &curve(size_t line) const noexcept { return *curves_[line]; }
    [[nodiscard]] const std::vector<size_t> &users(size_t line) const noexcept { return users_[line]; }
    [[nodiscard]] const model::SharedBorders &borders() const noexcept { return borders_; }

    // The number of the use by a curve of a face.
    [[nodiscard]] size_t at(int64_t face, int32_t loop, int32_t index) const noexcept {
        return static_cast<size_t>(borders_.number(face, loop, index));
    }
    // The use by the segment that follows a curve, if there is a gap between its end and the next curve.
    [[nodiscard]] std::optional<size_t> behind(int64_t face, int32_t loop, int32_t index) const noexcept;
    // The curve that follows in the loop, which is cyclic.
    [[nodiscard]] int32_t next_index(int64_t face, int32_t loop, int32_t index) const noexcept;
    [[nodiscard]] const face::Face &face_of(const EdgeUse &use) const noexcept { return face(use.face); }
    [[nodiscard]] const Spline &curve_of(const EdgeUse &use) const noexcept;
    // Whether curve and edge run in opposite directions.
    [[nodiscard]] bool is_against(const EdgeUse &use) const noexcept;

    // Makes parameters of fixed places on an edge equal where they differ by rounding only: those that
    // different faces have at one place, and those at an end or a break of the edge. The direction of the
    // edge between such parameters would not be known.
    void align_fixed(size_t line);
    // Parameters of the fixed places strictly inside the domain of an edge, rising and distinct.
    [[nodiscard]] std::vector<double> fixed_params(size_t line) const;

private:
    [[nodiscard]] const face::Face &face(int64_t number) const noexcept {
        return *model_.faces[static_cast<size_t>(number)].face;
    }
    [[nodiscard]] const face::Coedge &coedge_of(const EdgeUse &use) const noexcept {
        return face(use.face).loops()[static_cast<size_t>(use.loop)][static_cast<size_t>(use.index)];
    }
    void set_uses();
    void set_curves();
    size_t add_line(const SplinePtr &curve, std::vector<size_t> users);
    void pair_from(size_t first, double near);
    void add_gaps(int64_t number);
    void add_gap(size_t own, size_t next);
    void add_fixed(int64_t number);
    void fix(int64_t number, const face::BorderPieces &border, const LinePassage &passage);
    void fix_at(EdgeUse &use, double param, const face::Point2 &place) const;
    void put_fixed_in_order(EdgeUse &use) const;
    void fix_jump(int64_t number, const face::BorderPieces &border, const face::TrimPiece &piece);
    void fix_behind(int64_t number, const face::BorderPieces &border, const LinePassage &passage);

    const model::Model &model_;
    double chord_;
    model::SharedBorders borders_;
    std::vector<EdgeUse> uses_;              // curves of faces first, in the order of SharedBorders
    std::vector<SplinePtr> curves_;          // of the lines
    std::vector<std::vector<size_t>> users_; // of the lines
    std::map<size_t, size_t> gaps_;          // from the use of a curve to that of the segment that follows it
};

} // namespace nrb::mesh
