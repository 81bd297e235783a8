// The tables of refinement, of Bezier pieces and of elevation, whose rows are made many at a time.
#include "pieces/extraction.h"
#include "refine/degree/elevation_table.h"
#include "refine/knots/axis_table.h"
#include "refine/knots/bezier_rows.h"
#include "refine/knots/blossom_rows.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace rows_test {

namespace {

using nrb::KnotVector;
using nrb::LayerTable;
using nrb::max_basis;

constexpr double eps = std::numeric_limits<double>::epsilon();

// Knots in [1, 2], each `multiplicity` times, with ends of degree + 1.
std::vector<double> random_knots(std::mt19937_64 &random, int degree, int spans, int multiplicity) {
    std::uniform_real_distribution<double> uniform(1, 2);
    std::vector<double> knots;
    for (int i = 1; i < spans; ++i) {
        knots.insert(knots.end(), static_cast<size_t>(multiplicity), uniform(random));
    }
    const auto ends = static_cast<size_t>(degree) + 1;
    knots.insert(knots.end(), ends, 1);
    knots.insert(knots.end(), ends, 2);
    std::sort(knots.begin(), knots.end());
    return knots;
}

// The control points of t^k: the mean products of k of the degree knots that belong to each.
std::vector<double> monomial(const KnotVector &axis, int k) {
    std::vector<double> points;
    for (int64_t i = 0; i < axis.count(); ++i) {
        double sums[max_basis + 1] = {1}; // over the products of 0, 1, ... of the knots so far
        for (int j = 1; j <= axis.degree(); ++j) {
            for (int l = std::min(j, k); l > 0; --l) {
                sums[l] = (sums[l] * (j - l) + sums[l - 1] * axis[i + j] * l) / j; // means
            }
        }
        points.push_back(sums[k]);
    }
    return points;
}

double applied(const LayerTable &table, const LayerTable::Row &row, const std::vector<double> &points) {
    if (row.size == 0) {
        return points[static_cast<size_t>(row.first)];
    }
    double sum = 0;
    for (int i = 0; i < row.size; ++i) {
        sum += table.coefficients(row)[i] * points[static_cast<size_t>(row.first + i)];
    }
    return sum;
}

// A table is right if it makes the control points of all monomials from those of the old axis. All terms are
// positive, so that the errors of the coefficients, 4 d eps for d <= degree steps, and of the means are
// relative.
void expect_monomials(const LayerTable &table, const KnotVector &from, const KnotVector &to) {
    ASSERT_EQ(table.rows(), to.count());
    const double bound = (6 * from.degree() + 4 * to.degree() + 6) * eps;
    for (int k = 0; k <= from.degree(); ++k) {
        const std::vector<double> old = monomial(from, k), expected = monomial(to, k);
        for (int64_t r = 0; r < table.rows(); ++r) {
            const double wanted = expected[static_cast<size_t>(r)];
            ASSERT_NEAR(applied(table, table.row(r), old), wanted, bound * wanted)
                << "degree " << from.degree() << " power " << k << " row " << r;
        }
    }
}

TEST(Rows, of_refinement_are_right_and_each_as_if_alone) {
    std::mt19937_64 random(3);
    for (int degree = 1; degree <= 9; ++degree) {
        for (const int added : {1, 7, 40, 300}) {
            const KnotVector axis(degree, random_knots(random, degree, 20, 1));
            std::vector<double> fresh =
                random_knots(random, -1, added + 1, 1 + static_cast<int>(random() % 2));
            fresh[0] = axis[degree + 3];
            std::sort(fresh.begin(), fresh.end());
            const KnotVector fine(degree, nrb::refine::merged(axis.knots(), fresh));
            const nrb::refine::Refinement refinement(degree, axis.knots(), fine.knots());
            const LayerTable table = nrb::refine::rows_of(refinement, 0, refinement.rows());
            expect_monomials(table, axis, fine);
            for (int64_t j = 0; j < table.rows(); ++j) {
                const LayerTable alone = nrb::refine::rows_of(refinement, j, j + 1);
                const LayerTable::Row &row = table.row(j), &only = alone.row(0);
                ASSERT_TRUE(row.first == only.first && row.size == only.size);
                ASSERT_TRUE(std::equal(alone.coefficients(only), alone.coefficients(only) + row.size,
                                       table.coefficients(row)))
                    << "degree " << degree << " row " << j;
            }
        }
    }
}

TEST(Rows, of_bezier_pieces_are_those_of_refinement) {
    std::mt19937_64 random(4);
    for (int degree = 0; degree <= 9; ++degree) {
        for (int multiplicity = 1; multiplicity <= degree + 1; ++multiplicity) {
            std::vector<double> knots = random_knots(random, degree, 30, multiplicity);
            knots.erase(knots.begin(), knots.begin() + random() % 2); // unclamped
            const KnotVector axis(degree, std::move(knots));
            const std::vector<double> breaks = nrb::refine::breaks_of(axis);
            const std::vector<double> fine = nrb::refine::saturated(axis.degree(), axis.knots(), breaks);
            const nrb::refine::Refinement refinement(degree, axis.knots(), fine);
            const int64_t first = std::lower_bound(fine.begin(), fine.end(), breaks[0]) - fine.begin();
            const LayerTable table = nrb::refine::bezier_rows(axis);
            const LayerTable other = nrb::refine::rows_of(refinement, first, first + table.rows());
            ASSERT_EQ(table.rows(), (std::ssize(breaks) - 1) * (degree + 1));
            for (int64_t r = 0; r < table.rows(); ++r) {
                const LayerTable::Row &row = table.row(r), &wanted = other.row(r);
                ASSERT_TRUE(row.first == wanted.first && row.size == wanted.size) << r;
                ASSERT_TRUE(std::equal(other.coefficients(wanted), other.coefficients(wanted) + row.size,
                                       table.coefficients(row)));
            }
            expect_monomials(table, axis, *nrb::refine::bezier_knots(degree, breaks));
            const int64_t from = 1 + static_cast<int64_t>(random() % 10);
            const LayerTable part = nrb::refine::bezier_rows(axis, from, std::ssize(breaks) - 2);
            for (int64_t r = 0; r < part.rows(); ++r) {
                const LayerTable::Row &row = part.row(r), &wanted = table.row(from * (degree + 1) + r);
                ASSERT_TRUE(row.first == wanted.first && row.size == wanted.size) << r;
                ASSERT_TRUE(std::equal(part.coefficients(row), part.coefficients(row) + row.size,
                                       table.coefficients(wanted)));
            }
        }
    }
}

TEST(Rows, of_pieces_between_more_breaks_do_not_depend_on_the_part) {
    std::mt19937_64 random(6);
    for (int degree = 0; degree <= 9; ++degree) {
        for (int multiplicity = 1; multiplicity <= degree + 1; ++multiplicity) {
            std::vector<double> knots = random_knots(random, degree, 30, multiplicity);
            knots.erase(knots.begin(), knots.begin() + random() % 2); // unclamped
            const KnotVector axis(degree, std::move(knots));
            std::vector<double> breaks;
            for (const double knot : nrb::refine::breaks_of(axis)) {
                if (!breaks.empty() && random() % 2 == 0) {
                    breaks.push_back(breaks.back() / 2 + knot / 2);
                }
                breaks.push_back(knot);
            }
            const nrb::pieces::PieceRows source(axis, breaks);
            const int64_t pieces = std::ssize(breaks) - 1;
            const LayerTable table = source.rows(0, pieces);
            expect_monomials(table, axis, *nrb::refine::bezier_knots(degree, breaks));
            const int64_t from = static_cast<int64_t>(random() % 10);
            const LayerTable part = source.rows(from, pieces - static_cast<int64_t>(random() % 5));
            for (int64_t r = 0; r < part.rows(); ++r) {
                const LayerTable::Row &row = part.row(r), &wanted = table.row(from * (degree + 1) + r);
                ASSERT_TRUE(row.first == wanted.first && row.size == wanted.size) << r;
                ASSERT_TRUE(std::equal(part.coefficients(row), part.coefficients(row) + row.size,
                                       table.coefficients(wanted)));
            }
        }
    }
}

TEST(Rows, of_elevation_are_right_in_long_runs_of_one_multiplicity) {
    std::mt19937_64 random(5);
    for (int degree = 0; degree <= 9; ++degree) {
        for (int multiplicity = 1; multiplicity <= degree + 1; ++multiplicity) {
            const KnotVector axis(degree, random_knots(random, degree, 100, multiplicity));
            const nrb::refine::Elevation raised(axis);
            const LayerTable table = raised.rows(0, raised.rows());
            expect_monomials(table, axis, KnotVector(degree + 1, raised.knots()));
            const int64_t from = 1 + static_cast<int64_t>(random() % 30);
            const LayerTable part = raised.rows(from, raised.rows() - 5);
            for (int64_t r = 0; r < part.rows(); ++r) {
                const LayerTable::Row &row = part.row(r), &wanted = table.row(from + r);
                ASSERT_TRUE(row.first == wanted.first && row.size == wanted.size) << r;
                ASSERT_TRUE(std::equal(part.coefficients(row), part.coefficients(row) + row.size,
                                       table.coefficients(wanted)));
            }
        }
    }
}

} // namespace

} // namespace rows_test
