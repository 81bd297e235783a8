// SPDX-License-Identifier: MIT
// Makes the mesh of a domain by adaptive refinement. Triangles are made and proven in domain_mesher.cpp,
// judged and divided in domain_rounds.cpp; domain_angles.cpp removes small angles, and domain_output.cpp
// assembles the result.
#pragma once

#include "mesh/domain/angle_refinement.h"
#include "mesh/domain/domain_mesh.h"
#include "mesh/domain/triangle_pool.h"

#include <map>
#include <optional>
#include <set>

namespace nrb::mesh {

// Each round triangulates the cells inside and the strip along the border, and bounds how far every triangle
// is from the surface. Where a triangle is over a limit, the round adds cells, places of the strip or
// vertices of the border. What it does not change is kept.
class DomainMesher {
public:
    DomainMesher(const MeshDomain &domain, const MeshRule &rule);

    // Runs rounds until none would improve the mesh, or the work has ended. Returns whether there is a
    // result; otherwise the border has changed in a way that needs a new mesher.
    [[nodiscard]] bool run();
    // Takes over a border that was divided further. Returns whether this mesher can go on with it; otherwise
    // a new one is needed.
    [[nodiscard]] bool take_border();
    // last: run() is not called again, so that the memory of cells is freed for the result.
    [[nodiscard]] DomainMesh output(bool last);
    [[nodiscard]] size_t triangle_count() const noexcept { return triangles_.size(); }
    // Whether run() can be called again after an output that was not the last one.
    [[nodiscard]] bool goes_on() const noexcept { return !(rule_.least_angle > 0); }

private:
    // A cell and its triangles, which follow each other in the pool.
    struct CellState {
        std::array<int32_t, 4> corners{-1, -1, -1, -1}; // places; -1: not known
        int32_t places = 0;   // on its border, when its triangles were made; 0: they are to be made
        bool centred = false; // its triangles are a fan around a vertex in its middle
        TrianglePool::Range triangles;
    };

    [[nodiscard]] CellRule cell_rule() const;
    void coarsen(double factor) noexcept;
    [[nodiscard]] Side side_of(const Rectangle &part) const;
    void look_at_cells();
    void make_cells();
    void make_strip();
    [[nodiscard]] double rounding(double least_weight) const noexcept;
    [[nodiscard]] double within_reach(double length, double share) const noexcept;
    void prove();
    [[nodiscard]] Distances distances(size_t triangle) const noexcept;
    [[nodiscard]] MeshTriangle mesh_triangle(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] bool is_border(const Site &from, const Site &to) const noexcept;
    [[nodiscard]] std::array<int32_t, 3> points_of(const SiteTriangle &triangle) const noexcept {
        return {sites_[triangle.sites[0]].point, sites_[triangle.sites[1]].point,
                sites_[triangle.sites[2]].point};
    }
    // Whether two corners are one point, so that the triangle is degenerate.
    [[nodiscard]] bool is_at_point(const SiteTriangle &triangle) const noexcept {
        const auto p = points_of(triangle);
        return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    }
    // The side at whose midpoint a triangle of the strip is best divided.
    struct Split {
        double size = 0;               // length of the surface over it; infinite at a pole
        std::array<double, 2> place{}; // its midpoint
        int32_t border = -1;           // segment of the border
        double share = 0;              // of the extent of the domain
    };
    [[nodiscard]] Split split_of(const SiteTriangle &triangle) const;
    [[nodiscard]] bool is_large(size_t triangle) const noexcept {
        return !(distances(triangle).most() <= chord_) || is_long(triangle);
    }
    [[nodiscard]] bool is_long(size_t triangle) const noexcept {
        return longest_ > 0 && !(longest_side(triangles_[triangle]) <= longest_);
    }
    [[nodiscard]] double corners_off(size_t triangle) const noexcept;
    [[nodiscard]] bool is_held(size_t triangle) const noexcept;
    [[nodiscard]] bool is_over(size_t triangle) const {
        return is_large(triangle) || is_turned(triangles_[triangle]);
    }
    [[nodiscard]] double longest_side(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] double normals_apart(const SiteTriangle &triangle) const noexcept;
    [[nodiscard]] double turn_over(const SiteTriangle &triangle) const;
    [[nodiscard]] bool is_turned(const SiteTriangle &triangle) const {
        return angle_ > 0 && !is_at_point(triangle) &&
               (normals_apart(triangle) > most_apart_ || turn_over(triangle) > angle_);
    }
    [[nodiscard]] bool is_to_divide(size_t triangle) const;
    [[nodiscard]] double least_split(size_t triangle) const noexcept;
    [[nodiscard]] bool is_tiny(size_t triangle, const Split &split) const noexcept;
    [[nodiscard]] bool can_cut(int32_t cell) const noexcept;
    bool centre(int32_t cell);
    void make_cell(int32_t cell, const std::vector<int32_t> &border,
                   std::vector<std::array<int32_t, 3>> &sites);
    [[nodiscard]] int parts_for(size_t triangle) const noexcept;
    void add_weak(int32_t segment, int parts);
    [[nodiscard]] bool is_pair(size_t triangle) const noexcept;
    [[nodiscard]] bool change_border();
    void leave_border();
    void cut(const std::vector<int32_t> &cells);
    void add_place(const std::array<double, 2> &place, std::vector<std::array<double, 2>> &places) const;
    [[nodiscard]] double divide_in_strip(size_t triangle, std::vector<std::array<double, 2>> &places);
    bool divide_cells(std::vector<int32_t> cells);
    void divide_beside(std::vector<std::pair<size_t, double>> front,
                       std::vector<std::array<double, 2>> &places);
    [[nodiscard]] std::vector<std::pair<size_t, double>> beside(const std::vector<double> &sizes,
                                                                const std::vector<bool> &done) const;
    [[nodiscard]] bool improve();
    [[nodiscard]] bool keep_least_angle();
    void refine_angles();
    [[nodiscard]] AngleRefinement refinement();
    void take(AngleRefinement &refinement);
    bool divide_far(AngleRefinement &refinement);
    [[nodiscard]] bool is_whole() const;
    [[nodiscard]] std::vector<std::array<int32_t, 3>> all_points() const;
    [[nodiscard]] bool judge(DomainMesh &result) const;
    bool add_triangles(DomainMesh &result) const;
    void finish(bool good, DomainMesh &result) const;

    const MeshDomain &domain_;
    const MeshRule &rule_;
    const pieces::PieceGrid &grid_;
    std::optional<SegmentIndex> index_;
    double chord_, longest_, angle_; // the limits that triangles are made for
    double least_;                   // in units of the grid: nothing shorter is divided for an angle
    CellGrid cells_;
    double most_apart_;               // of unit normals: the chord of the angle
    std::array<double, 2> density_{}; // cells on a unit step along each axis, about
    Sites sites_;
    TriangleProof proof_;
    std::set<std::array<double, 2>> extra_; // additional places of the strip
    int round_ = 0;                         // since the border changed
    int all_rounds_ = 0;
    bool is_off_ = false;      // a triangle has a corner farther from the surface than the chord
    int changes_ = 0;          // of the border, for other reasons than distances
    int32_t known_points_ = 0; // of the domain, when the border was last taken over
    std::vector<CellState> states_;
    TrianglePool triangles_;
    double slack_ = 0;                                // what rounding adds to distances, in units of the grid
    std::vector<int32_t> crossed_;                    // segments of the border
    std::vector<std::array<int32_t, 2>> united_;      // points of the border
    std::vector<std::pair<int32_t, double>> touched_; // segments
    std::map<int32_t, int> weak_;             // segments, and into how many parts they are to be divided
    bool has_small_angles_ = false;           // angles that count are too small
    std::optional<DomainMesh> before_angles_; // the mesh before angles were refined, where it is better
};

} // namespace nrb::mesh
