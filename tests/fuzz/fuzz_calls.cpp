// Long calls with limits of work and wrong structs: the same question gives the same answer, whatever ends it, and the
// handles answer afterwards.
#include "fuzz/harness.h"

#include <vector>

using fuzz::Input;

namespace {

struct Outputs {
    double values[256];
    int64_t counts[4];
    int32_t states[64];
};

// Two calls with the same limit have the same status, and write the same or nothing.
template <class Call>
void twice(Call &&call) {
    Outputs a, b;
    std::memset(&a, 0x5a, sizeof a);
    std::memset(&b, 0x5a, sizeof b);
    const nurbs_status first = call(a), second = call(b);
    FUZZ_OK(first);
    FUZZ_REQUIRE(first == second);
    FUZZ_REQUIRE(std::memcmp(&a, &b, sizeof a) == 0);
    const auto *bytes = reinterpret_cast<const unsigned char *>(&a);
    for (size_t i = 0; first != NURBS_OK && i < sizeof a; ++i) {
        FUZZ_REQUIRE(bytes[i] == 0x5a);
    }
}

// The same for a call that makes a handle.
template <class Call>
void twice_made(Call &&call) {
    twice([&](Outputs &o) {
        nurbs *out = fuzz::poison();
        const nurbs_status status = call(o, &out);
        nurbs_destroy(fuzz::made(status, out, __LINE__));
        return status;
    });
}

nurbs_call_options any_options(Input &in) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = int64_t{1} << in.below(20);
    if (in.rarely()) {
        call.struct_size = in.bad_size();
    }
    if (in.rarely()) {
        call.work = in.bad_size();
    }
    return call;
}

void places(Input &in, const nurbs *g, int dim, const nurbs_call_options *call) {
    std::vector<double> points(static_cast<size_t>(4 * dim)), guesses(12, 0.5);
    for (double &x : points) {
        x = in.number();
    }
    nurbs_closest_query query{};
    query.struct_size = in.rarely() ? in.bad_size() : int64_t{sizeof query};
    query.n = 4;
    query.points = points.data();
    query.budget = 1 + in.below(20);
    const auto batch = [&](auto &&find) {
        twice([&](Outputs &o) {
            nurbs_closest_answer answer{};
            answer.struct_size = sizeof answer;
            answer.params = o.values;
            answer.status = o.states;
            return find(g, &query, &answer, call);
        });
    };
    batch([](auto... a) { return nurbs_closest_points_with(a...); });
    batch([](auto... a) { return nurbs_farthest_points_with(a...); });
    query.budget = 0;
    query.guesses = guesses.data();
    batch([](auto... a) { return nurbs_closest_local_with(a...); });
    query.guesses = nullptr;
    twice([&](Outputs &o) {
        nurbs_closest_answer answer{};
        answer.struct_size = sizeof answer;
        answer.distances = o.values;
        return nurbs_curve_signed_distances_with(g, &query, &answer, call);
    });
    twice([&](Outputs &o) {
        return nurbs_closest_all_with(g, points.data(), nullptr, 0, 20, 0, nullptr, nullptr, o.counts,
                                      o.states, call);
    });
    twice([&](Outputs &o) {
        return nurbs_critical_points_with(g, points.data(), nullptr, 0, 20, 0, nullptr, nullptr, nullptr,
                                          o.counts, o.states, call);
    });
}

void pairs(const nurbs *a, const nurbs *b, const nurbs_call_options *call) {
    twice([&](Outputs &o) {
        return nurbs_distance_with(a, b, 1e-3, 20, o.values, o.values + 1, nullptr, nullptr, o.states, call);
    });
    twice([&](Outputs &o) {
        return nurbs_hausdorff_distance_with(a, b, 1e-2, 16, o.values, o.values + 2, nullptr, nullptr,
                                             o.states, call);
    });
    twice_made([&](Outputs &, nurbs **out) { return nurbs_product_with(a, b, 0, call, out); });
    twice_made([&](Outputs &, nurbs **out) { return nurbs_compose_with(a, b, call, out); });
}

void measures(const nurbs *g, const nurbs_call_options *call) {
    const double half[] = {0.5};
    twice(
        [&](Outputs &o) { return nurbs_curve_length_with(g, nullptr, 1e-3, o.values, o.values + 1, call); });
    twice([&](Outputs &o) { return nurbs_curve_lengths_with(g, 1, half, 0, 1e-3, o.values, 0, call); });
    twice([&](Outputs &o) {
        return nurbs_curve_params_at_lengths_with(g, 1, half, 0, 1e-3, o.values, 0, NURBS_CLAMP, call);
    });
    twice([&](Outputs &o) {
        return nurbs_curve_divide_with(g, nullptr, 5, 1e-3, 0, o.values, o.values + 6, call);
    });
    twice(
        [&](Outputs &o) { return nurbs_surface_area_with(g, nullptr, 1e-2, o.values, o.values + 1, call); });
    twice([&](Outputs &o) {
        return nurbs_moments_with(g, 1e-2, o.values, nullptr, nullptr, o.values + 1, call);
    });
    twice([&](Outputs &o) {
        return nurbs_enclosed_area_with(1, &g, 1e9, 1e-3, o.values, nullptr, nullptr, o.values + 1, call);
    });
    twice([&](Outputs &o) {
        return nurbs_enclosed_volume_with(1, &g, 1e-2, o.values, nullptr, nullptr, o.values + 1, o.values + 2,
                                          call);
    });
    twice([&](Outputs &o) {
        return nurbs_recognize_with(g, 1e-3, o.states, o.values, o.values + 9, o.values + 12, call);
    });
    twice([&](Outputs &o) {
        return nurbs_curve_features_with(g, NURBS_FEATURE_INFLECTION, 0, nullptr, nullptr, nullptr, o.counts,
                                         o.states, call);
    });
    twice([&](Outputs &o) {
        return nurbs_extrema_with(g, NURBS_EXTREMUM_SADDLE, 0, nullptr, nullptr, nullptr, nullptr, o.counts,
                                  o.states, call);
    });
    twice(
        [&](Outputs &o) { return nurbs_fold_test_with(g, nullptr, o.states, o.values, o.values + 3, call); });
}

void changes(Input &in, const nurbs *g, int dim, const nurbs_call_options *call) {
    std::vector<double> zero(static_cast<size_t>(dim), 0.0), along = zero, across = zero, target = zero;
    along.front() = 1;
    across.back() = 1;
    target.front() = in.number();
    const double middle[] = {0.5, 0.5, 0.5};
    twice_made(
        [&](Outputs &o, nurbs **out) { return nurbs_reduce_knots_with(g, 0, 1e-2, o.values, call, out); });
    twice_made(
        [&](Outputs &o, nurbs **out) { return nurbs_reduce_degree_with(g, 0, 1, o.values, call, out); });
    twice_made([&](Outputs &o, nurbs **out) { return nurbs_simplify_with(g, 1e-2, o.values, call, out); });
    twice_made([&](Outputs &o, nurbs **out) {
        return nurbs_bend_with(g, zero.data(), along.data(), across.data(), 0.1, -1, 1, 0.1, o.values,
                               o.states, call, out);
    });
    twice_made([&](Outputs &o, nurbs **out) {
        return nurbs_free_form_deform_with(g, g, zero.data(), along.data(), 0.1, o.values, o.states, call,
                                           out);
    });
    twice_made([&](Outputs &o, nurbs **out) {
        return nurbs_fair_with(g, 1, nullptr, 0.1, o.values, o.values + 2, call, out);
    });
    nurbs_constraints wanted{};
    wanted.struct_size = in.rarely() ? in.bad_size() : int64_t{sizeof wanted};
    wanted.count = 1;
    wanted.params = middle;
    wanted.targets = target.data();
    twice_made([&](Outputs &o, nurbs **out) {
        nurbs_constraint_report report{};
        report.struct_size = sizeof report;
        report.residuals = o.values;
        return nurbs_constrain_with(g, &wanted, &report, call, out);
    });
}

void files(Input &in, const nurbs_call_options *call) {
    char text[200];
    for (char &letter : text) {
        letter = static_cast<char>(in.byte());
    }
    nurbs_list *list = nullptr;
    FUZZ_OK(nurbs_read_with(text, sizeof text, nullptr, call, &list));
    nurbs_list_destroy(list);
    FUZZ_OK(nurbs_read_file_with("/dev/null", nullptr, call, &list));
    nurbs_list_destroy(list);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const nurbs_call_options call = any_options(in);
    const fuzz::Spline first = fuzz::any_spline(in), second = fuzz::any_spline(in);
    const fuzz::Handle a(fuzz::create(first)), b(fuzz::create(second));
    if (a && b && first.total <= 12 && second.total <= 12) {
        places(in, a.get(), first.dim, &call);
        pairs(a.get(), b.get(), &call);
        measures(a.get(), &call);
        changes(in, a.get(), first.dim, &call);
    }
    files(in, &call);
    return 0;
}
