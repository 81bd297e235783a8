// SPDX-License-Identifier: MIT
#include "intersect/surfaces/contact/contact_curves.h"

#include "base/watch.h"
#include "intersect/surfaces/curves/segment_seams.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

constexpr size_t most_curves = 256;

// Adds the branches of one curve, with their nodes.
class Branches {
public:
    Branches(const pieces::Frame &frame, const CrossSurface &a, const CrossSurface &b, int64_t loop,
             Meet &meet)
        : frame_(frame), surfaces_{&a, &b}, loop_(loop), meet_(meet) {}

    void add(const ContactCurve &curve) {
        std::vector<std::vector<CrossSegment>> parts =
            parts_between_seams(*surfaces_[0], *surfaces_[1], curve.segments, curve.closed);
        const bool cut =
            curve.closed && is_seam(*surfaces_[0], *surfaces_[1], parts.back().back(), parts.front().front());
        if (curve.closed && !cut && parts.size() == 1) {
            add_branch(std::move(parts.front()), true, {-1, -1});
            return;
        }
        const auto first = std::ssize(meet_.nodes);
        for (size_t i = 0; i < parts.size(); ++i) {
            const bool begins = i == 0 && !cut, ends = i + 1 == parts.size() && !cut;
            const int64_t from = add_node(begins ? NodeKind::border : NodeKind::seam, parts[i].front(), 0);
            const int64_t to = add_node(ends ? NodeKind::border : NodeKind::seam, parts[i].back(), 3);
            if (i > 0) {
                go_on(from - 1, from);
            }
            add_branch(std::move(parts[i]), false, {from, to});
        }
        if (cut) {
            go_on(std::ssize(meet_.nodes) - 1, first);
        }
    }

private:
    int64_t add_node(NodeKind kind, const CrossSegment &segment, size_t place) {
        MeetNode &node = meet_.nodes.emplace_back(MeetNode{0, kind, {}, {}});
        for (size_t k = 0; k < 2; ++k) {
            node.at[k] = segment.on[0][place][k];
            node.at_second[k] = segment.on[1][place][k];
            node.range[k] = {node.at[k], node.at[k]};
            node.range_second[k] = {node.at_second[k], node.at_second[k]};
        }
        return std::ssize(meet_.nodes) - 1;
    }
    void go_on(int64_t from, int64_t to) {
        meet_.nodes[static_cast<size_t>(from)].next = to;
        meet_.nodes[static_cast<size_t>(to)].next = from;
    }
    void add_branch(std::vector<CrossSegment> segments, bool closed, const std::array<int64_t, 2> &nodes) {
        meet_.branches.push_back(
            branch_along(cross_curve(frame_, *surfaces_[0], *surfaces_[1], std::move(segments), closed),
                         nodes, loop_, BranchKind::touch));
    }

    const pieces::Frame &frame_;
    std::array<const CrossSurface *, 2> surfaces_;
    int64_t loop_;
    Meet &meet_;
};

} // namespace

std::vector<ContactCurve> contact_curves(ContactTracer &tracer, CrossParts &found) {
    std::vector<ContactCurve> curves;
    size_t tries = 0;
    double change = 0;
    for (const CrossContact &contact : found.contacts) {
        change = std::max(change, contact.change);
    }
    for (const CrossContact &contact : found.contacts) {
        const auto passes = [&](const ContactCurve &curve) {
            count_work(20 * std::ssize(curve.segments));
            return tracer.passes(curve, contact.place);
        };
        if (std::ranges::any_of(curves, passes)) {
            continue;
        }
        if (tries++ < most_curves && !work_ended()) {
            ContactCurve curve = tracer.trace(contact.place);
            if ((curve.closed || curve.ends) && !curve.segments.empty() && tracer.is_contact(curve, change)) {
                curves.push_back(std::move(curve));
                continue;
            }
        }
        found.clusters.push_back({contact.ranges});
    }
    return curves;
}

void add_branches(const std::vector<ContactCurve> &curves, const pieces::Frame &frame, const CrossSurface &a,
                  const CrossSurface &b, Meet &meet) {
    int64_t loops = 0;
    for (const MeetBranch &branch : meet.branches) {
        loops = std::max(loops, branch.loop + 1);
    }
    for (const ContactCurve &curve : curves) {
        Branches(frame, a, b, curve.closed ? loops++ : -1, meet).add(curve);
    }
}

} // namespace nrb::intersect
