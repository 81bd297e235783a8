// Fuzz target: any bytes go through nurbs_read(), and whatever comes out is used.
#include <nurbs/nurbs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

// What the header promises ends the program when it does not hold.
void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

nurbs *spline_of(const nurbs_list *list, int64_t index) {
    nurbs *spline = nullptr;
    require(nurbs_list_get(list, index, &spline) == NURBS_OK && spline != nullptr);
    return spline;
}

// The middle of a valid domain is a valid parameter, and the point there is finite or overflows on the way.
void evaluate_middle(const nurbs *spline) {
    int32_t axes = 0;
    int32_t dim = 0;
    require(nurbs_axes(spline, &axes) == NURBS_OK && nurbs_dimension(spline, &dim) == NURBS_OK);
    std::vector<double> params;
    for (int32_t axis = 0; axis < axes; ++axis) {
        double domain[2] = {0, 0};
        require(nurbs_domain(spline, axis, domain) == NURBS_OK);
        require(domain[0] < domain[1]);
        params.push_back(domain[0] / 2 + domain[1] / 2);
    }
    std::vector<double> point(static_cast<size_t>(dim));
    require(nurbs_eval(spline, 1, params.data(), 0, 0, point.data(), 0, 0,
                       NURBS_ON_ALL_AXES(axes, NURBS_CLAMP)) == NURBS_OK);
}

void read_name(const nurbs_list *list, int64_t index) {
    char name[8];
    int64_t length = -1;
    require(nurbs_list_name(list, index, name, sizeof name, &length) == NURBS_OK && length > 0);
}

void read_note(const nurbs_list *list, int64_t index) {
    char text[64];
    int32_t type = -1;
    int64_t line = -1;
    nurbs_status reason = NURBS_OK;
    int64_t length = -1;
    require(nurbs_list_note(list, index, &type, &line, &reason, text, sizeof text, &length) == NURBS_OK);
    require(type >= 0 && line > 0 && reason != NURBS_OK && reason != NURBS_ERROR_INTERNAL && length > 0);
}

void use(const nurbs_list *list) {
    int64_t count = -1;
    double metres = -1;
    require(nurbs_list_count(list, &count) == NURBS_OK && nurbs_list_unit(list, &metres) == NURBS_OK);
    require(metres >= 0 && std::isfinite(metres));
    for (int64_t i = 0; i < count; ++i) {
        nurbs *spline = spline_of(list, i);
        read_name(list, i);
        evaluate_middle(spline);
        nurbs_destroy(spline);
    }
    require(nurbs_list_note_count(list, &count) == NURBS_OK);
    for (int64_t i = 0; i < count; ++i) {
        read_note(list, i);
    }
}

void read_in(double unit, const uint8_t *data, size_t size) {
    nurbs_read_options options;
    require(nurbs_read_options_init(&options, sizeof options) == NURBS_OK);
    options.unit = unit;
    nurbs_list *list = nullptr;
    const nurbs_status status = nurbs_read(data, static_cast<int64_t>(size), &options, &list);
    require((status == NURBS_OK) == (list != nullptr) && status != NURBS_ERROR_INTERNAL);
    if (list != nullptr) {
        use(list);
    }
    nurbs_list_destroy(list);
}

// No file has such a name; whatever the bytes are, the call says so.
void read_missing_file(const uint8_t *data, size_t size) {
    const std::string path = "/nonexistent/" + std::string(data, data + std::min<size_t>(size, 300));
    nurbs_list *list = nullptr;
    require(nurbs_read_file(path.c_str(), nullptr, &list) == NURBS_ERROR_FILE && list == nullptr);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    read_in(0, data, size);
    read_in(0.001, data, size);
    read_missing_file(data, size);
    return 0;
}
