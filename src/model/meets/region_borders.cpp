// SPDX-License-Identifier: MIT
#include "model/meets/region_borders.h"

#include "face/meets/along_border.h"
#include "intersect/pairs/curve_curve.h"

#include <algorithm>
#include <map>

namespace nrb::model {

namespace {

using intersect::BranchKind;
using intersect::MeetBranch;

// The borders of regions in which faces coincide, indexed by the face of either model.
class RegionBorders {
public:
    RegionBorders(double tolerance, const std::vector<FacePair> &of_branches, const intersect::Meet &meet)
        : tolerance_(tolerance) {
        for (size_t i = 0; i < meet.branches.size(); ++i) {
            if (meet.branches[i].kind == BranchKind::overlap) {
                of_a_[of_branches[i].a].push_back(&meet.branches[i]);
                of_b_[of_branches[i].b].push_back(&meet.branches[i]);
            }
        }
    }

    [[nodiscard]] bool hold(const FacePair &faces, const MeetBranch &branch) const {
        std::vector<Interval> along;
        add(of_a_, faces.a, branch, along);
        add(of_b_, faces.b, branch, along);
        return face::cover(std::move(along), branch.space->axis(0).domain());
    }

private:
    using Borders = std::map<size_t, std::vector<const MeetBranch *>>;

    void add(const Borders &borders, size_t face, const MeetBranch &branch,
             std::vector<Interval> &along) const {
        const auto found = borders.find(face);
        if (found == borders.end()) {
            return;
        }
        for (const MeetBranch *border : found->second) {
            const double room = 2 * (std::min(branch.deviation, tolerance_) +
                                     std::min(border->deviation, tolerance_) + tolerance_);
            for (const intersect::PairHit &hit :
                 intersect::curve_curve(*branch.space, *border->space, room).list) {
                if (hit.kind == intersect::HitKind::overlap) {
                    along.push_back(hit.range_a);
                }
            }
        }
    }

    double tolerance_;
    Borders of_a_, of_b_;
};

// What continued in a branch that is dropped ends where that began.
void forget_nodes_of(const MeetBranch &dropped, intersect::Meet &meet) {
    for (const int64_t own : dropped.nodes) {
        const int64_t next = own < 0 ? -1 : meet.nodes[static_cast<size_t>(own)].next;
        if (next >= 0) {
            meet.nodes[static_cast<size_t>(next)].next = -1;
            meet.nodes[static_cast<size_t>(next)].gap = 0;
        }
    }
}

} // namespace

void drop_along_regions(double tolerance, std::vector<FacePair> &of_branches, intersect::Meet &meet) {
    const RegionBorders borders(tolerance, of_branches, meet);
    std::vector<FacePair> faces;
    std::vector<MeetBranch> kept;
    std::vector<bool> goes;
    for (size_t i = 0; i < meet.branches.size(); ++i) {
        goes.push_back(meet.branches[i].kind == BranchKind::crossing &&
                       borders.hold(of_branches[i], meet.branches[i]));
    }
    for (size_t i = 0; i < goes.size(); ++i) {
        if (goes[i]) {
            forget_nodes_of(meet.branches[i], meet);
        } else {
            faces.push_back(of_branches[i]);
            kept.push_back(std::move(meet.branches[i]));
        }
    }
    of_branches = std::move(faces);
    meet.branches = std::move(kept);
}

} // namespace nrb::model
