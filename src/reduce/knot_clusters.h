// SPDX-License-Identifier: MIT
// Near-equal knots made equal.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::reduce {

// Knots of a domain in groups that become one knot each. A group contains the lowest knot that is in no group
// yet, and all knots that are at most `width` above it. Only the two ends of the domain come first, each with
// the knots at most `width` away on either side (the lower end first). A chain of close knots is therefore
// cut where it gets longer than the width. The ends keep their values. Any other group becomes the knot in it
// that occurs most often, the lowest one if there are several.
class KnotClusters {
public:
    // `knots` are sorted and distinct; knots outside the domain join only an end. A width that is not below
    // the domain's length counts as the next number below it, so that the ends stay apart.
    KnotClusters(std::span<const KnotGroup> knots, Interval domain, double width);

    // The new value of a knot of the list.
    [[nodiscard]] double operator()(double knot) const noexcept;

private:
    struct Cluster {
        double first;
        double last;
        double value;
    };
    std::vector<Cluster> clusters_;
};

// An axis with its knots so moved, and the layers that are left; the knots of a periodic axis outside the
// domain are copies of those inside. The same axis if no knot moves. If more than degree + 1 knots become an
// end of a plain axis, functions between equal knots vanish with them: the first layer of a clamped start and
// the last of a clamped end stay, so that the end keeps its place, and the layers next to it are dropped (not
// of steps). `owner` begins the message of Status::multiplicity, thrown if knots of any other group together
// occur more than degree + 1 times.
refine::AxisTable moved_axis(const KnotVectorPtr &axis, const KnotClusters &clusters, int k,
                             const char *owner);

} // namespace nrb::reduce
