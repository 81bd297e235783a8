// SPDX-License-Identifier: MIT
#include "io/iges/model/assembly.h"

#include "io/iges/model/claims.h"
#include "io/iges/model/counts.h"
#include "io/iges/text.h"
#include "io/iges/types.h"
#include "model/placing.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

constexpr int64_t first_part = 0;
constexpr int64_t size_of_a_use = 32; // in doubles
constexpr int64_t size_of_a_claim = 8;

// The placement x -> scale R x + factor T by rows, without negative zeros.
std::array<double, 12> rows_of(const Transform &transform, double scale, double factor) {
    std::array<double, 12> rows{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            rows[4 * i + j] = scale * transform.r[i][j] + 0.0;
        }
        rows[4 * i + 3] = factor * transform.t[i] + 0.0;
    }
    return rows;
}

// Associativities (402) of these forms are groups: ordered or not, with or without back pointers.
bool is_group(const Entry &entry) noexcept {
    return entry.type == associativity_type &&
           (entry.form == 1 || entry.form == 7 || entry.form == 14 || entry.form == 15);
}

// Types whose own matrix moves what they consist of.
bool moves_others(int type) noexcept {
    return type == trimmed_surface_type || type == bounded_surface_type || type == face_type ||
           type == shell_type || type == solid_type;
}

// An instance of a subfigure (408) or of a solid (430).
struct Instance {
    int64_t pointer;
    int64_t target;
    std::array<double, 12> placement;
    std::string name;
};

class AssemblyReader {
public:
    AssemblyReader(Entities &entities, double factor, const TopologyEntities &topology,
                   std::vector<Damage> &damages)
        : entities_(entities), directory_(entities.directory()), factor_(factor), topology_(topology),
          damages_(damages) {
        result_.told.assign(directory_.entries().size(), false);
        result_.parts.emplace_back();
    }

    Assembly read() {
        for (const Entry &entry : directory_.entries()) {
            guarded(entry, [&] { read_entity(entry); });
        }
        claim_members();
        find_own_parts();
        hand_down();
        place_instances();
        for (const size_t i : model::drop_cycles(result_.parts.size(), result_.uses)) {
            const Entry &entry = *directory_entry(sources_[i]);
            damages_.push_back(
                {entry.line, Status::cycle, label_of(entry) + "places a part in itself, which is left out"});
        }
        model::place_the_rest(result_.parts.size(), result_.uses);
        return std::move(result_);
    }

private:
    // An error in one entity is reported, and does not affect the others.
    template <class Run>
    void guarded(const Entry &entry, Run &&run) {
        try {
            labelling(entry, run);
        } catch (const Error &error) {
            damages_.push_back({entry.line, error.status(), error.what()});
        }
    }
    [[nodiscard]] const Entry *directory_entry(int64_t pointer) const noexcept {
        const std::optional<size_t> index = directory_.find(pointer);
        return index ? &directory_.entries()[*index] : nullptr;
    }
    void tell(const Entry &entry) { result_.told[*directory_.find(entry.line)] = true; }

    void read_entity(const Entry &entry) {
        if (entry.type == subfigure_type) {
            tell(entry);
            read_subfigure(entry);
        } else if (entry.type == subfigure_instance_type || entry.type == solid_instance_type) {
            tell(entry);
            read_instance(entry);
        } else if (is_group(entry)) {
            tell(entry);
            Record record = entities_.record(entry);
            members_[entry.line] = read_pointers(record, "number of members");
        }
    }
    void read_subfigure(const Entry &entry) {
        Record record = entities_.record(entry);
        record.skip(1); // nesting depth, which follows from the instances
        std::string name = printable(trim(record.string("name")));
        entities_.spend(size_of_a_use);
        subfigures_[entry.line] = std::ssize(result_.parts);
        result_.parts.push_back({std::move(name)});
        members_[entry.line] = read_pointers(record, "number of members");
    }
    void read_instance(const Entry &entry) {
        Record record = entities_.record(entry);
        Instance instance{entry.line, record.integer("definition"), {}, {}};
        Transform moved;
        double scale = 1;
        if (entry.type == subfigure_instance_type) {
            for (double &x : moved.t) {
                x = record.real("translation");
            }
            const bool usual = record.next_is_blank();
            const double given = record.real("scale");
            scale = usual ? 1 : given;
        }
        if (!(scale > 0)) {
            fail(Status::factor, "scale %s, expected more than 0", Number(scale).text);
        }
        const Placement place = entities_.placement(entry, nullptr, 1, false);
        instance.placement =
            rows_of(place.transform ? compose(*place.transform, moved) : moved, scale, factor_);
        instance.name = entities_.name(entry, record);
        entities_.spend(size_of_a_use);
        instances_.push_back(std::move(instance));
    }

    // Groups in several subfigures become parts, too.
    void claim_members() {
        std::vector<int64_t> subfigures;
        for (const auto &[pointer, part] : subfigures_) {
            subfigures.push_back(pointer);
        }
        Claims claims = claims_of(subfigures, members_,
                                  [this](int64_t count) { entities_.spend(count * size_of_a_claim); });
        collections_ = subfigures_;
        for (const int64_t group : claims.shared) {
            collections_[group] = new_part(*directory_entry(group));
            for (const int64_t owner : claims.owners.at(group)) {
                add_use(collections_.at(owner), collections_[group], rows_of({}, 1, 1), {}, group);
            }
            claims.owners.erase(group);
        }
        for (auto &[pointer, owners] : claims.owners) {
            if (directory_entry(pointer) != nullptr) {
                std::ranges::transform(owners, owners.begin(),
                                       [this](int64_t owner) { return collections_.at(owner); });
                owners_[pointer] = std::move(owners);
            }
        }
    }

    // What only one subfigure lists belongs to its part; what has several owners or instances is a part of
    // its own.
    void find_own_parts() {
        for (const Instance &instance : instances_) {
            if (const Entry *const target = directory_entry(instance.target);
                target != nullptr && target->type != subfigure_type) {
                owned_part(*target);
            }
        }
        for (const auto &[pointer, owners] : owners_) {
            const Entry &entry = *directory_entry(pointer);
            const bool instance = entry.type == subfigure_instance_type || entry.type == solid_instance_type;
            if (instance || entry.type == subfigure_type) {
                continue;
            }
            if (owners.size() > 1) {
                const int64_t part = owned_part(entry);
                for (const int64_t owner : owners) {
                    add_use(owner, part, rows_of({}, 1, 1), {}, pointer);
                }
            } else if (!result_.part_of.contains(pointer)) {
                result_.part_of[pointer] = owners.front();
            }
        }
    }
    int64_t owned_part(const Entry &entry) {
        const auto known = own_.find(entry.line);
        return known != own_.end() ? known->second : own_[entry.line] = new_part(entry);
    }
    int64_t new_part(const Entry &entry) {
        const auto name = topology_.names.find(entry.line);
        entities_.spend(size_of_a_use);
        result_.parts.push_back({name == topology_.names.end() ? std::string() : name->second});
        return result_.part_of[entry.line] = std::ssize(result_.parts) - 1;
    }

    // Shells belong to the part of their solid, and faces to that of their shell, unless a subfigure lists
    // them.
    void hand_down() {
        for (const auto *const collections : {&topology_.solids, &topology_.shells}) {
            for (const auto &[pointer, members] : *collections) {
                move(pointer);
                for (const Oriented &member : members) {
                    result_.part_of.try_emplace(member.pointer, result_.part(pointer));
                }
            }
        }
        for (const Entry &entry : directory_.entries()) {
            if (moves_others(entry.type) && entry.type != solid_type && entry.type != shell_type) {
                move(entry.line);
            }
        }
    }
    // An entity with a matrix gets a part of its own inside its present part, and the matrix places that.
    void move(int64_t pointer) {
        const Entry &entry = *directory_entry(pointer);
        if (entry.transform == 0) {
            return;
        }
        guarded(entry, [&] {
            const Placement place = entities_.placement(entry, nullptr, 1, false);
            const int64_t around = result_.part(entry.line);
            add_use(around, new_part(entry), rows_of(*place.transform, 1, factor_), {}, entry.line);
        });
    }

    void place_instances() {
        for (const Instance &instance : instances_) {
            const Entry &entry = *directory_entry(instance.pointer);
            guarded(entry, [&] { place(instance); });
        }
    }
    void place(const Instance &instance) {
        const auto subfigure = subfigures_.find(instance.target);
        const auto own = own_.find(instance.target);
        if (subfigure == subfigures_.end() && own == own_.end()) {
            fail(Status::syntax, "directory line %lld is no definition that could be read",
                 static_cast<long long>(instance.target));
        }
        const int64_t child = subfigure != subfigures_.end() ? subfigure->second : own->second;
        const auto owners = owners_.find(instance.pointer);
        if (owners == owners_.end()) {
            return add_use(first_part, child, instance.placement, instance.name, instance.pointer);
        }
        for (const int64_t owner : owners->second) {
            add_use(owner, child, instance.placement, instance.name, instance.pointer);
        }
    }
    void add_use(int64_t parent, int64_t part, const std::array<double, 12> &placement, std::string name,
                 int64_t source) {
        entities_.spend(size_of_a_use);
        result_.uses.push_back({parent, part, placement, std::move(name)});
        sources_.push_back(source);
    }

    Entities &entities_;
    const Directory &directory_;
    double factor_;
    const TopologyEntities &topology_;
    std::vector<Damage> &damages_;
    std::map<int64_t, int64_t> subfigures_;           // pointer to part
    std::map<int64_t, int64_t> collections_;          // the same, with the groups that are parts
    std::map<int64_t, std::vector<int64_t>> members_; // of subfigures and groups
    std::vector<Instance> instances_;
    std::map<int64_t, std::vector<int64_t>> owners_; // parts that list an entity
    std::map<int64_t, int64_t> own_;                 // entities that are parts of their own
    std::vector<int64_t> sources_;                   // of each use
    Assembly result_;
};

} // namespace

Assembly read_assembly(Entities &entities, double factor, const TopologyEntities &topology,
                       std::vector<Damage> &damages) {
    return AssemblyReader(entities, factor, topology, damages).read();
}

} // namespace nrb::io::iges
