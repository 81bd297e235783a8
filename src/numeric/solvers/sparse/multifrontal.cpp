// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/multifrontal.h"

#include "base/watch.h"
#include "numeric/solvers/sparse/dense_product.h"

#include <Eigen/Core>

#include <algorithm>

namespace nrb::inline numeric {

namespace {

using sparse::at;

using Column = Eigen::Map<Eigen::VectorXd>;

// A frontal matrix: symmetric, only the lower triangle is used, stored by columns.
class Front {
public:
    void reset(int64_t size) {
        size_ = size;
        values_.assign(at(size * size), 0.0);
    }
    [[nodiscard]] int64_t size() const noexcept { return size_; }
    double *column(int64_t j) noexcept { return values_.data() + j * size_; }

    // Eliminates the first `columns` columns, which then hold L; the others hold the Schur complement.
    // Returns -1, or the column whose pivot is not above its floor.
    int64_t eliminate(int64_t columns, std::span<const double> floors, double *pivots) {
        constexpr int64_t wide = 32;
        for (int64_t first = 0; first < columns; first += wide) {
            const int64_t end = std::min(columns, first + wide);
            if (const int64_t bad = eliminate_panel(first, end, floors, pivots); bad >= 0) {
                return bad;
            }
            update_behind(first, end, pivots);
        }
        return -1;
    }

private:
    // Until the panel is finished its columns hold L D.
    int64_t eliminate_panel(int64_t first, int64_t end, std::span<const double> floors, double *pivots) {
        for (int64_t j = first; j < end; ++j) {
            double *const own = column(j);
            pivots[j] = own[j];
            if (!(pivots[j] > (floors.empty() ? 0 : floors[at(j)]))) {
                return j;
            }
            for (int64_t k = j + 1; k < end; ++k) {
                Column(column(k) + k, size_ - k) -= Column(own + k, size_ - k) * (own[k] / pivots[j]);
            }
        }
        count_work((end - first) * (end - first) / 2 * (size_ - first));
        return -1;
    }

    void update_behind(int64_t first, int64_t end, const double *pivots) {
        const int64_t left = size_ - end, width = end - first;
        scaled_.resize(left, width);
        for (int64_t j = first; j < end; ++j) {
            double *const own = column(j);
            std::for_each(own + j + 1, own + end, [&](double &x) { x /= pivots[j]; });
            scaled_.col(j - first) = Column(own + end, left) / pivots[j];
        }
        subtract_product({column(end) + end, left, left, size_}, {column(first) + end, left, width, size_},
                         {scaled_.data(), left, width, left}, true);
        for (int64_t j = first; j < end; ++j) {
            std::copy_n(scaled_.col(j - first).data(), left, column(j) + end);
        }
    }

    int64_t size_ = 0;
    std::vector<double> values_;
    Eigen::MatrixXd scaled_;
};

class Multifrontal {
public:
    Multifrontal(const SparseColumns &matrix, const Supernodes &supernodes)
        : matrix_(matrix), supernodes_(supernodes), children_(at(supernodes.count())),
          updates_(at(supernodes.count())), place_(at(matrix.size())) {
        for (int64_t s = 0; s < supernodes.count(); ++s) {
            if (const int32_t parent = supernodes.parent[at(s)]; parent >= 0) {
                children_[at(parent)].push_back(static_cast<int32_t>(s));
            }
        }
    }

    int64_t factorise(std::span<const double> floors, std::span<const int64_t> starts,
                      std::span<double> values, std::span<double> diagonal) {
        Steps steps(supernodes_.count());
        for (int64_t s = 0; s < supernodes_.count(); ++s, steps.next()) {
            const int64_t first = supernodes_.first[at(s)], columns = supernodes_.columns(s);
            assemble(s);
            const auto own = floors.empty() ? floors : floors.subspan(at(first), at(columns));
            if (const int64_t bad = front_.eliminate(columns, own, diagonal.data() + first); bad >= 0) {
                return first + bad;
            }
            for (int64_t j = 0; j < columns; ++j) {
                std::copy_n(front_.column(j) + j + 1, front_.size() - j - 1,
                            values.data() + starts[at(first + j)]);
            }
            keep_update(s);
        }
        return -1;
    }

private:
    void assemble(int64_t s) {
        const int64_t first = supernodes_.first[at(s)], columns = supernodes_.columns(s);
        const auto below = supernodes_.below(s);
        front_.reset(columns + std::ssize(below));
        for (int64_t j = 0; j < columns; ++j) {
            place_[at(first + j)] = static_cast<int32_t>(j);
        }
        for (size_t i = 0; i < below.size(); ++i) {
            place_[at(below[i])] = static_cast<int32_t>(columns) + static_cast<int32_t>(i);
        }
        for (int64_t j = first; j < first + columns; ++j) {
            double *const target = front_.column(j - first);
            for (int64_t p = matrix_.starts[at(j)]; p < matrix_.starts[at(j) + 1]; ++p) {
                if (const int32_t row = matrix_.rows[at(p)]; row >= j) {
                    target[place_[at(row)]] += matrix_.values[at(p)];
                }
            }
        }
        for (const int32_t child : children_[at(s)]) {
            add_update(child);
        }
        count_work(front_.size() * front_.size());
    }

    void add_update(int32_t child) {
        const auto rows = supernodes_.below(child);
        const auto size = std::ssize(rows);
        std::vector<double> &update = updates_[at(child)];
        const double *from = update.data();
        for (int64_t j = 0; j < size; ++j, from += size) {
            double *const target = front_.column(place_[at(rows[at(j)])]);
            for (int64_t i = j; i < size; ++i) {
                target[place_[at(rows[at(i)])]] += from[i];
            }
        }
        count_work(size * size);
        update = std::vector<double>(); // releases the memory
    }

    void keep_update(int64_t s) {
        const int64_t columns = supernodes_.columns(s), size = front_.size() - columns;
        count_work(size * size);
        std::vector<double> &update = updates_[at(s)];
        update.reserve(at(size * size));
        for (int64_t j = 0; j < size; ++j) {
            const double *const from = front_.column(columns + j) + columns;
            update.insert(update.end(), from, from + size);
        }
    }

    const SparseColumns &matrix_;
    const Supernodes &supernodes_;
    std::vector<std::vector<int32_t>> children_;
    std::vector<std::vector<double>> updates_; // of supernodes whose parents come later
    std::vector<int32_t> place_;               // of an unknown in the front
    Front front_;
};

// Gathers the rows below a supernode, so that its columns read contiguous memory.
class BlockSolution {
public:
    BlockSolution(const Supernodes &supernodes, std::span<const int64_t> starts,
                  std::span<const double> values, double *x, int64_t width)
        : supernodes_(supernodes), starts_(starts), values_(values), x_(x), width_(width) {}

    void forwards(int64_t s) {
        const int64_t first = supernodes_.first[at(s)], end = supernodes_.first[at(s) + 1];
        const auto rows = supernodes_.below(s);
        below_.setZero(std::ssize(rows), width_);
        for (int64_t j = first; j < end; ++j) {
            const double *const own = values_.data() + starts_[at(j)];
            for (int64_t c = 0; c < width_; ++c) {
                const double solved = x_[j * width_ + c];
                for (int64_t i = j + 1; i < end; ++i) {
                    x_[i * width_ + c] -= own[i - j - 1] * solved;
                }
                below_.col(c) += solved * ConstColumn(own + (end - 1 - j), below_.rows());
            }
        }
        for (size_t i = 0; i < rows.size(); ++i) {
            for (int64_t c = 0; c < width_; ++c) {
                x_[rows[i] * width_ + c] -= below_(static_cast<Eigen::Index>(i), c);
            }
        }
        count_work(2 * width_ * (end - first) * (end - first + below_.rows()));
    }

    void backwards(int64_t s) {
        const int64_t first = supernodes_.first[at(s)], end = supernodes_.first[at(s) + 1];
        const auto rows = supernodes_.below(s);
        below_.resize(std::ssize(rows), width_);
        for (size_t i = 0; i < rows.size(); ++i) {
            for (int64_t c = 0; c < width_; ++c) {
                below_(static_cast<Eigen::Index>(i), c) = x_[rows[i] * width_ + c];
            }
        }
        for (int64_t j = end; j-- > first;) {
            const double *const own = values_.data() + starts_[at(j)];
            for (int64_t c = 0; c < width_; ++c) {
                double &sum = x_[j * width_ + c];
                for (int64_t i = j + 1; i < end; ++i) {
                    sum -= own[i - j - 1] * x_[i * width_ + c];
                }
                sum -= ConstColumn(own + (end - 1 - j), below_.rows()).dot(below_.col(c));
            }
        }
        count_work(2 * width_ * (end - first) * (end - first + below_.rows()));
    }

private:
    using ConstColumn = Eigen::Map<const Eigen::VectorXd>;

    const Supernodes &supernodes_;
    std::span<const int64_t> starts_;
    std::span<const double> values_;
    double *x_;
    int64_t width_;
    Eigen::MatrixXd below_; // [rows][width], one column for each right-hand side
};

} // namespace

void solve_fronts(const Supernodes &supernodes, std::span<const int64_t> starts,
                  std::span<const double> values, std::span<const double> diagonal, double *x,
                  int64_t width) {
    BlockSolution solution(supernodes, starts, values, x, width);
    for (int64_t s = 0; s < supernodes.count(); ++s) {
        solution.forwards(s);
    }
    for (int64_t j = 0; j < std::ssize(diagonal); ++j) {
        std::for_each_n(x + j * width, width, [&](double &value) { value /= diagonal[at(j)]; });
    }
    for (int64_t s = supernodes.count(); s-- > 0;) {
        solution.backwards(s);
    }
}

int64_t factorise_fronts(const SparseColumns &matrix, const Supernodes &supernodes,
                         std::span<const double> floors, std::span<const int64_t> starts,
                         std::span<double> values, std::span<double> diagonal) {
    return Multifrontal(matrix, supernodes).factorise(floors, starts, values, diagonal);
}

} // namespace nrb::inline numeric
