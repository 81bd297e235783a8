// SPDX-License-Identifier: MIT
#include "io/binary/texts.h"

#include "base/error.h"

namespace nrb::io {

namespace {

int32_t small_from(ByteReader &reader, const char *what) {
    const int64_t value = reader.take_integer();
    if (value != static_cast<int32_t>(value)) {
        fail(Status::syntax, "%s = %lld of a note, which no note has", what, static_cast<long long>(value));
    }
    return static_cast<int32_t>(value);
}

} // namespace

void Texts::write(ByteWriter &writer) const noexcept {
    uint64_t end = 0;
    for (const std::string_view text : texts_) {
        writer.put(end += text.size());
    }
    writer.align();
    for (const std::string_view text : texts_) {
        writer.put(text);
    }
    writer.align();
}

std::vector<std::string> texts_from(ByteReader &reader, int64_t count, int64_t bytes) {
    const std::vector<int64_t> ends = reader.take_integers(count);
    reader.align();
    std::vector<std::string> texts;
    int64_t before = 0;
    for (const int64_t end : ends) {
        if (end < before || end > bytes) {
            fail(Status::syntax, "a text ends at byte %lld, expected %lld to %lld",
                 static_cast<long long>(end), static_cast<long long>(before), static_cast<long long>(bytes));
        }
        texts.emplace_back(reader.take_text(end - before));
        before = end;
    }
    if (before != bytes) {
        fail(Status::syntax, "the texts end at byte %lld, expected %lld", static_cast<long long>(before),
             static_cast<long long>(bytes));
    }
    reader.align();
    return texts;
}

void write_notes(const std::vector<model::Note> &notes, ByteWriter &writer) noexcept {
    for (const model::Note &note : notes) {
        writer.put(int64_t{note.entity_type});
        writer.put(note.line);
        writer.put(static_cast<int64_t>(note.reason));
    }
    writer.align();
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
    reader.align();
    return notes;
}

} // namespace nrb::io
