/* SPDX-License-Identifier: MIT */
/* nurbs_model_write(), nurbs_list_write(), and what they refuse. */
#include "models.h"

#include <math.h>

enum { most_text = 65536 };

typedef struct {
    char data[most_text];
    int64_t size;
} Written;

static nurbs_write_options defaults(void) {
    nurbs_write_options options;
    CHECK_OK(nurbs_write_options_init(&options, (int64_t)sizeof options));
    return options;
}

static void text_in(int32_t format, const nurbs_model *model, const nurbs_write_options *options,
                    Written *made) {
    memset(made, 0, sizeof *made);
    CHECK_OK(nurbs_model_write(model, format, options, most_text, made->data, &made->size));
    CHECK(made->size > 0 && made->size < most_text);
}

/* The options and their size, as for other structs. */
static void options_begin_as_defaults(void) {
    nurbs_write_options options = defaults();
    CHECK_INT(options.struct_size, (int64_t)sizeof options);
    CHECK_DOUBLE(options.unit, 0);
    CHECK_DOUBLE(options.tolerance, 0);
    CHECK_FAILS(nurbs_write_options_init(NULL, (int64_t)sizeof options), NURBS_ERROR_NULL, "options");
    CHECK_FAILS(nurbs_write_options_init(&options, 0), NURBS_ERROR_OPTIONS, "struct_size|0");
    struct {
        nurbs_write_options options;
        int64_t later;
    } wide;
    CHECK_OK(nurbs_write_options_init(&wide.options, (int64_t)sizeof wide));
    CHECK_INT(wide.later, 0);
}

/* A box: the same bytes every time, a solid, and the same box when it is read; with words that its file has. */
static void box_comes_back(int32_t format, const char *solid, const char *unit) {
    static Written made, again;
    nurbs_model *model = box(), *read = NULL;
    int64_t length = 0;
    CHECK_OK(nurbs_model_write(model, format, NULL, 0, NULL, &length));
    text_in(format, model, NULL, &made);
    CHECK_INT(made.size, length);
    CHECK(strstr(made.data, solid) != NULL);
    CHECK(strstr(made.data, unit) != NULL);
    CHECK_OK(nurbs_read_model(made.data, made.size, NULL, &read));
    int64_t faces = 0, edges = 0, vertices = 0;
    CHECK_OK(nurbs_model_counts(read, NULL, NULL, &faces, &edges, &vertices));
    CHECK_INT(faces, 6);
    CHECK_INT(edges, 12);
    CHECK_INT(vertices, 8);
    text_in(format, read, NULL, &again);
    CHECK_INT(again.size, made.size);
    CHECK_BITS(again.data, made.data, (size_t)made.size);
    nurbs_model_destroy(read);
    nurbs_model_destroy(model);
}

static void boxes_come_back(void) {
    box_comes_back(NURBS_FORMAT_STEP, "MANIFOLD_SOLID_BREP(", ".MILLI.");
    box_comes_back(NURBS_FORMAT_IGES, "     186 ", "2HMM");
}

/* In inches, of which a unit is told when it is read. */
static void unit_is_converted(int32_t format, const char *inch) {
    static Written made;
    nurbs_model *model = box(), *read = NULL;
    nurbs_write_options options = defaults();
    options.unit = 0.0254;
    text_in(format, model, &options, &made);
    CHECK(strstr(made.data, inch) != NULL);
    CHECK_OK(nurbs_read_model(made.data, made.size, NULL, &read));
    double sum[3] = {0, 0, 0};
    for (int64_t i = 0; i < 8; ++i) {
        double point[3];
        CHECK_OK(nurbs_model_vertex(read, i, point));
        for (int k = 0; k < 3; ++k) {
            sum[k] += point[k] / 4;
        }
    }
    CHECK_NEAR(sum, VALUES(1 / 25.4, 2 / 25.4, 3 / 25.4), 3, 1e-15);
    nurbs_list *splines = NULL;
    double unit = 0;
    CHECK_OK(nurbs_model_splines(read, &splines));
    CHECK_OK(nurbs_list_unit(splines, &unit));
    CHECK_DOUBLE(unit, 0.0254);
    nurbs_list_destroy(splines);
    nurbs_model_destroy(read);
    nurbs_model_destroy(model);
}

static void units_are_converted(void) {
    unit_is_converted(NURBS_FORMAT_STEP, "'INCH'");
    unit_is_converted(NURBS_FORMAT_IGES, "4HINCH");
}

static nurbs *curve_of(int32_t dim) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    static const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 0, 1, 2, 3};
    SplineArgs a = {1, &degree, &count, knots, 4, dim, points, 0, 0, NULL, 0, 0};
    return make(a);
}

static void list_comes_back(int32_t format) {
    static char text[most_text];
    nurbs *curve = curve_of(3), *number = curve_of(1);
    nurbs_list *list = NULL, *read = NULL;
    const char *names[] = {"it's \xC3\xA4", "b"};
    int64_t size = 0, count = 0;
    CHECK_OK(nurbs_list_create(2, CURVES(curve, curve), names, 0, &list));
    CHECK_OK(nurbs_list_write(list, format, NULL, most_text, text, &size));
    CHECK_OK(nurbs_read(text, size, NULL, &read));
    CHECK_OK(nurbs_list_count(read, &count));
    CHECK_INT(count, 2);
    char name[16];
    CHECK_OK(nurbs_list_name(read, 0, name, (int64_t)sizeof name, NULL));
    CHECK(strcmp(name, names[0]) == 0);
    double unit = 0;
    CHECK_OK(nurbs_list_unit(read, &unit));
    CHECK_DOUBLE(unit, 0.001); /* what has none is in millimetres */
    nurbs_list_destroy(read);
    nurbs_list_destroy(list);
    CHECK_OK(nurbs_list_create(2, CURVES(curve, number), NULL, 0, &list));
    CHECK_FAILS(nurbs_list_write(list, format, NULL, most_text, text, &size), NURBS_ERROR_DIMENSION,
                "splines[1]|dimension 1");
    nurbs_list_destroy(list);
    nurbs_destroy(curve);
    nurbs_destroy(number);
}

/* A curve of the plane among curves of space, in inches: it has no unit. */
static void flat_curve_comes_back(int32_t format) {
    static char text[most_text];
    nurbs *curve = curve_of(3), *flat = curve_of(2), *got = NULL;
    nurbs_list *list = NULL, *read = NULL;
    nurbs_write_options options = defaults();
    options.unit = 0.0254;
    int64_t size = 0;
    CHECK_OK(nurbs_list_create(2, CURVES(flat, curve), NULL, 0.001, &list));
    CHECK_OK(nurbs_list_write(list, format, &options, most_text, text, &size));
    CHECK_OK(nurbs_read(text, size, NULL, &read));
    CHECK_OK(nurbs_list_get(read, 0, &got));
    int32_t dim = 0;
    CHECK_OK(nurbs_dimension(got, &dim));
    CHECK_INT(dim, 2);
    double points[4];
    CHECK_OK(nurbs_points(got, 2, points, 0, 0));
    CHECK_NEAR(points, VALUES(0, 0, 0, 1), 4, 0);
    nurbs_destroy(got);
    nurbs_list_destroy(read);
    nurbs_list_destroy(list);
    nurbs_destroy(curve);
    nurbs_destroy(flat);
}

static void lists_come_back(void) {
    list_comes_back(NURBS_FORMAT_STEP);
    list_comes_back(NURBS_FORMAT_IGES);
    flat_curve_comes_back(NURBS_FORMAT_STEP);
    flat_curve_comes_back(NURBS_FORMAT_IGES);
}

static void files_are_written(void) {
    static const char path[] = "write_test.step";
    static Written made;
    nurbs_model *model = box(), *read = NULL;
    nurbs_list *list = NULL, *none = NULL;
    text_in(NURBS_FORMAT_STEP, model, NULL, &made);
    CHECK_OK(nurbs_model_write_file(model, path, NURBS_FORMAT_STEP, NULL));
    static char kept[most_text];
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    if (file != NULL) {
        CHECK_INT((int64_t)fread(kept, 1, most_text, file), made.size);
        (void)fclose(file);
        CHECK_BITS(kept, made.data, (size_t)made.size);
    }
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, (int64_t)sizeof call));
    call.work = 1;
    CHECK_FAILS(nurbs_model_write_file_with(model, path, NURBS_FORMAT_STEP, NULL, &call), NURBS_ERROR_WORK,
                "");
    CHECK_FAILS(nurbs_model_write_with(model, NURBS_FORMAT_STEP, NULL, 0, NULL, NULL, &call),
                NURBS_ERROR_WORK, "");
    CHECK_OK(nurbs_read_model_file(path, NULL, &read));
    CHECK_OK(nurbs_model_splines(read, &list));
    CHECK_OK(nurbs_list_write_file(list, path, NURBS_FORMAT_STEP, NULL));
    CHECK_OK(nurbs_list_write_file_with(list, path, NURBS_FORMAT_STEP, NULL, NULL));
    CHECK_OK(nurbs_list_write_with(list, NURBS_FORMAT_STEP, NULL, 0, NULL, NULL, NULL));
    CHECK_OK(nurbs_read_file(path, NULL, &none));
    CHECK_FAILS(nurbs_model_write_file(model, "no/such/folder", NURBS_FORMAT_STEP, NULL), NURBS_ERROR_FILE,
                "no/such/folder|No such file");
    (void)remove(path);
    nurbs_list_destroy(none);
    nurbs_list_destroy(list);
    nurbs_model_destroy(read);
    nurbs_model_destroy(model);
}

static void what_cannot_be_is_refused(void) {
    char bytes[8];
    nurbs_model *model = box();
    nurbs_list *list = NULL;
    nurbs_write_options options = defaults();
    CHECK_OK(nurbs_model_splines(model, &list));
    CHECK_FAILS(nurbs_model_write(NULL, 99, NULL, 0, NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_list_write(NULL, 99, NULL, 0, NULL, NULL), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_model_write_file(NULL, "a", 99, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_write_file(model, NULL, 99, NULL), NURBS_ERROR_NULL, "path");
    CHECK_FAILS(nurbs_list_write_file(NULL, "a", 99, NULL), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_write_file(list, NULL, 99, NULL), NURBS_ERROR_NULL, "path");
    CHECK_FAILS(nurbs_model_write(model, 0, NULL, 0, NULL, NULL), NURBS_ERROR_FORMAT, "format = 0");
    CHECK_FAILS(nurbs_list_write(list, 99, NULL, 0, NULL, NULL), NURBS_ERROR_FORMAT, "format = 99");
    CHECK_FAILS(nurbs_model_write(model, 1, NULL, -1, NULL, NULL), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_write(model, 1, NULL, 8, bytes, NULL), NURBS_ERROR_SIZE, "cap");
    options.unit = NAN;
    CHECK_FAILS(nurbs_model_write(model, 1, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS, "unit");
    options.unit = 1e-320;
    CHECK_FAILS(nurbs_model_write(model, 1, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS, "unit");
    options.unit = 1;
    options.tolerance = -1;
    CHECK_FAILS(nurbs_model_write(model, 1, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS, "tolerance = -1");
    options.struct_size = 8;
    CHECK_FAILS(nurbs_model_write(model, 1, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_list_destroy(list);
    nurbs_model_destroy(model);
}

int main(void) {
    options_begin_as_defaults();
    boxes_come_back();
    units_are_converted();
    lists_come_back();
    files_are_written();
    what_cannot_be_is_refused();
    return check_summary("write");
}
