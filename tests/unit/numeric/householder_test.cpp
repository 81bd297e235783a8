// SPDX-License-Identifier: MIT
#include "numeric/solvers/householder.h"

#include "base/numbers.h"
#include "support/generators.h"

#include <gtest/gtest.h>
#include <set>

namespace householder_test {

using namespace nrb;
using Eigen::MatrixXd;

namespace {

MatrixXd random_matrix(support::Random &random, Eigen::Index rows, Eigen::Index columns) {
    MatrixXd a(rows, columns);
    for (double &x : a.reshaped()) {
        x = random.between(-1, 1);
    }
    return a;
}

// Q R with the columns in their first order.
MatrixXd product(const Householder &made) {
    MatrixXd r = made.factors().triangularView<Eigen::Upper>();
    r.applyOnTheLeft(made.q());
    MatrixXd a(r.rows(), r.cols());
    for (Eigen::Index i = 0; i < r.cols(); ++i) {
        a.col(made.order()[static_cast<size_t>(i)]) = r.col(i);
    }
    return a;
}

} // namespace

// Sizes about those of panels and chunks.
TEST(Householder, the_factors_are_those_of_the_matrix) {
    support::Random random(1);
    for (const auto &[rows, columns] : std::vector<std::pair<int, int>>{
             {1, 1}, {5, 3}, {3, 5}, {48, 48}, {60, 49}, {97, 96}, {130, 300}, {400, 200}}) {
        const MatrixXd a = random_matrix(random, rows, columns);
        for (const auto pivoting : {Householder::Pivoting::none, Householder::Pivoting::columns}) {
            const Householder made(a, pivoting);
            EXPECT_LE((product(made) - a).cwiseAbs().maxCoeff(), 8 * eps * (rows + columns));
            EXPECT_EQ(std::set<Eigen::Index>(made.order().begin(), made.order().end()).size(),
                      static_cast<size_t>(columns));
        }
    }
}

TEST(Householder, pivots_fall_and_tell_the_rank) {
    support::Random random(2);
    for (const Eigen::Index rank : {0, 1, 7, 20}) {
        const MatrixXd a = random_matrix(random, 40, rank) * random_matrix(random, rank, 30);
        const Householder made(a, Householder::Pivoting::columns);
        EXPECT_EQ(made.rank(1e-12), rank);
        for (Eigen::Index k = 1; k < rank; ++k) {
            EXPECT_LE(std::abs(made.factors()(k, k)),
                      std::abs(made.factors()(k - 1, k - 1)) * (1 + 64 * eps));
        }
    }
}

} // namespace householder_test
