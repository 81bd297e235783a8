// SPDX-License-Identifier: MIT
// What makes the mesh of a domain: making and proving in domain_mesher.cpp, judging and dividing in domain_rounds.cpp, angles in
// domain_angles.cpp, the result in domain_output.cpp.
#pragma once

#include "mesh/domain/angle_refinement.h"
#include "mesh/domain/domain_mesh.h"
#include "mesh/domain/triangle_pool.h"

#include <map>
#include <optional>
#include <set>

namespace nrb::mesh {

// Rounds: triangles of cells and of the strip, proofs, and more cells, places and vertices of the border where these fail. What a
// round does not change stays.
class DomainMesher {
public:
    DomainMesher(const MeshDomain &domain, const MeshRule &rule);

    // Until no round would do better, or the work has ended. Returns whether there is a result: else the border is another one, for
    // which only a new mesher will do.
    [[nodiscard]] bool run();
    // Goes on where the border was divided further. Returns whether that is enough for it: else only a new mesher will do.
    [[nodiscard]] bool take_border();
    // last: nothing follows, and memory is free for it.
    [[nodiscard]] DomainMesh output(bool last);
    [[nodiscard]] size_t triangle_count() const noexcept { return triangles_.size(); }
    // Whether run() can go on after an output that was not the last one.
    [[nodiscard]] bool goes_on() const noexcept { return !(rule_.least_angle > 0); }

private:
    // Of the triangles of a cell, side by side.
    struct CellState {
        std::array<int32_t, 4> corners{-1, -1, -1, -1}; // places; -1: not known
        int32_t places = 0;                             // on its border
        bool centred = false;                           // triangles are about a vertex in its middle
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
    // Whether two corners are at one point.
    [[nodiscard]] bool is_at_point(const SiteTriangle &triangle) const noexcept {
        const auto p = points_of(triangle);
        return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    }
    struct Split {
        double size = 0;
        std::array<double, 2> place{};
        int32_t border = -1; // segment of the border
        double share = 0;    // of the domain
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
    double chord_, longest_, angle_; // that triangles are made for
    double least_;                   // in the units of the grid
    CellGrid cells_;
    double most_apart_;               // of unit normals
    std::array<double, 2> density_{}; // of cells on steps along the axes
    Sites sites_;
    TriangleProof proof_;
    std::set<std::array<double, 2>> extra_; // places of the strip besides
    int round_ = 0;                         // since the border changed
    int all_rounds_ = 0;
    bool is_off_ = false;      // a triangle has a corner farther from the surface than the chord
    int changes_ = 0;          // of the border, for other sakes than distances
    int32_t known_points_ = 0; // of the domain
    std::vector<CellState> states_;
    TrianglePool triangles_;
    double slack_ = 0;                                // what rounding adds to distances
    std::vector<int32_t> crossed_;                    // segments of the border
    std::vector<std::array<int32_t, 2>> united_;      // points of the border
    std::vector<std::pair<int32_t, double>> touched_; // segments
    std::map<int32_t, int> weak_;                     // these, and into how many parts they are to be divided
    bool has_small_angles_ = false;                   // that count
    std::optional<DomainMesh> before_angles_;         // what there was before them, if that is better
};

} // namespace nrb::mesh
