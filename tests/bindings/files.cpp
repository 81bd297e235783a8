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

int main(int count, char **arguments) {
    EXPECT(count == 2 && version() / 10000 == version_major);
    if (count == 2) {
        read(arguments[1]);
        errors(arguments[1]);
    }
    return failures == 0 ? 0 : 1;
}
