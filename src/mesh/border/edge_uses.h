// SPDX-License-Identifier: MIT
// The curves of faces over the edges that they are on, and the places that these have to have vertices at.
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

// Where the curve of a face passes from one copy of its domain to the next, or a kink of its surface.
struct FixedPlace {
    double curve, edge; // parameters
    face::Point2 place;
};

// A curve of a face, or the segment of its domain by which a loop goes on behind one.
struct EdgeUse {
    int64_t face = 0;
    int32_t loop = 0, index = 0; // of the curve, or of the one that the segment is behind
    size_t line = 0;             // the edge that it is on
    SplinePtr own{};             // the segment
    std::unique_ptr<CurvePairing> pairing{};
    std::vector<FixedPlace> fixed{};
};

// Edges are those of the model, in their order, then those of faces alone.
class EdgeUses {
public:
    // For meshes within a distance.
    EdgeUses(const model::Model &model, double chord);

    [[nodiscard]] double chord() const noexcept { return chord_; }

    [[nodiscard]] const std::vector<EdgeUse> &all() const noexcept { return uses_; }
    [[nodiscard]] const EdgeUse &operator[](size_t use) const noexcept { return uses_[use]; }
    [[nodiscard]] size_t line_count() const noexcept { return curves_.size(); }
    [[nodiscard]] const Spline &curve(size_t line) const noexcept { return *curves_[line]; }
    [[nodiscard]] const std::vector<size_t> &users(size_t line) const noexcept { return users_[line]; }
    [[nodiscard]] const model::SharedBorders &borders() const noexcept { return borders_; }

    // The use that a curve of a face is.
    [[nodiscard]] size_t at(int64_t face, int32_t loop, int32_t index) const noexcept {
        return static_cast<size_t>(borders_.number(face, loop, index));
    }
    // The one behind it, if its end is far from the next curve.
    [[nodiscard]] std::optional<size_t> behind(int64_t face, int32_t loop, int32_t index) const noexcept;
    // The first curve of a loop is behind its last one.
    [[nodiscard]] int32_t next_index(int64_t face, int32_t loop, int32_t index) const noexcept;
    [[nodiscard]] const face::Face &face_of(const EdgeUse &use) const noexcept { return face(use.face); }
    [[nodiscard]] const Spline &curve_of(const EdgeUse &use) const noexcept;
    // Whether curve and edge run in opposite directions.
    [[nodiscard]] bool is_against(const EdgeUse &use) const noexcept;

    // What faces have at one place of an edge, but for rounding, is at one parameter, and so is what is at its ends. So is what is at
    // a break: of what would be between them, nobody knows the direction.
    void align_fixed(size_t line);
    // Inside of the domain of an edge, rising.
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
    void fix_jump(int64_t number, const face::BorderPieces &border, const face::TrimPiece &piece);
    void fix_behind(int64_t number, const face::BorderPieces &border, const LinePassage &passage);

    const model::Model &model_;
    double chord_;
    model::SharedBorders borders_;
    std::vector<EdgeUse> uses_;              // curves of faces first, in the order of SharedBorders
    std::vector<SplinePtr> curves_;          // of the lines
    std::vector<std::vector<size_t>> users_; // of the lines
    std::map<size_t, size_t> gaps_;          // uses behind the uses of curves
};

} // namespace nrb::mesh
