// Sparse factors: by rows and by dense blocks, of bands that products show, and what is selected of their inverses.
#include "numeric/solvers/sparse/selected_inverse.h"

#include "base/watch.h"
#include "numeric/solvers/sparse/grid_order.h"
#include "numeric/solvers/sparse/probed_band.h"
#include "support/generators.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace sparse_factors_test {

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

// Of a matrix over a grid of control points, nested dissection and all, and every size of supernodes.
nrb::SparseColumns grid_matrix(support::Random &random, int64_t count, int64_t reach, bool periodic) {
    const auto order =
        nrb::grid_order({nrb::GridAxis{count, reach, periodic}, {count, reach, false}, {1, 0, false}});
    const auto size = static_cast<int>(order.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < i; ++j) {
            const int64_t first = order[static_cast<size_t>(i)], second = order[static_cast<size_t>(j)];
            const int64_t across = std::abs(first / count - second / count);
            if ((across <= reach || (periodic && count - across <= reach)) &&
                std::abs(first % count - second % count) <= reach) {
                a(i, j) = a(j, i) = random.between(-1, 1);
            }
        }
        a(i, i) = 2 * static_cast<double>((2 * reach + 1) * (2 * reach + 1));
    }
    return columns_of(a);
}

Eigen::MatrixXd dense(const nrb::SparseColumns &columns) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(columns.size(), columns.size());
    for (int64_t j = 0; j < columns.size(); ++j) {
        for (auto p = columns.starts[static_cast<size_t>(j)]; p < columns.starts[static_cast<size_t>(j) + 1];
             ++p) {
            a(columns.rows[static_cast<size_t>(p)], j) = columns.values[static_cast<size_t>(p)];
        }
    }
    return a;
}

} // namespace

// What dense blocks make of a system is its solution, and the elements of its inverse.
TEST(Supernodes, solve_and_invert) {
    support::Random random(930200);
    for (const auto &[count, reach, periodic] :
         {std::tuple{12, 3, false}, {20, 3, true}, {24, 2, false}, {9, 8, true}, {26, 4, true}}) {
        const nrb::SparseColumns columns = grid_matrix(random, count, reach, periodic);
        const Eigen::MatrixXd a = dense(columns), expected = a.inverse();
        nrb::SparseLdlt factors(columns);
        ASSERT_FALSE(factors.supernodes().empty());
        for (int again = 0; again < 2; ++again) {
            ASSERT_EQ(factors.factorise(columns), -1);
        }
        Eigen::VectorXd x = Eigen::VectorXd::Random(a.rows());
        const Eigen::VectorXd right = a * x;
        Eigen::VectorXd solution = right;
        factors.solve(solution.data(), 1);
        ASSERT_LE((solution - x).norm(), 0x1p-46 * x.norm());
        const nrb::SelectedInverse inverse(factors);
        double worst = 0;
        for (int i = 0; i < a.rows(); ++i) {
            for (int j = 0; j < a.rows(); ++j) {
                worst = std::max(worst, a(i, j) != 0 ? std::abs(inverse.element(i, j) - expected(i, j)) : 0);
            }
        }
        ASSERT_LE(worst, 0x1p-50 * expected.norm());
        ASSERT_NEAR(inverse.trace_of_product(columns), static_cast<double>(a.rows()),
                    static_cast<double>(a.rows()) * 0x1p-46);
    }
}

// A factorisation that was ended while memory was provided is done anew.
TEST(Supernodes, are_factorised_after_an_end) {
    support::Random random(930250);
    const nrb::SparseColumns columns = grid_matrix(random, 40, 4, false);
    nrb::SparseLdlt whole(columns);
    ASSERT_EQ(whole.factorise(columns), -1);
    constexpr int64_t part = int64_t{1} << 15; // of grow_watched()
    const int64_t parts = whole.starts().back() / part;
    ASSERT_GE(parts, 2);
    for (int64_t done = 0; done < 2 * parts; ++done) {
        nrb::SparseLdlt factors(columns);
        {
            const nrb::Watch watch({(done + 1) * part - 1, nullptr, nullptr});
            EXPECT_THROW((void)factors.factorise(columns), nrb::CallEnded);
        }
        ASSERT_EQ(factors.factorise(columns), -1);
        ASSERT_TRUE(std::ranges::equal(factors.rows(), whole.rows())) << done;
        ASSERT_TRUE(std::ranges::equal(factors.values(), whole.values())) << done;
    }
}

// The element of the diagonal that is not above its floor is told, wherever it is.
TEST(Supernodes, tell_the_first_pivot_that_is_too_small) {
    support::Random random(930300);
    const nrb::SparseColumns good = grid_matrix(random, 16, 3, false);
    for (int i = 0; i < 60; ++i) {
        nrb::SparseColumns bad = good;
        const auto at = static_cast<int64_t>(random.bits() % static_cast<uint64_t>(good.size()));
        const auto first = bad.rows.begin() + bad.starts[static_cast<size_t>(at)];
        bad.values[static_cast<size_t>(std::find(first, bad.rows.end(), at) - bad.rows.begin())] = -1;
        nrb::SparseLdlt factors(good);
        ASSERT_EQ(factors.factorise(bad), at);
        std::vector<double> floors(static_cast<size_t>(good.size()), 0.0);
        ASSERT_EQ(factors.factorise(good, floors), -1);
        floors[static_cast<size_t>(at)] = 1e3;
        ASSERT_EQ(factors.factorise(good, floors), at);
    }
}

// Of a matrix without other elements the products show all.
TEST(ProbedBand, has_the_factors_of_a_band) {
    support::Random random(930500);
    for (const auto &shape : {std::pair{1, 3}, {7, 3}, {40, 3}, {41, 0}, {30, 40}}) {
        const int size = shape.first, reach = shape.second;
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
        for (int i = 0; i < size; ++i) {
            for (int j = std::max(0, i - reach); j < i; ++j) {
                a(i, j) = a(j, i) = random.between(-1, 1);
            }
            a(i, i) = 2 * reach + 2;
        }
        const auto product = [&](const std::vector<double> &x) {
            const Eigen::VectorXd y = a * Eigen::VectorXd::Map(x.data(), size);
            return std::vector<double>(y.data(), y.data() + size);
        };
        const auto factors = nrb::probed_band(size, reach, product);
        ASSERT_TRUE(factors.has_value());
        const Eigen::VectorXd x = Eigen::VectorXd::Random(size);
        Eigen::VectorXd solution = a * x;
        factors->solve(solution.data(), 1);
        ASSERT_LE((solution - x).norm(), 0x1p-46 * x.norm()) << size << ' ' << reach;
        a(size / 2, size / 2) = -1;
        ASSERT_FALSE(nrb::probed_band(size, reach, product).has_value());
    }
}

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

} // namespace sparse_factors_test
