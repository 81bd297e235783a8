// Curves and surfaces of real CAD files. Their folder is named by the environment variable NURBS_TEST_DATA;
// files in JSON need nlohmann-json.
#pragma once

#include "property/same_shape.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#if __has_include(<nlohmann/json.hpp>)
#include <nlohmann/json.hpp>
#endif

namespace support {

using List = std::unique_ptr<nurbs_list, decltype(&nurbs_list_destroy)>;

struct RealSpline {
    std::string name;
    SplineData data;
    Handle handle;
};

inline std::vector<Handle> items(const List &list) {
    int64_t count = 0;
    require_ok(nurbs_list_count(list.get(), &count));
    std::vector<Handle> handles;
    for (int64_t i = 0; i < count; ++i) {
        nurbs *item = nullptr;
        require_ok(nurbs_list_get(list.get(), i, &item));
        handles.emplace_back(item);
    }
    return handles;
}

inline void read_iges(const std::filesystem::path &path, std::vector<RealSpline> &splines) {
    nurbs_list *list = nullptr;
    require_ok(nurbs_read_file(path.c_str(), nullptr, &list));
    for (Handle &handle : items(List(list, nurbs_list_destroy))) {
        SplineData data = read_back(handle.get());
        splines.push_back({path.filename().string() + " " + std::to_string(splines.size()), std::move(data),
                           std::move(handle)});
    }
}

#ifdef NLOHMANN_JSON_VERSION_MAJOR
inline constexpr bool reads_json = true;

// Numbers in nested lists, the innermost fastest.
inline void append_numbers(const nlohmann::json &values, std::vector<double> &out) {
    if (values.is_array()) {
        for (const auto &value : values) {
            append_numbers(value, out);
        }
    } else {
        out.push_back(values.get<double>());
    }
}

// An entity: degree p or [p, q], knots of each axis, points[i] or points[i][j], weights or null.
inline SplineData data_of(const nlohmann::json &entity) {
    SplineData data;
    const bool curve = entity["degree"].is_number();
    const nlohmann::json degrees = curve ? nlohmann::json::array({entity["degree"]}) : entity["degree"];
    const nlohmann::json knots = curve ? nlohmann::json::array({entity["knots"]}) : entity["knots"];
    for (size_t k = 0; k < degrees.size(); ++k) {
        data.degrees.push_back(degrees[k].get<int32_t>());
        append_numbers(knots[k], data.knots.emplace_back());
        data.counts.push_back(std::ssize(data.knots[k]) - data.degrees[k] - 1);
    }
    append_numbers(entity["points"], data.points);
    data.dim = static_cast<int32_t>(std::ssize(data.points) / data.point_count());
    if (!entity["weights"].is_null()) {
        append_numbers(entity["weights"], data.weights);
    }
    return data;
}

inline void read_json(const std::filesystem::path &path, std::vector<RealSpline> &splines) {
    std::ifstream file(path);
    const nlohmann::json document = nlohmann::json::parse(file);
    for (const auto &entity : document["entities"]) {
        SplineData data = data_of(entity);
        Handle handle = create(data);
        splines.push_back(
            {path.filename().string() + " " + entity["id"].dump(), std::move(data), std::move(handle)});
    }
}
#else
inline constexpr bool reads_json = false;
inline void read_json(const std::filesystem::path &, std::vector<RealSpline> &) {}
#endif

inline std::vector<RealSpline> read_files(const std::filesystem::path &folder, bool json) {
    std::vector<RealSpline> splines;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        const auto extension = entry.path().extension();
        if (json && extension == ".json") {
            read_json(entry.path(), splines);
        } else if (!json && (extension == ".iges" || extension == ".igs")) {
            read_iges(entry.path(), splines);
        }
    }
    return splines;
}

// Tests that need the files, and are skipped without.
class RealFiles : public ::testing::Test {
protected:
    static const std::vector<RealSpline> &iges() {
        static const std::vector<RealSpline> list = read_files(std::getenv("NURBS_TEST_DATA"), false);
        return list;
    }
    static const std::vector<RealSpline> &json() {
        static const std::vector<RealSpline> list = read_files(std::getenv("NURBS_TEST_DATA"), true);
        return list;
    }
    void SetUp() override {
        if (std::getenv("NURBS_TEST_DATA") == nullptr) {
            GTEST_SKIP() << "NURBS_TEST_DATA is not set";
        }
    }
};

} // namespace support
