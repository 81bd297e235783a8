// SPDX-License-Identifier: MIT
// Sections of the faces of a model with planes, face by face.
#pragma once

#include "face/trimmed_meet.h"
#include "model/rays/instances.h"
#include "model/sections/shared_borders.h"

#include <vector>

namespace nrb::model {

// Planes with a common normal, by ascending offset.
struct ParallelPlanes {
    Vector3 normal;
    std::vector<double> offsets;
    std::vector<int64_t> levels; // the number of each plane
};

// An end of a branch on the border of its face.
struct SectionEnd {
    int64_t branch;
    bool begins;
    struct Place {
        int64_t coedge; // number in SharedBorders
        double param;
    };
    std::vector<Place> places; // nearest first
    Vector3 point;             // in the whole
    double room;               // how far from the point the section of the next face may begin
};

// The sections found so far, in the whole, with their faces and instances, and the ends that may be joined.
struct FaceSections {
    intersect::Meet meet;
    std::vector<SectionEnd> ends;
};

// Cuts faces where they stand in the whole.
class FaceCutter {
public:
    FaceCutter(const Model &model, const SharedBorders &borders, double tolerance);

    // Adds the sections of a face in an instance with planes. A shared edge that lies in a plane becomes a
    // branch of those of its faces that are below the plane beside it, as if the plane stood a little lower.
    void add(int64_t face, int64_t instance, const Placement &placement, const ParallelPlanes &planes,
             FaceSections &out);

private:
    struct Cut {
        int64_t face, instance;
        const Placement &placement;
        std::vector<int64_t> levels; // number of the plane for each level of the meet
        bool reversed;
    };
    void add_meet(const face::BorderedMeet &found, const Cut &cut, FaceSections &out);
    void add_branch(const face::BorderedMeet &found, size_t i, const Cut &cut, FaceSections &out);
    static int64_t add_node(const intersect::MeetNode &node, const Cut &cut, FaceSections &out);
    [[nodiscard]] bool is_above_shared_edge(const face::Course &course, int64_t face) const;

    const Model &model_;
    const SharedBorders &borders_;
    double tolerance_;
    std::vector<intersect::Box3> boxes_;
    std::vector<double> tolerances_; // widest_tolerances()
    std::vector<int64_t> nodes_;     // new numbers of the nodes of a face
};

} // namespace nrb::model
