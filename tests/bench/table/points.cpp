// SPDX-License-Identifier: MIT
// Points one a call, and in batches.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

namespace bench {

namespace {

constexpr size_t places = 1000;

struct SurfacePoints {
    Net net{2, 3, 20};
    Handle ours = net.make();
    TextbookSurface textbook = net.textbook();
    std::shared_ptr<SISLSurf> sisl = net.sisl_surface();
    std::vector<double> params = net.params(places), found = std::vector<double>(3 * places),
                        expected = found, normals = found;

    void run_alone() {
        for (size_t i = 0; i < places; ++i) {
            require_ok(nurbs_eval(ours.get(), 1, params.data() + 2 * i, 0, 0, found.data() + 3 * i, 0, 0, 0));
        }
    }
    void run() { require_ok(nurbs_eval(ours.get(), places, params.data(), 0, 0, found.data(), 0, 0, 0)); }
    void run_frames(size_t n) {
        for (size_t i = 0; i < places; i += n) {
            const nurbs_status status = nurbs_surface_eval_frames(
                ours.get(), static_cast<int64_t>(n), params.data() + 2 * i, 0, 0, found.data() + 3 * i, 0, 0,
                nullptr, 0, 0, nullptr, 0, 0, normals.data() + 3 * i, 0, 0, nullptr, 0);
            require_ok(status);
        }
    }
    void run_textbook() {
        for (size_t i = 0; i < places; ++i) {
            textbook.point(params[2 * i], params[2 * i + 1], expected.data() + 3 * i);
        }
    }
    void run_sisl() {
        int left = 0, right = 0, status = 0;
        for (size_t i = 0; i < places; ++i) {
            double at[] = {params[2 * i + 1], params[2 * i]}, values[9], normal[3];
            s1421(sisl.get(), 1, at, &left, &right, values, normal, &status);
            std::copy_n(values, 3, expected.data() + 3 * i);
        }
    }
};

} // namespace

void add_points(Rows &rows) {
    const auto curve = std::make_shared<CurvePoints<3>>(Net(1, 3, 100), places);
    rows.add({"curve, one point a call", "Eigen", places, [=] { curve->run_alone(); },
              [=] { curve->run_other(); }, [=] { return curve->difference(); }});
    const auto surface = std::make_shared<SurfacePoints>();
    const auto textbook = [=] {
        surface->run_alone();
        surface->run_textbook();
        return apart(surface->expected, surface->found);
    };
    rows.add({"surface, one point a call", "textbook", places, [=] { surface->run_alone(); },
              [=] { surface->run_textbook(); }, textbook});
    const auto sisl = [=] {
        surface->run_frames(1);
        surface->run_sisl();
        return apart(surface->expected, surface->found);
    };
    rows.add({"surface, point and normal a call", "SISL", places, [=] { surface->run_frames(1); },
              [=] { surface->run_sisl(); }, sisl});
    rows.add({"surface, 1000 points", "textbook", places, [=] { surface->run(); },
              [=] { surface->run_textbook(); }, textbook});
    rows.add({"surface, 1000 points and normals", "SISL", places, [=] { surface->run_frames(places); },
              [=] { surface->run_sisl(); }, sisl});
}

} // namespace bench
