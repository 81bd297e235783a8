// SPDX-License-Identifier: MIT
// Units of measure. Those of a representation context hold for everything that its representations contain.
#pragma once

#include "io/step/entities.h"

#include <string>
#include <vector>

namespace nrb::io::step {

struct Measures {
    double metres = 0;      // per unit of length; 0: not stated, by no other context either
    double radians = 1;     // per unit of angle; 1 if it is not stated
    double uncertainty = 0; // in units of length; 0: not stated
};

// An error in a context or in one of its units, and the number of the context.
struct ContextDamage {
    int64_t number;
    Status reason;
    std::string text;
};

class Contexts {
public:
    explicit Contexts(Entities &entities);

    // The measures of the instance of geometry or topology at a place, its index in Instances::all(). They
    // are those of the context of the first representation that contains the instance, among its items or
    // below them. If all contexts agree, and for an instance that no representation contains, they are those
    // of the first context. A context that states no length has that of the first one that does, which is told
    // among the damages if shapes are in it. Sets of curves in parameter planes have no unit of length.
    [[nodiscard]] const Measures &of(int64_t place) const noexcept {
        return all_[of_instance_.empty() ? 0 : of_instance_[static_cast<size_t>(place)]];
    }
    // Never empty: without any context there is one entry, in which nothing is stated.
    [[nodiscard]] const std::vector<Measures> &all() const noexcept { return all_; }
    [[nodiscard]] const std::vector<ContextDamage> &damages() const noexcept { return damages_; }

private:
    struct Found {
        int64_t context; // number of the instance
        uint32_t measures;
        bool used = false; // by a representation of a shape
    };
    void read_contexts(Entities &entities);
    static std::vector<int64_t> sets_in_parameters(const Entities &entities);
    void set_unstated_lengths();
    void assign(const Entities &entities, const std::vector<int64_t> &bare);

    std::vector<Measures> all_;
    std::vector<uint32_t> of_instance_; // by place: index in all_; empty: all are 0
    std::vector<Found> found_;          // in ascending order of `context`
    std::vector<ContextDamage> damages_;
};

} // namespace nrb::io::step
