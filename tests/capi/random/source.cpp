/* SPDX-License-Identifier: MIT */
#include "random/source.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sys/mman.h>

namespace random_calls {

namespace {

constexpr size_t array_length = 1 << 15, pattern = 512;
constexpr size_t room_size = size_t{1} << 26,
                 rooms = 16; // of addresses; memory comes where something is written
constexpr size_t most_kept = 40;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool says(const char *name, const char *word) {
    return std::strstr(name, word) != nullptr;
}

} // namespace

Source::Source()
    : rooms_(static_cast<std::byte *>(mmap(nullptr, room_size * rooms, PROT_READ | PROT_WRITE,
                                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0))) {
    if (rooms_ == MAP_FAILED) {
        std::perror("mmap");
        std::abort();
    }
}

Source::~Source() {
    std::for_each(pool_.begin(), pool_.end(), nurbs_destroy);
    std::for_each(shapes_.begin(), shapes_.end(), nurbs_destroy);
    munmap(rooms_, room_size * rooms);
}

void Source::begin(uint64_t seed) {
    random_ = Random(seed);
    std::for_each(shapes_.begin(), shapes_.end(), nurbs_destroy);
    shapes_.clear();
    reals_.clear();
    integers_.clear();
    (void)madvise(rooms_, room_size * rooms_taken_, MADV_DONTNEED);
    rooms_taken_ = 0;
    drawn_ = 0;
    batch_ = 1;
    hostile_at_ = random_.one_in(4) ? random_.below(10) : -1;
    facts_ = {};
}

void Source::tell(const char *name, double value) const {
    if (tells) {
        std::printf("    %s = %.17g\n", name, value);
    }
}

void Source::tell(const nurbs *g) const {
    for (int32_t k = 0; tells && k < facts_.axes; ++k) {
        int32_t degree = 0, form = 0, rational = 0;
        (void)nurbs_degree(g, k, &degree);
        (void)nurbs_knot_form(g, k, &form);
        (void)nurbs_is_rational(g, &rational);
        std::printf("    axis %d: degree %d, %lld points, form %d, dimension %d, rational %d\n", k, degree,
                    static_cast<long long>(facts_.counts[k]), form, facts_.dim, rational);
    }
}

// One argument of a hostile step is.
bool Source::hostile() {
    return drawn_++ == hostile_at_;
}

Source::Facts Source::facts_of(const nurbs *g) {
    Facts facts;
    (void)nurbs_axes(g, &facts.axes);
    (void)nurbs_dimension(g, &facts.dim);
    (void)nurbs_point_count(g, &facts.points);
    for (int32_t k = 0; k < facts.axes; ++k) {
        (void)nurbs_count(g, k, &facts.counts[k]);
        (void)nurbs_domain(g, k, facts.domain[k]);
    }
    return facts;
}

const nurbs *Source::spline(const nurbs *usual) {
    if (hostile() && random_.one_in(2)) {
        return nullptr;
    }
    const Facts wanted = facts_of(usual);
    const nurbs *given = usual;
    if (random_.one_in(4) && !pool_.empty()) {
        given = pool_[static_cast<size_t>(random_.below(static_cast<int>(pool_.size())))];
    } else if (!random_.one_in(8)) {
        const bool same = !random_.one_in(10);
        shapes_.push_back(random_shape(random_, same ? wanted.axes : 1 + random_.below(3),
                                       same ? wanted.dim : 1 + random_.below(4)));
        given = shapes_.back();
    }
    facts_ = facts_of(given);
    tell(given);
    return given;
}

double Source::any_real() {
    static constexpr double values[] = {0,     -0.0,     -1,        1e-300,
                                        1e300, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
    return random_.any_of(values);
}

double Source::in_domain(int k) {
    const auto &[lower, upper] = facts_.domain[k % 3];
    return random_.one_in(8) ? (random_.one_in(2) ? lower : upper) : random_.between(lower, upper);
}

double Source::real(const char *name, double usual) {
    const double drawn = any(name, usual);
    tell(name, drawn);
    return drawn;
}

double Source::any(const char *name, double usual) {
    static constexpr double tolerances[] = {0, 0, 1e-300, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1, infinity};
    if (hostile()) {
        return any_real();
    }
    if (says(name, "tolerance")) {
        return random_.one_in(4) ? usual : random_.any_of(tolerances);
    }
    if (says(name, "param") || random_.one_in(8)) {
        return in_domain(0);
    }
    return random_.one_in(2) ? usual : usual * std::ldexp(1 + random_.unit(), random_.below(9) - 4);
}

// Lengths that no array of the caller has are left to those that overflow.
int64_t Source::integer(const char *name, int64_t usual) {
    static constexpr int64_t extremes[] = {-1, std::numeric_limits<int64_t>::min(),
                                           std::numeric_limits<int64_t>::max()};
    if (says(name, "budget") || says(name, "work")) {
        return 0;
    }
    const int64_t drawn = hostile() ? random_.any_of(extremes) : likely(name, usual);
    tell(name, static_cast<double>(drawn));
    if (std::strcmp(name, "n") == 0) {
        batch_ = std::clamp<int64_t>(drawn, 1, 60);
    }
    return drawn;
}

int32_t Source::small_integer(const char *name, int32_t usual) {
    static constexpr int32_t extremes[] = {-1, std::numeric_limits<int32_t>::min(),
                                           std::numeric_limits<int32_t>::max()};
    return hostile() ? extremes[random_.below(says(name, "dim") ? 2 : 3)]
                     : static_cast<int32_t>(likely(name, usual));
}

int64_t Source::likely(const char *name, int64_t usual) {
    if (random_.one_in(3) || says(name, "size") || says(name, "axes")) {
        return usual;
    }
    if (says(name, "stride")) {
        return random_.one_in(8) ? random_.below(6) : usual;
    }
    if (says(name, "axis")) {
        return random_.below(facts_.axes);
    }
    if (says(name, "dim")) {
        return 1 + random_.below(4);
    }
    if (std::strcmp(name, "order") == 0) { // of so many derivatives the arrays have room
        return random_.below(6);
    }
    if (says(name, "cap")) {
        return random_.one_in(4) ? 0 : 30000;
    }
    if (says(name, "count")) {
        const int64_t counts[] = {facts_.points, facts_.counts[0], usual, facts_.counts[0] + usual};
        return random_.any_of(counts);
    }
    if (std::strcmp(name, "n") == 0 || says(name, "parts") || says(name, "samples")) {
        return 1 + random_.below(60);
    }
    return random_.one_in(8) ? random_.below(32) : random_.below(5);
}

uint32_t Source::flags(uint32_t usual) {
    if (hostile()) {
        return 1U << random_.below(32) | usual;
    }
    return random_.one_in(4) ? 1U << random_.below(6) : usual;
}

int64_t Source::struct_size(size_t size) {
    static constexpr int64_t sizes[] = {0, -1, 1, std::numeric_limits<int64_t>::max()};
    return hostile() ? random_.any_of(sizes) : static_cast<int64_t>(size);
}

double Source::element(const char *name, std::span<const double> usual, size_t i, int kind) {
    const auto axis = static_cast<int>(
        says(name, "range") || says(name, "keep") ? i / 2 : i % static_cast<size_t>(facts_.axes));
    if (kind == 0 && !usual.empty()) {
        return usual[i % usual.size()];
    }
    if (says(name, "weight")) {
        return kind == 1 ? std::pow(10, random_.between(-12, 12)) : random_.between(0.5, 2);
    }
    if (kind <= 2 || says(name, "range") || says(name, "param") || says(name, "knot") ||
        says(name, "break")) {
        return in_domain(axis);
    }
    return kind == 3 ? random_.between(-1, 1) : std::ldexp(random_.between(-1, 1), random_.below(60) - 30);
}

const double *Source::array(const char *name, std::span<const double> usual) {
    const bool bad = hostile();
    if (bad && random_.one_in(4)) {
        return nullptr;
    }
    std::vector<double> &values = reals_.emplace_back(array_length);
    const int kind = random_.below(5);
    for (size_t i = 0; i < pattern; ++i) {
        values[i] = element(name, usual, i, kind);
    }
    if (kind != 0 && (says(name, "knot") || says(name, "break"))) {
        std::sort(values.begin(), values.begin() + pattern);
    }
    for (size_t i = 0; kind != 0 && says(name, "range") && i < 6; i += 2) {
        std::sort(values.begin() + static_cast<ptrdiff_t>(i), values.begin() + static_cast<ptrdiff_t>(i) + 2);
    }
    for (size_t i = pattern; i < array_length; ++i) {
        values[i] = values[i - pattern];
    }
    if (bad) {
        values[static_cast<size_t>(random_.below(8))] = any_real();
    }
    return values.data();
}

// Small numbers, because they are lengths of other arrays, or too large ones for any.
template <class T>
const T *Source::integers(const char *name, std::span<const T> usual) {
    const bool bad = hostile();
    if (bad && random_.one_in(4)) {
        return nullptr;
    }
    std::vector<int64_t> &storage = integers_.emplace_back(array_length * sizeof(T) / sizeof(int64_t));
    T *values = reinterpret_cast<T *>(storage.data());
    const bool changed = random_.one_in(3) && !says(name, "count");
    for (size_t i = 0; i < array_length; ++i) {
        values[i] = usual[i % usual.size()];
        values[i] += static_cast<T>(changed && i < 8 && random_.one_in(3) ? random_.below(3) - 1 : 0);
    }
    if (bad) {
        static constexpr T extremes[] = {-1, 0, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};
        values[random_.below(static_cast<int>(std::min<size_t>(usual.size(), 4)))] = random_.any_of(extremes);
    }
    return values;
}

const int64_t *Source::array(const char *name, std::span<const int64_t> usual) {
    return integers(name, usual);
}
const int32_t *Source::array(const char *name, std::span<const int32_t> usual) {
    return integers(name, usual);
}

std::byte *Source::room_of_bytes() {
    if (rooms_taken_ == rooms) {
        std::fprintf(stderr, "a call has more than %zu outputs\n", rooms);
        std::abort();
    }
    return rooms_ + room_size * rooms_taken_++;
}

void Source::keep(nurbs *made) {
    if (made == nullptr) {
        return;
    }
    if (facts_of(made).points > 1000) {
        nurbs_destroy(made);
    } else if (pool_.size() < most_kept) {
        pool_.push_back(made);
    } else {
        nurbs *&place = pool_[static_cast<size_t>(random_.below(most_kept))];
        nurbs_destroy(place);
        place = made;
    }
}

} // namespace random_calls
