// SPDX-License-Identifier: MIT
// CommonKnots::raising(): the layers of a member over the common knots, as means of its polar form.
#include "refine/algebra/common_knots.h"

#include "base/watch.h"
#include "numeric/double_double.h"
#include "numeric/sum.h"

#include <algorithm>

namespace nrb::refine {

namespace {

// Beyond this number of choices, the mean is computed knot by knot.
constexpr double many_choices = 256;

// A weighted sum of rows of coefficients; value(layer) is the coefficient of one layer. Returns the first
// layer whose coefficient is not 0.
template <class Row, class Value>
int64_t write_sum(const std::vector<Row> &rows, std::vector<double> &sum, Value &&value) {
    int64_t first = rows.front().first, end = first;
    for (const Row &row : rows) {
        first = std::min(first, row.first);
        end = std::max(end, row.first + row.size);
    }
    sum.clear();
    for (int64_t layer = first; layer < end; ++layer) {
        sum.push_back(value(layer));
    }
    // Drops the zeros before the first coefficient.
    const auto zeros = std::ranges::find_if(sum, [](double x) { return x != 0; }) - sum.begin();
    sum.erase(sum.begin(), sum.begin() + zeros);
    return first + zeros;
}

double count_of_choices(const CommonKnots::Window &window, int total) noexcept {
    double ways[max_basis] = {1};
    for (int i = 0; i < window.size; ++i) {
        for (int n = total; n > 0; --n) {
            for (int c = 1; c <= std::min(n, window.copies[static_cast<size_t>(i)]); ++c) {
                ways[n] += ways[n - c];
            }
        }
    }
    return ways[total];
}

// append_argument() in double-double arithmetic.
void append_exactly(const double *left, const double *right, int d, double t,
                    DoubleDouble *coefficients) noexcept {
    left -= d;
    DoubleDouble carried;
    for (int r = 0; r < d; ++r) {
        const DoubleDouble share = coefficients[r] / DoubleDouble::sum(right[r], -left[r]);
        coefficients[r] = carried + share * DoubleDouble::sum(right[r], -t);
        carried = share * DoubleDouble::sum(t, -left[r]);
    }
    coefficients[d] = carried;
}

} // namespace

// The mean of a member's polar form over all choices of arguments, knot by knot.
//
// The arguments that are knots of the member are determined by how many copies a choice takes of the first
// knot of the window and of the last one: the knots strictly inside are always all among the arguments,
// because they occur too often in the common knots to be omitted. For fixed numbers of copies at both ends,
// choices differ only in their foreign arguments, those that are not knots of the member. The window is
// processed knot by knot. After each knot, all choices with the same number of foreign arguments so far are
// merged into one sum of rows, because the remaining steps are the same for them. All terms are positive, and
// in double-double arithmetic the number of terms does not matter.
class CommonKnots::KnotByKnot {
public:
    struct Row {
        int64_t first;
        int size;
        std::array<DoubleDouble, max_basis> coefficients;
    };

    KnotByKnot(const CommonKnots &joint, size_t member, const Window &window) noexcept
        : joint_(joint), member_(member), window_(window), groups_(joint.groups_.data() + window.group),
          degree_(joint.members_[member].degree) {}

    // One row for each pair (copies of the first knot, copies of the last knot) that are knots of the member.
    [[nodiscard]] std::vector<Row> rows() {
        std::vector<Row> rows;
        const int last = window_.size - 1;
        int inside = 0;
        for (int i = 1; i < last; ++i) {
            inside += own(i);
        }
        for (int a = 0; a <= std::min(own(0), copies(0)); ++a) {
            for (int b = 0; b <= std::min(own(last), copies(last)); ++b) {
                if (a + inside + b <= degree_) {
                    rows.push_back(row(a, b, degree_ - a - inside - b));
                }
            }
        }
        return rows;
    }

private:
    [[nodiscard]] int own(int i) const noexcept { return groups_[i].times[member_]; }
    [[nodiscard]] int copies(int i) const noexcept { return window_.copies[static_cast<size_t>(i)]; }

    // The sum over the choices that take, as knots of the member, `a` copies of the first knot and `b` of the
    // last one, and `foreign` further arguments.
    [[nodiscard]] Row row(int a, int b, int foreign) {
        const int last = window_.size - 1;
        const double *knots = joint_.members_[member_].knots.data();
        const int64_t first = groups_[0].place[member_] + own(0) - a, end = groups_[last].place[member_] + b;
        sums_.assign(static_cast<size_t>(foreign) + 1, {});
        sums_[0][0] = DoubleDouble(1);
        const auto most_of = [&](int i) {
            const int used = used_of(i, a, b);
            return used < own(i) ? 0 : copies(i) - used;
        };
        int least = foreign, reached = 0; // bounds on the number of foreign arguments so far
        for (int i = 0; i <= last; ++i) {
            least -= most_of(i);
        }
        for (int i = 0; i <= last; ++i) {
            const int most = most_of(i);
            take(i, used_of(i, a, b), most, {least, reached}, knots + first, knots + end);
            least += most;
            reached = std::min(reached + most, foreign);
        }
        count_work(int64_t{16} * window_.size * (foreign + 1) * (foreign + 1));
        Row row{first - foreign - 1 - joint_.members_[member_].shift, foreign + 1, {}};
        row.coefficients = sums_[static_cast<size_t>(foreign)];
        return row;
    }

    // How many copies of knot i are used as knots of the member.
    [[nodiscard]] int used_of(int i, int a, int b) const noexcept {
        return i == 0 ? a : i == window_.size - 1 ? b : own(i);
    }

    // The range for the number of foreign arguments before a knot is processed: at least `least`, or the
    // knots that follow cannot supply the rest; at most `reached`, as many as the knots so far can supply.
    struct Foreign {
        int least, reached;
    };
    // Takes up to `most` copies of knot i as foreign arguments, besides those used as knots of the member.
    void take(int i, int used, int most, Foreign now, const double *first, const double *end) {
        const int foreign = static_cast<int>(sums_.size()) - 1;
        next_.assign(sums_.size(), {});
        for (int d = std::max(now.least, 0); d <= now.reached; ++d) {
            std::array<DoubleDouble, max_basis> sum;
            std::copy_n(sums_[static_cast<size_t>(d)].begin(), d + 1, sum.begin());
            for (int more = 0; more <= std::min(most, foreign - d); ++more) {
                if (more > 0) {
                    append_exactly(first, end, d + more, groups_[i].knot, sum.data());
                }
                auto &target = next_[static_cast<size_t>(d + more)];
                const DoubleDouble ways(binomial(copies(i), used + more));
                for (size_t r = 0; r <= static_cast<size_t>(d + more); ++r) {
                    target[r] = target[r] + ways * sum[r];
                }
            }
        }
        sums_.swap(next_);
    }

    const CommonKnots &joint_;
    size_t member_;
    const Window &window_;
    const Group *groups_;
    int degree_;
    std::vector<std::array<DoubleDouble, max_basis>> sums_, next_; // by number of foreign arguments
};

int64_t CommonKnots::mean_by_knots(int member, const Window &window,
                                   std::vector<double> &coefficients) const {
    const auto m = static_cast<size_t>(member);
    const auto rows = KnotByKnot(*this, m, window).rows();
    const DoubleDouble total(binomial(degree_, members_[m].degree));
    return write_sum(rows, coefficients, [&](int64_t layer) {
        DoubleDouble sum;
        for (const KnotByKnot::Row &row : rows) {
            const int64_t at = layer - row.first;
            sum = at >= 0 && at < row.size ? sum + row.coefficients[static_cast<size_t>(at)] : sum;
        }
        return (sum / total).value();
    });
}

int64_t CommonKnots::mean_of_choices(int member, const Window &window,
                                     std::vector<double> &coefficients) const {
    const int p = members_[static_cast<size_t>(member)].degree;
    std::vector<BlossomRow> rows;
    std::vector<double> times;
    for_each_choice(window, p, [&](const int *chosen, double ways) {
        blossom_row(member, window, chosen, rows.emplace_back());
        times.push_back(ways);
    });
    const double total = binomial(degree_, p);
    return write_sum(rows, coefficients, [&](int64_t layer) {
        CompensatedSum sum;
        for (size_t i = 0; i < rows.size(); ++i) {
            const int64_t at = layer - rows[i].first;
            if (at >= 0 && at < rows[i].size) {
                sum.add(times[i] * rows[i].coefficients[at]);
            }
        }
        return sum.value() / total;
    });
}

int64_t CommonKnots::mean_row(int member, const Window &window, std::vector<double> &coefficients) const {
    const int p = members_[static_cast<size_t>(member)].degree;
    const bool many = count_of_choices(window, p) > many_choices;
    return many ? mean_by_knots(member, window, coefficients) : mean_of_choices(member, window, coefficients);
}

// A new layer depends only on old layers whose supports contain its own. These are at most p + 1, and they
// are stored contiguously.
LayerTable CommonKnots::raising(int member) const {
    LayerTable table;
    table.reserve(axis_->count(), axis_->degree() + 1);
    std::vector<double> coefficients;
    for (int64_t layer = 0; layer < axis_->count(); ++layer) {
        const int64_t first = mean_row(member, window(layer), coefficients);
        count_work(int64_t{16} * (axis_->degree() + 1));
        table.add_row(stored_layer(member, first), coefficients.data(),
                      static_cast<int>(coefficients.size()));
    }
    return table;
}

} // namespace nrb::refine
