// SPDX-License-Identifier: MIT
// What the first calls on a new handle cost; making it is not counted.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

#include <string>

namespace bench {

namespace {

// New handles in store, each for one run.
class Fresh {
public:
    explicit Fresh(Net net) : net_(std::move(net)) { fill(); }
    // Another one; they are made in groups, so that making them is a part that can be measured apart.
    const nurbs *next() {
        if (used_ == handles_.size()) {
            fill();
        }
        return handles_[used_++].get();
    }

private:
    void fill() {
        handles_.clear();
        for (int i = 0; i < 256; ++i) {
            handles_.push_back(net_.make());
        }
        used_ = 0;
    }

    Net net_;
    std::vector<Handle> handles_;
    size_t used_ = 0;
};

constexpr size_t runs = 256;

struct FirstPoints {
    Net net;
    size_t n;
    std::vector<double> params = net.params(n), found = std::vector<double>(3 * n);

    // Points of 256 new handles, one call each with a point.
    void run() {
        Fresh fresh(net);
        for (size_t i = 0; i < runs; ++i) {
            const nurbs *g = fresh.next();
            for (size_t k = 0; k < n; ++k) {
                require_ok(nurbs_eval(g, 1, params.data() + k * static_cast<size_t>(net.axes), 0, 0,
                                      found.data() + 3 * k, 0, 0, 0));
            }
        }
    }
    void make_only() { const Fresh fresh(net); }
};

} // namespace

// Ours beside making the handles alone: what is beyond 1 is the first calls.
void add_first_calls(Rows &rows) {
    for (const size_t n : {1, 4, 16, 64}) {
        const auto curve = std::make_shared<FirstPoints>(FirstPoints{Net(1, 3, 100), n});
        rows.add({"making 256 curves, and their first " + std::to_string(n) + " points",
                  "making alone",
                  runs,
                  [=] { curve->run(); },
                  [=] { curve->make_only(); },
                  {}});
        const auto surface = std::make_shared<FirstPoints>(FirstPoints{Net(2, 3, 20), n});
        rows.add({"making 256 surfaces, and their first " + std::to_string(n) + " points",
                  "making alone",
                  runs,
                  [=] { surface->run(); },
                  [=] { surface->make_only(); },
                  {}});
    }
    const auto net = std::make_shared<Net>(2, 3, 20);
    const auto sisl = net->sisl_surface();
    const auto ours = [=] {
        const double point[] = {8.3, 9.1, 3};
        double at[2];
        const Handle fresh = net->make();
        require_ok(nurbs_closest_points(fresh.get(), 1, point, 0, 0, nullptr, 0, 0, at, 0, 0, nullptr, 0, 0,
                                        nullptr, 0, nullptr, 0));
    };
    const auto theirs = [=] {
        double point[] = {8.3, 9.1, 3}, *at = nullptr;
        int count = 0, curve_count = 0, status = 0;
        SISLIntcurve **curves = nullptr;
        s1954(sisl.get(), point, 3, 1e-15, 1e-9, &count, &at, &curve_count, &curves, &status);
        std::free(at);
        freeIntcrvlist(curves, curve_count);
    };
    rows.add({"surface, making and first nearest point", "SISL", 1, ours, theirs, {}});
}

} // namespace bench
