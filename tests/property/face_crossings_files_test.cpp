// The faces of real files pass the check for crossing loops, until one is added that crosses them.
#include "property/faces.h"
#include "property/models.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <utility>

namespace face_crossings_files_test {

using namespace support;
using namespace support::models;
using faces::checked;

namespace {

struct Parts {
    Handle surface;
    std::vector<std::vector<Handle>> curves;
    double tolerance = 0;

    [[nodiscard]] faces::Curves loops() const {
        faces::Curves result;
        for (const std::vector<Handle> &loop : curves) {
            result.emplace_back();
            for (const Handle &curve : loop) {
                result.back().push_back(curve.get());
            }
        }
        return result;
    }
};

Parts parts_of(const nurbs_face *face) {
    Parts parts;
    parts.surface = made([&](nurbs **out) { return nurbs_face_surface(face, out); });
    require_ok(nurbs_face_tolerance(face, &parts.tolerance));
    int64_t count = 0;
    require_ok(nurbs_face_loops(face, 0, nullptr, &count));
    std::vector<int64_t> sizes(static_cast<size_t>(count));
    require_ok(nurbs_face_loops(face, count, sizes.data(), nullptr));
    for (int64_t i = 0; i < count; ++i) {
        parts.curves.emplace_back();
        for (int64_t j = 0; j < sizes[static_cast<size_t>(i)]; ++j) {
            parts.curves.back().push_back(
                made([&](nurbs **out) { return nurbs_face_curve(face, i, j, out); }));
        }
    }
    return parts;
}

// The middle of a curve, and a place beside it.
std::vector<double> two_places(const nurbs *curve) {
    double ends[2];
    require_ok(nurbs_domain(curve, 0, ends));
    const double middle = (ends[0] + ends[1]) / 2;
    return eval(curve, {middle, middle + (ends[1] - ends[0]) / 8});
}

double radius_of(const std::vector<double> &at) {
    return std::hypot(at[2] - at[0], at[3] - at[1]);
}

// About the first place, through the second.
Handle circle(const std::vector<double> &at) {
    return made([&](nurbs **out) {
        return nurbs_curve_circle(2, at.data(), nullptr, nullptr, radius_of(at), NURBS_ARC_QUARTERS, out);
    });
}

// Of the circle in space, along the axis on which it is smaller.
double size_in_space(const nurbs *surface, const std::vector<double> &at) {
    const double r = radius_of(at);
    double least = std::numeric_limits<double>::infinity();
    for (const auto &[u, v] : {std::pair(r, 0.0), std::pair(0.0, r)}) {
        const std::vector<double> x =
            eval(surface, {at[0] - u, at[1] - v, at[0] + u, at[1] + v}, NURBS_CLAMP | NURBS_CLAMP << 8);
        least = std::min(least, std::hypot(x[3] - x[0], x[4] - x[1], x[5] - x[2]));
    }
    return least;
}

// Those of real files are faces.
void check_whole(const Parts &parts) {
    for (const uint32_t flags : {0u, NURBS_AS_ORIENTED}) {
        EXPECT_EQ(checked(parts.surface.get(), parts.loops(), parts.tolerance, flags | NURBS_KEEP_GAPS),
                  NURBS_OK)
            << last_error();
    }
}

// With a circle across a curve they are not; it may leave the domain, though. Returns whether it crosses.
bool crosses(const Parts &parts, const nurbs *curve) {
    const std::vector<double> at = two_places(curve);
    if (size_in_space(parts.surface.get(), at) < 16 * parts.tolerance) {
        return false; // of the size of the tolerance
    }
    faces::Curves loops = parts.loops();
    const Handle across = circle(at);
    loops.push_back({across.get()});
    const nurbs_status status = checked(parts.surface.get(), loops, parts.tolerance, NURBS_KEEP_GAPS);
    EXPECT_TRUE(status == NURBS_ERROR_CROSSING || status == NURBS_ERROR_OUTSIDE_DOMAIN)
        << status << ' ' << last_error();
    return status == NURBS_ERROR_CROSSING;
}

void check_file(const std::filesystem::path &path, int &whole, int &crossed) {
    nurbs_model *read = nullptr;
    require_ok(nurbs_read_model_file(path.c_str(), nullptr, &read));
    const Model model(read);
    for (int64_t i = 0; i < counts_of(model.get()).faces; ++i) {
        SCOPED_TRACE(path.filename().string() + " face " + std::to_string(i));
        const Face face = face_of(model.get(), i);
        const Parts parts = parts_of(face.get());
        if (!parts.curves.empty()) {
            check_whole(parts);
            ++whole;
            for (const Handle &curve : parts.curves[0]) {
                crossed += crosses(parts, curve.get()) ? 1 : 0;
            }
        }
    }
}

TEST(FaceCrossingsFiles, faces_of_real_files_have_none) {
    const char *folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    int whole = 0, crossed = 0;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        const std::string kind = entry.path().extension();
        if (kind == ".step" || kind == ".stp" || kind == ".iges" || kind == ".igs") {
            check_file(entry.path(), whole, crossed);
        }
    }
    EXPECT_GT(whole, 250);
    EXPECT_GT(crossed, 100);
}

} // namespace

} // namespace face_crossings_files_test
