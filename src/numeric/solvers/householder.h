// SPDX-License-Identifier: MIT
// Factorisations by Householder reflections, one column after the other, so that the caller can be told of them.
// The file is for the solvers of this folder alone, since it shows Eigen.
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace nrb::inline numeric {

// A P = Q R, with the permutation P of the columns or without one.
class Householder {
public:
    enum class Pivoting { none, columns };
    Householder(Eigen::MatrixXd a, Pivoting pivoting);

    [[nodiscard]] Eigen::Index rows() const noexcept { return a_.rows(); }
    [[nodiscard]] Eigen::Index columns() const noexcept { return a_.cols(); }
    // R above its diagonal, the reflections below.
    [[nodiscard]] const Eigen::MatrixXd &factors() const noexcept { return a_; }
    // Column i of A P is column order()[i] of A.
    [[nodiscard]] const std::vector<Eigen::Index> &order() const noexcept { return order_; }
    // Diagonal elements of R beyond `threshold` times the largest one.
    [[nodiscard]] Eigen::Index rank(double threshold) const noexcept;
    // Q as a sequence of reflections, which Eigen applies in blocks.
    [[nodiscard]] auto q() const { return Eigen::HouseholderSequence(a_, coefficients_); }
    // Q x and its inverse for one column.
    void turn(Eigen::MatrixXd &x) const;
    void turn_back(Eigen::MatrixXd &x) const;

private:
    struct Norms {
        Eigen::VectorXd updated;
        Eigen::VectorXd computed; // when the column was last looked at as a whole
    };
    void reflect(Eigen::Index k, Eigen::MatrixXd &x, double &work) const;
    void choose_column(Eigen::Index k, Norms &norms);
    void reflect(Eigen::Index k, Eigen::Index end);
    void update(Eigen::Index k, Norms &norms) const;
    void factorise_by_columns();
    void factorise_by_panels();
    void apply_panel(Eigen::Index first, Eigen::Index end);

    Eigen::MatrixXd a_;
    Eigen::VectorXd coefficients_;
    Eigen::VectorXd work_;
    std::vector<Eigen::Index> order_;
};

} // namespace nrb::inline numeric
