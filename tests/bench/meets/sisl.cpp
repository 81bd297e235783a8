// SPDX-License-Identifier: MIT
// Meets of surfaces by SISL: s1859 finds curves, s1310 makes them, in space and in both domains.     bench_meets_sisl PAIR TOLERANCE
#include "bench/meets/job.h"

#include <sisl.h>

namespace {

using namespace bench::meets;

void good(int status, const char *call) {
    if (status < 0) {
        std::fprintf(stderr, "%s: status %d\n", call, status);
        std::exit(1);
    }
}

// Of its control points the first index varies fastest.
SISLSurf *surface_of(Net net) {
    std::vector<double> points;
    for (int j = 0; j < net.counts[1]; ++j) {
        for (int i = 0; i < net.counts[0]; ++i) {
            const Point &x = net.points[static_cast<size_t>(i * net.counts[1] + j)];
            points.insert(points.end(), x.begin(), x.end());
        }
    }
    return newSurf(net.counts[0], net.counts[1], degree + 1, degree + 1, net.knots[0].data(),
                   net.knots[1].data(), points.data(), 1, 3, 1);
}

struct Meet {
    SISLSurf *a = nullptr, *b = nullptr;
    int points = 0, curves = 0;
    double *on_a = nullptr, *on_b = nullptr;
    SISLIntcurve **found = nullptr;

    void renew(const Pair &pair) {
        release();
        a = surface_of(pair.a);
        b = surface_of(pair.b);
    }
    void make(double tolerance) {
        int status = 0;
        s1859(a, b, 0, tolerance, &points, &on_a, &on_b, &curves, &found, &status);
        good(status, "s1859");
        for (int i = 0; i < curves; ++i) {
            s1310(a, b, found[i], tolerance, 0, 2, 0, &status);
            good(status, "s1310");
        }
    }
    void release() {
        if (a != nullptr) {
            freeSurf(a);
            freeSurf(b);
            std::free(on_a);
            std::free(on_b);
            freeIntcrvlist(found, curves);
        }
        *this = {};
    }
};

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_meets_sisl PAIR TOLERANCE\n");
        return 2;
    }
    const Pair pair = pair_of(argv[1]);
    const double tolerance = std::atof(argv[2]);
    Meet meet;
    const double ms = milliseconds([&] { meet.renew(pair); }, [&] { meet.make(tolerance); });
    Curves curves(pair);
    for (int i = 0; i < meet.curves; ++i) {
        SISLCurve *curve = meet.found[i]->pgeom;
        if (curve == nullptr) {
            continue;
        }
        const double first = curve->et[curve->ik - 1], last = curve->et[curve->in];
        int left = 0;
        curves.add([&](double share) {
            Point at{};
            int status = 0;
            s1221(curve, 0, (1 - share) * first + share * last, &left, at.data(), &status);
            good(status, "s1221");
            return at;
        });
    }
    curves.tell(ms, -1);
    meet.release();
    return 0;
}
