// SPDX-License-Identifier: MIT
// Instances that are read when they are needed: what they name is followed with a guard against cycles and depth,
// and within a limit of what may be made of a file.
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
    double tolerance = 0; // distances below it count as none; 0: not stated. In the unit of the model
};

class Entities : public Limits {
public:
    explicit Entities(const Instances &instances)
        : Limits(instances.text().size(), "#"), instances_(instances) {}

    [[nodiscard]] const Instances &instances() const noexcept { return instances_; }

    // The instance that an attribute names. Throws Status::syntax if the file has none.
    const Instance &at(int64_t number, const Attributes &owner, const char *attribute) const;
    // The same, which has to be of a kind; `expected` says of which.
    const Instance &at(int64_t number, Kind kind, const Attributes &owner, const char *attribute,
                       const char *expected) const;
    [[noreturn]] void fail_kind(const Instance &found, const Attributes &owner, const char *attribute,
                                const char *expected) const;

    // What a note is to say on an instance that has been read, once however often it is read; nothing if the text is empty.
    void remark(int64_t number, bool approximated, std::string text);
    [[nodiscard]] const std::map<int64_t, std::string> &remarks() const noexcept { return remarks_; }
    // How many shapes have been approximated, each time that one was read.
    [[nodiscard]] int64_t approximations() const noexcept { return approximations_; }

private:
    const Instances &instances_;
    std::map<int64_t, std::string> remarks_;
    int64_t approximations_ = 0;
};

// Takes what is wrong with an instance.
using TellError = std::function<void(const Instance &, const Error &)>;

} // namespace nrb::io::step
