// SPDX-License-Identifier: MIT
// Snaps nearly equal knots together.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::reduce {

// Groups the knots of a domain into clusters, each of which becomes a single knot. The two ends of the domain
// come first, each with the knots at most `width` away on either side (the lower end first). Any other
// cluster consists of the lowest knot that is in no cluster yet, and of all knots at most `width` above it. A
// chain of close knots is therefore cut where it would get longer than the width. The ends keep their values.
// Any other cluster takes the value of its knot of highest multiplicity, the lowest one if there are several.
class KnotClusters {
public:
    // `knots` are sorted and distinct; knots outside the domain can only join an end. A width not below the
    // length of the domain is replaced by the next number below that length, so that the ends stay apart.
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

// The axis with its knots moved, and the layers that remain; the knots of a periodic axis outside the domain
// are copies of those inside. Returns the same axis if no knot moves. If more than degree + 1 knots of a
// non-periodic axis move to an end, functions between equal knots vanish: the first layer of a clamped start
// and the last layer of a clamped end stay, so that the end point does not move, and the layers next to it
// are dropped (for degree 0 the layers of the end itself). `owner` is the prefix of the message of
// Status::multiplicity, thrown if the knots of any other cluster together occur more than degree + 1 times.
refine::AxisTable moved_axis(const KnotVectorPtr &axis, const KnotClusters &clusters, int k,
                             const char *owner);

} // namespace nrb::reduce
