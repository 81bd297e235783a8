// SPDX-License-Identifier: MIT
// Units of measure: those of a representation context hold for what its representations contain.
#pragma once

#include "io/step/entities.h"

#include <string>
#include <vector>

namespace nrb::io::step {

struct Measures {
    double metres = 0;      // of a unit of length; 0: not stated
    double radians = 1;     // of a unit of angle; 1 if it is not stated
    double uncertainty = 0; // in units of length; 0: not stated
};

// What is wrong with a context or one of its units.
struct ContextDamage {
    int64_t number;
    Status reason;
    std::string text;
};

class Contexts {
public:
    explicit Contexts(Entities &entities);

    // The measures of an instance of geometry or topology: those of the context of the first representation that
    // contains it, by its items and what they name. Where all contexts agree, and for what is in none, those of the
    // first context. Sets of curves in parameter planes have no unit of length.
    [[nodiscard]] const Measures &of(int64_t place) const noexcept {
        return all_[of_instance_.empty() ? 0 : of_instance_[static_cast<size_t>(place)]];
    }
    // At least one: without any context, nothing is stated.
    [[nodiscard]] const std::vector<Measures> &all() const noexcept { return all_; }
    [[nodiscard]] const std::vector<ContextDamage> &damages() const noexcept { return damages_; }

private:
    struct Found {
        int64_t context; // number of the instance
        uint32_t measures;
    };
    void read_contexts(Entities &entities);
    static std::vector<int64_t> sets_in_parameters(const Entities &entities);
    void assign(const Entities &entities, const std::vector<int64_t> &bare);

    std::vector<Measures> all_;
    std::vector<uint32_t> of_instance_; // empty: all the same
    std::vector<Found> found_;          // in the order of the numbers
    std::vector<ContextDamage> damages_;
};

} // namespace nrb::io::step
