// Bytes of handles: those of splines and lists that were made come back; any others are refused, or are a handle that
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

void read_all(const Bytes &bytes) {
    const auto spline_from = [](auto... given) { return nurbs_from_bytes(given...); };
    read<nurbs>(bytes, spline_from, spline_to, nurbs_destroy, use_spline);
    read<nurbs_list>(bytes, nurbs_list_from_bytes, list_to, nurbs_list_destroy, use_list);
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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Bytes bytes(data, data + size);
    read_all(bytes);
    put_right(bytes);
    read_all(bytes);
    Input in(data, size);
    send(in);
    return 0;
}
