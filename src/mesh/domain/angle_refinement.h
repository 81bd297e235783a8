// SPDX-License-Identifier: MIT
// Delaunay refinement: triangles without small angles, by more vertices inside.
//
// A triangle with an angle that is too small has a circle that is large for its shortest side. A vertex at the centre of that circle
// is as far from all others as the radius says, so that sides do not become shorter than those that there are, and it comes to an
// end: P. Chew, Guaranteed-quality triangular meshes, 1989, and for surfaces 1993; J. Ruppert, A Delaunay refinement algorithm for
// quality 2-dimensional mesh generation, 1995; J. Shewchuk, Delaunay refinement algorithms for triangular mesh generation,
// 2002. Where a nearer place makes the angle large enough, it is taken: A. Üngör, Off-centers, 2004.
//
// Angles are those of the triangles in space. A place in the plane of a triangle is one of the domain by the map that takes corners to
// corners. Sides are flipped where that makes the smallest angle of two triangles larger, which in the plane is where
// they are not Delaunay. Sides at the border stay as they are. Sides on a seam or a kink are halved where places come too near to
// them or lie beyond.
#pragma once

#include "mesh/domain/site_net.h"
#include "mesh/domain/sites.h"

#include <functional>

namespace nrb::mesh {

// Judging and the order of things are in angle_refinement.cpp, where vertices are wanted in angle_places.cpp, and what makes them in
// angle_steps.cpp.
class AngleRefinement {
public:
    struct Rule {
        double angle = 0;    // the least one
        double scale = 1;    // by a power of two lengths come near 1
        double shortest = 0; // in that unit: no side of such a length is divided
        std::function<bool(int32_t from, int32_t to)> is_allowed_side{}; // between sites, for new ones
        std::function<bool(int32_t from, int32_t to)> is_near_side{};    // the same, of keep_near()
    };
    AngleRefinement(const CellGrid &cells, Sites &sites, Rule rule)
        : cells_(cells), sites_(sites), rule_(std::move(rule)) {}

    // All triangles, and then join() once.
    int32_t add(const NetTriangle &triangle) { return net_.add(triangle); }
    void join();

    // From now on flips make no sides that are too far from the surface, even where angles would be larger: else what one division
    // mends would go on in the triangles beside it, row by row. For that some longest sides are halved, and there is a bound of
    // how many triangles that may make.
    void keep_near() noexcept;
    // Until no triangle can be made better, or the limit of work.
    void run();
    // Halves the longest side of a triangle that can be halved, if it is longer than that in the unit of the sites. A segment of the border would have to be
    // halved by others: then that is told, else -1.
    struct Divided {
        bool done = false;
        int32_t border = -1;
    };
    Divided divide(int32_t triangle, double longer);

    [[nodiscard]] const SiteNet &net() const noexcept { return net_; }
    void set_source(int32_t triangle, int32_t source) noexcept { net_.set_source(triangle, source); }
    void clear_dropped() noexcept { net_.clear_dropped(); }
    // The smallest angle of a triangle is too small, and neither does a corner lie at the border or at a pole nor is the border in the way
    // of a vertex in its circle: there sides are given.
    [[nodiscard]] bool fails(int32_t triangle) const;

private:
    // Angles are aimed at by so much more than asked for, so that rounding does not count.
    static constexpr double room = 1 + 1e-6;
    // Shares of the corners of a triangle, of the sum 1.
    using Shares = std::array<double, 3>;
    struct Place {
        int32_t triangle = -1; // -1: none
        std::array<double, 2> param{};
        int32_t barrier = -1; // the side that stays in the way: 4 times its triangle and its number
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
    [[nodiscard]] Shares wanted_place(int32_t triangle, size_t shortest) const noexcept;
    [[nodiscard]] Place walk(int32_t triangle, const Shares &shares) const noexcept;
    [[nodiscard]] bool is_near(const Vector3 &x, int32_t triangle, double distance) const noexcept;
    [[nodiscard]] int32_t side_seen(const Vector3 &x, int32_t triangle) const noexcept;
    [[nodiscard]] int32_t side_in_the_way(const Vector3 &x, int32_t triangle) const;
    [[nodiscard]] Vector3 point_in(int32_t triangle, const std::array<double, 2> &param) const noexcept;
    [[nodiscard]] Place place_for(int32_t triangle) const;
    // -1 if there is one.
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
    std::vector<char> fixed_, poles_; // sites at the border, and at poles
    std::vector<std::pair<double, std::array<int32_t, 4>>>
        waiting_; // a heap: angles, triangles with their sites
    std::vector<std::pair<int32_t, size_t>> to_flip_;
};

} // namespace nrb::mesh
