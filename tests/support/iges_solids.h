// Small faces and solids as IGES files, of which areas and numbers are known.
#pragma once

#include "face/integrals/face_moments.h"
#include "support/iges_reading.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace iges_test {

inline nrb::model::Model read_model(const std::string &text, const nrb::io::ReadSettings &settings = {}) {
    return nrb::io::read_model(text, settings);
}
inline nrb::model::Model read_model(const IgesBuilder &builder, const nrb::io::ReadSettings &settings = {}) {
    return read_model(builder.text(), settings);
}

inline double area_of(const nrb::model::ModelFace &face) {
    return nrb::face::moments(*face.face, nrb::measure::MomentOrder::content, 1e-10).content;
}

inline std::string listed(const std::vector<int64_t> &pointers) {
    std::string text = std::to_string(pointers.size());
    for (const int64_t pointer : pointers) {
        text += "," + std::to_string(pointer);
    }
    return text;
}

using Corner = std::array<int, 3>;

class FacesBuilder : public IgesBuilder {
public:
    static std::string name(int64_t pointer) { return std::to_string(pointer); }
    static std::string coordinates(const Corner &x) {
        return name(x[0]) + "," + name(x[1]) + "," + name(x[2]);
    }

    // The plane parallelogram with corners at a, b (along v), c (along u), d, over [0, 1]^2.
    int64_t patch(const Corner &a, const Corner &b, const Corner &c, const Corner &d,
                  const Fields &fields = {}) {
        return add(128,
                   "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.," + coordinates(a) + "," +
                       coordinates(c) + "," + coordinates(b) + "," + coordinates(d) + ",0.,1.,0.,1.",
                   fields);
    }
    // [0, size]^2 at z = 0.
    int64_t square(int size, const Fields &fields = {}) {
        return patch({0, 0, 0}, {0, size, 0}, {size, 0, 0}, {size, size, 0}, fields);
    }
    int64_t line(const Corner &a, const Corner &b, const Fields &fields = {}) {
        return add(110, coordinates(a) + "," + coordinates(b), fields);
    }
    int64_t composite(const std::vector<int64_t> &curves) { return add(102, listed(curves)); }
    // Through text coordinates "x,y" (or "x,y,z") one after the other and back to the first.
    int64_t polygon(const std::vector<std::string> &corners) {
        std::vector<int64_t> sides;
        for (size_t i = 0; i < corners.size(); ++i) {
            sides.push_back(add(110, point(corners[i]) + "," + point(corners[(i + 1) % corners.size()])));
        }
        return composite(sides);
    }
    int64_t curve_on_surface(int64_t surface, int64_t domain_curve, int64_t space_curve, int preference) {
        return add(142, "0," + name(surface) + "," + name(domain_curve) + "," + name(space_curve) + "," +
                            name(preference));
    }
    // With an outer boundary of 0, that of the domain.
    int64_t trimmed(int64_t surface, int64_t outer, const std::vector<int64_t> &inner = {},
                    const Fields &fields = {}) {
        std::string text = name(surface) + "," + (outer == 0 ? "0" : "1") + "," + name(std::ssize(inner)) +
                           "," + name(outer);
        for (const int64_t pointer : inner) {
            text += "," + name(pointer);
        }
        return add(144, text, fields);
    }
    // A cylinder about the z axis over a height, by turning the line at (radius, 0): u along the line, v the angle.
    int64_t cylinder(int radius, int height) {
        const int64_t axis = line({0, 0, 0}, {0, 0, 1}), side = line({radius, 0, 0}, {radius, 0, height});
        return add(120, name(axis) + "," + name(side) + ",0.,6.283185307179586");
    }

    int64_t subfigure(const std::string &title, const std::vector<int64_t> &members) {
        return add(308, "0," + name(std::ssize(title)) + "H" + title + "," + listed(members));
    }
    int64_t instance(int64_t subfigure, const std::string &translation, const std::string &scale = "",
                     const Fields &fields = {}) {
        return add(408, name(subfigure) + "," + translation + (scale.empty() ? "" : "," + scale), fields);
    }
    int64_t matrix(const std::string &rows) { return add(124, rows); }

private:
    static std::string point(const std::string &x) {
        return std::count(x.begin(), x.end(), ',') == 1 ? x + ",0." : x;
    }
};

// A cube [0, 1]^3 as a solid with 8 vertices, 12 edges and 6 faces, whose outer normals are told by their orientations.
class CubeBuilder : public FacesBuilder {
public:
    // `damaged`: the index of an edge of which the curve is not there; -1: none.
    int64_t cube(int damaged = -1, const Fields &face_fields = {}, const Fields &shell_fields = {},
                 const Fields &solid_fields = {}) {
        std::string points = "8";
        for (int i = 0; i < 8; ++i) {
            points += "," + coordinates(corner(i));
        }
        vertices_ = add(502, points);
        make_edges(damaged);
        std::string faces = "6";
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                // Along the next two axes, so that the normal of the surface is along the axis.
                faces += "," + name(face(axis, side, face_fields)) + "," + name(side);
            }
        }
        const int64_t shell = add(514, faces, shell_fields);
        return add(186, name(shell) + ",1,0", solid_fields);
    }

private:
    static Corner corner(int i) { return {i & 1, (i >> 1) & 1, (i >> 2) & 1}; }

    // From each corner to its neighbours along the axes; every second one is written backwards, which its vertices tell.
    void make_edges(int damaged) {
        std::vector<std::pair<int64_t, std::pair<int, int>>> edges;
        for (int i = 0; i < 8; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                if (((i >> axis) & 1) == 0) {
                    const int j = i | (1 << axis);
                    const bool back = edges.size() % 2 == 1;
                    const int64_t curve = std::ssize(edges) == damaged ? 9999
                                          : back                       ? line(corner(j), corner(i))
                                                                       : line(corner(i), corner(j));
                    edges.push_back({curve, {i, j}});
                    ends_.push_back({i, j});
                }
            }
        }
        std::string text = name(std::ssize(edges));
        for (const auto &[curve, ends] : edges) {
            text += "," + name(curve) + "," + name(vertices_) + "," + name(ends.first + 1) + "," +
                    name(vertices_) + "," + name(ends.second + 1);
        }
        edges_ = add(504, text);
    }
    int64_t face(int axis, int side, const Fields &fields) {
        const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), at = side << axis;
        const int64_t surface = patch(corner(at), corner(at | v), corner(at | u), corner(at | u | v));
        const std::array<int, 5> round{at, at | u, at | u | v, at | v, at};
        std::string text = "4";
        for (size_t k = 0; k < 4; ++k) {
            text += "," + edge_use(round[k], round[k + 1]);
        }
        const int64_t loop = add(508, text);
        return add(510, name(surface) + ",1,1," + name(loop), fields);
    }
    std::string edge_use(int from, int to) const {
        for (size_t i = 0; i < ends_.size(); ++i) {
            if (ends_[i] == std::pair{from, to} || ends_[i] == std::pair{to, from}) {
                return "0," + name(edges_) + "," + name(static_cast<int64_t>(i) + 1) + "," +
                       (ends_[i].first == from ? "1" : "0") + ",0";
            }
        }
        throw std::logic_error("no such edge");
    }

    int64_t vertices_ = 0, edges_ = 0;
    std::vector<std::pair<int, int>> ends_;
};

} // namespace iges_test
