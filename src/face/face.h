// SPDX-License-Identifier: MIT
// The face: the part of a surface that is bounded by loops of curves in its domain (a trimmed surface).
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
    double tolerance = 0; // in space
    // The inside is to the left of the loops as they run; else loops are turned until it is.
    bool as_oriented = false;
    bool keep_gaps = false; // gaps larger than the tolerance are accepted, and closed by segments
    // How much farther an edge may be from the image of a curve that is made for it than from the surface; 0:
    // half of the tolerance.
    double precision = 0;
    // Whether curves that are made are proven to be within the tolerance; if not, deviation_of() proves it.
    bool prove = true;
    NearestPlace nearest{};       // on the surface, if it is known
    bool check_crossings = false; // refuse loops that cross
};

// Makes the curves that are missing, in the direction of their loops, as the constructor of a face does.
// Throws what curve_under() throws, naming the loop and the edge.
void make_curves(FaceParts &parts);

// Immutable: any number of threads may use it at once.
class Face {
public:
    // gaps, if not null: the largest gap of each loop, in space; set even if Status::gap is thrown. Throws
    // Status::gap for a gap larger than the tolerance, outside_domain for a curve that leaves the domain by
    // more than the tolerance, orientation for loops that have no common inside, weight_sign for a weight
    // that is not positive; with check_crossings also what Crossings throws.
    Face(FaceParts parts, std::vector<double> *gaps);
    // The same part of another surface over the same parameters, such as one that was moved. Edges are
    // dropped.
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
    // The segments between the ends of curves that do not meet.
    [[nodiscard]] const std::vector<Joint> &joints() const noexcept { return joints_; }
    // For the curves of all loops, one after the other: the edges that edge_of() makes where none is given,
    // else null.
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
    std::shared_ptr<const TrimMap> trims_; // of the other face, if this is the same part of another surface
    Lazy<std::vector<SplinePtr>> made_edges_;
};
using FacePtr = std::shared_ptr<const Face>;

// The side of each place: 1 inside, -1 outside. 0 if the place is no farther from the boundary than the
// tolerance, measured in space by the first derivatives of the surface at the place, or than rounding. A
// place outside of the domain counts as -1, unless the nearest place of the domain is that near. sides:
// [params.count].
void classify(const Face &face, const ConstRecords &params, double tolerance, int32_t *sides);

} // namespace nrb::face
