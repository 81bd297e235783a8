// SPDX-License-Identifier: MIT
// STEP and IGES files read by libnurbs.
#include "bench/files/job.h"

#include <cstdlib>
#include <nurbs/nurbs.h>

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

bench::files::Answer read(const char *path, bool areas) {
    nurbs_read_options options;
    nurbs_model *model = nullptr;
    bench::files::Answer answer;
    check(nurbs_read_options_init(&options, sizeof options));
    options.unit = 0.001; // as others have it
    check(nurbs_read_model_file(path, &options, &model));
    check(nurbs_model_counts(model, nullptr, nullptr, &answer.faces, nullptr, nullptr));
    for (int64_t i = 0; areas && i < answer.faces; ++i) {
        answer.area += area_of(model, i);
    }
    nurbs_model_destroy(model);
    return answer;
}

} // namespace

int main(int count, char **arguments) {
    return bench::files::run(count, arguments, read);
}
