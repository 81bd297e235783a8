/* SPDX-License-Identifier: MIT */
// What nurbs_read() takes for STEP and IGES files, and nurbs_read_model() for IGES files, that are made to take much: at most 64 times the size of the file and 1 MB more,
// on a stack of 128 KB. Counts what operator new gives, which is what the library allocates with.
#include "check.h"
#include "support/iges_builder.h"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>
#include <pthread.h>
#include <string>
#include <utility>
#include <vector>

// Sanitizers have an allocator, and frames, of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED 1
#endif
#endif

#ifndef SANITIZED

namespace {
std::atomic<int64_t> held{0}, peak{0};

void *taken(size_t bytes) {
    void *place = std::malloc(bytes);
    if (place == nullptr) {
        throw std::bad_alloc();
    }
    const int64_t now = held += static_cast<int64_t>(malloc_usable_size(place));
    peak = now > peak ? now : peak.load();
    return place;
}

void given(void *place) noexcept {
    held -= static_cast<int64_t>(malloc_usable_size(place));
    std::free(place);
}
} // namespace

void *operator new(size_t bytes) {
    return taken(bytes);
}
void operator delete(void *place) noexcept {
    given(place);
}
void operator delete(void *place, size_t) noexcept {
    given(place);
}

namespace {

std::string name(int64_t number) {
    return "#" + std::to_string(number);
}

std::string times(const std::string &text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

// A data section, whose instances from #20 on come `many` times; or an IGES file.
struct File {
    const char *what;
    std::string data;
};

constexpr int many = 5000;
const std::string basis =
    "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=AXIS2_PLACEMENT_3D('',#1,$,$);#3=HYPERBOLA('',#2,1.,1.);"
    "#4=CARTESIAN_POINT('',(1.,1.E300,0.));#5=CARTESIAN_POINT('',(1.,-1.E300,0.));#6=VERTEX_POINT('',#4);"
    "#7=VERTEX_POINT('',#5);#8=DIRECTION('',(0.,0.,1.));#9=VECTOR('',#8,1.);"
    "#10=SURFACE_OF_LINEAR_EXTRUSION('',#3,#9);#11=POLY_LOOP('',(#4,#5,#1));#12=FACE_BOUND('',#11,.T.);"
    "#13=CYLINDRICAL_SURFACE('',#2,1.);#14=SPHERICAL_SURFACE('',#2,1.);#15=POLY_LOOP('',(#1,#1));"
    "#16=FACE_BOUND('',#15,.T.);";

std::string instances(const std::string &entity) {
    std::string data = basis;
    for (int i = 0; i < many; ++i) {
        data += name(20 + i) + "=" + entity + ";";
    }
    return data;
}

// Each composite curve has the one before it eight times.
std::string multiplied() {
    std::string data = basis + "#18=POLYLINE('',(#1,#1));";
    for (int64_t i = 20; i < 60; i += 2) {
        data += name(i) + "=COMPOSITE_CURVE_SEGMENT(.C.,.T.," + name(i == 20 ? 18 : i - 1) + ");" +
                name(i + 1) + "=COMPOSITE_CURVE('',(" + name(i) + times("," + name(i), 7) + "),.F.);";
    }
    return data + instances("A()").substr(basis.size());
}

const File files[] = {
    {"edges on long hyperbolas", instances("EDGE_CURVE('',#6,#7,#3,.T.)")},
    {"faces on extruded ones", instances("ADVANCED_FACE('',(#12),#10,.T.)")},
    {"an offset of a large ellipse",
     basis + "#20=ELLIPSE('',#2,3000.,2000.);#21=OFFSET_CURVE_3D('',#20,500.,.F.,#8);"},
    {"offsets of one ellipse", "#18=ELLIPSE('',#2,3.,2.);" + instances("OFFSET_CURVE_3D('',#18,.5,.F.,#8)")},
    {"faces on cylinders", instances("ADVANCED_FACE('',(#16),#13,.T.)")},
    {"faces on one sphere", instances("ADVANCED_FACE('',(),#14,.T.)")},
    {"short instances that are wrong", instances("LINE()")},
    {"contexts that are wrong", instances("GLOBAL_UNIT_ASSIGNED_CONTEXT()")},
    {"a polyline", basis + "#20=POLYLINE('',(#1" + times(",#1", 20 * many) + "));"},
    {"a surface", basis + "#20=BEZIER_SURFACE('',1,1,((#1" + times(",#1", 10 * many) + "),(#1" +
                      times(",#1", 10 * many) + ")),.U.,.F.,.F.,.F.);"},
    {"multiplied curves", multiplied()},
    {"deep parentheses", basis + "#20=CIRCLE(" + times("(", 100 * many) + times(")", 100 * many) + ");"},
};

void read_list(const std::string &text) {
    nurbs_list *list = nullptr;
    CHECK_INT(nurbs_read(text.data(), static_cast<int64_t>(text.size()), nullptr, &list), NURBS_OK);
    nurbs_list_destroy(list);
}

void read_model(const std::string &text) {
    nurbs_model *model = nullptr;
    CHECK_INT(nurbs_read_model(text.data(), static_cast<int64_t>(text.size()), nullptr, &model), NURBS_OK);
    nurbs_model_destroy(model);
}

void check_memory(const char *what, const std::string &text, void (*read)(const std::string &)) {
    const int64_t before = held;
    peak = before;
    read(text);
    const auto size = static_cast<int64_t>(text.size());
    const int64_t limit = 64 * size + (1 << 20), most = peak - before;
    if (most > limit) {
        std::fprintf(stderr, "%s: %lld bytes for %lld\n", what, static_cast<long long>(most),
                     static_cast<long long>(size));
    }
    CHECK(most > 0); // what is counted is what the library takes
    CHECK(most <= limit);
    CHECK_INT(held.load(), before);
}

// A whole IGES file: parts, and then an entity `times` times.
std::string iges(const std::vector<std::pair<int, std::string>> &parts, int type, const std::string &data,
                 int times, int64_t form = 0) {
    iges_test::IgesBuilder builder;
    for (const auto &[part, content] : parts) {
        builder.add(part, content, {.form = part == 106 ? 11 : 0});
    }
    for (int i = 0; i < times; ++i) {
        builder.add(type, data, {.form = form});
    }
    return builder.text();
}

// A polygon, and parametric splines, with that many corners or pieces.
std::string polygon(int corners) {
    return "1," + std::to_string(corners) + ",0" + times(",1,2", corners);
}
std::string spline_pieces(int pieces) {
    std::string data = "3,2,3," + std::to_string(pieces);
    for (int i = 0; i <= pieces; ++i) {
        data += "," + std::to_string(i);
    }
    return data + times(",1,2,1,3,0,0,2,5,1,1,1,2", pieces);
}
std::string spline_patches(int pieces) {
    std::string data = "3,1," + std::to_string(pieces) + ",1";
    for (int i = 0; i <= pieces; ++i) {
        data += "," + std::to_string(i);
    }
    return data + ",0,1" + times(times(",1,2,3", 32), pieces);
}

// Each composite curve has the next one eight times.
std::string multiplied_composites() {
    iges_test::IgesBuilder builder;
    for (int i = 0; i < 20; ++i) {
        builder.add(102, "8" + times("," + std::to_string(builder.next() + 2), 8));
    }
    builder.add(110, "0,0,0,0,0,0");
    return builder.text();
}

const std::pair<int, std::string> axis{110, "0,0,0,0,0,1"}, arc{100, "0,0,0,1,0,0,1"};

const File iges_files[] = {
    {"lines", iges({}, 110, "0,0,0,1,1,1", many)},
    {"arcs", iges({}, 100, "0,0,0,1,0,1,0", many)},
    {"hyperbolas", iges({}, 104, "1,0,-1,0,0,-1,0,1.E150,1.E150,1.E150,-1.E150", many, 2)},
    {"spheres", iges({{116, "0,0,0"}}, 196, "1,1.", many)},
    {"a polygon revolved", iges({axis, {106, polygon(4 * many)}}, 120, "1,3,0,6", 1)},
    {"a polygon revolved often", iges({axis, {106, polygon(100)}}, 120, "1,3,0,6", many)},
    {"a polygon moved often", iges({{106, polygon(100)}}, 122, "1,0,0,1", many)},
    {"rules between polygons",
     iges({{106, polygon(4 * many)}, {106, polygon(4 * many - 1)}}, 118, "1,3,0", 4, 1)},
    {"rules between arcs and polygons", iges({arc, {106, polygon(4 * many)}}, 118, "1,3,0", 4, 1)},
    {"composites of one line", iges({axis}, 102, "9" + times(",1", 9), many)},
    {"parametric splines", iges({}, 112, spline_pieces(4 * many), 1)},
    {"parametric spline surfaces", iges({}, 114, spline_patches(many), 1)},
    {"multiplied composites", multiplied_composites()},
    {"entities that are wrong", iges({}, 120, "", many)},
};

// --- Models of IGES files.

struct IgesModel {
    const char *what;
    iges_test::IgesBuilder file;
};

constexpr const char *patch =
    "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,4.,0.,0.,0.,4.,0.,"
    "4.,4.,0.,0.,1.,0.,1.";

// A patch (1), an axis (3) and a line beside it (5), the cylinder of them (7), a closed polygon (9) on the patch (11), the lists of
// a vertex (13) and of an edge (15) that is a circle (17), a loop of it many times (19), and the group of all (21).
iges_test::IgesBuilder iges_basis() {
    iges_test::IgesBuilder file;
    file.add(128, patch);
    file.add(110, "0.,0.,0.,0.,0.,1.");
    file.add(110, "1.,0.,0.,1.,0.,1.");
    file.add(120, "3,5,0.,6.283185307179586");
    file.add(126,
             "4,1,0,1,1,0,0.,0.,1.,2.,3.,4.,4.,1.,1.,1.,1.,1.,1.,1.,0.,3.,1.,0.,3.,2.,0.,1.,2.,0.,1.,1.,0.,"
             "0.,4.,0.,0.,1.");
    file.add(142, "0,1,0,9,2");
    file.add(502, "1,1.,0.,0.");
    file.add(504, "1,17,13,1,13,1");
    file.add(100, "0.,0.,0.,1.,0.,1.,0.");
    file.add(508, std::to_string(many) + times(",0,15,1,1,0", many));
    file.add(402, "10,1,3,5,7,9,11,13,15,17,19", {.form = 7});
    return file;
}

IgesModel iges_case(const char *what, int type, const std::string &data,
                    const iges_test::Fields &fields = {}) {
    IgesModel result{what, iges_basis()};
    for (int i = 0; i < many; ++i) {
        result.file.add(type, data, fields);
    }
    return result;
}

// Each subfigure has the one before it twice.
IgesModel iges_doubled() {
    IgesModel result{"subfigures that double", iges_basis()};
    std::string last = std::to_string(result.file.add(308, "0,1Hx,1,1"));
    for (int i = 0; i < many / 4; ++i) {
        const int64_t a = result.file.add(408, last + ",1.,0.,0."),
                      b = result.file.add(408, last + ",0.,1.,0.");
        last = std::to_string(result.file.add(308, "0,1Hx,2," + std::to_string(a) + "," + std::to_string(b)));
    }
    return result;
}

std::vector<IgesModel> iges_models() {
    return {iges_case("trimmed surfaces that share all", 144, "1,1,0,11"),
            iges_case("cylinders that share a spline", 144, "7,0,0,0"),
            iges_case("cylinders with a hole that is none", 144, "7,0,1,0,11"),
            iges_case("faces that share a long loop", 510, "1,1,1,19"),
            iges_case("short entities that are wrong", 144, ""),
            iges_case("loops of nothing", 508, "0"),
            iges_case("subfigures of one group", 308, "0,,1,21"),
            iges_case("instances", 408, "1,0.,0.,0."),
            iges_case("instances of nothing", 408, "9999,0.,0.,0."),
            iges_case("groups", 402, "3,21,1,3", {.form = 1}),
            iges_case("colours", 144, "1,0,0,0", {.colour = -1}),
            iges_doubled()};
}

void *read_all(void *) {
    for (const File &file : files) {
        check_memory(file.what, "ISO-10303-21;HEADER;ENDSEC;DATA;" + file.data + "ENDSEC;END-ISO-10303-21;",
                     read_list);
    }
    for (const File &file : iges_files) {
        check_memory(file.what, file.data, read_list);
    }
    for (const IgesModel &file : iges_models()) {
        check_memory(file.what, file.file.text(), read_model);
    }
    return nullptr;
}

void read_on_a_small_stack() {
    pthread_attr_t attributes;
    pthread_t thread;
    CHECK(pthread_attr_init(&attributes) == 0 && pthread_attr_setstacksize(&attributes, 128 << 10) == 0);
    CHECK(pthread_create(&thread, &attributes, read_all, nullptr) == 0 && pthread_join(thread, nullptr) == 0);
    CHECK(pthread_attr_destroy(&attributes) == 0);
}

} // namespace
#endif

int main() {
#ifndef SANITIZED
    read_on_a_small_stack();
    return check_summary("read_memory");
#else
    std::puts("skipped: a sanitizer has an allocator of its own");
    return 77;
#endif
}
