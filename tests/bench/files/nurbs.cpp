// SPDX-License-Identifier: MIT
// STEP and IGES files read by libnurbs.
#include "bench/files/job.h"

#include <cstdlib>
#include <nurbs/nurbs.h>
#include <string_view>

namespace {

void check(nurbs_status status) {
    if (status != NURBS_OK) {
        char text[512];
        nurbs_last_error(text, sizeof text);
        std::fprintf(stderr, "%s: %s\n", nurbs_status_name(status), text);
        std::exit(1);
    }
}

double area_of(const nurbs_model *model, int64_t index) {
    nurbs_face *face = nullptr;
    double area = 0;
    check(nurbs_model_face(model, index, nullptr, nullptr, nullptr, nullptr, &face));
    check(nurbs_face_area(face, 1e-6, &area, nullptr));
    nurbs_face_destroy(face);
    return area;
}

nurbs_model *model_of(const char *path) {
    nurbs_read_options options;
    nurbs_model *model = nullptr;
    check(nurbs_read_options_init(&options, sizeof options));
    options.unit = 0.001; // as others have it
    check(nurbs_read_model_file(path, &options, &model));
    return model;
}

bench::files::Answer read(const char *path, bool areas) {
    nurbs_model *model = model_of(path);
    bench::files::Answer answer;
    check(nurbs_model_counts(model, nullptr, nullptr, &answer.faces, nullptr, nullptr));
    for (int64_t i = 0; areas && i < answer.faces; ++i) {
        answer.area += area_of(model, i);
    }
    nurbs_model_destroy(model);
    return answer;
}

// PROGRAM FILE COPY writes a file that was read, as the name of the copy ends.
int write(const char *path, const char *copy) {
    nurbs_model *model = model_of(path);
    const bool step = std::string_view(copy).ends_with(".step");
    check(nurbs_model_write_file(model, copy, step ? NURBS_FORMAT_STEP : NURBS_FORMAT_IGES, nullptr));
    nurbs_model_destroy(model);
    return 0;
}

} // namespace

int main(int count, char **arguments) {
    return count == 3 ? write(arguments[1], arguments[2]) : bench::files::run(count, arguments, read);
}
