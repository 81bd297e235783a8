// SPDX-License-Identifier: MIT
#include "face/arrange/split.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "face/arrange/domain_area.h"
#include "face/arrange/edge_sides.h"
#include "face/arrange/face_loops.h"
#include "face/arrange/parts.h"
#include "face/arrange/plane_map.h"
#include "face/made/curve_under.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <map>
#include <optional>

namespace nrb::face {

namespace {

constexpr int32_t of_face = 0, of_curves = -1;

// The half-edges with the face to their left. Edges along curves inside the face occur in both directions.
std::vector<DirectedEdge> dividing_edges(const Arrangement &arrangement, const PassedSums &at_corner) {
    std::vector<DirectedEdge> result;
    const std::vector<SideValues> sides = values_beside(arrangement, at_corner);
    for (size_t i = 0; i < sides.size(); ++i) {
        const auto is_inside = [](const PassedSums &sums) { return !sums.empty() && sums.front().value > 0; };
        if (is_inside(sides[i].left)) {
            result.push_back({i, false});
        }
        if (is_inside(sides[i].right)) {
            result.push_back({i, true});
        }
    }
    return result;
}

bool is_of_curves(const Arrangement &arrangement, const Arrangement::Member &member) {
    return arrangement.loop(arrangement.cuts().edges()[member.cut]).owner == of_curves;
}

// Removes the edges with the same part on both sides. If a dividing curve runs along one of these, `loose`
// becomes a place of it.
std::vector<DirectedEdge> between_parts(const Arrangement &arrangement, std::vector<DirectedEdge> edges,
                                        std::optional<Point2> &loose) {
    const PartsWithin parts(arrangement, edges);
    const std::vector<DirectedEdge> all = edges; // sorted
    std::erase_if(edges, [&](DirectedEdge edge) {
        const DirectedEdge other{edge.edge, !edge.back};
        const bool same =
            std::ranges::binary_search(all, other) && parts.part_left_of(edge) == parts.part_left_of(other);
        if (same && std::ranges::any_of(arrangement.edges()[edge.edge].members, [&](const auto &member) {
                return is_of_curves(arrangement, member);
            })) {
            loose = arrangement.nodes()[arrangement.from(edge)];
        }
        return same;
    });
    return edges;
}

// Notes on which sides of the dividing curves along its loops a part lies.
void set_sides(const Arrangement &arrangement, const PartLoops &loops, SplitPart &part) {
    for (const EdgeLoop &loop : loops) {
        for (const DirectedEdge edge : loop) {
            for (const Arrangement::Member &member : arrangement.edges()[edge.edge].members) {
                if (is_of_curves(arrangement, member)) {
                    (member.against == edge.back ? part.left : part.right) = true;
                }
            }
        }
    }
}

// By nodes: whether more than two edges meet there.
std::vector<bool> forks(const Arrangement &arrangement, const std::vector<DirectedEdge> &edges) {
    std::vector<std::vector<size_t>> at(arrangement.nodes().size());
    for (const DirectedEdge edge : edges) {
        at[arrangement.from(edge)].push_back(edge.edge);
        at[arrangement.to(edge)].push_back(edge.edge);
    }
    std::vector<bool> result;
    for (std::vector<size_t> &own : at) {
        std::ranges::sort(own);
        result.push_back(std::unique(own.begin(), own.end()) - own.begin() > 2);
    }
    return result;
}

// Makes the coedges of the parts. Those on both sides of one run have a common edge.
class Coedges {
public:
    // border: the half-edges between parts, sorted.
    Coedges(const Face &face, const Covering &covering, const Arrangement &arrangement,
            const std::vector<DirectedEdge> &border, double tolerance)
        : face_(face), covering_(covering), arrangement_(arrangement), tolerance_(tolerance),
          map_(plane_map(*face.surface())), shared_(arrangement.cuts().edges().size(), false) {
        for (size_t i = 1; i < border.size(); ++i) {
            if (border[i].edge == border[i - 1].edge) {
                shared_[arrangement.edges()[border[i].edge].members.front().cut] = true;
            }
        }
        for (const Loop &loop : face.loops()) {
            for (const Coedge &coedge : loop) {
                last_key_ = std::max(last_key_, coedge.key);
            }
        }
    }

    [[nodiscard]] Coedge of(const Run &run) {
        Coedge coedge{curve_of(arrangement_, run), nullptr};
        const Coedge *given = source(run);
        const bool keeps = given != nullptr && is_whole(arrangement_, run) && given->edge != nullptr;
        if (keeps) {
            coedge.edge = given->edge;
            coedge.key = key_of(*given, run);
            coedge.against = given->against != run.back;
            coedge.deviation = run.back ? std::nullopt : given->deviation;
            return coedge;
        }
        const Made &made = made_for(run, coedge, given);
        coedge.edge = made.edge;
        coedge.key = made.key;
        coedge.against = made.against != run.back;
        return coedge;
    }

private:
    struct Made {
        SplinePtr edge;
        int64_t key;
        bool against; // the curve, as the key of a coedge that stays whole says
    };

    // The coedge of the face that a run is a part of; null for a part of a dividing curve.
    [[nodiscard]] const Coedge *source(const Run &run) const {
        const Arrangement::Origin &own = arrangement_.origin(arrangement_.cuts().edges()[run.first]);
        return own.loop < face_.loops().size() ? &face_.loops()[own.loop][own.index] : nullptr;
    }
    // Of a coedge that stays whole. An edge without number gets one where parts on both sides have it, or
    // where it runs against the loop, which only a number tells.
    [[nodiscard]] int64_t key_of(const Coedge &given, const Run &run) {
        if (given.key != 0 || !(shared_[run.first] || run.back)) {
            return given.key;
        }
        int64_t &key = keys_[&given];
        key = key == 0 ? ++last_key_ : key;
        return key;
    }
    const Made &made_for(const Run &run, const Coedge &coedge, const Coedge *given) {
        const std::pair name{std::min(run.first, run.last), std::max(run.first, run.last)};
        const auto found = made_.find(name);
        if (found != made_.end()) {
            return found->second;
        }
        const SplinePtr along = run.back ? refine::reverse(*coedge.curve, 0, false) : coedge.curve;
        const bool whole = given != nullptr && is_whole(arrangement_, run) && given->key != 0;
        const int64_t key = whole ? given->key : ++last_key_;
        const SplinePtr edge =
            map_ ? map_->image(*along) : edge_over(face_.surface(), covering_, along, tolerance_).curve;
        const auto &cuts = arrangement_.cuts().edges();
        const size_t from = cuts[name.first].from, to = cuts[name.second].to;
        const SplinePtr own = snapped(snapped(edge, false, from), true, to);
        const bool against = whole && given->against;
        const Made made{against ? refine::reverse(*own, 0, false) : own, key, against};
        return made_.emplace(name, made).first->second;
    }
    // Makes all edges that come to a node end in one point, bit for bit. Curves end there to within the
    // tolerance as the domain measures it. Since parameters may be spread unevenly in space, edges may be
    // moved by a few tolerances.
    [[nodiscard]] SplinePtr snapped(const SplinePtr &edge, bool upper, size_t node) {
        constexpr double rounding = 0x1p-40; // of the size of the surface, or its coordinates
        auto [known, fresh] = points_.try_emplace(node);
        if (fresh) {
            known->second = point_at(*face_.surface(), covering_.in_domain(arrangement_.nodes()[node]));
        }
        const double reach = std::max(covering_.extent(), largest_magnitude(known->second));
        return with_end(edge, upper, known->second, std::max(rounding * reach, 4 * tolerance_));
    }

    const Face &face_;
    const Covering &covering_;
    const Arrangement &arrangement_;
    double tolerance_;
    std::optional<PlaneMap> map_;
    std::vector<bool> shared_; // by cuts: whether parts on both sides have it
    int64_t last_key_ = 0;
    std::map<const Coedge *, int64_t> keys_; // that edges without number get
    std::map<std::pair<size_t, size_t>, Made> made_;
    std::map<size_t, std::vector<double>> points_; // of nodes, in space
};

// The face of a part, without loops that are points of space, such as those around poles.
FacePtr face_of(const Face &face, const Arrangement &arrangement, const PartLoops &part,
                const std::vector<bool> &ends, double tolerance, Coedges &coedges) {
    FaceParts parts{face.surface(), {}, tolerance, true};
    for (const EdgeLoop &loop : part) {
        Loop own;
        for (const Run &run : runs_of(arrangement, loop, RunRule::shared, ends)) {
            own.push_back(coedges.of(run));
        }
        if (!own.empty()) {
            parts.tolerance = std::max(parts.tolerance, largest_gap(*face.surface(), face.covering(), own));
            parts.loops.push_back(std::move(own));
        }
    }
    return std::make_shared<const Face>(std::move(parts), nullptr);
}

} // namespace

SplitFace split_with_sides(const Face &face, std::span<const SplinePtr> curves, double tolerance) {
    if (face.has_gaps()) {
        fail(Status::gap, "the face has gaps larger than its tolerance");
    }
    const double near = std::max(tolerance, largest_gap(face));
    check_border_curves(curves);
    std::vector<ArrangedLoop> loops = loops_of(face, of_face);
    for (const SplinePtr &curve : curves) {
        loops.push_back({{{{curve, {0, 0}}}, {0, 0}}, of_curves});
    }
    const Arrangement arrangement(face.covering(), loops, near);
    AtCorner corner(arrangement);
    corner.add(face, of_face);
    SplitFace result;
    const std::vector<DirectedEdge> border =
        between_parts(arrangement, dividing_edges(arrangement, corner.sums()), result.loose);
    const std::vector<bool> ends = forks(arrangement, border);
    Coedges coedges(face, face.covering(), arrangement, border, near);
    std::vector<FacePtr> faces;
    for (const PartLoops &part : PartsWithin(arrangement, border).list(!corner.sums().empty())) {
        faces.push_back(face_of(face, arrangement, part, ends, std::max(near, face.tolerance()), coedges));
        set_sides(arrangement, part, result.parts.emplace_back(SplitPart{faces.back()}));
    }
    if (faces.empty()) {
        fail(Status::not_converged, "the face is no larger than the tolerance %s", Number(near).text);
    }
    check_area(arrangement, faces, domain_area(face));
    return result;
}

std::vector<FacePtr> split(const Face &face, std::span<const SplinePtr> curves, double tolerance) {
    std::vector<FacePtr> faces;
    for (SplitPart &part : split_with_sides(face, curves, tolerance).parts) {
        faces.push_back(std::move(part.face));
    }
    return faces;
}

} // namespace nrb::face
