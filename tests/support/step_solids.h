// Small solids and faces as STEP files, of which areas and numbers are known.
#pragma once

#include "support/step_builder.h"

#include <utility>

namespace step_test {

// With vertices and edges that faces share.
class SolidBuilder : public StepBuilder {
public:
    struct Bound {
        std::vector<std::pair<std::string, std::string>> edges; // with their orientations
        std::string sense = ".T.";
        std::string loop{}; // in place of edges
    };

    std::string line(const std::string &from, const std::string &way) {
        const std::string at = point(from), along = vector(way, "1.");
        return add("LINE(''," + at + "," + along + ")");
    }
    std::string circle(const std::string &place, const std::string &radius) {
        return add("CIRCLE(''," + place + "," + radius + ")");
    }
    std::string curve_edge(const std::string &from, const std::string &to, const std::string &curve) {
        return add("EDGE_CURVE(''," + from + "," + to + "," + curve + ",.T.)");
    }
    // At height z, X along x.
    std::string level(const std::string &z, const std::string &up = "1.") {
        return placement("0.,0.," + z, "0.,0.," + up, "1.,0.,0.");
    }
    std::string bounded_face(const std::string &surface, const std::vector<Bound> &bounds,
                             const std::string &sense = ".T.", const std::string &name = "") {
        std::string all;
        for (const Bound &bound : bounds) {
            all += (all.empty() ? "" : ",") + bound_of(bound, all.empty());
        }
        return add("ADVANCED_FACE('" + name + "',(" + all + ")," + surface + "," + sense + ")");
    }
    // The whole file, in millimetres.
    std::string solid(const std::vector<std::string> &faces) {
        std::string all;
        for (const std::string &face : faces) {
            all += (all.empty() ? "" : ",") + face;
        }
        const std::string shell = add("CLOSED_SHELL('',(" + all + "))");
        const std::string brep = add("MANIFOLD_SOLID_BREP(''," + shell + ")");
        const std::string length = millimetre(), angle = radian();
        shape(brep, context(length, angle));
        return text();
    }

private:
    std::string bound_of(const Bound &bound, bool outer) {
        std::string loop = bound.loop;
        if (loop.empty()) {
            std::string all;
            for (const auto &[edge, sense] : bound.edges) {
                all += (all.empty() ? "" : ",") + add("ORIENTED_EDGE('',*,*," + edge + "," + sense + ")");
            }
            loop = add("EDGE_LOOP('',(" + all + "))");
        }
        return add(std::string(outer ? "FACE_OUTER_BOUND" : "FACE_BOUND") + "(''," + loop + "," +
                   bound.sense + ")");
    }
};

// The sides of a cube [low, high]^3, seen from outside. Edges run along the axes; edge 4 k + j is the j-th one along axis k.
inline std::vector<std::string> cube_faces(SolidBuilder &b, const std::string &low_end,
                                           const std::string &high_end) {
    const auto place = [&](int corner) {
        const auto at = [&](int axis) { return corner >> axis & 1 ? high_end : low_end; };
        return at(0) + "," + at(1) + "," + at(2);
    };
    std::vector<std::string> vertices;
    for (int corner = 0; corner < 8; ++corner) {
        vertices.push_back(b.vertex(place(corner)));
    }
    const char *const ways[] = {"1.,0.,0.", "0.,1.,0.", "0.,0.,1."};
    std::string edges[3][8]; // by axis and first corner
    for (int axis = 0; axis < 3; ++axis) {
        for (int from = 0; from < 8; ++from) {
            if ((from >> axis & 1) == 0) {
                edges[axis][from] = b.curve_edge(vertices[static_cast<size_t>(from)],
                                                 vertices[static_cast<size_t>(from | 1 << axis)],
                                                 b.line(place(from), ways[axis]));
            }
        }
    }
    std::vector<std::string> faces;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int side = 0; side < 2; ++side) { // counterclockwise as seen against the axis
            const int low = side << axis;
            const SolidBuilder::Bound loop{{{edges[u][low], ".T."},
                                            {edges[v][low | 1 << u], ".T."},
                                            {edges[u][low | 1 << v], ".F."},
                                            {edges[v][low], ".F."}},
                                           side == 1 ? ".T." : ".F."};
            const std::string plane = b.add("PLANE(''," + b.placement(place(low), ways[axis], ways[u]) + ")");
            faces.push_back(b.bounded_face(plane, {loop}, side == 1 ? ".T." : ".F.",
                                           std::string(1, "xyz"[axis]) + (side == 1 ? "+" : "-")));
        }
    }
    return faces;
}

// The cube [0, 2]^3.
inline std::string step_cube() {
    SolidBuilder b;
    return b.solid(cube_faces(b, "0.", "2."));
}

// The cube [0, 4]^3 without the cubes [1, 2]^3 and [2.5, 3]^3 in it, whose shells are turned.
inline std::string step_hollow_cube() {
    SolidBuilder b;
    const auto shell = [&](const std::string &low, const std::string &high) {
        std::string all;
        for (const std::string &face : cube_faces(b, low, high)) {
            all += (all.empty() ? "" : ",") + face;
        }
        return b.add("CLOSED_SHELL('',(" + all + "))");
    };
    const std::string outer = shell("0.", "4."), first = shell("1.", "2."), second = shell("2.5", "3."),
                      turned = b.add("ORIENTED_CLOSED_SHELL('',*," + first + ",.F.)"),
                      other = b.add("ORIENTED_CLOSED_SHELL('',*," + second + ",.F.)");
    const std::string brep = b.add("BREP_WITH_VOIDS(''," + outer + ",(" + turned + "," + other + "))");
    const std::string length = b.millimetre(), angle = b.radian();
    b.shape(brep, b.context(length, angle));
    return b.text();
}

// Radius 2, from z = 0 to 5. The seam is a line, or a curve that says so.
inline std::string step_cylinder(bool seam_curve) {
    SolidBuilder b;
    const std::string low = b.vertex("2.,0.,0."), high = b.vertex("2.,0.,5.");
    const std::string bottom = b.level("0."), top = b.level("5.");
    const std::string lower = b.curve_edge(low, low, b.circle(bottom, "2."));
    const std::string upper = b.curve_edge(high, high, b.circle(top, "2."));
    std::string seam = b.line("2.,0.,0.", "0.,0.,1.");
    if (seam_curve) {
        seam = b.add("SEAM_CURVE(''," + seam + ",(),.CURVE_3D.)");
    }
    seam = b.curve_edge(low, high, seam);
    const std::string side = b.add("CYLINDRICAL_SURFACE(''," + bottom + ",2.)");
    return b.solid({b.bounded_face(side, {{{{lower, ".T."}, {seam, ".T."}, {upper, ".F."}, {seam, ".F."}}}}),
                    b.bounded_face(b.add("PLANE(''," + bottom + ")"), {{{{lower, ".F."}}}}, ".F."),
                    b.bounded_face(b.add("PLANE(''," + top + ")"), {{{{upper, ".T."}}}})});
}

// Base of radius 3 at z = 0, apex at z = 4, to which a seam goes. Its surface is that of a cone that opens downwards, or the half
// beyond the apex of one that opens upwards.
inline std::string step_cone(bool beyond_apex = false) {
    SolidBuilder b;
    const std::string base = b.level("0."), down = b.level("0.", "-1.");
    const std::string rim = b.vertex("3.,0.,0."), apex = b.vertex("0.,0.,4.");
    const std::string circle = b.curve_edge(rim, rim, b.circle(base, "3."));
    const std::string seam = b.curve_edge(rim, apex, b.line("3.,0.,0.", "-3.,0.,4."));
    const std::string side =
        b.add("CONICAL_SURFACE(''," + (beyond_apex ? b.level("8.") : down) + ",3.,0.643501108793284387)");
    return b.solid({b.bounded_face(side, {{{{circle, ".T."}, {seam, ".T."}, {seam, ".F."}}}}),
                    b.bounded_face(b.add("PLANE(''," + base + ")"), {{{{circle, ".F."}}}}, ".F.")});
}

// Radius 3; bounded by a vertex loop, or by its seam there and back.
inline std::string step_sphere(bool vertex_loop) {
    SolidBuilder b;
    const std::string ball = b.add("SPHERICAL_SURFACE(''," + b.level("0.") + ",3.)");
    const std::string south = b.vertex("0.,0.,-3."), north = b.vertex("0.,0.,3.");
    if (vertex_loop) {
        return b.solid({b.bounded_face(ball, {{{}, ".T.", b.add("VERTEX_LOOP(''," + south + ")")}})});
    }
    const std::string upright = b.placement("0.,0.,0.", "0.,-1.,0.", "1.,0.,0.");
    const std::string seam = b.curve_edge(south, north, b.circle(upright, "3."));
    return b.solid({b.bounded_face(ball, {{{{seam, ".T."}, {seam, ".F."}}}})});
}

// The upper half of a ring of radii 5 and 2, with its seam, on a plane.
inline std::string step_half_torus() {
    SolidBuilder b;
    const std::string flat = b.level("0."), outside = b.vertex("7.,0.,0."), inside = b.vertex("3.,0.,0.");
    const std::string across = b.placement("5.,0.,0.", "0.,-1.,0.", "1.,0.,0.");
    const std::string outer = b.curve_edge(outside, outside, b.circle(flat, "7."));
    const std::string inner = b.curve_edge(inside, inside, b.circle(flat, "3."));
    const std::string seam = b.curve_edge(outside, inside, b.circle(across, "2."));
    const std::string torus = b.add("TOROIDAL_SURFACE(''," + flat + ",5.,2.)");
    return b.solid(
        {b.bounded_face(torus, {{{{outer, ".T."}, {seam, ".T."}, {inner, ".F."}, {seam, ".F."}}}}),
         b.bounded_face(b.add("PLANE(''," + flat + ")"), {{{{outer, ".F."}}}, {{{inner, ".T."}}}}, ".F.")});
}

// The square [0, 4]^2 without a circle of radius 1 in it. `bound` is the sense of both bounds, whose loops are turned where it
// is .F.; `same` is that of the face.
inline std::string step_plate(const std::string &bound, const std::string &same) {
    SolidBuilder b;
    const char *const corners[] = {"0.,0.,0.", "4.,0.,0.", "4.,4.,0.", "0.,4.,0."};
    const char *const ways[] = {"1.,0.,0.", "0.,1.,0.", "-1.,0.,0.", "0.,-1.,0."};
    std::string vertices[4];
    for (size_t i = 0; i < 4; ++i) {
        vertices[i] = b.vertex(corners[i]);
    }
    const bool turned = (bound == ".T.") != (same == ".T.");
    SolidBuilder::Bound outer{{}, bound}, hole{{}, bound};
    for (size_t i = 0; i < 4; ++i) {
        const std::string edge =
            b.curve_edge(vertices[i], vertices[(i + 1) % 4], b.line(corners[i], ways[i]));
        outer.edges.insert(turned ? outer.edges.begin() : outer.edges.end(), {edge, turned ? ".F." : ".T."});
    }
    const std::string rim = b.vertex("3.,2.,0.");
    const std::string circle =
        b.curve_edge(rim, rim, b.circle(b.placement("2.,2.,0.", "0.,0.,1.", "1.,0.,0."), "1."));
    hole.edges.push_back({circle, turned ? ".T." : ".F."});
    return b.solid({b.bounded_face(b.add("PLANE(''," + b.level("0.") + ")"), {outer, hole}, same)});
}

// A right triangle with the legs 2 and 4.
inline std::string step_polygon() {
    SolidBuilder b;
    const std::string corners = b.point("0.,0.,1.") + "," + b.point("2.,0.,1.") + "," + b.point("0.,4.,1.");
    const std::string loop = b.add("POLY_LOOP('',(" + corners + "))");
    return b.solid({b.bounded_face(b.add("PLANE(''," + b.level("1.") + ")"), {{{}, ".T.", loop}})});
}

// The part v < u of the surface (u, v, u^2) over the unit square, a B-spline, with curves in its domain.
inline std::string step_patch() {
    SolidBuilder b;
    const auto row = [&b](const std::string &x, const std::string &z) {
        return "(" + b.point(x + ",0.," + z) + "," + b.point(x + ",1.," + z) + ")";
    };
    const std::string rows = row("0.", "0.") + "," + row("0.5", "0.") + "," + row("1.", "1.");
    const std::string surface = b.add("B_SPLINE_SURFACE_WITH_KNOTS('',2,1,(" + rows +
                                      "),.U.,.F.,.F.,.F.,(3,3),(2,2),(0.,1.),(0.,1.),.U.)");
    const auto parabola = [&b](const std::string &middle, const std::string &last) {
        const std::string points = b.point("0.,0.,0.") + "," + b.point(middle) + "," + b.point(last);
        return b.add("B_SPLINE_CURVE_WITH_KNOTS('',2,(" + points + "),.U.,.F.,.F.,(3,3),(0.,1.),.U.)");
    };
    const std::string flat = b.add("(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()"
                                   "REPRESENTATION_CONTEXT('2D',''))");
    const auto over = [&](const std::string &space, const std::string &from, const std::string &way) {
        const std::string line = b.line(from, way);
        const std::string where = b.add("DEFINITIONAL_REPRESENTATION('',(" + line + ")," + flat + ")");
        const std::string flat_curve = b.add("PCURVE(''," + surface + "," + where + ")");
        return b.add("SURFACE_CURVE(''," + space + ",(" + flat_curve + "),.CURVE_3D.)");
    };
    const std::string o = b.vertex("0.,0.,0."), s = b.vertex("1.,0.,1."), e = b.vertex("1.,1.,1.");
    const std::string south = b.curve_edge(o, s, over(parabola("0.5,0.,0.", "1.,0.,1."), "0.,0.", "1.,0."));
    const std::string east = b.curve_edge(s, e, over(b.line("1.,0.,1.", "0.,1.,0."), "1.,0.", "0.,1."));
    const std::string diagonal =
        b.curve_edge(o, e, over(parabola("0.5,0.5,0.", "1.,1.,1."), "0.,0.", "1.,1."));
    return b.solid({b.bounded_face(surface, {{{{south, ".T."}, {east, ".T."}, {diagonal, ".F."}}}})});
}

} // namespace step_test
