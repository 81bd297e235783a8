/* SPDX-License-Identifier: MIT */
// Where the random calls take their arguments from. Arrays are longer than any number that is drawn for them says, so that
// what cannot be seen by the library, a length that is not true, does not happen.
#ifndef NURBS_TESTS_CAPI_RANDOM_SOURCE_H
#define NURBS_TESTS_CAPI_RANDOM_SOURCE_H

#include "random/shapes.h"

#include <cstddef>
#include <span>
#include <vector>

namespace random_calls {

class Source {
public:
    Source();
    Source(const Source &) = delete;
    Source &operator=(const Source &) = delete;
    ~Source();

    // A step begins: all that is drawn depends on the seed and on what the steps before have made.
    void begin(uint64_t seed);

    // In place of an input of the table: of as many axes and dimensions, mostly.
    const nurbs *spline(const nurbs *usual);
    double real(const char *name, double usual);
    int64_t integer(const char *name, int64_t usual);
    int32_t small_integer(const char *name, int32_t usual);
    uint32_t flags(uint32_t usual);
    int64_t struct_size(size_t size);
    const double *array(const char *name, std::span<const double> usual);
    const int64_t *array(const char *name, std::span<const int64_t> usual);
    const int32_t *array(const char *name, std::span<const int32_t> usual);
    // An array for an output, each time another one.
    template <class T>
    T *room() {
        return reinterpret_cast<T *>(room_of_bytes());
    }
    // Makes a result an input of later steps, or destroys it.
    void keep(nurbs *made);

    // The number n of points that was drawn for a batch, or 1.
    [[nodiscard]] int64_t batch() const noexcept { return batch_; }

    bool tells = false; // prints what is drawn

private:
    struct Facts {
        int32_t axes = 1, dim = 1;
        int64_t points = 1, counts[3] = {1, 1, 1};
        double domain[3][2] = {{0, 1}, {0, 1}, {0, 1}};
    };
    static Facts facts_of(const nurbs *g);
    void tell(const char *name, double value) const;
    void tell(const nurbs *g) const;
    [[nodiscard]] bool hostile();
    int64_t likely(const char *name, int64_t usual);
    double in_domain(int k);
    double element(const char *name, std::span<const double> usual, size_t i, int kind);
    double any_real();
    double any(const char *name, double usual);
    template <class T>
    const T *integers(const char *name, std::span<const T> usual);
    std::byte *room_of_bytes();

    Random random_{0};
    int drawn_ = 0, hostile_at_ = -1;
    int64_t batch_ = 1;
    Facts facts_;                        // of the last spline
    std::vector<nurbs *> pool_, shapes_; // results, and what this step was given
    std::vector<std::vector<double>> reals_;
    std::vector<std::vector<int64_t>> integers_;
    std::byte *rooms_;
    size_t rooms_taken_ = 0;
};

} // namespace random_calls

#endif
