/* SPDX-License-Identifier: MIT */
// Every function with splines whose numbers are as large, as small and as far apart as doubles allow:
// whatever the answer, no call ends the program or finds a defect of the library, and the splines stay what
// they were.
#include "calls/calls.h"
#include "support/scale.h"

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string_view>

namespace {

using Random = std::mt19937_64;

int below(Random &random, int n) {
    return static_cast<int>(random() % static_cast<uint64_t>(n));
}

// A factor 2^e, e of one of a few sizes.
class Spread {
public:
    explicit Spread(Random &random) : random_(random), most_(sizes[below(random, std::size(sizes))]) {}
    double operator()(double x) {
        const double y = std::ldexp(x, below(random_, 2 * most_ + 1) - most_);
        return std::isfinite(y) ? y : std::copysign(DBL_MAX, y);
    }

private:
    static constexpr int sizes[] = {0, 3, 40, 330, 1000};
    Random &random_;
    int most_;
};

// The arguments of a spline of the calls.
struct Parts {
    int32_t axes = 0, dim = 0, homogeneous = 0, rational = 0;
    int64_t total = 0;
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> knots, records; // homogeneous ones, or points before their weights
    uint32_t flags = 0;

    explicit Parts(const nurbs *g) {
        CHECK_OK(nurbs_axes(g, &axes));
        CHECK_OK(nurbs_dimension(g, &dim));
        CHECK_OK(nurbs_point_count(g, &total));
        CHECK_OK(nurbs_is_homogeneous(g, &homogeneous));
        CHECK_OK(nurbs_is_rational(g, &rational));
        degrees.resize(static_cast<size_t>(axes));
        counts.resize(static_cast<size_t>(axes));
        for (int32_t k = 0; k < axes; ++k) {
            add_axis(g, k);
        }
        const auto n = static_cast<size_t>(total), width = static_cast<size_t>(dim) + 1;
        records.resize(n * width);
        if (homogeneous != 0) {
            CHECK_OK(nurbs_homogeneous_points(g, total, records.data(), 0, 0));
            return;
        }
        CHECK_OK(nurbs_points(g, total, records.data(), static_cast<int64_t>(width), 1));
        CHECK_OK(nurbs_weights(g, total, records.data() + dim, static_cast<int64_t>(width)));
    }

    [[nodiscard]] nurbs_status create(nurbs **out) const {
        const auto knot_count = static_cast<int64_t>(knots.size()), width = int64_t{dim} + 1;
        return homogeneous != 0
                   ? nurbs_create_homogeneous(axes, degrees.data(), counts.data(), knots.data(), knot_count,
                                              dim, records.data(), 0, 0, flags, out)
                   : nurbs_create(axes, degrees.data(), counts.data(), knots.data(), knot_count, dim,
                                  records.data(), width, 1, rational != 0 ? records.data() + dim : nullptr,
                                  width, flags, out);
    }

private:
    void add_axis(const nurbs *g, int32_t k) {
        const auto i = static_cast<size_t>(k);
        int32_t form = 0;
        CHECK_OK(nurbs_degree(g, k, &degrees[i]));
        CHECK_OK(nurbs_count(g, k, &counts[i]));
        CHECK_OK(nurbs_knot_form(g, k, &form));
        flags |= (form & NURBS_FORM_PERIODIC) != 0 ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
        const size_t before = knots.size();
        knots.resize(before + static_cast<size_t>(counts[i] + degrees[i] + 1));
        CHECK_OK(nurbs_knots(g, k, counts[i] + degrees[i] + 1, knots.data() + before));
    }
};

// Copies on periodic axes get one factor.
void stretch(Random &random, Parts &parts) {
    Spread points(random), weights(random), knots(random);
    const auto dim = static_cast<size_t>(parts.dim);
    const double one = points(1), other = weights(1);
    for (size_t i = 0; i < parts.records.size(); ++i) {
        const bool weight = i % (dim + 1) == dim;
        double &x = parts.records[i];
        x = parts.flags != 0 ? x * (weight ? other : one) : weight ? weights(x) : points(x);
    }
    const double speed = below(random, 4) == 0 ? knots(1) : 1;
    for (double &t : parts.knots) {
        t *= speed;
    }
}

// In place of a spline; the spline itself where the numbers chosen make none.
void replace(Random &random, nurbs *&g) {
    for (int trial = 0; trial < 20; ++trial) {
        Parts parts(g);
        stretch(random, parts);
        nurbs *other = nullptr;
        if (parts.create(&other) == NURBS_OK) {
            nurbs_destroy(g);
            g = other;
            return;
        }
    }
}

calls::Inputs extreme_inputs(uint64_t seed) {
    Random random(seed);
    calls::Inputs in = calls::make_inputs();
    for (const auto spline : calls::splines) {
        replace(random, in.*spline);
    }
    return in;
}

std::vector<std::vector<double>> all_numbers(const calls::Inputs &in) {
    std::vector<std::vector<double>> all;
    for (const auto spline : calls::splines) {
        all.push_back(calls::numbers_of(in.*spline));
    }
    return all;
}

// Meshes within given lengths or angles, of shapes that may be any number of times as large, take all the work that calls may do,
// seconds: one seed of six has them.
bool is_left_out(const calls::Call &call, uint64_t seed) {
    const std::string_view name = call.name;
    const auto says = [name](const char *what) { return name.find(what) != name.npos; };
    return seed % 6 != 5 &&
           (name.starts_with("mesh_curve") || says("by length") || says("levels") || says("small angles"));
}

int good = 0, refused = 0;

void run(const calls::Call &call, const calls::Inputs &in, uint64_t seed) {
    if (is_left_out(call, seed)) {
        return;
    }
    calls::Output o;
    const nurbs_status status = call.run(in, o);
    ++(status == NURBS_OK ? good : refused);
    if (status == NURBS_ERROR_INTERNAL || status == NURBS_ERROR_MEMORY) {
        std::fprintf(stderr, "seed %llu, %s: %s\n", static_cast<unsigned long long>(seed), call.name,
                     nurbs_status_name(status));
        ++check_failures;
    }
    calls::destroy(o);
}

} // namespace

// Seeds from the first argument on, as many as the second says: else 6 * NURBS_TEST_SCALE (environment, default 1).
int main(int argc, char **argv) {
    const uint64_t first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0,
                   count = argc > 2 ? std::strtoull(argv[2], nullptr, 10)
                                    : static_cast<uint64_t>(support::scaled(6));
    const char *const path = "extremes_test.igs";
    CHECK(calls::write_files(path));
    for (uint64_t seed = first; seed < first + count; ++seed) {
        const calls::Inputs in = extreme_inputs(seed);
        const auto before = all_numbers(in);
        calls::for_each_allocating([&](const calls::Call &call) { run(call, in, seed); });
        for (const calls::Call &call : calls::scalar_calls()) {
            run(call, in, seed);
        }
        CHECK(all_numbers(in) == before);
        calls::destroy(in);
    }
    calls::remove_files();
    std::printf("%d answers, %d refusals\n", good, refused);
    CHECK(good > refused / 2);
    return check_summary("extremes");
}
