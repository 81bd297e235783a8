#include "reference/zero_count.h"

#include <map>
#include <numeric>
#include <tuple>

namespace reference {

namespace {

constexpr int finest = 40, most_level = 24; // places are integers times 2^-finest

struct ZeroDoubt {
    const char *what;
};
using Coefficients = std::vector<Integer>;

// Halves of a polynomial, times 2^degree.
std::array<Coefficients, 2> halves_of(const Coefficients &whole) {
    const size_t n = whole.size() - 1;
    std::array<Coefficients, 2> halves{whole, whole};
    Coefficients means = whole;
    for (size_t r = 0; r <= n; ++r) {
        halves[0][r] = means[0] << static_cast<unsigned>(n - r);
        halves[1][n - r] = means[n - r] << static_cast<unsigned>(n - r);
        for (size_t i = 0; i + r < n; ++i) {
            means[i] += means[i + 1];
        }
    }
    return halves;
}

int sign_of(const Integer &x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}
int sign_changes(const Coefficients &c) {
    int changes = 0, last = 0;
    for (const Integer &x : c) {
        const int sign = sign_of(x);
        changes += sign * last < 0 ? 1 : 0;
        last = sign == 0 ? last : sign;
    }
    return changes;
}
// 1 or -1 if all of them have that sign; else 0.
int common_sign(const Coefficients &c) {
    const int sign = sign_of(c.front());
    for (const Integer &x : c) {
        if (sign_of(x) != sign) {
            return 0;
        }
    }
    return sign;
}

// Zeros as the intervals of length 2^-finest that they are in, rising.
void add_zeros(const Coefficients &c, int64_t lower, int level, std::vector<int64_t> &zeros) {
    if (c.front() == 0 || c.back() == 0) {
        throw ZeroDoubt{"a zero at a corner"};
    }
    const int changes = sign_changes(c);
    if (changes == 0) {
        return;
    }
    if (level == finest) {
        if (changes > 1) {
            throw ZeroDoubt{"zeros that are all but one"};
        }
        zeros.push_back(lower);
        return;
    }
    const std::array<Coefficients, 2> halves = halves_of(c);
    add_zeros(halves[0], lower, level + 1, zeros);
    add_zeros(halves[1], lower + (int64_t{1} << (finest - level - 1)), level + 1, zeros);
}

class ZeroCounter {
public:
    explicit ZeroCounter(const std::array<int, 2> &counts)
        : rows_(static_cast<size_t>(counts[0])), columns_(static_cast<size_t>(counts[1])) {}

    ZeroCount run(const Coefficients &coefficients) {
        std::vector<Square> squares{{coefficients, {0, 0}, 0}};
        while (!squares.empty()) {
            const Square square = std::move(squares.back());
            squares.pop_back();
            if (!is_done(square)) {
                divide(square, squares);
            }
        }
        return counted();
    }

private:
    struct Square {
        Coefficients c;
        std::array<int64_t, 2> lower;
        int level;
        [[nodiscard]] int64_t size() const { return int64_t{1} << (finest - level); }
    };
    // Axis of the line, its place, and the place on it.
    using Name = std::tuple<size_t, int64_t, int64_t>;

    [[nodiscard]] Coefficients line(const Coefficients &c, size_t axis, size_t index) const {
        Coefficients result;
        for (size_t k = 0; k < (axis == 0 ? rows_ : columns_); ++k) {
            result.push_back(axis == 0 ? c[k * columns_ + index] : c[index * columns_ + k]);
        }
        return result;
    }
    // The sign of the derivative along an axis, if its coefficients have one.
    [[nodiscard]] int slope_sign(const Coefficients &c, size_t axis) const {
        Coefficients slopes;
        for (size_t i = 0; i < (axis == 0 ? columns_ : rows_); ++i) {
            const Coefficients along = line(c, axis, i);
            for (size_t k = 0; k + 1 < along.size(); ++k) {
                slopes.push_back(along[k + 1] - along[k]);
            }
        }
        return common_sign(slopes);
    }

    bool is_done(const Square &square) {
        if (common_sign(square.c) != 0) {
            return true;
        }
        for (const size_t axis : {size_t{1}, size_t{0}}) {
            if (slope_sign(square.c, axis) != 0) {
                add_arcs(square, 1 - axis);
                return true;
            }
        }
        return false;
    }
    void divide(const Square &square, std::vector<Square> &squares) const {
        if (square.level == most_level) {
            throw ZeroDoubt{"zeros that are singular, or near it"};
        }
        for (const int up : {0, 1}) {
            Coefficients half(square.c.size());
            for (size_t j = 0; j < columns_; ++j) {
                const Coefficients part = halves_of(line(square.c, 0, j))[static_cast<size_t>(up)];
                for (size_t i = 0; i < rows_; ++i) {
                    half[i * columns_ + j] = part[i];
                }
            }
            std::array<Coefficients, 2> quarters;
            for (size_t i = 0; i < rows_; ++i) {
                const std::array<Coefficients, 2> parts = halves_of(line(half, 1, i));
                for (size_t end = 0; end < 2; ++end) {
                    quarters[end].insert(quarters[end].end(), parts[end].begin(), parts[end].end());
                }
            }
            const int64_t step = square.size() / 2;
            for (size_t end = 0; end < 2; ++end) {
                squares.push_back(
                    {std::move(quarters[end]),
                     {square.lower[0] + up * step, square.lower[1] + static_cast<int64_t>(end) * step},
                     square.level + 1});
            }
        }
    }

    // Zeros are a graph over an axis: places at the ends of it, and between these those on both sides, are by turns beginnings and ends.
    void add_arcs(const Square &square, size_t axis) {
        const size_t other = 1 - axis;
        std::vector<std::pair<int64_t, Name>> places;
        for (const size_t end : {size_t{0}, size_t{1}}) {
            const auto at = [&](size_t k) {
                return square.lower[k] + static_cast<int64_t>(end) * square.size();
            };
            const auto last = [&](size_t k) { return end == 0 ? 0 : (k == 0 ? rows_ : columns_) - 1; };
            std::vector<int64_t> along, across;
            add_zeros(line(square.c, axis, last(other)), square.lower[axis], square.level, along);
            add_zeros(line(square.c, other, last(axis)), square.lower[other], square.level, across);
            for (const int64_t place : along) {
                places.push_back({place, {axis, at(other), place}});
            }
            for (const int64_t place : across) { // one at most, at an end
                places.push_back({end == 0 ? -1 : int64_t{1} << (finest + 1), {other, at(axis), place}});
            }
        }
        std::sort(places.begin(), places.end());
        for (size_t i = 0; i + 1 < places.size(); ++i) {
            if (places[i].first == places[i + 1].first) {
                throw ZeroDoubt{"places that are not told apart"};
            }
        }
        if (places.size() % 2 != 0) {
            throw ZeroDoubt{"an odd number of places"};
        }
        for (size_t i = 0; i < places.size(); i += 2) {
            arcs_.push_back({vertex(places[i].second), vertex(places[i + 1].second)});
        }
    }
    size_t vertex(const Name &name) { return names_.try_emplace(name, names_.size()).first->second; }

    ZeroCount counted() {
        std::vector<size_t> of(names_.size()), ends(names_.size(), 0);
        std::iota(of.begin(), of.end(), size_t{0});
        const auto root = [&](size_t i) {
            while (of[i] != i) {
                i = of[i] = of[of[i]];
            }
            return i;
        };
        for (const auto &[from, to] : arcs_) {
            ++ends[from];
            ++ends[to];
            of[root(from)] = root(to);
        }
        ZeroCount count;
        for (const auto &[name, i] : names_) {
            const int64_t at = std::get<1>(name);
            const bool border = at == 0 || at == int64_t{1} << finest;
            if (ends[i] != (border ? 1U : 2U)) {
                throw ZeroDoubt{"an arc that ends inside"};
            }
            count.open += border ? 1 : 0;
            count.closed += root(i) == i ? 1 : 0;
        }
        count.open /= 2;
        count.closed -= count.open;
        return count;
    }

    size_t rows_, columns_;
    std::map<Name, size_t> names_;
    std::vector<std::array<size_t, 2>> arcs_;
};

} // namespace

ZeroCount count_zeros(const std::vector<Integer> &coefficients, const std::array<int, 2> &counts) {
    try {
        return ZeroCounter(counts).run(coefficients);
    } catch (const ZeroDoubt &doubt) {
        return {doubt.what};
    }
}

} // namespace reference
