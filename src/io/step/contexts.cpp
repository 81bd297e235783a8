// SPDX-License-Identifier: MIT
#include "io/step/contexts.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/step/units.h"

#include <algorithm>
#include <array>
#include <map>

namespace nrb::io::step {
namespace {

constexpr uint32_t nobody = ~uint32_t{0};

// Gives an owner to all geometry and topology below an instance, except to what has one already.
class Assignment {
public:
    Assignment(const Instances &instances, std::vector<uint32_t> &owners)
        : instances_(instances), owners_(owners) {}

    void run(const Instance &representation, uint32_t owner) {
        visit_references(representation, owner);
        while (!waiting_.empty()) {
            const int64_t place = waiting_.back();
            waiting_.pop_back();
            visit_references(instances_[place], owner);
        }
    }

private:
    void visit_references(const Instance &instance, uint32_t owner) {
        for_each_reference(instances_.text(), instance, [&](int64_t number) {
            const int64_t place = instances_.find(number);
            if (place >= 0 && is_shape(instances_[place].kind()) &&
                owners_[static_cast<size_t>(place)] == nobody) {
                owners_[static_cast<size_t>(place)] = owner;
                waiting_.push_back(place);
            }
        });
        count_work(16);
    }

    const Instances &instances_;
    std::vector<uint32_t> &owners_;
    std::vector<int64_t> waiting_;
};

} // namespace

Contexts::Contexts(Entities &entities) {
    read_contexts(entities);
    if (all_.empty()) {
        all_.emplace_back();
    }
    const std::vector<int64_t> bare = sets_in_parameters(entities);
    if (all_.size() > 1 || !bare.empty()) {
        assign(entities, bare);
        set_unstated_lengths();
    }
}

// The places of the sets of curves in parameter planes that belong to no surface. (Curves that belong to a
// surface are read with it.)
std::vector<int64_t> Contexts::sets_in_parameters(const Entities &entities) {
    const Instances &instances = entities.instances();
    std::vector<int64_t> sets;
    for (const Instance &instance : instances.all()) {
        if (instance.kind() != Kind::definitional_representation) {
            continue;
        }
        for_each_reference(instances.text(), instance, [&](int64_t number) {
            const int64_t place = instances.find(number);
            if (place >= 0 && instances[place].kind() == Kind::geometric_set) {
                sets.push_back(place);
            }
        });
    }
    return sets;
}

void Contexts::read_contexts(Entities &entities) {
    std::map<std::array<double, 3>, size_t> places;
    for (const Instance &instance : entities.instances().all()) {
        if (instance.kind() != Kind::unit_context) {
            continue;
        }
        try {
            const Measures measures = read_measures(entities, instance);
            const auto [known, added] =
                places.try_emplace({measures.metres, measures.radians, measures.uncertainty}, all_.size());
            if (added) {
                all_.push_back(measures);
            }
            found_.push_back({instance.number(), static_cast<uint32_t>(known->second)});
        } catch (const Error &error) {
            damages_.push_back({instance.number(), error.status(), error.what()});
        }
    }
}

// The length of a context that states none is that of the first one that does.
void Contexts::set_unstated_lengths() {
    const auto states = [](const Measures &measures) { return measures.metres > 0; };
    const auto stated = std::ranges::find_if(all_, states);
    if (stated == all_.end()) {
        return;
    }
    for (const Found &found : found_) {
        if (found.used && !states(all_[found.measures])) {
            damages_.push_back({found.context, Status::syntax,
                                "#" + std::to_string(found.context) +
                                    ": states no unit of length; that of another context is taken"});
        }
    }
    for (const Found &found : found_) {
        double &metres = all_[found.measures].metres;
        metres = metres > 0 ? metres : stated->metres;
    }
}

void Contexts::assign(const Entities &entities, const std::vector<int64_t> &bare) {
    const Instances &instances = entities.instances();
    of_instance_.assign(static_cast<size_t>(instances.size()), nobody);
    Assignment assignment(instances, of_instance_);
    const auto no_units = static_cast<uint32_t>(all_.size());
    for (const int64_t set : bare) {
        assignment.run(instances[set], no_units);
    }
    if (!bare.empty()) {
        all_.push_back({0, all_.front().radians, 0});
    }
    for (const Instance &instance : instances.all()) {
        if (instance.kind() != Kind::shape_representation) {
            continue;
        }
        for_each_reference(instances.text(), instance, [&](int64_t number) {
            const auto context = std::ranges::lower_bound(found_, number, {}, &Found::context);
            if (context != found_.end() && context->context == number) {
                context->used = true;
                assignment.run(instance, context->measures);
            }
        });
    }
    std::ranges::replace(of_instance_, nobody, 0U);
}

} // namespace nrb::io::step
