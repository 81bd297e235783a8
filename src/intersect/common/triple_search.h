// SPDX-License-Identifier: MIT
// A subdivision search for the common points of three surfaces.
#pragma once

#include "intersect/common/common_points.h"
#include "intersect/common/triple_chart.h"
#include "intersect/surfaces/cross_side.h"

#include <deque>
#include <vector>

namespace nrb::intersect {

// First triples of pieces whose boxes intersect, then triples of their parts, breadth first. A triple is
// excluded, has a chart, or one of its parts is halved. Where the number of triples grows without end, as
// along a common curve of all three surfaces, they are left open.
class TripleSearch {
public:
    TripleSearch(const std::array<const Spline *, 3> &surfaces, const std::array<SurfaceBorders, 3> &borders);

    // Every point occurs once for each triple of pieces that contains it.
    std::vector<CommonPoint> run(double tolerance);

private:
    using PairCell = closest::PairCell;
    using Cells = std::array<PairCell *, 3>;
    void find_pieces();
    void look_at(const Cells &cells);
    void divide(const Cells &cells);
    void look(const TripleParts &parts);
    void look_at_chart(const TripleParts &parts);
    void halve(const TripleParts &parts, size_t first);
    void add_open(const TripleParts &parts);
    void add_unknown(const Cells &cells);
    void add_point(const TripleParts &parts, const TripleChart::Found &found);

    pieces::Frame frame_;
    std::deque<CrossSide> sides_;
    double tolerance_ = 0;
    std::vector<Cells> stack_;
    std::vector<TripleParts> parts_, next_;
    TripleChart chart_;
    std::vector<CommonPoint> found_;
};

} // namespace nrb::intersect
