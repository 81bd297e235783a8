/* SPDX-License-Identifier: MIT */
/* nurbs_mesh_write(), and what it refuses. */
#include "models.h"

#include <math.h>

enum { most_bytes = 8192 };
static const int32_t formats[] = {NURBS_FORMAT_STL, NURBS_FORMAT_STL_TEXT, NURBS_FORMAT_OBJ,
                                  NURBS_FORMAT_PLY, NURBS_FORMAT_GLB,      NURBS_FORMAT_VTU};
enum { format_count = 6 };

/* What files of these formats begin with. */
static const char *const beginnings[] = {"Written by", "solid ", "# Written", "ply\n", "glTF", "<?xml "};

typedef struct {
    char data[most_bytes];
    int64_t size;
} Written;

static nurbs_mesh *mesh_of_box(void) {
    nurbs_model *model = box();
    nurbs_mesh *mesh = NULL;
    CHECK_OK(nurbs_mesh_model(model, NULL, &mesh));
    nurbs_model_destroy(model);
    return mesh;
}

static void write_to(const nurbs_mesh *mesh, int32_t format, const nurbs_write_options *options,
                     Written *made) {
    memset(made, 0, sizeof *made);
    CHECK_OK(nurbs_mesh_write(mesh, format, options, most_bytes, made->data, &made->size));
    CHECK(made->size > 0 && made->size < most_bytes);
}

static double single_at(const char *bytes) {
    uint32_t bits = 0;
    for (int i = 3; i >= 0; --i) {
        bits = bits << 8 | (unsigned char)bytes[i];
    }
    float value = 0;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* What the facets of a binary STL file enclose. */
static double volume_of(const Written *file) {
    double sum = 0;
    for (int64_t at = 84; at + 50 <= file->size; at += 50) {
        double p[3][3];
        for (int64_t i = 0; i < 9; ++i) {
            p[i / 3][i % 3] = single_at(file->data + at + 12 + 4 * i);
        }
        sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
               p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    return sum / 6;
}

/* The same bytes every time, and as many as the call without an array says; the model may be gone. */
static void boxes_are_written(void) {
    static Written made, again;
    nurbs_mesh *mesh = mesh_of_box(), *copy = NULL;
    CHECK_OK(nurbs_mesh_clone(mesh, &copy));
    for (int i = 0; i < format_count; ++i) {
        int64_t length = 0;
        CHECK_OK(nurbs_mesh_write(mesh, formats[i], NULL, 0, NULL, &length));
        write_to(mesh, formats[i], NULL, &made);
        CHECK_INT(made.size, length);
        CHECK(strncmp(made.data, beginnings[i], strlen(beginnings[i])) == 0);
        CHECK_OK(nurbs_mesh_write_with(copy, formats[i], NULL, most_bytes, again.data, &again.size, NULL));
        CHECK_INT(again.size, made.size);
        CHECK_BITS(again.data, made.data, (size_t)made.size);
        CHECK_OK(nurbs_mesh_write(mesh, formats[i], NULL, length, again.data, NULL));
    }
    nurbs_mesh_destroy(copy);
    nurbs_mesh_destroy(mesh);
}

/* Of 1, 2 and 3 mm: outside is outside, in millimetres and in inches. */
static void box_is_seen_from_outside(void) {
    static Written made;
    nurbs_mesh *mesh = mesh_of_box();
    nurbs_write_options options;
    CHECK_OK(nurbs_write_options_init(&options, (int64_t)sizeof options));
    write_to(mesh, NURBS_FORMAT_STL, NULL, &made);
    CHECK_INT(made.size, 84 + 50 * 12);
    CHECK_NEAR(VALUES(volume_of(&made)), VALUES(6), 1, 1e-6);
    options.unit = 0.0254;
    write_to(mesh, NURBS_FORMAT_STL, &options, &made);
    CHECK_NEAR(VALUES(volume_of(&made)), VALUES(6 / (25.4 * 25.4 * 25.4)), 1, 1e-9);
    nurbs_mesh_destroy(mesh);
}

static void files_are_written(void) {
    static const char path[] = "mesh_write_test.bin";
    static Written made;
    static char kept[most_bytes];
    nurbs_mesh *mesh = mesh_of_box();
    for (int i = 0; i < format_count; ++i) {
        write_to(mesh, formats[i], NULL, &made);
        CHECK_OK(nurbs_mesh_write_file(mesh, path, formats[i], NULL));
        FILE *file = fopen(path, "rb");
        CHECK(file != NULL);
        if (file != NULL) {
            CHECK_INT((int64_t)fread(kept, 1, most_bytes, file), made.size);
            (void)fclose(file);
            CHECK_BITS(kept, made.data, (size_t)made.size);
        }
    }
    CHECK_OK(nurbs_mesh_write_file_with(mesh, path, NURBS_FORMAT_GLB, NULL, NULL));
    CHECK_FAILS(nurbs_mesh_write_file(mesh, "no/such/folder", NURBS_FORMAT_STL, NULL), NURBS_ERROR_FILE,
                "no/such/folder|No such file");
    CHECK_FAILS(nurbs_mesh_write_file(mesh, ".", NURBS_FORMAT_STL, NULL), NURBS_ERROR_FILE, "directory");
    (void)remove(path);
    nurbs_mesh_destroy(mesh);
}

/* Nothing is written, and the file is as it was. */
static void long_calls_can_be_ended(void) {
    static const char path[] = "mesh_write_ended.bin";
    static Written made;
    nurbs_mesh *mesh = mesh_of_box();
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, (int64_t)sizeof call));
    CHECK_OK(nurbs_mesh_write_file(mesh, path, NURBS_FORMAT_STL, NULL));
    call.work = 1;
    memset(&made, 7, sizeof made);
    for (int i = 0; i < format_count; ++i) {
        CHECK_FAILS(nurbs_mesh_write_with(mesh, formats[i], NULL, most_bytes, made.data, &made.size, &call),
                    NURBS_ERROR_WORK, "");
        CHECK_FAILS(nurbs_mesh_write_file_with(mesh, path, formats[i], NULL, &call), NURBS_ERROR_WORK, "");
    }
    CHECK_INT(made.data[0], 7);
    CHECK_INT(made.data[most_bytes - 1], 7);
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    if (file != NULL) {
        CHECK_INT((int64_t)fread(made.data, 1, most_bytes, file), 84 + 50 * 12);
        (void)fclose(file);
    }
    call.work = 1000000;
    CHECK_OK(nurbs_mesh_write_with(mesh, NURBS_FORMAT_VTU, NULL, most_bytes, made.data, &made.size, &call));
    CHECK(strncmp(made.data, "<?xml", 5) == 0);
    (void)remove(path);
    nurbs_mesh_destroy(mesh);
}

/* Of a model without faces. */
static nurbs_mesh *mesh_without_triangles(void) {
    nurbs_model *model = NULL;
    nurbs_mesh *mesh = NULL;
    CHECK_OK(nurbs_model_create(0, NULL, 0, &model));
    CHECK_OK(nurbs_mesh_model(model, NULL, &mesh));
    nurbs_model_destroy(model);
    return mesh;
}

static void what_cannot_be_is_refused(void) {
    char bytes[8] = "unused";
    nurbs_mesh *mesh = mesh_of_box(), *empty = mesh_without_triangles();
    nurbs_write_options options;
    CHECK_OK(nurbs_write_options_init(&options, (int64_t)sizeof options));
    CHECK_FAILS(nurbs_mesh_write(NULL, 99, NULL, 0, NULL, NULL), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_write_file(NULL, "a", 99, NULL), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_write_file(mesh, NULL, 99, NULL), NURBS_ERROR_NULL, "path");
    for (int32_t format = NURBS_FORMAT_STEP; format <= NURBS_FORMAT_IGES; ++format) {
        CHECK_FAILS(nurbs_mesh_write(mesh, format, NULL, 0, NULL, NULL), NURBS_ERROR_FORMAT, "format = |STL");
    }
    CHECK_FAILS(nurbs_mesh_write(mesh, 9, NULL, 0, NULL, NULL), NURBS_ERROR_FORMAT, "format = 9");
    CHECK_FAILS(nurbs_mesh_write(mesh, -3, NULL, 0, NULL, NULL), NURBS_ERROR_FORMAT, "format = -3");
    for (int i = 0; i < format_count; ++i) {
        const int32_t format = formats[i];
        CHECK_FAILS(nurbs_mesh_write(mesh, format, NULL, -1, NULL, NULL), NURBS_ERROR_COUNT, "cap = -1");
        CHECK_FAILS(nurbs_mesh_write(mesh, format, NULL, 8, bytes, NULL), NURBS_ERROR_SIZE, "cap = 8");
        CHECK_FAILS(nurbs_mesh_write(empty, format, NULL, 0, NULL, NULL), NURBS_ERROR_COUNT, "no triangles");
        CHECK_FAILS(nurbs_mesh_write_file(empty, "a", format, NULL), NURBS_ERROR_COUNT, "no triangles");
    }
    CHECK(strcmp(bytes, "unused") == 0);
    options.unit = NAN;
    CHECK_FAILS(nurbs_mesh_write(mesh, NURBS_FORMAT_STL, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS,
                "unit");
    options.unit = 1e-320;
    CHECK_FAILS(nurbs_mesh_write(mesh, NURBS_FORMAT_STL, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS,
                "unit");
    options.unit = 1e-100;
    CHECK_FAILS(nurbs_mesh_write(mesh, NURBS_FORMAT_GLB, &options, 0, NULL, NULL),
                NURBS_ERROR_NOT_REPRESENTABLE, "single precision");
    options.struct_size = 8;
    CHECK_FAILS(nurbs_mesh_write(mesh, NURBS_FORMAT_STL, &options, 0, NULL, NULL), NURBS_ERROR_OPTIONS,
                "struct_size");
    nurbs_mesh_destroy(empty);
    nurbs_mesh_destroy(mesh);
}

int main(void) {
    boxes_are_written();
    box_is_seen_from_outside();
    files_are_written();
    long_calls_can_be_ended();
    what_cannot_be_is_refused();
    return check_summary("mesh_write");
}
