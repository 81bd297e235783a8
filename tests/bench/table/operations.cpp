// SPDX-License-Identifier: MIT
// Knots, degrees and pieces of curves.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

namespace bench {

namespace {

struct Curves {
    Net coarse{1, 3, 100}, fine{1, 3, 1000};
    Handle ours = coarse.make(), ours_fine = fine.make();
    std::shared_ptr<SISLCurve> sisl = coarse.sisl_curve(), sisl_fine = fine.sisl_curve();
    std::vector<double> knots = coarse.params(1000);
    std::vector<double> points, weights;

    Curves() {
        std::sort(knots.begin(), knots.end());
        points.resize(3 * 4 * 997);
        weights.resize(4 * 997);
    }
};

template <class Make>
void made(Make &&make) {
    nurbs *out = nullptr;
    require_ok(make(&out));
    nurbs_destroy(out);
}

template <class Make>
void sisl_made(Make &&make) {
    SISLCurve *out = nullptr;
    int status = 0;
    make(&out, &status);
    freeCurve(out);
}

void decompose(const nurbs *g, bool open) {
    nurbs_list *list = nullptr;
    int64_t count = 0;
    require_ok(nurbs_decompose(g, &list));
    require_ok(nurbs_list_count(list, &count));
    for (int64_t i = 0; open && i < count; ++i) {
        made([&](nurbs **out) { return nurbs_list_get(list, i, out); });
    }
    nurbs_list_destroy(list);
}

} // namespace

void add_operations(Rows &rows) {
    const auto c = std::make_shared<Curves>();
    const auto pieces = [=] {
        sisl_made([&](SISLCurve **out, int *status) { s1730(c->sisl_fine.get(), out, status); });
    };
    rows.add(
        {"refine by 1000 knots",
         "SISL",
         1,
         [=] {
             made([&](nurbs **out) { return nurbs_refine(c->ours.get(), 0, 1000, c->knots.data(), out); });
         },
         [=] {
             sisl_made([&](SISLCurve **out, int *status) {
                 s1018(c->sisl.get(), c->knots.data(), 1000, out, status);
             });
         },
         {}});
    rows.add({"decompose 1000 points", "SISL", 1, [=] { decompose(c->ours_fine.get(), false); }, pieces, {}});
    rows.add({"decompose, all pieces opened",
              "SISL",
              1,
              [=] { decompose(c->ours_fine.get(), true); },
              pieces,
              {}});
    rows.add({"all pieces as arrays",
              "SISL",
              1,
              [=] {
                  int64_t count = 0;
                  require_ok(nurbs_bezier_pieces(c->ours_fine.get(), 997, c->points.data(), c->weights.data(),
                                                 nullptr, nullptr, &count));
              },
              pieces,
              {}});
    rows.add({"length to 1e-10, of a new handle",
              "SISL",
              1,
              [=] {
                  const Handle fresh = c->coarse.make();
                  double length = 0;
                  require_ok(nurbs_curve_length(fresh.get(), nullptr, 1e-10, &length, nullptr));
              },
              [=] {
                  double length = 0;
                  int status = 0;
                  s1240(c->sisl.get(), 1e-10, &length, &status);
              },
              {}});
    rows.add(
        {"elevate 1000 points",
         "SISL",
         1,
         [=] { made([&](nurbs **out) { return nurbs_elevate(c->ours_fine.get(), 0, 1, out); }); },
         [=] { sisl_made([&](SISLCurve **out, int *status) { s1750(c->sisl_fine.get(), 5, out, status); }); },
         {}});
}

} // namespace bench
