#include "numeric/solvers/sparse/selected_inverse.h"

#include "support/generators.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace selected_inverse_test {

namespace {

// Symmetric and positive definite, with elements here and there.
Eigen::MatrixXd some_matrix(support::Random &random, int size) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < i; ++j) {
            a(i, j) = a(j, i) = random.chance(25) ? random.between(-1, 1) : 0;
        }
        a(i, i) = size;
    }
    return a;
}

nrb::SparseColumns columns_of(const Eigen::MatrixXd &a) {
    nrb::SparseColumns columns{{0}, {}, {}};
    for (int j = 0; j < a.cols(); ++j) {
        for (int i = 0; i < a.rows(); ++i) {
            if (a(i, j) != 0) {
                columns.rows.push_back(i);
                columns.values.push_back(a(i, j));
            }
        }
        columns.starts.push_back(std::ssize(columns.rows));
    }
    return columns;
}

} // namespace

TEST(SelectedInverse, has_the_elements_of_the_inverse) {
    support::Random random(930100);
    for (int size = 1; size <= 30; ++size) {
        const Eigen::MatrixXd a = some_matrix(random, size), expected = a.inverse();
        const nrb::SparseColumns columns = columns_of(a);
        nrb::SparseLdlt factors(columns);
        ASSERT_EQ(factors.factorise(columns), -1);
        const nrb::SelectedInverse inverse(factors);
        const double error = 0x1p-50 * expected.norm();
        for (int i = 0; i < size; ++i) {
            for (int j = 0; j < size; ++j) {
                if (a(i, j) != 0) {
                    ASSERT_NEAR(inverse.element(i, j), expected(i, j), error)
                        << size << ": " << i << ", " << j;
                }
            }
        }
        ASSERT_NEAR(inverse.trace_of_product(columns), size, size * 0x1p-48);
    }
}

} // namespace selected_inverse_test
