// Knot refinement as rows of coefficients: E. Cohen, T. Lyche, R. Riesenfeld, "Discrete B-splines and
// subdivision techniques" (1980); T. Lyche, K. Morken, "Making the Oslo algorithm more efficient" (1986).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb {

// One step of de Boor's algorithm on rows: from the d coefficients of a value of the polar form to the d + 1 of
// the value at one more argument t. left[-1], left[-2], ... and right[0], right[1], ... are the old knots on
// either side that are no arguments. All factors lie in [0, 1] if t lies between left[-1] and right[0]; beyond
// them this is the continuation of the polynomial piece.
void append_argument(const double *left, const double *right, int d, double t, double *coefficients) noexcept;

// New control point j over the knots `fine` is the polar form of the spline over `coarse` at the arguments
// fine[j + 1], ..., fine[j + p]. Arguments that are old knots fix as many parameters of the polar form; the
// others all lie between the nearest old knots around those, so that each of them is one step of de Boor's
// algorithm with factors in [0, 1]. A row depends neither on how the others were found nor on their number.
class Refinement {
public:
    struct Band {
        int64_t first; // old layer
        int size;
    };

    // Both vectors must outlive this. Preconditions: they are sorted; fine holds every knot of coarse at
    // least as often, and at most degree + 1 times; knots that it holds more often lie in [coarse[p],
    // coarse[count]].
    Refinement(int degree, std::span<const double> coarse, std::span<const double> fine);

    [[nodiscard]] int64_t rows() const noexcept { return std::ssize(fine_) - degree_ - 1; }
    // The coefficients, at most degree + 1, of new layer j. With n arguments that are not old knots there are
    // n + 1, each accurate to 3 n eps relative to itself; without any the new layer is an old one, and the
    // coefficient exactly 1. Cost: n (n + 1) / 2 divisions.
    Band row(int64_t j, double *coefficients) const noexcept;

private:
    int degree_;
    std::span<const double> coarse_;
    std::span<const double> fine_;
    // How many of the first i fine knots are old, if among equal knots the old ones come first, or last.
    std::vector<int64_t> old_first_;
    std::vector<int64_t> old_last_;
};

} // namespace nrb
