// SPDX-License-Identifier: MIT
// Finds where rays pass near the boundary of a face, so that none slips between neighbours unnoticed.
#pragma once

#include "face/face.h"
#include "intersect/rays/box_tree.h"

#include <vector>

namespace nrb::model {

// A part of a ray that is near a curve of the boundary.
struct EdgePassage {
    Interval ts;         // outside of this interval of t the ray is not near
    face::Point2 params; // approximate place in the domain
    double room;         // the distance within which the ray counts as near
};

// All curves at which a face may end, including its seams.
class FaceEdges {
public:
    // rooms: the distances within which a ray is near the curves of each loop and, last, the one for all
    // other curves.
    FaceEdges(const face::Face &face, const std::vector<double> &rooms);

    // Appends the parts of a ray that are near the boundary.
    void passages(const intersect::RayQuery &query, std::vector<EdgePassage> &out) const;

private:
    struct Item {
        SplinePtr plane, space; // null: only the box and `middle` are known
        double room;
        face::Point2 middle{};
    };
    void add(const face::Face &face, SplinePtr plane, SplinePtr space, double room);
    void add_boxes(const face::Face &face, const Spline &plane, double room);
    void add_item(Item item, intersect::Box3 box);

    double size_ = 0; // of the face
    std::vector<Item> items_;
    std::vector<intersect::Box3> boxes_;
    intersect::BoxTree tree_;
};

} // namespace nrb::model
