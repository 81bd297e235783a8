// Bytes of handles: those of splines, lists, faces and models that were made come back; any others are refused, or are a handle that
// is used, also where their sizes and checksums are put right, so that what they say is looked at.
#include "fuzz/harness.h"

#include <memory>
#include <string>

using fuzz::Input;

namespace {

using Bytes = std::vector<unsigned char>;

template <class Write, class Handle>
Bytes written(Write &&write, const Handle *handle) {
    int64_t size = 0;
    FUZZ_REQUIRE(write(handle, 0, nullptr, &size) == NURBS_OK);
    Bytes bytes(static_cast<size_t>(size));
    FUZZ_REQUIRE(write(handle, size, bytes.data(), nullptr) == NURBS_OK);
    return bytes;
}

constexpr auto spline_to = [](auto... given) { return nurbs_to_bytes(given...); };
constexpr auto list_to = [](auto... given) { return nurbs_list_to_bytes(given...); };

// What bytes are read as, if they are; it has bytes of its own, which are read as the same.
template <class Handle, class Read, class Write, class Destroy, class Use>
void read(const Bytes &bytes, Read &&read, Write &&write, Destroy &&destroy, Use &&use) {
    Handle *first = reinterpret_cast<Handle *>(fuzz::poison()), *second = nullptr;
    const bool ok = FUZZ_OK(read(bytes.data(), std::ssize(bytes), &first));
    FUZZ_REQUIRE(ok == (first != nullptr));
    if (!ok) {
        return;
    }
    int32_t kind = 0, major = 0, minor = 0;
    FUZZ_REQUIRE(nurbs_bytes_kind(bytes.data(), 64, &kind, &major, &minor) == NURBS_OK);
    FUZZ_REQUIRE(kind == use(first) && major <= 1);
    const Bytes own = written(write, first);
    FUZZ_REQUIRE(read(own.data(), std::ssize(own), &second) == NURBS_OK);
    FUZZ_REQUIRE(written(write, second) == own);
    destroy(first);
    destroy(second);
}

int32_t use_spline(const nurbs *g) {
    int32_t axes = 0, dim = 0;
    FUZZ_REQUIRE(nurbs_axes(g, &axes) == NURBS_OK && nurbs_dimension(g, &dim) == NURBS_OK);
    std::vector<double> params(static_cast<size_t>(axes)), point(static_cast<size_t>(dim));
    for (int32_t k = 0; k < axes; ++k) {
        double domain[2] = {0, 0};
        FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK && domain[0] < domain[1]);
        params[static_cast<size_t>(k)] = domain[0];
    }
    FUZZ_REQUIRE(nurbs_eval(g, 1, params.data(), 0, 0, point.data(), 0, 0, 0) == NURBS_OK);
    return NURBS_BYTES_SPLINE;
}

int32_t use_list(const nurbs_list *list) {
    int64_t count = 0, length = 0;
    double metres = -1;
    FUZZ_REQUIRE(nurbs_list_count(list, &count) == NURBS_OK && nurbs_list_unit(list, &metres) == NURBS_OK);
    FUZZ_REQUIRE(metres >= 0 && std::isfinite(metres));
    for (int64_t i = 0; i < count; ++i) {
        nurbs *g = nullptr;
        FUZZ_REQUIRE(nurbs_list_get(list, i, &g) == NURBS_OK &&
                     nurbs_list_name(list, i, nullptr, 0, &length) == NURBS_OK);
        use_spline(g);
        nurbs_destroy(g);
    }
    FUZZ_REQUIRE(nurbs_list_note_count(list, &count) == NURBS_OK);
    for (int64_t i = 0; i < count; ++i) {
        FUZZ_REQUIRE(nurbs_list_note(list, i, nullptr, nullptr, nullptr, nullptr, 0, &length) == NURBS_OK);
    }
    return NURBS_BYTES_LIST;
}

int32_t use_statistics(const nurbs_statistics *statistics) {
    FUZZ_REQUIRE(nurbs_statistics_size(statistics, nullptr, nullptr, nullptr, nullptr, nullptr) == NURBS_OK);
    return NURBS_BYTES_STATISTICS;
}

constexpr auto face_to = [](auto... given) { return nurbs_face_to_bytes(given...); };
constexpr auto model_to = [](auto... given) { return nurbs_model_to_bytes(given...); };

int32_t use_face(const nurbs_face *face) {
    nurbs *g = nullptr;
    int64_t loops = -1;
    FUZZ_REQUIRE(nurbs_face_surface(face, &g) == NURBS_OK &&
                 nurbs_face_loops(face, 0, nullptr, &loops) == NURBS_OK);
    double u[2] = {0, 0}, v[2] = {0, 0};
    FUZZ_REQUIRE(nurbs_domain(g, 0, u) == NURBS_OK && nurbs_domain(g, 1, v) == NURBS_OK && loops >= 0);
    const double middle[] = {u[0] / 2 + u[1] / 2, v[0] / 2 + v[1] / 2};
    int32_t side = -7;
    FUZZ_REQUIRE(nurbs_face_classify(face, 1, middle, 0, 0, 0, &side) == NURBS_OK && -1 <= side && side <= 1);
    nurbs_destroy(g);
    return NURBS_BYTES_FACE;
}

int32_t use_model(const nurbs_model *model) {
    int64_t uses = -1, faces = -1, edges = -1, length = -1;
    FUZZ_REQUIRE(nurbs_model_counts(model, nullptr, &uses, &faces, &edges, nullptr) == NURBS_OK);
    for (int64_t i = 0; i < faces; ++i) {
        nurbs_face *face = nullptr;
        int32_t shape = -1;
        FUZZ_REQUIRE(nurbs_model_face(model, i, nullptr, &shape, nullptr, nullptr, &face) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_model_face_name(model, i, nullptr, 0, &length) == NURBS_OK);
        use_face(face);
        nurbs_face_destroy(face);
    }
    for (int64_t i = 0; i < edges; ++i) {
        nurbs *g = nullptr;
        FUZZ_REQUIRE(nurbs_model_edge(model, i, nullptr, nullptr, nullptr, &g) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_model_edge_uses(model, i, 0, nullptr, &length) == NURBS_OK);
        use_spline(g);
        nurbs_destroy(g);
    }
    for (int64_t i = 0; i < uses; ++i) {
        FUZZ_REQUIRE(nurbs_model_use(model, i, nullptr, nullptr, nullptr) == NURBS_OK);
    }
    return NURBS_BYTES_MODEL;
}

void read_all(const Bytes &bytes) {
    const auto spline_from = [](auto... given) { return nurbs_from_bytes(given...); };
    const auto face_from = [](auto... given) { return nurbs_face_from_bytes(given...); };
    const auto model_from = [](auto... given) { return nurbs_model_from_bytes(given...); };
    read<nurbs>(bytes, spline_from, spline_to, nurbs_destroy, use_spline);
    read<nurbs_list>(bytes, nurbs_list_from_bytes, list_to, nurbs_list_destroy, use_list);
    read<nurbs_face>(bytes, face_from, face_to, nurbs_face_destroy, use_face);
    read<nurbs_model>(bytes, model_from, model_to, nurbs_model_destroy, use_model);
    read<nurbs_statistics>(bytes, nurbs_statistics_from_bytes, nurbs_statistics_to_bytes,
                           nurbs_statistics_destroy, use_statistics);
}

void put(Bytes &bytes, size_t place, uint64_t value) {
    for (size_t i = 0; i < 8; ++i) {
        bytes[place + i] = static_cast<unsigned char>(value >> (8 * i));
    }
}

uint64_t size_at(const Bytes &bytes, size_t place) {
    uint64_t size = 0;
    for (size_t i = 8; i-- > 0;) {
        size = size << 8 | bytes[place + 16 + i];
    }
    return size;
}

// The checksum of the bytes of a handle that begins at `place`.
void sign(Bytes &bytes, size_t place, size_t size) {
    uint64_t sum = ~uint64_t{0};
    for (size_t i = 0; i < size; ++i) {
        if (i < 24 || i >= 32) {
            sum ^= bytes[place + i];
            for (int k = 0; k < 8; ++k) {
                sum = sum >> 1 ^ ((sum & 1) != 0 ? 0xC96C5795D7870F42u : 0);
            }
        }
    }
    put(bytes, place + 24, ~sum);
}

// Sizes and checksums of the whole and of the splines in it.
void put_right(Bytes &bytes) {
    static constexpr unsigned char magic[] = {0x89, 'N', 'U', 'R', 0x0d, 0x0a, 0x1a, 0x0a};
    if (bytes.size() < 64) {
        return;
    }
    std::copy(std::begin(magic), std::end(magic), bytes.begin());
    for (size_t place = 64; place + 64 <= bytes.size(); place += 64) {
        const uint64_t size = size_at(bytes, place);
        if (std::equal(std::begin(magic), std::end(magic),
                       bytes.begin() + static_cast<std::ptrdiff_t>(place)) &&
            size >= 64 && size <= bytes.size() - place) {
            sign(bytes, place, static_cast<size_t>(size));
        }
    }
    put(bytes, 16, bytes.size());
    sign(bytes, 0, bytes.size());
}

// A spline, and a list of it, come back; a byte that changes is found.
void send(Input &in) {
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return;
    }
    const nurbs *const twice[] = {g.get(), g.get()};
    const std::string name(static_cast<size_t>(in.byte()), 'n');
    const char *const names[] = {name.c_str(), ""};
    nurbs_list *list = nullptr, *none = nullptr;
    FUZZ_REQUIRE(nurbs_list_create(2, twice, in.coin() ? names : nullptr, std::abs(in.number()), &list) ==
                 NURBS_OK);
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_list_create(in.bad_size(), twice, names, 1, &none)) && none == nullptr);
    Bytes bytes = written(list_to, list);
    read_all(bytes);
    FUZZ_REQUIRE(bytes.size() > written(spline_to, static_cast<const nurbs *>(g.get())).size());
    bytes[(size_t{in.byte()} * 256 + in.byte()) % bytes.size()] ^=
        static_cast<unsigned char>(1 << in.below(8));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_list_from_bytes(bytes.data(), std::ssize(bytes), &none)) && none == nullptr);
    nurbs_list_destroy(list);
}

// Numbers of good bytes replaced, signed again: whatever is read is a handle that can be used.
void damage(Input &in, Bytes bytes) {
    for (int i = in.below(4); i >= 0; --i) {
        const size_t place = (size_t{in.byte()} * 256 + in.byte()) % (bytes.size() / 8) * 8;
        if (place >= 64) {
            put(bytes, place,
                in.coin()   ? in.byte()
                : in.coin() ? ~uint64_t{0} - in.byte()
                : in.coin() ? uint64_t{1} << in.below(64)
                            : 0x3ff0000000000000u + in.byte());
        }
    }
    put_right(bytes);
    read_all(bytes);
}

// The face of a plane within a triangle, alone and in a model.
void send_faces(Input &in) {
    const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1},
                 corners[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, in.number()};
    const double ways[] = {0, 0, 1, 2, 3, 3}, places[] = {0, 0, 1, 0, 0, 1, 0, 0};
    const int32_t degrees[] = {1, 1};
    const int64_t counts[] = {2, 2}, four = 4, one = 1;
    nurbs *surface = nullptr, *curve = nullptr;
    nurbs_face *face = nullptr;
    nurbs_model *model = nullptr;
    if (FUZZ_OK(nurbs_create(2, degrees, counts, knots, 8, 3, corners, 0, 0, nullptr, 0, 0, &surface))) {
        FUZZ_REQUIRE(nurbs_create(1, degrees, &four, ways, 6, 2, places, 0, 0, nullptr, 0, 0, &curve) ==
                     NURBS_OK);
        if (FUZZ_OK(nurbs_face_create(surface, 1, &one, &curve, nullptr, nullptr, 1e-9, 0, nullptr, &face))) {
            FUZZ_REQUIRE(nurbs_model_create(1, &face, 1e-3, &model) == NURBS_OK);
            damage(in, written(face_to, static_cast<const nurbs_face *>(face)));
            damage(in, written(model_to, static_cast<const nurbs_model *>(model)));
        }
    }
    nurbs_model_destroy(model);
    nurbs_face_destroy(face);
    nurbs_destroy(curve);
    nurbs_destroy(surface);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Bytes bytes(data, data + size);
    read_all(bytes);
    put_right(bytes);
    read_all(bytes);
    Input in(data, size);
    send(in);
    send_faces(in);
    return 0;
}
