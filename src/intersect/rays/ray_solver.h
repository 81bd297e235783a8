// SPDX-License-Identifier: MIT
// Where a ray meets one Bezier piece of a surface.
#pragma once

#include "intersect/contraction.h"
#include "intersect/rays/turned_patches.h"

namespace nrb::intersect {

// Places on the piece, and t on the ray.
struct RayMeet {
    Place<2> place{};
    Box<2> around{}; // in which all of the meet is
    double t = 0;
    Interval ts{}; // of a touch: where it is
    int64_t piece = 0;
    bool proven = true;  // false: a touch, as far as rounding can tell, or what the limit of work left open
    bool inside = false; // of the piece, for certain
    double sine = 0;     // between the ray and the tangent plane, negative from the back
};

// About the ray's origin and turned so that the ray is the third axis, the first two coordinates are
//     F(u, v) = (A - w o) . (n1, n2)
// and the ray meets the piece where F = 0 (planes through the ray: T. Nishita, T. W. Sederberg & M. Kakimoto 1990).
// M is the inverse of the mean derivative, and rho follows from all Bernstein coefficients of F'. Parts for which that
// is no contraction are halved.
class RaySolver {
public:
    explicit RaySolver(const pieces::PieceGrid &grid);

    // For the calls that follow. room() is how far rounding moves pieces and rays in all.
    void set_ray(const PlacedRay &ray);
    [[nodiscard]] double room() const noexcept { return noise_; }

    // Calls found(meet) for each, with lower <= t <= limit() at the time, which may fall from call to call. Returns
    // whether all of the piece was looked at.
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
    // Of the coefficients of a part.
    struct Ranges {
        double least_weight, most_weight;
        double nearest, farthest; // of t
        double size;              // largest |F| / w
        bool misses;              // F is 0 nowhere
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
