/* SPDX-License-Identifier: MIT */
// The splines that the calls share, and the arrays that they write to.
#include "calls/calls.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace calls {

namespace {

// The splines of the inputs, those of the lists, the faces, the models and the meets behind the others, each to be destroyed.
std::vector<nurbs *> splines_of(const Inputs &in) {
    std::vector<nurbs *> all;
    for (const auto spline : splines) {
        CHECK_OK(nurbs_clone(in.*spline, &all.emplace_back(nullptr)));
    }
    for (const auto list : lists) {
        int64_t count = 0;
        CHECK_OK(nurbs_list_count(in.*list, &count));
        for (int64_t i = 0; i < count; ++i) {
            CHECK_OK(nurbs_list_get(in.*list, i, &all.emplace_back(nullptr)));
        }
    }
    for (const auto face : faces_made) {
        CHECK_OK(nurbs_face_surface(in.*face, &all.emplace_back(nullptr)));
        CHECK_OK(nurbs_face_curve(in.*face, 0, 0, &all.emplace_back(nullptr)));
    }
    for (const auto model : models) {
        int64_t edges = 0;
        CHECK_OK(nurbs_model_counts(in.*model, nullptr, nullptr, nullptr, &edges, nullptr));
        if (edges == 0) {
            continue;
        }
        CHECK_OK(nurbs_model_edge(in.*model, 0, nullptr, nullptr, nullptr, &all.emplace_back(nullptr)));
    }
    for (const auto meet : meets) {
        nurbs *space = nullptr, *on_surface = nullptr;
        CHECK_OK(nurbs_meet_branch(in.*meet, 0, &space, &on_surface));
        all.insert(all.end(), {space, on_surface});
    }
    return all;
}

// The numbers of all of them, one spline after the other.
std::vector<double> all_numbers(const Inputs &in) {
    std::vector<double> all;
    for (nurbs *g : splines_of(in)) {
        const std::vector<double> own = numbers_of(g);
        CHECK(!own.empty());
        all.insert(all.end(), own.begin(), own.end());
        nurbs_destroy(g);
    }
    for (const auto statistics : all_statistics) {
        int64_t size = 0;
        CHECK_OK(nurbs_statistics_to_bytes(in.*statistics, 0, nullptr, &size));
        std::vector<unsigned char> bytes(static_cast<size_t>(size));
        CHECK_OK(nurbs_statistics_to_bytes(in.*statistics, size, bytes.data(), nullptr));
        all.insert(all.end(), bytes.begin(), bytes.end());
    }
    return all;
}

bool write(const char *path, const char *text) {
    std::FILE *f = std::fopen(path, "wb");
    const size_t size = std::strlen(text);
    return f != nullptr && std::fwrite(text, 1, size, f) == size && std::fclose(f) == 0;
}

} // namespace

const char *file_path = nullptr, *solid_path = nullptr, *replaced_path = nullptr;

bool write_files(const char *path) {
    static std::string names[3];
    names[0] = path;
    names[1] = names[0] + ".step";
    file_path = names[0].c_str();
    names[2] = names[0] + ".replaced.step";
    solid_path = names[1].c_str();
    replaced_path = names[2].c_str();
    return write(file_path, texts::file) && write(solid_path, texts::solid) &&
           write(replaced_path, texts::replaced);
}

void remove_files() {
    std::remove(file_path);
    std::remove(solid_path);
    std::remove(replaced_path);
}

void destroy(const Inputs &in) {
    for (const auto spline : splines) {
        nurbs_destroy(in.*spline);
    }
    for (const auto list : lists) {
        nurbs_list_destroy(in.*list);
    }
    for (const auto statistics : all_statistics) {
        nurbs_statistics_destroy(in.*statistics);
    }
    for (const auto face : faces_made) {
        nurbs_face_destroy(in.*face);
    }
    for (const auto model : models) {
        nurbs_model_destroy(in.*model);
    }
    for (const auto meet : meets) {
        nurbs_meet_destroy(in.*meet);
    }
    for (const auto mesh : meshes) {
        nurbs_mesh_destroy(in.*mesh);
    }
}

void check_intact(const Inputs &in) {
    const Inputs fresh = make_inputs();
    CHECK(same_bits(all_numbers(in), all_numbers(fresh)));
    destroy(fresh);
}

std::vector<double> numbers_of(const nurbs *g) {
    std::vector<double> numbers;
    const auto more = [&](int64_t n) {
        numbers.resize(numbers.size() + static_cast<size_t>(n));
        return numbers.data() + numbers.size() - n;
    };
    int32_t axes = 0, dim = 0, degree = 0;
    int64_t total = 0, count = 0;
    bool good = nurbs_axes(g, &axes) == NURBS_OK && nurbs_dimension(g, &dim) == NURBS_OK &&
                nurbs_point_count(g, &total) == NURBS_OK &&
                nurbs_homogeneous_points(g, total, more(total * (dim + 1)), 0, 0) == NURBS_OK;
    for (int32_t k = 0; k < axes; ++k) {
        good = good && nurbs_degree(g, k, &degree) == NURBS_OK && nurbs_count(g, k, &count) == NURBS_OK &&
               nurbs_knots(g, k, count + degree + 1, more(count + degree + 1)) == NURBS_OK;
    }
    return good ? numbers : std::vector<double>{};
}

bool same_bits(std::span<const double> a, std::span<const double> b) {
    return std::ranges::equal(a, b, {}, std::bit_cast<uint64_t, double>, std::bit_cast<uint64_t, double>);
}

Output::Output() {
    FILL(values);
    FILL(singles);
    FILL(spans);
    FILL(states);
    FILL(text);
}

void destroy(const Output &o) {
    for (nurbs *g : {o.out, o.other}) {
        nurbs_destroy(g == check_poison() ? nullptr : g);
    }
    nurbs_list_destroy(o.list);
    nurbs_statistics_destroy(o.statistics);
    nurbs_face_destroy(o.face);
    nurbs_model_destroy(o.model);
    nurbs_meet_destroy(o.meet);
    nurbs_mesh_destroy(o.mesh);
}

void check_nothing_written(const Output &o) {
    for (const nurbs *g : {o.out, o.other}) {
        CHECK(g == nullptr || g == check_poison());
    }
    CHECK(o.list == nullptr);
    CHECK(o.statistics == nullptr);
    CHECK(o.face == nullptr);
    CHECK(o.model == nullptr);
    CHECK(o.meet == nullptr);
    CHECK(o.mesh == nullptr);
    CHECK_UNTOUCHED(o.values);
    CHECK_UNTOUCHED(o.singles);
    CHECK_UNTOUCHED(o.spans);
    CHECK_UNTOUCHED(o.states);
    CHECK_UNTOUCHED(o.text);
}

} // namespace calls
