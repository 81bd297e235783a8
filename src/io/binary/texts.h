// SPDX-License-Identifier: MIT
// The texts in a body, one after the other, and the notes that have some.
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
    // The text has to outlive this.
    void add(std::string_view text) {
        texts_.push_back(text);
        bytes_ += text.size();
    }
    [[nodiscard]] size_t bytes() const noexcept { return bytes_; }
    // From the beginning of a part to its end.
    [[nodiscard]] size_t size_in_bytes() const noexcept {
        return aligned(8 * texts_.size()) + aligned(bytes_);
    }
    void write(ByteWriter &writer) const noexcept;

private:
    std::vector<std::string_view> texts_;
    size_t bytes_ = 0;
};

// `count` texts of `bytes` in all, at the beginning of a part. Throws Status::syntax, truncated.
std::vector<std::string> texts_from(ByteReader &reader, int64_t count, int64_t bytes);

// Of each note its entity type, line and reason; the words are in texts.
void write_notes(const std::vector<model::Note> &notes, ByteWriter &writer) noexcept;
// Throws Status::syntax, truncated.
std::vector<model::Note> notes_from(ByteReader &reader, int64_t count);

} // namespace nrb::io
