/* SPDX-License-Identifier: MIT */
/* Lists of given splines, and lists as bytes: names, notes and unit, each spline once. */
#include "iges_text.h"
#include "shapes.h"
#include "signed_bytes.h"

#include <math.h>

#define NO_LIST(out, call, status, words)                                                                    \
    do {                                                                                                     \
        (out) = (nurbs_list *)(void *)check_before;                                                          \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, (out) == NULL, #out " == NULL");                                      \
    } while (0)

/* An arch, a loop and the arch again. */
static nurbs_list *three(const char *const *names, double metres) {
    nurbs *a = make(arch()), *b = make(loop());
    const nurbs *const splines[] = {a, b, a};
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_list_create(3, splines, names, metres, &list));
    nurbs_destroy(a);
    nurbs_destroy(b);
    return list;
}

static const char *const names_of_three[] = {"first", "", "f\xfcnf"};

static nurbs_list *from_file(void) {
    const IgesText file = small_file();
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_read(file.bytes, file.size, NULL, &list));
    return list;
}

static Bytes bytes_of(const nurbs_list *list) {
    Bytes made;
    memset(&made, 0, sizeof made);
    CHECK_OK(nurbs_list_to_bytes(list, most_bytes, made.data, &made.size));
    CHECK(made.size >= 2 * header_bytes && made.size <= most_bytes);
    return made;
}

static void check_name(int line, const nurbs_list *list, int64_t index, const char *expected) {
    char text[64] = "?";
    int64_t length = -1;
    CHECK_OK(nurbs_list_name(list, index, text, sizeof text, &length));
    check_true(__FILE__, line, strcmp(text, expected) == 0 && length == (int64_t)strlen(expected), expected);
}

static void check_spline(int line, const nurbs_list *list, int64_t index, SplineArgs shape) {
    nurbs *found = NULL, *expected = make(shape);
    Bytes x, y;
    memset(&x, 0, sizeof x);
    memset(&y, 0, sizeof y);
    CHECK_OK(nurbs_list_get(list, index, &found));
    CHECK_OK(nurbs_to_bytes(found, most_bytes, x.data, &x.size));
    CHECK_OK(nurbs_to_bytes(expected, most_bytes, y.data, &y.size));
    check_bits(__FILE__, line, x.data, y.data, sizeof x.data);
    nurbs_destroy(found);
    nurbs_destroy(expected);
}

static void check_three(const nurbs_list *list, const char *const *names, double metres) {
    int64_t count = -1;
    double unit = -1;
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 3);
    CHECK_OK(nurbs_list_unit(list, &unit));
    CHECK_DOUBLE(unit, metres);
    CHECK_OK(nurbs_list_note_count(list, &count));
    CHECK_INT(count, 0);
    check_spline(__LINE__, list, 0, arch());
    check_spline(__LINE__, list, 1, loop());
    check_spline(__LINE__, list, 2, arch());
    for (int i = 0; i < 3; ++i) {
        check_name(__LINE__, list, i, names[i]);
    }
}

static void made_of_splines(void) {
    static const char *const numbers[] = {"0", "1", "2"};
    int64_t count = -1;
    nurbs_list *named = three(names_of_three, 0.0254), *numbered = three(NULL, 0), *none = NULL;
    check_three(named, names_of_three, 0.0254);
    check_three(numbered, numbers, 0);
    CHECK_OK(nurbs_list_create(0, NULL, NULL, 1, &none));
    CHECK_OK(nurbs_list_count(none, &count));
    CHECK_INT(count, 0);
    nurbs_list_destroy(named);
    nurbs_list_destroy(numbered);
    nurbs_list_destroy(none);
}

static void refused_lists(void) {
    nurbs *a = make(arch());
    const nurbs *const splines[] = {a, a}, *const hole[] = {a, NULL};
    const char *const names[] = {"a", NULL};
    nurbs_list *list;
    NO_LIST(list, nurbs_list_create(-1, splines, NULL, 1, &list), NURBS_ERROR_COUNT, "count = -1");
    NO_LIST(list, nurbs_list_create(INT64_MAX, splines, NULL, 1, &list), NURBS_ERROR_OVERFLOW, "splines");
    NO_LIST(list, nurbs_list_create(2, NULL, NULL, 1, &list), NURBS_ERROR_NULL, "splines");
    NO_LIST(list, nurbs_list_create(2, hole, NULL, -1, &list), NURBS_ERROR_NULL, "splines[1]");
    NO_LIST(list, nurbs_list_create(2, splines, names, -1, &list), NURBS_ERROR_NULL, "names[1]");
    NO_LIST(list, nurbs_list_create(2, splines, NULL, -1, &list), NURBS_ERROR_FACTOR, "metres = -1");
    NO_LIST(list, nurbs_list_create(2, splines, NULL, NAN, &list), NURBS_ERROR_FACTOR, "metres = nan");
    NO_LIST(list, nurbs_list_create(2, splines, NULL, INFINITY, &list), NURBS_ERROR_FACTOR, "metres = inf");
    CHECK_FAILS(nurbs_list_create(2, splines, NULL, 1, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(a);
}

/* Bytes from bytes are the same, for lists that are kept in any way. */
static void round_trip(int line, nurbs_list *list) {
    const Bytes made = bytes_of(list);
    nurbs_list *again = NULL;
    CHECK_OK(nurbs_list_from_bytes(made.data, made.size, &again));
    const Bytes same = bytes_of(again);
    check_bits(__FILE__, line, made.data, same.data, sizeof made.data);
    nurbs_list_destroy(again);
    nurbs_list_destroy(list);
}

static void bytes_and_back(void) {
    nurbs_list *list = three(names_of_three, 0.0254), *again = NULL;
    Bytes made = bytes_of(list), signed_again;
    CHECK_OK(nurbs_list_from_bytes(made.data, made.size, &again));
    check_three(again, names_of_three, 0.0254);
    signed_again = made;
    sign(signed_again.data, made.size);
    CHECK_BITS(made.data, signed_again.data, (size_t)made.size);
    nurbs_list_destroy(again);
    nurbs_list_destroy(list);
    round_trip(__LINE__, three(NULL, 0));
    round_trip(__LINE__, from_file());
    nurbs *g = make(cube()), *c = make(circle());
    CHECK_OK(nurbs_boundaries(g, &list));
    round_trip(__LINE__, list);
    CHECK_OK(nurbs_decompose(c, &list)); /* parts that are made when they are taken */
    round_trip(__LINE__, list);
    CHECK_OK(nurbs_list_create(0, NULL, NULL, 0, &list));
    round_trip(__LINE__, list);
    nurbs_destroy(g);
    nurbs_destroy(c);
}

/* Notes of a file, with all that they say. */
static void notes_survive(void) {
    nurbs_list *list = from_file(), *again = NULL;
    const Bytes made = bytes_of(list);
    int32_t type[2] = {-1, -2};
    int64_t count = -1, row[2] = {-1, -2};
    nurbs_status reason[2] = {-1, -2};
    double unit[2] = {-1, -2};
    char text[2][200] = {"?", "!"};
    CHECK_OK(nurbs_list_from_bytes(made.data, made.size, &again));
    const nurbs_list *both[2] = {list, again};
    for (int i = 0; i < 2; ++i) {
        CHECK_OK(nurbs_list_note_count(both[i], &count));
        CHECK_INT(count, 1);
        CHECK_OK(nurbs_list_note(both[i], 0, &type[i], &row[i], &reason[i], text[i], sizeof text[i], NULL));
        CHECK_OK(nurbs_list_unit(both[i], &unit[i]));
    }
    CHECK_INT(type[1], type[0]);
    CHECK_INT(type[1], 116);
    CHECK_INT(row[1], row[0]);
    CHECK_INT(reason[1], reason[0]);
    CHECK(strcmp(text[0], text[1]) == 0 && strlen(text[0]) > 3);
    CHECK_DOUBLE(unit[1], unit[0]);
    nurbs_list_destroy(list);
    nurbs_list_destroy(again);
}

/* The layout that nurbs.h publishes: a spline that occurs twice is stored once, and can be cut out. */
static void layout(void) {
    enum { indices = 128, ends = 192, texts = 256, places = 320, first = 384 };
    nurbs_list *list = three(names_of_three, 0.0254);
    const Bytes made = bytes_of(list);
    CHECK_BITS(made.data, "\x89NUR\r\n\x1a\n\x01\0\0\0\x02\0\0\0", 16);
    CHECK_INT(number_from(made.data + 64, 8), 3);
    CHECK_INT(number_from(made.data + 72, 8), 2);
    CHECK_INT(number_from(made.data + 80, 8), 0);
    CHECK_INT(number_from(made.data + 88, 8), 9);
    CHECK(number_from(made.data + 96, 8) == bits_of(0.0254));
    CHECK_INT(number_from(made.data + indices, 8), 0);
    CHECK_INT(number_from(made.data + indices + 8, 8), 1);
    CHECK_INT(number_from(made.data + indices + 16, 8), 0);
    CHECK_INT(number_from(made.data + ends, 8), 5);
    CHECK_INT(number_from(made.data + ends + 8, 8), 5);
    CHECK_INT(number_from(made.data + ends + 16, 8), 9);
    CHECK_BITS(made.data + texts, "firstf\xfcnf", 9);
    CHECK_INT(number_from(made.data + places, 8), first);
    const uint64_t second = number_from(made.data + places + 8, 8);
    CHECK_INT(second % 64, 0);
    nurbs *cut = NULL;
    CHECK_OK(nurbs_from_bytes(made.data + second, (int64_t)number_from(made.data + second + 16, 8), &cut));
    CHECK_POINTS(cut, loop().points);
    nurbs_destroy(cut);
    nurbs_list_destroy(list);
}

static void equal_splines_are_stored_once(void) {
    nurbs *a = make(arch()), *b = make(arch()), *c = make(loop());
    const nurbs *const splines[] = {a, c, b};
    nurbs_list *list = NULL, *same = three(NULL, 0);
    CHECK_OK(nurbs_list_create(3, splines, NULL, 0, &list));
    const Bytes made = bytes_of(list), expected = bytes_of(same);
    CHECK_BITS(made.data, expected.data, sizeof made.data);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
    nurbs_list_destroy(list);
    nurbs_list_destroy(same);
}

static void buffers(void) {
    nurbs_list *list = three(NULL, 1);
    Bytes made = bytes_of(list), again;
    int64_t size = -7;
    CHECK_OK(nurbs_list_to_bytes(list, 0, NULL, &size));
    CHECK_INT(size, made.size);
    FILL(again.data);
    size = -7;
    CHECK_FAILS(nurbs_list_to_bytes(NULL, 0, NULL, &size), NURBS_ERROR_NULL, "list");
    CHECK_FAILS(nurbs_list_to_bytes(list, -1, again.data, &size), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_list_to_bytes(list, made.size - 1, again.data, &size), NURBS_ERROR_SIZE, "cap");
    CHECK_FAILS(nurbs_list_to_bytes(list, most_bytes, again.data, (int64_t *)(void *)again.data),
                NURBS_ERROR_OVERLAP, "bytes");
    CHECK_INT(size, -7);
    CHECK_UNTOUCHED(again.data);
    nurbs_list_destroy(list);
}

static void refused_bytes(void) {
    nurbs_list *whole = from_file(), *list;
    nurbs *g;
    Bytes made = bytes_of(whole);
    for (int64_t size = 1; size < made.size; ++size) {
        NO_LIST(list, nurbs_list_from_bytes(made.data, size, &list), NURBS_ERROR_TRUNCATED, "size = ");
    }
    for (int64_t i = 0; i < 8 * made.size; ++i) {
        const unsigned char bit = (unsigned char)(1 << i % 8);
        made.data[i / 8] ^= bit;
        list = NULL;
        const nurbs_status status = nurbs_list_from_bytes(made.data, made.size, &list);
        CHECK(list == NULL && status != NURBS_OK && (i < 8 * 24 || status == NURBS_ERROR_CHECKSUM));
        made.data[i / 8] ^= bit;
    }
    NO_LIST(list, nurbs_list_from_bytes(NULL, 64, &list), NURBS_ERROR_NULL, "bytes");
    NO_LIST(list, nurbs_list_from_bytes(made.data, -1, &list), NURBS_ERROR_COUNT, "size = -1");
    CHECK_FAILS(nurbs_list_from_bytes(made.data, made.size, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size, &g), NURBS_ERROR_FORMAT,
                    "hold a list, expected a spline");
    nurbs_list_destroy(whole);
}

static void check_bad_number(int line, int place, uint64_t value, nurbs_status status, const char *words) {
    nurbs_list *whole = three(names_of_three, 1), *list = (nurbs_list *)(void *)check_before;
    Bytes made = bytes_of(whole);
    number_into(made.data + place, value, 8);
    sign(made.data, made.size);
    check_forget();
    check_refusal(__FILE__, line, nurbs_list_from_bytes(made.data, made.size, &list), status, words);
    check_true(__FILE__, line, list == NULL, "list == NULL");
    nurbs_list_destroy(whole);
}
#define BAD_NUMBER(place, value, status, words)                                                              \
    check_bad_number(__LINE__, place, (uint64_t)(value), NURBS_ERROR_##status, words)

/* Numbers of good bytes replaced by some that no list has. */
static void numbers_of_no_list(void) {
    enum { indices = 128, ends = 192, places = 320, first = 384 };
    BAD_NUMBER(64, -1, SYNTAX, "number of places = -1");
    BAD_NUMBER(64, INT64_MAX, SYNTAX, "number of places = 9223372036854775807");
    BAD_NUMBER(64, 2, SYNTAX, "texts|5|9");
    BAD_NUMBER(64, 200, TRUNCATED, "200 numbers at byte 128");
    BAD_NUMBER(72, -1, SYNTAX, "number of splines = -1");
    BAD_NUMBER(72, 1, SYNTAX, "a spline 1 of a list, expected 0 to 0");
    BAD_NUMBER(72, 3, SYNTAX, "a record at byte 0");
    BAD_NUMBER(80, -1, SYNTAX, "number of notes = -1");
    BAD_NUMBER(80, 200, TRUNCATED, "600 numbers at byte 192");
    BAD_NUMBER(88, -1, SYNTAX, "number of bytes of text = -1");
    BAD_NUMBER(88, 8, SYNTAX, "ends at byte 9, expected 5 to 8");
    BAD_NUMBER(88, 10, SYNTAX, "texts|byte 9, expected 10");
    BAD_NUMBER(96, bits_of(-1), FACTOR, "metres = -1");
    BAD_NUMBER(96, bits_of(NAN), FACTOR, "metres = nan");
    BAD_NUMBER(indices + 8, 2, SYNTAX, "a spline 2 of a list, expected 0 to 1");
    BAD_NUMBER(indices + 8, -1, SYNTAX, "a spline -1");
    BAD_NUMBER(ends + 8, 4, SYNTAX, "ends at byte 4, expected 5 to 9");
    BAD_NUMBER(ends + 16, 10, SYNTAX, "ends at byte 10, expected 5 to 9");
    BAD_NUMBER(places, 0, SYNTAX, "a record at byte 0, expected at byte 384");
    BAD_NUMBER(places + 8, first, SYNTAX, "a record at byte 384");
    BAD_NUMBER(first + 16, 63, TRUNCATED, "the record at byte 384 has 63 bytes");
    BAD_NUMBER(first + 16, 1 << 20, TRUNCATED, "the record at byte 384 has 1048576 bytes");
    BAD_NUMBER(first + 192, bits_of(1), CHECKSUM, "spline 0: ");
    BAD_NUMBER(first, 1, FORMAT, "spline 0: ");
}

/* Notes of a file, of which one has a type that no note has. */
static void numbers_of_no_note(void) {
    enum { notes = 192 };
    nurbs_list *whole = from_file(), *list;
    Bytes made = bytes_of(whole);
    CHECK_INT(number_from(made.data + notes, 8), 116);
    number_into(made.data + notes, UINT64_C(1) << 32, 8);
    sign(made.data, made.size);
    NO_LIST(list, nurbs_list_from_bytes(made.data, made.size, &list), NURBS_ERROR_SYNTAX,
            "entity type = 4294967296");
    number_into(made.data + notes, 116, 8);
    number_into(made.data + notes + 16, UINT64_C(1) << 40, 8);
    sign(made.data, made.size);
    NO_LIST(list, nurbs_list_from_bytes(made.data, made.size, &list), NURBS_ERROR_SYNTAX,
            "reason = 1099511627776");
    nurbs_list_destroy(whole);
}

/* Lists of one machine are those of another: these bytes are written everywhere. */
static void same_on_every_machine(void) {
    nurbs_list *given = three(names_of_three, 0.0254), *read = from_file();
    const Bytes made = bytes_of(given), of_file = bytes_of(read);
    CHECK(number_from(made.data + 24, 8) == UINT64_C(0xc1e8a9db06bf0f61));
    CHECK(number_from(of_file.data + 24, 8) == UINT64_C(0xb4eacbb37cb810ff));
    nurbs_list_destroy(given);
    nurbs_list_destroy(read);
}

int main(void) {
    made_of_splines();
    refused_lists();
    bytes_and_back();
    notes_survive();
    layout();
    equal_splines_are_stored_once();
    buffers();
    refused_bytes();
    numbers_of_no_list();
    numbers_of_no_note();
    same_on_every_machine();
    return check_summary("list_bytes");
}
