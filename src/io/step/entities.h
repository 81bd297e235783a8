// SPDX-License-Identifier: MIT
// Reads instances when they are needed. References are followed with a guard against cycles and deep nesting,
// and within limits on what is made of a file.
#pragma once

#include "base/error.h"
#include "io/limits.h"
#include "io/step/structure/attributes.h"

#include <functional>
#include <map>
#include <string>

namespace nrb::io::step {

// The measures of a context, as factors to the units that are wanted.
struct Units {
    double length = 1;    // to the unit of the model
    double angle = 1;     // to radians
    double tolerance = 0; // in the unit of the model; distances below it count as 0; 0: not stated
};

class Entities : public Limits {
public:
    explicit Entities(const Instances &instances)
        : Limits(instances.text().size(), "#"), instances_(instances) {}

    [[nodiscard]] const Instances &instances() const noexcept { return instances_; }

    // The instance that an attribute names. Throws Status::syntax if it is not in the file.
    const Instance &at(int64_t number, const Attributes &owner, const char *attribute) const;
    // The same for an instance of a given kind. For another kind it throws what fail_kind() throws.
    // `expected`: the name of the kind in messages.
    const Instance &at(int64_t number, Kind kind, const Attributes &owner, const char *attribute,
                       const char *expected) const;
    // Throws Status::unsupported if the kind of the instance found is not known, else syntax.
    [[noreturn]] void fail_kind(const Instance &found, const Attributes &owner, const char *attribute,
                                const char *expected) const;

    // Keeps what a note has to say about an instance that has been read: one text, however often the instance
    // is read; none if the text is empty. `approximated`: whether a shape was approximated, which is counted.
    void remark(int64_t number, bool approximated, std::string text);
    [[nodiscard]] const std::map<int64_t, std::string> &remarks() const noexcept { return remarks_; }
    // The number of shapes that have been approximated, counted each time that one is read.
    [[nodiscard]] int64_t approximations() const noexcept { return approximations_; }

private:
    const Instances &instances_;
    std::map<int64_t, std::string> remarks_;
    int64_t approximations_ = 0;
};

// Receives the errors in instances.
using TellError = std::function<void(const Instance &, const Error &)>;

} // namespace nrb::io::step
