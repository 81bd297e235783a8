// Models and lists as files: what is read of any bytes is written, reads back with as much in it, and is written again as the same
// bytes from then on; lists of any splines read back bit for bit, or what cannot be written is told.
#include "fuzz/harness.h"

#include <memory>
#include <string>

using fuzz::Input;

namespace {

struct Deleter {
    void operator()(nurbs_model *model) const { nurbs_model_destroy(model); }
    void operator()(nurbs_list *list) const { nurbs_list_destroy(list); }
    void operator()(nurbs *g) const { nurbs_destroy(g); }
};
using Model = std::unique_ptr<nurbs_model, Deleter>;
using List = std::unique_ptr<nurbs_list, Deleter>;
using Owned = std::unique_ptr<nurbs, Deleter>;

nurbs_call_options limited(int64_t work) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    return call;
}

nurbs_write_options any_options(Input &in) {
    nurbs_write_options options;
    FUZZ_REQUIRE(nurbs_write_options_init(&options, sizeof options) == NURBS_OK);
    if (in.coin()) {
        options.unit = in.rarely() ? in.anything() : 0.0254;
        options.tolerance = in.rarely() ? in.anything() : 0;
    }
    return options;
}

// The text, or none if the call says why.
template <class Write>
bool written(Write &&write, std::string &text) {
    int64_t size = -1;
    if (!FUZZ_OK(write(0, nullptr, &size))) {
        return false;
    }
    FUZZ_REQUIRE(size > 0);
    text.assign(static_cast<size_t>(size), '\0');
    FUZZ_REQUIRE(write(size, text.data(), nullptr) == NURBS_OK);
    return true;
}

bool written(const nurbs_model *model, int32_t format, const nurbs_write_options *options,
             std::string &text) {
    return written(
        [&](int64_t cap, void *bytes, int64_t *length) {
            return nurbs_model_write(model, format, options, cap, bytes, length);
        },
        text);
}

bool written(const nurbs_list *list, int32_t format, const nurbs_write_options *options, std::string &text) {
    return written(
        [&](int64_t cap, void *bytes, int64_t *length) {
            return nurbs_list_write(list, format, options, cap, bytes, length);
        },
        text);
}

// Within a limit, since what is made of hostile bytes may take long.
Model read(const void *bytes, size_t size) {
    const nurbs_call_options call = limited(3'000'000);
    nurbs_model *out = nullptr;
    FUZZ_OK(nurbs_read_model_with(bytes, static_cast<int64_t>(size), nullptr, &call, &out));
    return Model(out);
}

int32_t any_format(Input &in) {
    return in.coin() ? NURBS_FORMAT_IGES : NURBS_FORMAT_STEP;
}

void of_a_model(Input &in, const nurbs_model *model) {
    const nurbs_call_options call = limited(30);
    const int32_t format = any_format(in);
    FUZZ_OK(nurbs_model_write_with(model, format, nullptr, 0, nullptr, nullptr, &call));
    const nurbs_write_options options = any_options(in);
    std::string other, first, second, third;
    written(model, format, &options, other);
    if (!written(model, format, nullptr, first)) {
        return;
    }
    const Model once = read(first.data(), first.size());
    if (!once || !written(once.get(), format, nullptr, second)) {
        return;
    }
    const Model twice = read(second.data(), second.size());
    if (twice && written(twice.get(), format, nullptr, third)) {
        FUZZ_REQUIRE(third == second);
    }
}

// --- Lists.

void expect_same(const nurbs *a, const nurbs *b) {
    int64_t n[2] = {0, 0};
    int32_t dim = 0, first = 0;
    FUZZ_REQUIRE(nurbs_dimension(a, &first) == NURBS_OK);
    const nurbs *const both[] = {a, b};
    std::vector<double> points[2];
    for (size_t i = 0; i < 2; ++i) {
        FUZZ_REQUIRE(nurbs_dimension(both[i], &dim) == NURBS_OK && dim == first && (dim == 2 || dim == 3));
        FUZZ_REQUIRE(nurbs_point_count(both[i], &n[i]) == NURBS_OK);
        points[i].resize(static_cast<size_t>(dim * n[i]));
        FUZZ_REQUIRE(nurbs_points(both[i], n[i], points[i].data(), 0, 0) == NURBS_OK);
    }
    FUZZ_REQUIRE(points[0] == points[1]);
}

void of_a_list(Input &in) {
    std::vector<Owned> splines;
    std::vector<const nurbs *> given;
    std::vector<std::string> names;
    std::vector<const char *> texts;
    for (int i = in.below(4); i > 0; --i) {
        if (Owned g = Owned(fuzz::create(fuzz::any_spline(in)))) {
            given.push_back(g.get());
            splines.push_back(std::move(g));
            names.push_back(
                std::string(static_cast<size_t>(in.below(5)), static_cast<char>(1 + in.below(255))));
        }
    }
    for (const std::string &name : names) {
        texts.push_back(name.c_str());
    }
    nurbs_list *made = nullptr, *read_list = nullptr;
    if (!FUZZ_OK(
            nurbs_list_create(std::ssize(given), given.data(), texts.data(), in.below(3) / 1000.0, &made))) {
        return;
    }
    const List list(made);
    const nurbs_write_options options = any_options(in);
    const int32_t format = any_format(in);
    std::string other, text;
    written(made, format, &options, other);
    if (!written(made, format, nullptr, text)) {
        return;
    }
    FUZZ_REQUIRE(nurbs_read(text.data(), std::ssize(text), nullptr, &read_list) == NURBS_OK);
    const List again(read_list);
    int64_t count = -1;
    FUZZ_REQUIRE(nurbs_list_count(read_list, &count) == NURBS_OK && count == std::ssize(given));
    for (int64_t i = 0; i < count; ++i) {
        nurbs *g = nullptr;
        FUZZ_REQUIRE(nurbs_list_get(read_list, i, &g) == NURBS_OK);
        expect_same(given[static_cast<size_t>(i)], g);
        nurbs_destroy(g);
    }
}

void to_nowhere(Input &in, const nurbs_model *model) {
    const nurbs_call_options call = limited(1000);
    nurbs_list *made = nullptr;
    FUZZ_REQUIRE(nurbs_model_splines(model, &made) == NURBS_OK);
    const List list(made);
    const char *const path = in.coin() ? "/nonexistent/a.step" : "/dev/null";
    FUZZ_OK(nurbs_model_write_file(model, path, in.below(4), nullptr));
    FUZZ_OK(nurbs_model_write_file_with(model, path, NURBS_FORMAT_STEP, nullptr, &call));
    FUZZ_OK(nurbs_list_write_file(made, path, in.below(4), nullptr));
    FUZZ_OK(nurbs_list_write_file_with(made, path, NURBS_FORMAT_STEP, nullptr, &call));
    FUZZ_OK(nurbs_list_write_with(made, NURBS_FORMAT_STEP, nullptr, in.bad_size(), nullptr, nullptr, &call));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    if (const Model model = read(data, size)) {
        of_a_model(in, model.get());
        to_nowhere(in, model.get());
    }
    of_a_list(in);
    return 0;
}
