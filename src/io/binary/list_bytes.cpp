// SPDX-License-Identifier: MIT
#include "io/binary/list_bytes.h"

#include "base/error.h"

#include <limits>

namespace nrb::io {

namespace {

constexpr size_t at_places = 128;

struct ListSizes {
    int64_t places, splines, notes, text;
};

int64_t size_from(ByteReader &reader, const char *what) {
    const int64_t size = reader.take_integer();
    if (size < 0 || static_cast<uint64_t>(size) > reader.left()) {
        fail(Status::syntax, "%s = %lld, expected 0 to %zu, for the bytes that follow", what,
             static_cast<long long>(size), reader.left());
    }
    return size;
}

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

int32_t small_from(ByteReader &reader, const char *what) {
    const int64_t value = reader.take_integer();
    if (value != static_cast<int32_t>(value)) {
        fail(Status::syntax, "%s = %lld of a note, which no note has", what, static_cast<long long>(value));
    }
    return static_cast<int32_t>(value);
}

std::vector<model::Note> notes_from(ByteReader &reader, int64_t count) {
    reader.need(3 * static_cast<uint64_t>(count));
    std::vector<model::Note> notes;
    for (int64_t i = 0; i < count; ++i) {
        model::Note note{};
        note.entity_type = small_from(reader, "entity type");
        note.line = reader.take_integer();
        note.reason = static_cast<Status>(small_from(reader, "reason"));
        notes.push_back(std::move(note));
    }
    return notes;
}

// `count` texts of `size` bytes in all.
std::vector<std::string> texts_from(ByteReader &reader, int64_t count, int64_t size) {
    const std::vector<int64_t> ends = reader.take_integers(count);
    reader.align();
    std::vector<std::string> texts;
    int64_t before = 0;
    for (const int64_t end : ends) {
        if (end < before || end > size) {
            fail(Status::syntax, "a text of a list ends at byte %lld, expected %lld to %lld",
                 static_cast<long long>(end), static_cast<long long>(before), static_cast<long long>(size));
        }
        texts.emplace_back(reader.take_text(end - before));
        before = end;
    }
    if (before != size) {
        fail(Status::syntax, "the texts of a list end at byte %lld, expected %lld",
             static_cast<long long>(before), static_cast<long long>(size));
    }
    return texts;
}

} // namespace

ListBytes::ListBytes(const model::Model &model) : model_(model) {
    indices_.reserve(model.splines.size());
    for (const model::NamedSpline &named : model.splines) {
        indices_.push_back(table_.add(named.spline));
        text_size_ += named.name.size();
    }
    for (const model::Note &note : model.notes) {
        text_size_ += note.text.size();
    }
    const size_t texts = model.splines.size() + model.notes.size();
    size_ = at_places + aligned(8 * indices_.size()) + aligned(24 * model.notes.size()) + aligned(8 * texts) +
            aligned(text_size_) + table_.size_in_bytes();
}

void ListBytes::write(std::span<unsigned char> out) const noexcept {
    ByteWriter writer(Kind::list, {}, out);
    writer.put(std::ssize(indices_));
    writer.put(table_.count());
    writer.put(std::ssize(model_.notes));
    writer.put(uint64_t{text_size_});
    writer.put(model_.metres_per_unit + 0.0); // -0 is the same unit
    writer.align();
    for (const int64_t index : indices_) {
        writer.put(index);
    }
    writer.align();
    for (const model::Note &note : model_.notes) {
        writer.put(int64_t{note.entity_type});
        writer.put(note.line);
        writer.put(static_cast<int64_t>(note.reason));
    }
    writer.align();
    write_texts(writer);
    table_.write(writer);
    writer.finish();
}

void ListBytes::write_texts(ByteWriter &writer) const noexcept {
    uint64_t end = 0;
    for (const model::NamedSpline &named : model_.splines) {
        writer.put(end += named.name.size());
    }
    for (const model::Note &note : model_.notes) {
        writer.put(end += note.text.size());
    }
    writer.align();
    for (const model::NamedSpline &named : model_.splines) {
        writer.put(std::string_view(named.name));
    }
    for (const model::Note &note : model_.notes) {
        writer.put(std::string_view(note.text));
    }
    writer.align();
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
    reader.align();
    std::vector<std::string> texts = texts_from(reader, sizes.places + sizes.notes, sizes.text);
    reader.align();
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
