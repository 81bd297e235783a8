// SPDX-License-Identifier: MIT
#include "io/binary/list_bytes.h"

#include "base/error.h"
#include "io/binary/checked_numbers.h"

namespace nrb::io {

namespace {

constexpr size_t at_places = 128;

struct ListSizes {
    int64_t places, splines, notes, text;
};

std::vector<int64_t> indices_from(ByteReader &reader, const ListSizes &sizes) {
    std::vector<int64_t> indices = reader.take_integers(sizes.places);
    for (const int64_t index : indices) {
        if (index < 0 || index >= sizes.splines) {
            fail(Status::syntax, "a spline %lld of a list, expected 0 to %lld", static_cast<long long>(index),
                 static_cast<long long>(sizes.splines) - 1);
        }
    }
    return indices;
}

} // namespace

ListBytes::ListBytes(const model::Model &model) : model_(model) {
    indices_.reserve(model.splines.size());
    for (const model::NamedSpline &named : model.splines) {
        indices_.push_back(table_.add(named.spline));
        texts_.add(named.name);
    }
    for (const model::Note &note : model.notes) {
        texts_.add(note.text);
    }
    size_ = at_places + aligned(8 * indices_.size()) + aligned(24 * model.notes.size()) +
            texts_.size_in_bytes() + table_.size_in_bytes();
}

void ListBytes::write(std::span<unsigned char> out) const noexcept {
    ByteWriter writer(Kind::list, {}, out);
    writer.put(std::ssize(indices_));
    writer.put(table_.count());
    writer.put(std::ssize(model_.notes));
    writer.put(uint64_t{texts_.bytes()});
    writer.put(model_.metres_per_unit + 0.0); // -0 is the same unit
    writer.align();
    for (const int64_t index : indices_) {
        writer.put(index);
    }
    writer.align();
    write_notes(model_.notes, writer);
    texts_.write(writer);
    table_.write(writer);
    writer.finish();
}

model::Model list_from(std::span<const unsigned char> bytes) {
    ByteReader reader(bytes, Kind::list);
    ListSizes sizes{};
    sizes.places = size_from(reader, "number of places");
    sizes.splines = size_from(reader, "number of splines");
    sizes.notes = size_from(reader, "number of notes");
    sizes.text = size_from(reader, "number of bytes of text");
    model::Model model;
    model.metres_per_unit = reader.take_double();
    model::check_metres(model.metres_per_unit);
    reader.align();
    const std::vector<int64_t> indices = indices_from(reader, sizes);
    reader.align();
    model.notes = notes_from(reader, sizes.notes);
    std::vector<std::string> texts = texts_from(reader, sizes.places + sizes.notes, sizes.text);
    const std::vector<SplinePtr> splines = splines_from(reader, sizes.splines);
    reader.end();
    auto text = texts.begin();
    for (const int64_t index : indices) {
        model.splines.push_back({std::move(*text++), splines[static_cast<size_t>(index)]});
    }
    for (model::Note &note : model.notes) {
        note.text = std::move(*text++);
    }
    return model;
}

} // namespace nrb::io
