/* SPDX-License-Identifier: MIT */
/* nurbs_read(), nurbs_read_file(), nurbs_read_options_init() and the lists they give. */
#include "check.h"

#include "iges_text.h"
#include "shapes.h"

#include <stdint.h>

static nurbs_list *poison(void) {
    return (nurbs_list *)(void *)check_poison();
}

#define NO_LIST(call, status, words)                                                                         \
    do {                                                                                                     \
        list = poison();                                                                                     \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK(list == NULL);                                                                                 \
    } while (0)

static nurbs_list *read_small(const nurbs_read_options *options) {
    const IgesText file = small_file();
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_read(file.bytes, file.size, options, &list));
    if (list == NULL) {
        exit(2);
    }
    return list;
}

static nurbs_read_options defaults(void) {
    nurbs_read_options options;
    memset(&options, 0x5a, sizeof options);
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    return options;
}

static void default_options(void) {
    struct {
        nurbs_read_options options;
        char behind[16];
    } wide;
    nurbs_read_options options = defaults();
    CHECK_INT(options.struct_size, sizeof options);
    CHECK_DOUBLE(options.unit, 0);
    CHECK_INT(options.max_bytes, INT64_C(1) << 30);
    CHECK_DOUBLE(options.tolerance, 0);
    CHECK_INT(options.kinds, 0);
    CHECK_INT(options.reserved, 0);
    memset(&wide, 0x5a, sizeof wide);
    CHECK_OK(nurbs_read_options_init(&wide.options, (int64_t)sizeof wide.options));
    CHECK_UNTOUCHED(wide.behind);
    CHECK_FAILS(nurbs_read_options_init(NULL, (int64_t)sizeof options), NURBS_ERROR_NULL, "options");
    memset(&options, 0x5a, sizeof options);
    CHECK_FAILS(nurbs_read_options_init(&options, 0), NURBS_ERROR_OPTIONS, "struct_size|0");
    CHECK_FAILS(nurbs_read_options_init(&options, -1), NURBS_ERROR_OPTIONS, "struct_size|-1");
    CHECK_FAILS(nurbs_read_options_init(&options, INT64_MIN), NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(nurbs_read_options_init(&options, 4), NURBS_ERROR_OPTIONS, "struct_size|4");
    check_untouched(__FILE__, __LINE__, &options, sizeof options);
}

static void contents(void) {
    static const double points[] = {0, 0, 0, 1, 2, 0, 3, 2, 0, 4, 0, 0}, weights[] = {1, 2};
    char text[64];
    int64_t count = -1, length = -1, line = -1;
    int32_t type = -1, rational = -1;
    nurbs_status reason = -1;
    double metres = -1;
    nurbs *g = NULL;
    nurbs_list *list = read_small(NULL);
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_list_unit(list, &metres));
    CHECK_DOUBLE(metres, 0.001);
    CHECK_OK(nurbs_list_name(list, 0, text, 64, &length));
    CHECK(strcmp(text, "126#1") == 0);
    CHECK_INT(length, 5);
    CHECK_OK(nurbs_list_name(list, 1, text, 64, NULL));
    CHECK(strcmp(text, "BOW") == 0);
    CHECK_OK(nurbs_list_note_count(list, &count));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_list_note(list, 0, &type, &line, &reason, text, 64, &length));
    CHECK_INT(type, 116);
    CHECK_INT(line, 3);
    CHECK_INT(reason, NURBS_ERROR_UNSUPPORTED);
    CHECK(length > 0 && (length > 63 || (int64_t)strlen(text) == length));
    CHECK_OK(nurbs_list_note(list, 0, NULL, NULL, NULL, NULL, 0, NULL));
    CHECK_OK(nurbs_list_get(list, 0, &g));
    nurbs *h = NULL;
    CHECK_OK(nurbs_list_get(list, 1, &h));
    nurbs_list_destroy(list);
    CHECK_POINTS(g, points);
    CHECK_KNOTS(g, 0, arch().knots);
    CHECK_OK(nurbs_is_rational(g, &rational));
    CHECK_INT(rational, 0);
    CHECK_WEIGHTS(h, weights);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* A wanted unit of one metre divides millimetres by 1000. */
static void units(void) {
    static const double expected[] = {0, 0, 0, 0.001, 0.002, 0, 0.003, 0.002, 0, 0.004, 0, 0};
    nurbs_read_options options = defaults();
    double metres = -1, points[12];
    nurbs *g = NULL;
    options.unit = 1;
    nurbs_list *list = read_small(&options);
    CHECK_OK(nurbs_list_unit(list, &metres));
    CHECK_DOUBLE(metres, 1);
    CHECK_OK(nurbs_list_get(list, 0, &g));
    CHECK_OK(nurbs_points(g, 4, points, 0, 0));
    CHECK_NEAR(points, expected, 12, 0x1p-52 * 0.004);
    nurbs_destroy(g);
    nurbs_list_destroy(list);
}

static void truncated_texts(void) {
    char text[8];
    int64_t length = -1;
    nurbs_list *list = read_small(NULL);
    for (int64_t cap = 0; cap <= 7; ++cap) {
        FILL(text);
        CHECK_OK(nurbs_list_name(list, 0, text, cap, &length));
        CHECK_INT(length, 5);
        const int64_t kept = cap == 0 ? 0 : cap < 6 ? cap - 1 : 5;
        CHECK(memcmp(text, "126#1", (size_t)kept) == 0);
        CHECK(cap == 0 || text[kept] == '\0');
        const int64_t written = cap == 0 ? 0 : kept + 1;
        check_untouched(__FILE__, __LINE__, text + written, sizeof text - (size_t)written);
        CHECK_OK(nurbs_list_note(list, 0, NULL, NULL, NULL, text, cap, &length));
        CHECK(length > 7);
        CHECK(cap == 0 || text[cap - 1] == '\0');
    }
    CHECK_OK(nurbs_list_name(list, 0, NULL, 0, &length));
    CHECK_INT(length, 5);
    nurbs_list_destroy(list);
}

static void bad_options(void) {
    const IgesText file = small_file();
    nurbs_list *list;
    nurbs_read_options options = defaults();
    static const double units[] = {-1, NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 4; ++i) {
        options.unit = units[i];
        NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_OPTIONS, "unit");
    }
    options = defaults();
    options.max_bytes = -1;
    NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_OPTIONS, "max_bytes|-1");
    options = defaults();
    options.struct_size = 0;
    NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_OPTIONS, "struct_size|0");
    options.struct_size = -8;
    NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_OPTIONS, "struct_size|-8");
    options = defaults();
    options.kinds = 0x8;
    NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_OPTIONS, "kinds = 0x8");
    options.kinds = NURBS_READ_FACES;
    options.reserved = 1;
    NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_OPTIONS, "reserved = 1");
    options.reserved = 0;
    int64_t count = -1;
    list = read_small(&options);
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 0);
    nurbs_list_destroy(list);
    options = defaults();
    options.max_bytes = file.size - 1;
    NO_LIST(nurbs_read(file.bytes, file.size, &options, &list), NURBS_ERROR_TOO_LARGE, "");
    options.max_bytes = file.size;
    nurbs_list_destroy(read_small(&options));
}

static void bad_bytes(void) {
    static const char binary[200] = {0};
    IgesText file = small_file();
    nurbs_list *list;
    NO_LIST(nurbs_read(NULL, 10, NULL, &list), NURBS_ERROR_NULL, "bytes");
    CHECK_FAILS(nurbs_read(file.bytes, file.size, NULL, NULL), NURBS_ERROR_NULL, "out");
    NO_LIST(nurbs_read(file.bytes, -1, NULL, &list), NURBS_ERROR_COUNT, "size|-1");
    NO_LIST(nurbs_read(file.bytes, INT64_MIN, NULL, &list), NURBS_ERROR_COUNT, "size");
    NO_LIST(nurbs_read(file.bytes, INT64_MAX, NULL, &list), NURBS_ERROR_TOO_LARGE, "");
    NO_LIST(nurbs_read(NULL, 0, NULL, &list), NURBS_ERROR_FORMAT, "the file is empty");
    NO_LIST(nurbs_read(file.bytes, 0, NULL, &list), NURBS_ERROR_FORMAT, "");
    NO_LIST(nurbs_read(binary, 200, NULL, &list), NURBS_ERROR_FORMAT, "");
    NO_LIST(nurbs_read("hello, world\n", 13, NULL, &list), NURBS_ERROR_FORMAT, "");
    NO_LIST(nurbs_read(file.bytes, 81 * 5, NULL, &list), NURBS_ERROR_TRUNCATED, "");
}

static void bad_list_arguments(void) {
    static const int64_t indices[] = {-1, 2, INT64_MAX, INT64_MIN};
    char text[16];
    int64_t count = -7;
    double metres = -7;
    nurbs *g;
    nurbs_list *list = read_small(NULL);
    FILL(text);
    CHECK_FAILS(nurbs_list_count(NULL, &count), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_count(list, NULL), NURBS_ERROR_NULL, "count");
    CHECK_FAILS(nurbs_list_note_count(NULL, &count), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_note_count(list, NULL), NURBS_ERROR_NULL, "count");
    CHECK_FAILS(nurbs_list_unit(NULL, &metres), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_unit(list, NULL), NURBS_ERROR_NULL, "metres");
    CHECK_NO_HANDLE(g, nurbs_list_get(NULL, 0, &g), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_get(list, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_list_name(NULL, 0, text, 16, &count), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_name(list, 0, NULL, 16, &count), NURBS_ERROR_NULL, "buf");
    CHECK_FAILS(nurbs_list_name(list, 0, text, -1, &count), NURBS_ERROR_COUNT, "cap|-1");
    CHECK_FAILS(nurbs_list_note(NULL, 0, NULL, NULL, NULL, text, 16, &count), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_note(list, 0, NULL, NULL, NULL, NULL, 16, &count), NURBS_ERROR_NULL, "buf");
    CHECK_FAILS(nurbs_list_note(list, 0, NULL, NULL, NULL, text, -1, &count), NURBS_ERROR_COUNT, "cap|-1");
    for (int i = 0; i < 4; ++i) {
        int32_t type = -7;
        CHECK_NO_HANDLE(g, nurbs_list_get(list, indices[i], &g), NURBS_ERROR_INDEX, "index|0 to 1");
        CHECK_FAILS(nurbs_list_name(list, indices[i], text, 16, &count), NURBS_ERROR_INDEX, "index|0 to 1");
        CHECK_FAILS(nurbs_list_note(list, indices[i], &type, NULL, NULL, text, 16, &count), NURBS_ERROR_INDEX,
                    "index|0 to 0");
        CHECK_INT(type, -7);
    }
    CHECK_UNTOUCHED(text);
    CHECK_INT(count, -7);
    CHECK_DOUBLE(metres, -7);
    nurbs_list_destroy(list);
    nurbs_list_destroy(NULL);
}

/* A program built with a later header hands over a longer struct: cleared by init, refused where it is
 * used. */
static void longer_options(void) {
    union {
        nurbs_read_options options;
        unsigned char bytes[64];
    } wide;
    const IgesText text = small_file();
    nurbs_list *list = NULL;
    size_t i;
    memset(&wide, 0xab, sizeof wide);
    CHECK_OK(nurbs_read_options_init(&wide.options, (int64_t)sizeof wide));
    CHECK_INT(wide.options.struct_size, sizeof wide);
    for (i = sizeof wide.options; i < sizeof wide; ++i) {
        CHECK_INT(wide.bytes[i], 0);
    }
    CHECK_OK(nurbs_read(text.bytes, text.size, &wide.options, &list));
    nurbs_list_destroy(list);
    wide.bytes[63] = 1;
    NO_LIST(nurbs_read(text.bytes, text.size, &wide.options, &list), NURBS_ERROR_OPTIONS, "beyond byte 40");
    wide.options.struct_size = 4097;
    NO_LIST(nurbs_read(text.bytes, text.size, &wide.options, &list), NURBS_ERROR_OPTIONS, "struct_size|4097");
    wide.options.struct_size = INT64_MAX;
    NO_LIST(nurbs_read(text.bytes, text.size, &wide.options, &list), NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(nurbs_read_options_init(&wide.options, INT64_MAX), NURBS_ERROR_OPTIONS, "struct_size");
    wide.options = defaults();
    wide.options.max_bytes = 0;
    CHECK_OK(nurbs_read(text.bytes, text.size, &wide.options, &list));
    nurbs_list_destroy(list);
}

static void files(void) {
    const IgesText text = small_file();
    nurbs_read_options options = defaults();
    const char *path = "read_test.igs";
    int64_t count = 0;
    nurbs_list *list = NULL;
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(text.bytes, 1, (size_t)text.size, file) != (size_t)text.size ||
        fclose(file) != 0) {
        check_report(__FILE__, __LINE__, "the test file cannot be written\n");
        return;
    }
    CHECK_OK(nurbs_read_file(path, NULL, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 2);
    nurbs_list_destroy(list);
    options.max_bytes = text.size - 1;
    NO_LIST(nurbs_read_file(path, &options, &list), NURBS_ERROR_TOO_LARGE, "");
    options.max_bytes = -1;
    NO_LIST(nurbs_read_file(path, &options, &list), NURBS_ERROR_OPTIONS, "max_bytes");
    CHECK_FAILS(nurbs_read_file(path, NULL, NULL), NURBS_ERROR_NULL, "out");
    (void)remove(path);
    NO_LIST(nurbs_read_file(path, NULL, &list), NURBS_ERROR_FILE, "read_test.igs");
    NO_LIST(nurbs_read_file(NULL, NULL, &list), NURBS_ERROR_NULL, "path");
    NO_LIST(nurbs_read_file("", NULL, &list), NURBS_ERROR_FILE, "");
    NO_LIST(nurbs_read_file(".", NULL, &list), NURBS_ERROR_FILE, "");
}

int main(void) {
    default_options();
    longer_options();
    contents();
    units();
    truncated_texts();
    bad_options();
    bad_bytes();
    bad_list_arguments();
    files();
    return check_summary("read");
}
