// SPDX-License-Identifier: MIT
// Meets of surfaces by this library, through its C interface: curves in space and in both domains.
//   bench_meets_nurbs PAIR TOLERANCE
#include "bench/meets/job.h"

#include <memory>
#include <nurbs/nurbs.h>

namespace {

using namespace bench::meets;

void good(nurbs_status status) {
    if (status != NURBS_OK) {
        char text[256] = "";
        nurbs_last_error(text, sizeof text);
        std::fprintf(stderr, "%s\n", text);
        std::exit(1);
    }
}

struct Destroy {
    void operator()(nurbs *g) const noexcept { nurbs_destroy(g); }
    void operator()(nurbs_meet *meet) const noexcept { nurbs_meet_destroy(meet); }
};
using Handle = std::unique_ptr<nurbs, Destroy>;
using Meet = std::unique_ptr<nurbs_meet, Destroy>;

Handle made(const Net &net) {
    std::vector<double> knots = net.knots[0];
    knots.insert(knots.end(), net.knots[1].begin(), net.knots[1].end());
    const int32_t degrees[] = {degree, degree};
    const int64_t counts[] = {net.counts[0], net.counts[1]};
    nurbs *g = nullptr;
    good(nurbs_create(2, degrees, counts, knots.data(), static_cast<int64_t>(knots.size()), 3,
                      net.points.front().data(), 0, 0, nullptr, 0, 0, &g));
    return Handle(g);
}

// The largest deviation of a branch; less than 0: there may be others.
double proven(const nurbs_meet *meet, int64_t branches) {
    std::vector<double> deviations(static_cast<size_t>(branches));
    good(nurbs_meet_branches(meet, branches, nullptr, nullptr, nullptr, deviations.data(), nullptr));
    int32_t complete = 0;
    good(nurbs_meet_counts(meet, nullptr, nullptr, &complete));
    return complete == 1 && branches > 0 ? *std::ranges::max_element(deviations) : -1;
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_meets_nurbs PAIR TOLERANCE\n");
        return 2;
    }
    const Pair pair = pair_of(argv[1]);
    const double tolerance = std::atof(argv[2]);
    Handle a, b;
    Meet meet;
    const auto prepare = [&] {
        meet = nullptr;
        a = made(pair.a);
        b = made(pair.b);
    };
    const double ms = milliseconds(prepare, [&] {
        nurbs_meet *out = nullptr;
        good(nurbs_surface_intersections(a.get(), b.get(), tolerance, &out));
        meet.reset(out);
    });
    int64_t branches = 0;
    good(nurbs_meet_counts(meet.get(), &branches, nullptr, nullptr));
    Curves curves(pair);
    for (int64_t i = 0; i < branches; ++i) {
        nurbs *space = nullptr, *on = nullptr;
        good(nurbs_meet_branch(meet.get(), i, &space, &on));
        const Handle curve(space), under(on);
        double domain[2];
        good(nurbs_domain(space, 0, domain));
        curves.add([&](double share) {
            const double t = share == 1 ? domain[1] : domain[0] + share * (domain[1] - domain[0]);
            Point at{};
            good(nurbs_eval(space, 1, &t, 0, 0, at.data(), 0, 0, 0));
            return at;
        });
    }
    curves.tell(ms, proven(meet.get(), branches));
    return 0;
}
