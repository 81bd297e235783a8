#include "refine/boehm.h"

#include "basis/bspline.h"

#include <algorithm>
#include <array>

namespace nrb {

namespace {

// Rows of coefficients over the p - s + 1 old points P_(k-p), ..., P_(k-s) that insertion involves. After j
// steps row i, j <= i <= p - s, is point i of the triangle of de Boor's algorithm at the new knot, which
// stops there after p - s steps.
class Triangle {
public:
    Triangle(int degree, const double *knots, int64_t k, int present, double knot) noexcept
        : size_(degree - present + 1), knot_(knot), left_(knots + k - degree), right_(knots + k) {
        for (int i = 0; i < size_; ++i) {
            std::fill_n(rows_[i], size_, 0.0);
            rows_[i][i] = 1;
        }
    }

    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] const double *row(int i) const noexcept { return rows_[i]; }

    void step(int j) noexcept {
        for (int i = size_ - 1; i >= j; --i) {
            const auto [alpha, beta] = split(1, left_[i], knot_, right_[i - j + 1]);
            for (int c = 0; c < size_; ++c) {
                rows_[i][c] = alpha * rows_[i][c] + beta * rows_[i - 1][c];
            }
        }
    }

private:
    int size_;
    double knot_;
    const double *left_;
    const double *right_;
    double rows_[max_basis][max_basis];
};

// The new points lie on the border of the triangle's first `steps` columns: down its left side, along the
// last column, up its right side.
void append_border(Triangle &triangle, int64_t first, int times, LayerTable &table) {
    const int n = triangle.size();
    const int steps = std::min(times, n - 1);
    std::vector<std::array<double, max_basis>> right;
    table.add_row(first, triangle.row(0), n);
    for (int j = 1; j <= steps; ++j) {
        std::array<double, max_basis> &kept = right.emplace_back();
        std::copy_n(triangle.row(n - 1), n, kept.begin());
        triangle.step(j);
        table.add_row(first, triangle.row(j), n);
    }
    for (int i = steps + 1; i < n; ++i) {
        table.add_row(first, triangle.row(i), n);
    }
    if (times == n) { // the knot now splits the curve: its point ends one part and begins the next
        table.add_row(first, triangle.row(n - 1), n);
    }
    for (auto row = right.rbegin(); row != right.rend(); ++row) {
        table.add_row(first, row->data(), n);
    }
}

} // namespace

std::vector<double> insert_into_knots(std::span<const double> knots, double knot, int times) {
    const auto behind = std::upper_bound(knots.begin(), knots.end(), knot);
    std::vector<double> result;
    result.reserve(knots.size() + static_cast<size_t>(times));
    result.insert(result.end(), knots.begin(), behind);
    result.insert(result.end(), static_cast<size_t>(times), knot);
    result.insert(result.end(), behind, knots.end());
    return result;
}

void append_insertion_rows(int degree, std::span<const double> knots, double knot, int times,
                           LayerTable &table) {
    const int64_t k = std::upper_bound(knots.begin(), knots.end(), knot) - knots.begin() - 1;
    const int present = multiplicity(knots, knot);
    const int64_t count = static_cast<int64_t>(knots.size()) - degree - 1;
    table.reserve(table.rows() + count + times);
    for (int64_t i = 0; i < k - degree; ++i) {
        table.add_copy(i);
    }
    Triangle triangle(degree, knots.data(), k, present, knot);
    append_border(triangle, k - degree, times, table);
    for (int64_t i = k - present + 1; i < count; ++i) {
        table.add_copy(i);
    }
}

} // namespace nrb
