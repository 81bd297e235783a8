// SPDX-License-Identifier: MIT
// Rays that pass near the boundary of a face.
#pragma once

#include "face/face.h"
#include "intersect/rays/box_tree.h"

#include <vector>

namespace nrb::model {

struct EdgePassage {
    Interval ts;         // outside of which the ray is not near
    face::Point2 params; // about where, in the domain
    double room;         // how near is near
};

// All curves at which a face may end, its seams among them.
class FaceEdges {
public:
    // rooms: how near to the curves of each loop is near, and, last, to others.
    FaceEdges(const face::Face &face, const std::vector<double> &rooms);

    // Appends the passages of a ray.
    void passages(const intersect::RayQuery &query, std::vector<EdgePassage> &out) const;

private:
    struct Item {
        SplinePtr plane, space; // null: only the box is known
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
