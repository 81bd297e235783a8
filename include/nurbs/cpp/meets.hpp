/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file meets.hpp
/// \brief Curves where shapes meet, and the nodes where these end; every answer says whether it is complete.
#ifndef NURBS_CPP_MEETS_HPP
#define NURBS_CPP_MEETS_HPP

#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// What a node is.
inline constexpr std::int32_t node_border = NURBS_NODE_BORDER;
inline constexpr std::int32_t node_seam = NURBS_NODE_SEAM;
inline constexpr std::int32_t node_touch = NURBS_NODE_TOUCH;
inline constexpr std::int32_t node_undecided = NURBS_NODE_UNDECIDED;

/// How much a meet holds.
struct MeetCounts {
    std::int64_t branches; ///< Number of branches.
    std::int64_t nodes;    ///< Number of nodes.
    bool complete;         ///< Whether it is proven that there is nothing else, no node being undecided.
};

/// What branches belong to, and where they end.
struct MeetBranches {
    std::vector<std::int64_t> levels; ///< Which plane each lies in.
    /// [n][2]: the nodes at which it begins and ends, -1 where it closes.
    std::vector<std::int64_t> end_nodes;
    std::vector<std::int64_t> loops; ///< The closed way that it is a part of, counted from 0; -1 for none.
    std::vector<double> deviations;  ///< Proven bounds of the distances of its curves from the section.
};

/// Where branches end, and where there may be more than they tell.
struct MeetNodes {
    std::vector<std::int64_t> levels; ///< Which plane each lies in.
    std::vector<std::int32_t> kinds;  ///< One of the node_ constants each.
    std::vector<double> params;       ///< [n][2] of the surface; of a part its middle.
    /// [n][2][2] of parameters: the lower and upper end of the part on each axis.
    std::vector<double> ranges;
};

/// Curves where shapes meet: a handle that is copied in constant time and freed by its destructor.
class Meet : public detail::MeetHandle {
public:
    using MeetHandle::MeetHandle;

    // Curves where shapes meet, and the nodes where these end; every answer says whether it is complete

    /// Where planes normal . x = offset cut a surface: all curves to within a tolerance, proven to be all.
    [[nodiscard]] static Returned<Meet> sections(const Spline &g, const std::array<double, 3> &normal,
                                                 View<double> offsets, double tolerance) {
        return detail::made<Meet>(nurbs_surface_sections, g.get(), normal.data(), detail::length(offsets),
                                  offsets.data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> sections(const Spline &g, const std::array<double, 3> &normal,
                                                 View<double> offsets, double tolerance,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_sections_with, g.get(), normal.data(),
                                  detail::length(offsets), offsets.data(), tolerance, watch.get());
    }
    /// How much it holds.
    [[nodiscard]] Returned<MeetCounts> counts() const {
        MeetCounts found{};
        std::int32_t complete = 0;
        detail::call(nurbs_meet_counts, get(), &found.branches, &found.nodes, &complete);
        found.complete = complete != 0;
        return found;
    }
    /// What the branches belong to, and where they end.
    [[nodiscard]] Returned<MeetBranches> branches() const {
        MeetBranches found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_branches, get(), cap, found.levels.data(), found.end_nodes.data(),
                         found.loops.data(), found.deviations.data(), &count);
        };
        ask(0);
        found.levels = detail::room<std::int64_t>(count);
        found.end_nodes = detail::room<std::int64_t>(count, 2);
        found.loops = detail::room<std::int64_t>(count);
        found.deviations = detail::room(count);
        ask(count);
        return found;
    }
    /// The curves of a branch, with common knots: in space, and in the parameter domain.
    [[nodiscard]] Returned<std::pair<Spline, Spline>> branch(std::int64_t index) const {
        nurbs *space = nullptr, *on_surface = nullptr;
        detail::call(nurbs_meet_branch, get(), index, &space, &on_surface);
        return std::pair(Spline(space), Spline(on_surface));
    }
    /// Where branches end, and where there may be more than they tell.
    [[nodiscard]] Returned<MeetNodes> nodes() const {
        MeetNodes found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_nodes, get(), cap, found.levels.data(), found.kinds.data(),
                         found.params.data(), found.ranges.data(), &count);
        };
        ask(0);
        found.levels = detail::room<std::int64_t>(count);
        found.kinds = detail::room<std::int32_t>(count);
        found.params = detail::room(count, 2);
        found.ranges = detail::room(count, 2, 2);
        ask(count);
        return found;
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MEETS_HPP
