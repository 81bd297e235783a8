// Many samples of a shape against its mesh and the other way, and which sides of triangles may be free.
#pragma once

#include "property/meshes.h"
#include "support/generators.h"

#include <numeric>

namespace support::meshes {

// Triangles of one face by the part of the domain that they lie over. Those over a place are near its point; only where these
// are farther than allowed does it take all of them.
class DomainTriangles {
public:
    explicit DomainTriangles(const Mesh &mesh) : mesh_(mesh) {
        for (size_t k = 0; k < 2; ++k) {
            lower_[k] = INFINITY;
            double upper = -INFINITY;
            for (const auto &param : mesh.params) {
                lower_[k] = std::min(lower_[k], param[k]);
                upper = std::max(upper, param[k]);
            }
            side_[k] = std::max((upper - lower_[k]) / static_cast<double>(parts()), 1e-300);
        }
        cells_.resize(parts() * parts());
        for (size_t i = 0; i < mesh.triangles.size(); ++i) {
            add(i);
        }
    }

    [[nodiscard]] bool is_near(const std::array<double, 2> &param, const Point &x, double most) const {
        const auto &over = cells_[cell(0, param[0]) * parts() + cell(1, param[1])];
        const auto near = [&](size_t i) { return triangle(mesh_, i).distance(x) <= most; };
        return std::ranges::any_of(over, near) || distance(mesh_, x) <= most;
    }

private:
    [[nodiscard]] size_t parts() const {
        return static_cast<size_t>(std::sqrt(static_cast<double>(mesh_.triangles.size()))) + 1;
    }
    [[nodiscard]] size_t cell(size_t k, double param) const {
        const double at = std::floor((param - lower_[k]) / side_[k]);
        return static_cast<size_t>(std::clamp(at, 0.0, static_cast<double>(parts() - 1)));
    }
    void add(size_t i) {
        std::array<size_t, 2> first{parts(), parts()}, last{0, 0};
        for (const int64_t vertex : mesh_.triangles[i]) {
            for (size_t k = 0; k < 2; ++k) {
                const size_t at = cell(k, mesh_.params[static_cast<size_t>(vertex)][k]);
                first[k] = std::min(first[k], at);
                last[k] = std::max(last[k], at);
            }
        }
        for (size_t u = first[0]; u <= last[0]; ++u) {
            for (size_t v = first[1]; v <= last[1]; ++v) {
                cells_[u * parts() + v].push_back(i);
            }
        }
    }

    const Mesh &mesh_;
    std::array<double, 2> lower_{}, side_{};
    std::vector<std::vector<size_t>> cells_;
};

// Of the domain, and of a face those inside.
inline Vec places_of(const nurbs *g, const nurbs_face *face, Random &random, int64_t count) {
    double u[2], v[2];
    require_ok(nurbs_domain(g, 0, u));
    require_ok(nurbs_domain(g, 1, v));
    Vec places;
    for (int64_t i = 0; i < count; ++i) {
        places.insert(places.end(), {random.between(u[0], u[1]), random.between(v[0], v[1])});
    }
    if (face != nullptr) {
        const std::vector<int32_t> sides = faces::sides(face, places);
        Vec inside;
        for (size_t i = 0; i < sides.size(); ++i) {
            if (sides[i] > 0) {
                inside.insert(inside.end(), {places[2 * i], places[2 * i + 1]});
            }
        }
        places = std::move(inside);
    }
    return places;
}

// No sample of the shape is farther from the mesh than it says; `face` may be null.
inline void expect_shape_near(const nurbs *g, const nurbs_face *face, const Mesh &mesh, Random &random,
                              int64_t samples) {
    const DomainTriangles triangles(mesh);
    constexpr int64_t batch = 4096;
    int64_t far = 0, seen = 0;
    for (int64_t done = 0; done < samples; done += batch) {
        const Vec places = places_of(g, face, random, std::min(batch, samples - done)),
                  points = eval(g, places);
        for (size_t i = 0; 2 * i < places.size(); ++i, ++seen) {
            const Point x{points[3 * i], points[3 * i + 1], points[3 * i + 2]};
            const double most = mesh.from_shape * (1 + 1e-12);
            far += triangles.is_near({places[2 * i], places[2 * i + 1]}, x, most) ? 0 : 1;
        }
    }
    EXPECT_GT(seen, 0);
    EXPECT_EQ(far, 0) << "of " << seen << " samples farther from the mesh than " << mesh.from_shape;
}

// Places of triangles that are farther from the points with their parameters than `most`.
inline Vec far_places(const nurbs *g, const Mesh &mesh, Random &random, int64_t samples, double most) {
    Vec places, params, far;
    for (int64_t i = 0; i < samples; ++i) {
        const auto at = static_cast<size_t>(random.bits() % mesh.triangles.size());
        const double root = std::sqrt(random.unit()), part = random.unit() * root;
        const std::array<double, 3> shares{1 - root, root - part, part};
        const Point x = triangle(mesh, at).at(shares[1], shares[2]);
        places.insert(places.end(), x.begin(), x.end());
        for (size_t k = 0; k < 2; ++k) {
            params.push_back(0);
            for (size_t c = 0; c < 3; ++c) {
                params.back() += shares[c] * mesh.params[static_cast<size_t>(mesh.triangles[at][c])][k];
            }
        }
    }
    const Vec points = eval(g, params, NURBS_CLAMP | NURBS_CLAMP << 8);
    for (size_t i = 0; i < places.size(); i += 3) {
        const Point off{places[i] - points[i], places[i + 1] - points[i + 1], places[i + 2] - points[i + 2]};
        if (!(std::sqrt(dot(off, off)) <= most)) {
            far.insert(far.end(), {places[i], places[i + 1], places[i + 2]});
        }
    }
    return far;
}

// No sample of the triangles is farther from the surface than the mesh says.
inline void expect_mesh_near(const nurbs *g, const Mesh &mesh, Random &random, int64_t samples) {
    constexpr int64_t batch = 4096;
    for (int64_t done = 0; done < samples; done += batch) {
        const Vec far = far_places(g, mesh, random, std::min(batch, samples - done), mesh.from_mesh);
        const auto n = std::ssize(far) / 3;
        if (n == 0) {
            continue;
        }
        Vec params(static_cast<size_t>(2 * n)), distances(static_cast<size_t>(n));
        require_ok(nurbs_closest_points(g, n, far.data(), 0, 0, nullptr, mesh.from_mesh / 1024, 0,
                                        params.data(), 0, 0, nullptr, 0, 0, distances.data(), 0, nullptr, 0));
        EXPECT_LE(*std::ranges::max_element(distances), mesh.from_mesh * (1 + 1.0 / 512));
    }
}

// Without a triangle on their other side are segments of edges alone, and each of these is a side of a triangle. Every point
// and every vertex is a corner.
inline void expect_whole(const Mesh &mesh, const Sides &sides) {
    const auto has = [&](int64_t a, int64_t b) { return sides.count({a, b}) > 0; };
    std::set<std::array<int64_t, 2>> segments;
    for (size_t i = 0; i < mesh.edge_firsts.size(); ++i) {
        for (int64_t k = 1; k < mesh.edge_sizes[i]; ++k) {
            const int64_t *at = &mesh.edge_points[static_cast<size_t>(mesh.edge_firsts[i] + k)];
            segments.insert({std::min(at[-1], at[0]), std::max(at[-1], at[0])});
        }
    }
    int64_t loose = 0, open = 0;
    for (const auto &[a, b] : segments) {
        loose += a == b || has(a, b) || has(b, a) ? 0 : 1;
    }
    for (const auto &[side, count] : sides) {
        EXPECT_EQ(count, 1);
        open += has(side[1], side[0]) ||
                        segments.count({std::min(side[0], side[1]), std::max(side[0], side[1])}) > 0
                    ? 0
                    : 1;
    }
    EXPECT_EQ(loose, 0) << "segments of edges are no sides";
    EXPECT_EQ(open, 0) << "sides are free inside";
    std::set<int64_t> points, vertices;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        points.insert(mesh.welded[i].begin(), mesh.welded[i].end());
        vertices.insert(mesh.triangles[i].begin(), mesh.triangles[i].end());
    }
    EXPECT_EQ(points.size(), mesh.points.size()) << "points are loose";
    EXPECT_EQ(vertices.size(), mesh.at.size()) << "vertices are loose";
}
inline void expect_whole(const Mesh &mesh) {
    expect_whole(mesh, sides_of(mesh));
}

} // namespace support::meshes
