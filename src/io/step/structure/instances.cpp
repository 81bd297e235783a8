// SPDX-License-Identifier: MIT
#include "io/step/structure/instances.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

bool by_number(const Instance &a, const Instance &b) noexcept {
    return a.number() < b.number();
}
bool same_number(const Instance &a, const Instance &b) noexcept {
    return a.number() == b.number();
}

} // namespace

Instances::Instances(std::string_view text, std::vector<Instance> instances)
    : text_(text), instances_(std::move(instances)) {
    if (!std::is_sorted(instances_.begin(), instances_.end(), by_number)) {
        std::sort(instances_.begin(), instances_.end(), [](const Instance &a, const Instance &b) {
            return a.number() != b.number() ? a.number() < b.number() : a.offset() < b.offset();
        });
    }
    for (size_t i = 1; i < instances_.size(); ++i) {
        const bool again = same_number(instances_[i], instances_[i - 1]);
        if (again && (repeated_.empty() || repeated_.back() != instances_[i].number())) {
            repeated_.push_back(instances_[i].number());
        }
    }
    instances_.erase(std::unique(instances_.begin(), instances_.end(), same_number), instances_.end());
}

int64_t Instances::find(int64_t number) const noexcept {
    if (instances_.empty() || number < instances_.front().number()) {
        return -1;
    }
    const int64_t guess = number - instances_.front().number();
    if (guess < size() && (*this)[guess].number() == number) {
        return guess;
    }
    const auto found =
        std::lower_bound(instances_.begin(), instances_.end(), Instance(number, Kind::other, 0), by_number);
    return found != instances_.end() && found->number() == number ? found - instances_.begin() : -1;
}

std::string_view Instances::keyword(const Instance &instance) const noexcept {
    Lexer lexer(text_, instance.offset());
    Token token = lexer.next();
    if (!token.is('(')) {
        return token.text;
    }
    std::string_view first;
    for (token = lexer.next(); token.kind == TokenKind::keyword; token = lexer.next()) {
        first = first.empty() ? token.text : first;
        if (instance.kind() != Kind::other && kind_of(token.text) == instance.kind()) {
            return token.text;
        }
        if (!lexer.next().is('(') || !lexer.skip_list()) {
            break;
        }
    }
    return first;
}

} // namespace nrb::io::step
