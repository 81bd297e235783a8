// SPDX-License-Identifier: MIT
// Splits an IGES file into its 80-column lines, sorted by section.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace nrb::io::iges {

inline constexpr size_t data_columns = 72;      // free text of a line in sections S, G and T
inline constexpr size_t parameter_columns = 64; // free text of a line in section P
inline constexpr size_t line_columns = 80;
inline constexpr int64_t sequence_limit = 10'000'000; // sequence numbers have seven digits

using Lines = std::vector<std::string_view>;

// Every line has at least 73 columns, and line i of a section has the sequence number i + 1.
struct Sections {
    Lines start;
    Lines global;
    Lines directory;
    Lines parameter;
    Lines terminate;
};

// The first line that is not blank, without a byte order mark before it.
std::string_view first_line(std::span<const char> bytes) noexcept;

// Whether that line belongs to the fixed-length, or to the compressed, ASCII form.
bool begins_iges(std::span<const char> bytes) noexcept;
bool begins_compressed(std::span<const char> bytes) noexcept;

// The lines are views into `bytes`. Throws Status::truncated or syntax; messages count the lines of the file
// from 1.
Sections split_sections(std::span<const char> bytes);

} // namespace nrb::io::iges
