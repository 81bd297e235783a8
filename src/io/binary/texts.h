// SPDX-License-Identifier: MIT
// The texts in a body, one after the other, and the notes to which some of them belong.
//
//     where each text ends, counted from the start of the texts (64 bits each)
//     the texts
#pragma once

#include "io/binary/envelope.h"
#include "model/model.h"

#include <string>

namespace nrb::io {

class Texts {
public:
    // The text must outlive this object.
    void add(std::string_view text) {
        texts_.push_back(text);
        bytes_ += text.size();
    }
    [[nodiscard]] size_t bytes() const noexcept { return bytes_; }
    // The size from the start of the first part to the end of the last one, padding included.
    [[nodiscard]] size_t size_in_bytes() const noexcept {
        return aligned(8 * texts_.size()) + aligned(bytes_);
    }
    void write(ByteWriter &writer) const noexcept;

private:
    std::vector<std::string_view> texts_;
    size_t bytes_ = 0;
};

// Reads `count` texts, which have `bytes` bytes in all, at the start of a part. Throws Status::syntax or
// truncated.
std::vector<std::string> texts_from(ByteReader &reader, int64_t count, int64_t bytes);

// Writes the entity type, line and reason of each note; its text is one of the texts.
void write_notes(const std::vector<model::Note> &notes, ByteWriter &writer) noexcept;
// Reads the same, without the texts. Throws Status::syntax or truncated.
std::vector<model::Note> notes_from(ByteReader &reader, int64_t count);

} // namespace nrb::io
