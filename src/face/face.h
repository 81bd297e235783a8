// SPDX-License-Identifier: MIT
// The face: the part of a surface that loops of curves in its domain bound.
#pragma once

#include "base/lazy.h"
#include "base/records.h"
#include "face/loop.h"
#include "face/made/curve_under.h"
#include "face/nearest_place.h"
#include "face/trims/trim_map.h"

#include <memory>
#include <span>
#include <vector>

namespace nrb::face {

// What a face is made of.
struct FaceParts {
    SplinePtr surface;
    std::vector<Loop> loops;
    double tolerance = 0; // of space
    bool as_oriented =
        false; // the inside is to the left of the loops as they run; else they are turned to be so
    bool keep_gaps = false; // larger ones than the tolerance are closed, too
    // Of curves that are made, beyond the distance of their edges from the surface; 0: half of the tolerance.
    double precision = 0;
    bool prove =
        true; // that curves which are made are within the tolerance; else deviation_of() proves it later
    NearestPlace nearest{};       // of the surface, if it is known
    bool check_crossings = false; // loops that cross are refused
};

// Makes the curves that are missing, in the direction of their loops, as a face that is made of the parts does. Throws what
// curve_under() throws, with the place of the edge.
void make_curves(FaceParts &parts);

// Immutable: any number of threads may ask at once.
class Face {
public:
    // gaps, if not null: the largest gap of each loop, in space; filled where loops are not closed, too. Throws Status::gap for a
    // gap larger than the tolerance, outside_domain for a curve that leaves it by more, orientation for loops that have no
    // common inside, weight_sign for a weight that is not positive; with check_crossings what Crossings does.
    Face(FaceParts parts, std::vector<double> *gaps);
    // The same part of a surface over the same parameters, as of one that was moved. Edges in space are left out.
    Face(const std::shared_ptr<const Face> &face, SplinePtr surface, double tolerance);
    Face(const Face &) = delete;
    Face &operator=(const Face &) = delete;

    [[nodiscard]] const SplinePtr &surface() const noexcept { return surface_; }
    [[nodiscard]] const std::vector<Loop> &loops() const noexcept { return loops_; }
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    // Whether a gap of a loop is larger than the tolerance.
    [[nodiscard]] bool has_gaps() const noexcept { return has_gaps_; }
    [[nodiscard]] const Covering &covering() const noexcept { return covering_; }
    [[nodiscard]] const TrimMap &trims() const noexcept { return *trims_; }
    // Where segments close what curves leave open.
    [[nodiscard]] const std::vector<Joint> &joints() const noexcept { return joints_; }
    // Of all loops one after the other: the edges that edge_of() makes where none is given, else null.
    [[nodiscard]] const Lazy<std::vector<SplinePtr>> &made_edges() const noexcept { return made_edges_; }

private:
    [[nodiscard]] TrimPieces pieces(std::vector<ClosedLoop> &closed, std::vector<double> *gaps, bool keep);
    [[nodiscard]] std::unique_ptr<const TrimMap> map(const TrimPieces &plane, bool turn,
                                                     bool astray = false) const;
    [[nodiscard]] std::unique_ptr<const TrimMap>
    uncrossed_map(const TrimPieces &plane, std::span<const ClosedLoop> loops, bool turn) const;

    SplinePtr surface_;
    std::vector<Loop> loops_;
    double tolerance_;
    bool has_gaps_ = false;
    Covering covering_;
    std::vector<Joint> joints_;
    std::shared_ptr<const TrimMap> trims_; // of the other face, if it is the same part
    Lazy<std::vector<SplinePtr>> made_edges_;
};
using FacePtr = std::shared_ptr<const Face>;

// 1 inside, 0 no farther from a curve of the boundary than the tolerance, as its first derivatives measure it, or than rounding;
// -1 outside and outside of the domain. sides: [params.count].
void classify(const Face &face, const ConstRecords &params, double tolerance, int32_t *sides);

} // namespace nrb::face
