// SPDX-License-Identifier: MIT
// Intersections of a ray with one Bezier piece of a surface.
#pragma once

#include "intersect/contraction.h"
#include "intersect/rays/turned_patches.h"

namespace nrb::intersect {

// An intersection: local parameters on the piece, and t on the ray.
struct RayMeet {
    Place<2> place{};
    Box<2> around{}; // a box that contains the intersection
    double t = 0;
    Interval ts{}; // of a touch: the range of t
    int64_t piece = 0;
    bool proven = true;  // false: a touch, as far as rounding can tell, or left open by the limit of work
    bool inside = false; // certainly in the interior of the piece
    double sine = 0;     // of the angle between the ray and the tangent plane, positive from the back
};

// In a system about the origin o of the ray, with the ray as the third axis and n1, n2 as the others, the
// first two coordinates of a piece with homogeneous points A and weights w are
//     F(u, v) = (A - w o) . (n1, n2)
// and the ray meets the piece where F = 0 (two planes through the ray: T. Nishita, T. W. Sederberg & M.
// Kakimoto 1990). M is the inverse of the mean derivative, and rho follows from all Bernstein coefficients of
// F' (Contraction). Parts on which that does not prove a contraction are halved.
class RaySolver {
public:
    explicit RaySolver(const pieces::PieceGrid &grid);

    // Sets the ray for the calls that follow. room() bounds the rounding of pieces and rays in all.
    void set_ray(const PlacedRay &ray);
    [[nodiscard]] double room() const noexcept { return noise_; }

    // Calls found(meet) for each intersection with lower <= t <= limit(), which may fall from call to call.
    // Returns whether the whole piece was searched.
    template <class Limit, class Found>
    bool solve(int64_t piece, double lower, Limit &&limit, Found &&found) {
        begin(piece);
        while (!stack_.empty() && boxes_ > 0) {
            switch (look(lower, limit())) {
            case Verdict::nothing:
                pop();
                break;
            case Verdict::meet:
                found(meet_);
                pop();
                break;
            case Verdict::open:
                halve();
                break;
            }
        }
        const bool complete = stack_.empty();
        stack_.clear();
        return complete;
    }

private:
    enum class Verdict { nothing, meet, open };
    struct Part {
        Place<2> lower{}, length{1, 1};
        double moved = 0;
        int depth = 0;
    };
    struct Chart {
        double m[2][2];
        Contraction contraction;
    };
    // Bounds from the coefficients of a part.
    struct Ranges {
        double least_weight, most_weight;
        double nearest, farthest; // of t
        double size;              // largest |F| / w
        bool misses;              // F is proven to have no zero
    };

    void begin(int64_t piece);
    Verdict look(double lower, double upper);
    void halve();
    void pop() { stack_.pop_back(); }
    [[nodiscard]] double *values(size_t part) noexcept { return memory_.data() + part * size_; }
    [[nodiscard]] Ranges ranges(const double *v, double noise) const noexcept;
    [[nodiscard]] Chart chart(const double *v, double noise_of_f) const noexcept;
    [[nodiscard]] bool excludes(const Chart &chart, const double *v, double noise) const noexcept;
    Verdict meet_by(const Chart &chart, const double *v, double error, Interval range);
    [[nodiscard]] Place<2> fixed_step(const Chart &chart) const noexcept;
    Place<2> approach(const Chart &chart, const double *v);
    void set_meet(const Place<2> &z, const Box<2> &exact);
    void set_touch(const Ranges &ranges);
    [[nodiscard]] int longest_axis(const double *v) const noexcept;

    const pieces::PieceGrid &grid_;
    pieces::PatchShape shape_;
    int64_t count_; // of coefficients
    size_t size_;   // of the values of a part
    TurnedPatches patches_;
    double noise_ = 0, reach_ = 0;
    int boxes_ = 0;
    std::vector<Part> stack_;
    std::vector<double> memory_, work_, point_;
    RayMeet meet_;
    int64_t piece_ = 0;
};

} // namespace nrb::intersect
