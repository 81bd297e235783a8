// SPDX-License-Identifier: MIT
// The attributes of an instance, read one after the other.
#pragma once

#include "base/status.h"
#include "io/step/structure/instances.h"
#include "io/step/structure/lexer.h"

#include <string>

namespace nrb::io::step {

// "#12 CIRCLE"
std::string label_of(const Instances &instances, const Instance &instance);

// What goes wrong throws Status::syntax and names the instance, its keyword, the attribute, the place in its lists, and
// what stands there: "#12 CIRCLE: radius: found .T., expected a number".
//
// A simple instance lists the attributes of all its supertypes in one parenthesis, a complex one has a part for each
// type. So readers name the type that an attribute belongs to by part(), which means something for complex ones only.
class Attributes {
public:
    Attributes(const Instances &instances, const Instance &instance);

    // The next attributes are those that this type declares. Throws if a complex instance has no such part.
    void part(std::string_view type);
    [[nodiscard]] bool has_part(std::string_view type) const;
    [[nodiscard]] bool complex() const noexcept { return complex_; }

    // A number, which may stand in the parentheses of its measure: LENGTH_MEASURE(25.4).
    double real(const char *name);
    double real_or(const char *name, double otherwise); // for $ and *
    int64_t integer(const char *name);
    bool boolean(const char *name); // .U. and $ are false
    std::string string(const char *name);
    std::string_view enumeration(const char *name); // empty for $ and *
    int64_t reference(const char *name);
    int64_t reference_or_none(const char *name); // 0 for $ and *
    void skip(const char *name);

    // Lists: open(), then elements as long as more(), which goes behind the list where it ends. Elements are read as
    // attributes are. A typed value is a list of one.
    void open(const char *name);
    [[nodiscard]] bool more(const char *name);
    // Goes behind the list, whatever is left in it.
    void close(const char *name);

    // What the next value begins with: '#', '(' or '$' for one of these, 'A' for a keyword, '\'' for a string, '.' for
    // an enumeration, '0' for a number, ')' where there is none.
    [[nodiscard]] char upcoming();
    // The keyword of a typed value, whose list is open then.
    std::string_view open_typed(const char *name);

    [[nodiscard]] std::string label() const;
    [[noreturn]] void fail_attribute(Status status, const char *name, const std::string &what) const;

private:
    void begin_value(const char *name);
    [[noreturn]] void fail_token(const Token &token, const char *name, const char *expected) const;
    Token take(const char *name, TokenKind kind, const char *expected);
    bool take_unset(const char *name);
    double number(const char *name);

    const Instances &instances_;
    const Instance &instance_;
    Lexer lexer_;
    bool complex_;
    bool first_ = true; // of its list
    int64_t index_ = 0; // in the innermost list
    int depth_ = 0;
};

} // namespace nrb::io::step
