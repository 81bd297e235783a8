// SPDX-License-Identifier: MIT
// Files through the C++ wrapper: parts.igs, the path of which is the argument, read by name and from memory.
#include "expect.hpp"

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

using namespace libnurbs;

static void holds_the_edge(const List &list, double scale) {
    EXPECT(list.size() == 1 && list.name(0) == "EDGE(7)");
    EXPECT((list[0].eval({0, 1}) == Values{0, 0, 0, scale, 2 * scale, 3 * scale}));
    EXPECT(near({list.unit()}, {0.001 / scale}));
    EXPECT(list.note_count() == 1);
    const Note note = list.note(0);
    EXPECT(note.entity_type == 116 && note.line == 3 && note.reason == Status::unsupported);
    EXPECT(!note.text.empty());
    EXPECT(status_of([&] { (void)list[1]; }) == Status::index);
}

static void read(const std::string &path) {
    holds_the_edge(List::read_file(path), 1);
    ReadOptions metres;
    metres.unit = 1;
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    holds_the_edge(List::read(std::as_bytes(std::span(text)), metres), 0.001);
}

static void errors(const std::string &path) {
    const std::string text = "no file of a known format";
    EXPECT(status_of([&] { (void)List::read(std::as_bytes(std::span(text))); }) == Status::format);
    EXPECT(status_of([] { (void)List::read_file("/no/such/file"); }) == Status::file);
    EXPECT(status_of([&] { (void)List::read_file(path + std::string("\0.old", 5)); }) == Status::file);
}

static Spline square() {
    const std::int32_t degrees[] = {2};
    const std::int64_t counts[] = {4};
    const Values knots{2, 3, 4, 5, 6}, points{1, 1, -1, 1, -1, -1, 1, -1};
    return Spline::create_periodic(degrees, counts, knots, 2, points, {}, periodic);
}

// Each control point once, and what is read back.
static void unwrapped() {
    const Spline loop = square();
    EXPECT(loop.count(0) == 6 && loop.unwrapped_count(0) == 4);
    EXPECT((loop.unwrapped_knots(0) == Values{2, 3, 4, 5, 6}));
    EXPECT((loop.short_knots(0) == Values{1, 2, 3, 4, 5, 6, 7}));
    const UnwrappedPoints found = loop.unwrapped_points();
    EXPECT((found.points == Values{1, 1, -1, 1, -1, -1, 1, -1} && found.weights == Values(4, 1)));
}

static void bytes() {
    const Spline loop = square();
    std::vector<std::byte> bytes = loop.to_bytes();
    EXPECT(bytes_kind(bytes).kind == bytes_spline && bytes_kind(bytes).major == 1);
    EXPECT(Spline::from_bytes(bytes).to_bytes() == bytes);
    bytes.back() ^= std::byte{1};
    EXPECT(status_of([&] { (void)Spline::from_bytes(bytes); }) == Status::checksum);
    EXPECT(status_of([&] { (void)List::from_bytes(loop.to_bytes()); }) == Status::format);
}

static void lists() {
    const Spline splines[] = {square(), square()};
    const std::string names[] = {"a", "square"}, zero[] = {std::string("a\0b", 3), "b"};
    const List list = List::create(splines, names, 0.001), numbered = List::create(splines);
    EXPECT(list.size() == 2 && list.name(1) == "square" && list.unit() == 0.001);
    EXPECT(numbered.name(1) == "1" && numbered.unit() == 0 && List::create({}).size() == 0);
    const List again = List::from_bytes(list.to_bytes());
    EXPECT(again.to_bytes() == list.to_bytes() && again.name(0) == "a");
    EXPECT(again[1].to_bytes() == splines[0].to_bytes());
    EXPECT(status_of([&] { (void)List::create(splines, std::span(names).first(1)); }) == Status::size);
    EXPECT(status_of([&] { (void)List::create(splines, zero); }) == Status::syntax);
    EXPECT(status_of([&] { (void)List::create(splines, {}, -1); }) == Status::factor);
}

int main(int count, char **arguments) {
    EXPECT(count == 2 && version() / 10000 == version_major);
    if (count == 2) {
        read(arguments[1]);
        errors(arguments[1]);
    }
    unwrapped();
    bytes();
    lists();
    return failures == 0 ? 0 : 1;
}
