// SPDX-License-Identifier: MIT
// Where planes cut the faces of a model, face by face.
#pragma once

#include "face/trimmed_meet.h"
#include "model/rays/instances.h"
#include "model/sections/shared_borders.h"

#include <vector>

namespace nrb::model {

// Planes with one normal, by rising offsets.
struct ParallelPlanes {
    Vector3 normal;
    std::vector<double> offsets;
    std::vector<int64_t> levels; // the numbers of the planes
};

// Where a branch begins or ends on the border of its face.
struct SectionEnd {
    int64_t branch;
    bool begins;
    struct Place {
        int64_t coedge; // of SharedBorders
        double param;
    };
    std::vector<Place> places; // the nearest one first
    Vector3 point;             // in the whole
    double room;               // how far from it the face next to it may go on
};

// What is found, with faces and instances, in the whole.
struct FaceSections {
    intersect::Meet meet;
    std::vector<SectionEnd> ends;
};

// Faces where they stand.
class FaceCutter {
public:
    FaceCutter(const Model &model, const SharedBorders &borders, double tolerance);

    // Adds the sections of a face in an instance by planes. Where an edge that two faces share lies in a plane, that is a branch of
    // those that are below beside it, as if the plane stood a little lower.
    void add(int64_t face, int64_t instance, const Placement &placement, const ParallelPlanes &planes,
             FaceSections &out);

private:
    struct Cut {
        int64_t face, instance;
        const Placement &placement;
        std::vector<int64_t> levels; // of those of the meet
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
    std::vector<double> tolerances_; // of faces and those beside them
    std::vector<int64_t> nodes_;     // where those of a face went
};

} // namespace nrb::model
