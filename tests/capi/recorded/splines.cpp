/* SPDX-License-Identifier: MIT */
#include "calls/calls.h"
#include "recorded/batteries/batteries.h"
#include "recorded/sections.h"
#include "support/golden_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>

namespace recorded {

namespace {

using support::KnotForm;
using support::Random;
using support::Recipe;
using support::Spacing;
using support::SplineData;
using support::Weights;

// The heavy ones take seconds for splines of thousands of points.
using Battery = void (*)(const Subject &);
constexpr Battery light[] = {call_getters,    call_points, call_frames,  call_bases,  call_conversions,
                             call_refinement, call_forms,  call_closest, call_weights};
constexpr Battery heavy[] = {call_algebra,  call_shapes,   call_reduction,  call_distances,
                             call_measures, call_features, call_deformation};

// The seed is of the name alone, so that one section can be run without the others.
void record_spline(const std::string &name, const nurbs *g, bool all = true) {
    const uint64_t seed = std::accumulate(name.begin(), name.end(), uint64_t{17}, [](uint64_t sum, char c) {
        return 31 * sum + static_cast<uint64_t>(c);
    });
    record.section(name, [&] {
        const Subject s(g, seed);
        std::for_each(std::begin(light), std::end(light), [&](Battery call) { call(s); });
        if (all && s.points <= 1500) {
            std::for_each(std::begin(heavy), std::end(heavy), [&](Battery call) { call(s); });
        }
    });
}

void record_data(const std::string &name, const SplineData &data) {
    const std::vector<double> knots = data.all_knots();
    Owned g;
    CHECK_OK(nurbs_create(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                          static_cast<int64_t>(knots.size()), data.dim, data.points.data(), 0, 0,
                          data.rational() ? data.weights.data() : nullptr, 0, data.flags, g.place()));
    if (g != nullptr) {
        record_spline(name, g);
    }
}

// With a control point of negative weight, and one at infinity.
void record_homogeneous(const std::string &name, const SplineData &data) {
    const std::vector<double> knots = data.all_knots();
    std::vector<double> records;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const double weight = i == 1 ? -0.05 : i == 2 ? 0 : data.weight(i);
        for (int c = 0; c < data.dim; ++c) {
            records.push_back((weight == 0 ? 0.1 : weight) * data.coordinate(i, c));
        }
        records.push_back(weight);
    }
    Owned g;
    CHECK_OK(nurbs_create_homogeneous(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                                      static_cast<int64_t>(knots.size()), data.dim, records.data(), 0, 0, 0,
                                      g.place()));
    if (g != nullptr) {
        record_spline(name, g);
    }
}

// A short run takes one of many.
bool left_out(int number, int step) {
    return record.quick() && number % step != step / 2;
}

constexpr KnotForm forms[] = {KnotForm::clamped, KnotForm::periodic, KnotForm::unclamped,
                              KnotForm::half_clamped};
constexpr Weights weights[] = {Weights::none, Weights::moderate, Weights::extreme, Weights::some_zero};
constexpr Spacing spacings[] = {Spacing::full, Spacing::integers, Spacing::few_bits, Spacing::ratio,
                                Spacing::tiny};

// Number i of those with these degrees.
Recipe recipe_of(std::initializer_list<int> degrees, int i) {
    static constexpr int dims[] = {3, 2, 3, 1, 2, 4, 3, 6, 5};
    Recipe recipe;
    for (const int degree : degrees) {
        const auto place = static_cast<int>(recipe.axes.size());
        recipe.axes.push_back({.degree = degree,
                               .form = forms[(i + place) % 4],
                               .spacing = spacings[(i + place) % 5],
                               .placement = {},
                               .spans = degrees.size() == 1 ? 2 + i % 4 : 1 + (i + place) % 3});
    }
    recipe.weights = weights[(i / 4) % 4];
    recipe.dim = dims[i % 9];
    return recipe;
}

std::string name_of(const char *kind, std::initializer_list<int> degrees, int i) {
    std::string name = kind + std::string(" ") + std::to_string(i);
    for (const int degree : degrees) {
        name += "_" + std::to_string(degree);
    }
    return name;
}

void make(std::initializer_list<int> degrees, int i, int &number) {
    if (!left_out(number++, 24)) {
        Random random(static_cast<uint64_t>(number));
        record_data(name_of("made", degrees, i), support::random_spline(random, recipe_of(degrees, i)));
    }
}

// Clamped and with weights, of which some are changed.
void make_homogeneous(std::initializer_list<int> degrees, int i, int &number) {
    if (!left_out(number++, 8)) {
        Random random(static_cast<uint64_t>(number));
        Recipe recipe = recipe_of(degrees, i);
        for (support::AxisRecipe &axis : recipe.axes) {
            axis.form = KnotForm::clamped;
        }
        recipe.weights = Weights::moderate;
        record_homogeneous(name_of("homogeneous", degrees, i), support::random_spline(random, recipe));
    }
}

} // namespace

void record_made() {
    int number = 0;
    for (const int degree : {0, 1, 2, 3, 4, 5, 7, 9, 10, 12}) {
        for (int i = 0; i < 16; ++i) {
            make({degree}, i, number);
        }
    }
    const std::pair<int, int> surfaces[] = {{0, 1}, {1, 1}, {2, 1}, {2, 2}, {3, 3},
                                            {3, 1}, {2, 5}, {4, 0}, {9, 2}};
    for (const auto &[p, q] : surfaces) {
        for (const int i : {0, 6, 11, 13}) {
            make({p, q}, i, number);
        }
    }
    for (const int i : {0, 6, 9}) {
        make({1, 1, 1}, i, number);
        make({2, 1, 0}, i, number);
        make({1, 3, 2}, i, number);
        make({5, 1, 1}, i, number);
    }
}

void record_homogeneous() {
    int number = 0;
    for (const int i : {0, 1, 4}) {
        make_homogeneous({2}, i, number);
        make_homogeneous({3}, i, number);
        make_homogeneous({6}, i, number);
    }
    make_homogeneous({2, 2}, 0, number);
    make_homogeneous({3, 1}, 1, number);
    make_homogeneous({1, 1, 2}, 2, number);
}

void record_shapes() {
    const calls::Inputs in = calls::make_inputs();
    int number = 0;
    for (const calls::Call &call : calls::shape_calls()) {
        calls::Output o;
        o.out = nullptr;
        if (!left_out(number++, 12) && call.run(in, o) == NURBS_OK && o.out != nullptr) {
            record_spline(std::string("shape ") + call.name, o.out);
        }
        calls::destroy(o);
    }
    calls::destroy(in);
}

void record_golden(const std::string &top) {
    for (const std::string name : {"curves", "surfaces", "volumes"}) {
        support::GoldenWords words(top + "/tests/golden/" + name + ".txt");
        int number = 0;
        for (std::string word; words.next(word);) {
            if (word == "spline" && !left_out(number++, 14)) {
                record_data("golden " + name + " " + std::to_string(number), words.spline());
            }
        }
        CHECK(number > 0);
    }
}

namespace {

// The file in millimetres, cut short at some places, and with a wrong letter.
void read_again(const std::filesystem::path &path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    const auto size = static_cast<int64_t>(bytes.size());
    nurbs_read_options options;
    nurbs_read_options_init(&options, sizeof options);
    options.unit = 1e-3;
    nurbs_read(bytes.data(), size, &options, unread);
    for (const int64_t part : {size / 7, size / 2, size - 100}) {
        nurbs_read(bytes.data(), part, nullptr, unread);
    }
    for (const size_t place : {bytes.size() / 9, bytes.size() / 3}) {
        bytes[place] = 'x';
        nurbs_read(bytes.data(), size, nullptr, unread);
    }
}

void record_file(const std::filesystem::path &path) {
    const std::string name = "file " + path.filename().string();
    nurbs_list *list = nullptr;
    int64_t count = 0;
    record.section(name, [&] {
        nurbs_read_file(path.c_str(), nullptr, unread);
        read_again(path);
    });
    if (nurbs_read_file(path.c_str(), nullptr, &list) == NURBS_OK) {
        CHECK_OK(nurbs_list_count(list, &count));
    }
    for (int64_t i = 0; i < count; ++i) {
        Owned g;
        CHECK_OK(nurbs_list_get(list, i, g.place()));
        record_spline(name + " " + std::to_string(i), g, i < 4 || i % 5 == 0);
    }
    nurbs_list_destroy(list);
}

} // namespace

void record_files(const std::string &folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::for_each(paths.begin(), paths.end(), record_file);
}

void record_everything(const std::string &top, const char *folder, const std::string &path) {
    record_calls(path);
    record_constructors();
    record_shapes();
    record_golden(top);
    record_made();
    record_homogeneous();
    if (folder != nullptr && !record.quick()) {
        record_files(folder);
    }
}

} // namespace recorded
