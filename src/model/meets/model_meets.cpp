// SPDX-License-Identifier: MIT
#include "model/meets/model_meets.h"

#include "base/watch.h"
#include "face/meets/face_meet.h"
#include "intersect/rays/box_tree.h"
#include "model/meets/meet_joints.h"
#include "model/meets/placed_faces.h"
#include "model/meets/region_borders.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <utility>

namespace nrb::model {

namespace {

using intersect::BranchKind;
using intersect::Meet;
using intersect::MeetBranch;

// The pairs of faces whose boxes intersect.
std::vector<FacePair> near_pairs(const PlacedFaces &a, const PlacedFaces &b) {
    std::vector<intersect::Box3> boxes;
    for (const PlacedFaces::Place &place : b.places()) {
        boxes.push_back(place.box);
    }
    const intersect::BoxTree tree(boxes);
    std::vector<FacePair> pairs;
    for (size_t i = 0; i < a.places().size(); ++i) {
        const size_t first = pairs.size();
        tree.walk_box(a.places()[i].box, [&](int64_t j) { pairs.push_back({i, static_cast<size_t>(j)}); });
        std::ranges::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(), {}, &FacePair::b);
        count_work(100);
    }
    return pairs;
}

// Reverses the branches whose direction follows from the outer normals. Branches around regions keep the
// direction that they have in the domain of the first face, and edges that of its loops.
void run_backwards(Meet &meet) {
    for (MeetBranch &branch : meet.branches) {
        if (branch.kind == BranchKind::overlap || branch.kind == BranchKind::edge) {
            continue;
        }
        for (SplinePtr *curve : {&branch.space, &branch.on, &branch.on_second}) {
            *curve = refine::reverse(**curve, 0, false);
        }
        std::swap(branch.nodes[0], branch.nodes[1]);
    }
    std::ranges::reverse(meet.branches); // the order along a way is reversed, too
}

// Gives the regions of all pairs consecutive levels.
void number_regions(Meet &meet, int64_t &regions) {
    int64_t own = 0;
    const auto number = [&](auto &of) {
        own = std::max(own, of.level);
        of.level += of.level > 0 ? regions : 0;
    };
    std::ranges::for_each(meet.branches, number);
    std::ranges::for_each(meet.nodes, number);
    regions += own;
}

void name_faces(Meet &meet, const PlacedFaces::Place &a, const PlacedFaces::Place &b) {
    const auto name = [&](auto &of) {
        of.face = a.face;
        of.instance = a.instance;
        of.second_face = b.face;
        of.second_instance = b.instance;
    };
    std::ranges::for_each(meet.branches, name);
    for (MeetBranch &branch : meet.branches) {
        branch.loop = -1; // ways will be formed from all pairs together
    }
    std::ranges::for_each(meet.nodes, name);
}

} // namespace

Meet model_intersections(const Model &a, const Model &b, double tolerance) {
    // The caller's limit of work is for all pairs of faces. Without one, each pair has the usual limit of its
    // own.
    const LimitedSearch whole;
    PlacedFaces on_a(a), on_b(b);
    Meet found;
    found.of_two = true;
    std::vector<FacePair> of_branches;
    const std::vector<FacePair> pairs = near_pairs(on_a, on_b);
    int64_t regions = 0;
    Steps steps(std::ssize(pairs));
    for (const FacePair &pair : pairs) {
        const PlacedFaces::Place &first = on_a.places()[pair.a], &second = on_b.places()[pair.b];
        Meet own = face::strangers_intersections(*on_a.shape(pair.a), *on_b.shape(pair.b), tolerance);
        if (first.turned != second.turned) {
            run_backwards(own);
        }
        name_faces(own, first, second);
        number_regions(own, regions);
        of_branches.insert(of_branches.end(), own.branches.size(), pair);
        found.append(std::move(own));
        steps.next();
    }
    drop_along_regions(tolerance, of_branches, found);
    MeetJoints(on_a, on_b, of_branches, tolerance, found).run();
    found.tidy_nodes();
    return with_loops(arranged(std::move(found)));
}

} // namespace nrb::model
