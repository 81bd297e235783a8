/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file mesh.hpp
/// \brief Shapes made of what is straight and flat, within a proven distance.
#ifndef NURBS_CPP_MESH_HPP
#define NURBS_CPP_MESH_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A polyline in place of a curve: parameters and points of its vertices, and how far it is from the curve,
/// as proven.
struct CurvePolyline {
    std::vector<double> params; ///< Of the vertices, rising; the same one twice where the curve jumps.
    std::vector<double> points; ///< The vertices, packed.
    double bound;               ///< No distance of a segment from its part of the curve is larger.
    bool reached;               ///< Whether all segments keep to the limits, as proven.
};

/// A polyline in place of a curve, every segment within `chord` of its part of the curve, as proven; with an
/// angle between tangents in a segment and a length of segments that are not exceeded either, if they are not
/// 0.
inline Returned<CurvePolyline> mesh_curve(const Spline &g, double chord, double angle = 0,
                                          double longest = 0) {
    CurvePolyline found{};
    std::int32_t reached = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_mesh_curve, g.get(), chord, angle, longest, cap, found.params.data(),
                     found.points.data(), &found.bound, &reached, &count);
    };
    ask(0);
    found.params = detail::room(count);
    found.points = detail::room(count, detail::dimension(g.get()));
    ask(count);
    found.reached = reached != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<CurvePolyline> mesh_curve(const Spline &g, double chord, double angle, double longest,
                                          const CallOptions &call) {
    CurvePolyline found{};
    const detail::Watch watch(call);
    std::int32_t reached = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_mesh_curve_with, g.get(), chord, angle, longest, cap, found.params.data(),
                     found.points.data(), &found.bound, &reached, &count, watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found.points = detail::room(count, detail::dimension(g.get()));
    ask(count);
    found.reached = reached != 0;
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MESH_HPP
