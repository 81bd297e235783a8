// SPDX-License-Identifier: MIT
// Delaunay refinement: inserts vertices inside a mesh until no triangle has a small angle.
//
// A triangle with too small an angle has a circumcircle that is large for its shortest side. A vertex at the
// circumcentre is at least the circumradius away from all others, so that no side becomes shorter than those
// that there are, and the refinement terminates: P. Chew, Guaranteed-quality triangular meshes, 1989, and for
// surfaces 1993; J. Ruppert, A Delaunay refinement algorithm for quality 2-dimensional mesh generation, 1995;
// J. Shewchuk, Delaunay refinement algorithms for triangular mesh generation, 2002. Where a place nearer to
// the shortest side makes the angle large enough, that is taken instead: A. Üngör, Off-centers, 2004.
//
// Angles are those of the triangles in space. A place in the plane of a triangle corresponds to a place of
// the domain by the affine map that takes corners to corners. A side is flipped where that enlarges the
// smallest angle of its two triangles; in the plane these are the sides that are not Delaunay. Sides at the
// border stay as they are. Sides on a seam or a kink are halved where new places come too near to them or lie
// beyond them.
#pragma once

#include "mesh/domain/site_net.h"
#include "mesh/domain/sites.h"

#include <functional>

namespace nrb::mesh {

// angle_refinement.cpp judges triangles and decides on the order of steps, angle_places.cpp finds the places
// of new vertices, and angle_steps.cpp inserts them.
class AngleRefinement {
public:
    struct Rule {
        double angle = 0;    // the least one that is allowed
        double scale = 1;    // a power of two that brings lengths near 1
        double shortest = 0; // after scaling: no side of this length or less is divided
        // Whether a flip may make a side between two sites; and whether it may after keep_near().
        std::function<bool(int32_t from, int32_t to)> is_allowed_side{};
        std::function<bool(int32_t from, int32_t to)> is_near_side{};
    };
    AngleRefinement(const CellGrid &cells, Sites &sites, Rule rule)
        : cells_(cells), sites_(sites), rule_(std::move(rule)) {}

    // To be called for all triangles, and then join() once.
    int32_t add(const NetTriangle &triangle) { return net_.add(triangle); }
    void join();

    // From now on flips make no sides that are too far from the surface, even where that would enlarge
    // angles: otherwise a division that mends one triangle would spoil those beside it, row by row. To make
    // up for that, some longest sides are halved, and the number of further triangles is bounded.
    void keep_near() noexcept;
    // Refines until no triangle can be improved, or the limit of work is reached.
    void run();
    // Halves the longest side of a triangle that can be halved, if it is longer than `longer` in the unit of
    // the sites. A segment of the border has to be halved by the caller: then `border` is its number, else
    // -1.
    struct Divided {
        bool done = false;
        int32_t border = -1;
    };
    Divided divide(int32_t triangle, double longer);

    [[nodiscard]] const SiteNet &net() const noexcept { return net_; }
    void set_source(int32_t triangle, int32_t source) noexcept { net_.set_source(triangle, source); }
    void clear_dropped() noexcept { net_.clear_dropped(); }
    // Whether a triangle that counts has too small an angle. A triangle does not count if a corner lies at
    // the border or at a pole, or if a side there is in the way of the vertex in its circumcircle, since
    // these sides are given.
    [[nodiscard]] bool fails(int32_t triangle) const;

private:
    // The angle that is aimed at exceeds the least one by this factor, so that rounding does not matter.
    static constexpr double room = 1 + 1e-6;
    // Barycentric coordinates of a place in a triangle.
    using Shares = std::array<double, 3>;
    struct Place {
        int32_t triangle = -1; // that it is in; -1: none
        std::array<double, 2> param{};
        int64_t barrier = -1; // 4 t + k: side k of triangle t stays, and is in the way; -1: none
    };

    [[nodiscard]] Vector3 at(int32_t site) const noexcept {
        return rule_.scale * sites_.point(sites_[site].point);
    }
    [[nodiscard]] double side_length(int32_t a, int32_t b) const noexcept { return length(at(a) - at(b)); }
    [[nodiscard]] double least_angle(const std::array<int32_t, 3> &sites) const noexcept;
    [[nodiscard]] double area(const std::array<int32_t, 3> &sites) const noexcept;
    [[nodiscard]] double area(int32_t a, int32_t b, const std::array<double, 2> &x) const noexcept;
    [[nodiscard]] bool is_fixed(int32_t site) const noexcept {
        return static_cast<size_t>(site) < fixed_.size() && fixed_[static_cast<size_t>(site)] != 0;
    }
    [[nodiscard]] bool has_pole(int32_t triangle) const noexcept;
    [[nodiscard]] bool is_bad(int32_t triangle) const noexcept;
    [[nodiscard]] size_t shortest_side(int32_t triangle) const noexcept;
    [[nodiscard]] size_t longest_side(int32_t triangle) const noexcept;
    [[nodiscard]] Shares wanted_place(int32_t t, size_t k) const noexcept;
    [[nodiscard]] Place walk(int32_t triangle, const Shares &shares) const noexcept;
    [[nodiscard]] bool is_near(const Vector3 &x, int32_t triangle, double distance) const noexcept;
    [[nodiscard]] int64_t side_seen(const Vector3 &x, int32_t triangle) const noexcept;
    [[nodiscard]] int64_t side_in_the_way(const Vector3 &x, int32_t triangle) const;
    [[nodiscard]] Vector3 point_in(int32_t triangle, const std::array<double, 2> &param) const noexcept;
    [[nodiscard]] Place place_for(int32_t triangle) const;
    // A new site in a triangle; -1: there is one already.
    int32_t make_site(const std::array<double, 2> &param, int32_t triangle);
    bool improve(int32_t triangle);
    bool halve_longest(int32_t triangle, double shortest);
    bool improve_all();
    void flip_all();
    void set_budget();
    bool insert(const Place &place, double shortest);
    bool halve(int32_t triangle, size_t k, double shortest);
    [[nodiscard]] bool makes_triangles(int32_t triangle, size_t k,
                                       const std::array<double, 2> &x) const noexcept;
    void settle(int32_t site, std::array<int32_t, 4> around);
    [[nodiscard]] bool are_joined(int32_t start, size_t corner, int32_t point) const noexcept;
    [[nodiscard]] bool is_better_flipped(int32_t triangle, size_t k) const noexcept;
    void want(int32_t triangle);

    const CellGrid &cells_;
    Sites &sites_;
    Rule rule_;
    SiteNet net_;
    bool keeps_near_ = false;
    int64_t halvings_ = 0;            // of longest sides that may still be tried
    int64_t budget_ = 0;              // places that may still be tried
    std::vector<char> fixed_, poles_; // of sites: whether they are at sides that are given, and at poles
    // A heap of triangles to improve: the negative of the smallest angle; the triangle, and its sites when it
    // was added.
    std::vector<std::pair<double, std::array<int32_t, 4>>> waiting_;
    std::vector<std::pair<int32_t, size_t>> to_flip_;
};

} // namespace nrb::mesh
