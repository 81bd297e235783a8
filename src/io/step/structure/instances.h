// SPDX-License-Identifier: MIT
// Where the instances of an exchange structure stand, and what kind they have.
#pragma once

#include "io/step/structure/keywords.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nrb::io::step {

// Two words, so that the index of a file is smaller than the file.
class Instance {
public:
    Instance(int64_t number, Kind kind, size_t offset) noexcept
        : number_and_kind_((static_cast<uint64_t>(number) << 16) | static_cast<uint64_t>(kind)),
          offset_(offset) {}

    [[nodiscard]] int64_t number() const noexcept { return static_cast<int64_t>(number_and_kind_ >> 16); }
    [[nodiscard]] Kind kind() const noexcept { return static_cast<Kind>(number_and_kind_ & 0xFFFF); }
    // Of the keyword, or of the parenthesis before the parts of a complex instance.
    [[nodiscard]] size_t offset() const noexcept { return static_cast<size_t>(offset_); }

private:
    uint64_t number_and_kind_;
    uint64_t offset_;
};

class Instances {
public:
    // In the order of their numbers, which need not be that of the file.
    explicit Instances(std::string_view text, std::vector<Instance> instances);

    [[nodiscard]] const std::vector<Instance> &all() const noexcept { return instances_; }
    // The place of an instance in all(), or -1. Numbers that follow each other without gaps are found at once.
    [[nodiscard]] int64_t find(int64_t number) const noexcept;
    [[nodiscard]] const Instance &operator[](int64_t place) const noexcept {
        return instances_[static_cast<size_t>(place)];
    }
    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(instances_.size()); }
    [[nodiscard]] std::string_view text() const noexcept { return text_; }
    // Numbers that stand for more than one instance: the first in the file counts.
    [[nodiscard]] const std::vector<int64_t> &repeated() const noexcept { return repeated_; }

    // The keyword of an instance, for messages: that of the part which made its kind, for a complex one.
    [[nodiscard]] std::string_view keyword(const Instance &instance) const noexcept;

private:
    std::string_view text_;
    std::vector<Instance> instances_;
    std::vector<int64_t> repeated_;
};

// Calls visit(number) for each instance that another one names.
template <class Visit>
void for_each_reference(std::string_view text, const Instance &instance, Visit &&visit);

} // namespace nrb::io::step

#include "io/step/structure/lexer.h"

namespace nrb::io::step {

template <class Visit>
void for_each_reference(std::string_view text, const Instance &instance, Visit &&visit) {
    Lexer lexer(text, instance.offset());
    for (Token token = lexer.next(); token.kind != TokenKind::end && !token.is(';'); token = lexer.next()) {
        if (token.kind == TokenKind::instance) {
            visit(instance_number(token.text));
        }
    }
}

} // namespace nrb::io::step
