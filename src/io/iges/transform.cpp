// SPDX-License-Identifier: MIT
#include "io/iges/transform.h"

#include "io/iges/types.h"

namespace nrb::io::iges {
namespace {

Transform read_matrix(Record record) {
    Transform result;
    for (size_t row = 0; row < 3; ++row) {
        for (double &value : result.r[row]) {
            value = record.real("matrix row", static_cast<int64_t>(row));
        }
        result.t[row] = record.real("translation", static_cast<int64_t>(row));
    }
    return result;
}

} // namespace

// Three products and three sums, rounded one by one: within 4 eps of the sum of the magnitudes.
std::array<double, 3> Transform::apply(const std::array<double, 3> &x) const noexcept {
    std::array<double, 3> result{};
    for (size_t i = 0; i < 3; ++i) {
        result[i] = r[i][0] * x[0] + r[i][1] * x[1] + r[i][2] * x[2] + t[i];
    }
    return result;
}

Transform compose(const Transform &outer, const Transform &inner) noexcept {
    Transform result;
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            result.r[i][j] =
                outer.r[i][0] * inner.r[0][j] + outer.r[i][1] * inner.r[1][j] + outer.r[i][2] * inner.r[2][j];
        }
    }
    result.t = outer.apply(inner.t);
    return result;
}

// Follows the pointers to the end of the chain, or to a matrix that is already resolved, whose value goes to
// `end`.
std::vector<size_t> Transforms::unresolved_chain(int64_t pointer, Resolved &end) {
    std::vector<size_t> chain;
    std::set<size_t> visited;
    while (pointer != 0) {
        const std::optional<size_t> index = directory_.find(pointer);
        if (!index || directory_.entries()[*index].type != matrix_type) {
            end.damage =
                "directory line " + std::to_string(pointer) + " is not a transformation matrix (124)";
            break;
        }
        if (const auto known = resolved_.find(*index); known != resolved_.end()) {
            end = known->second;
            break;
        }
        if (!visited.insert(*index).second) {
            end.damage = "the transformation matrix at directory line " + std::to_string(pointer) +
                         " applies to itself";
            end.reason = Status::cycle;
            break;
        }
        chain.push_back(*index);
        pointer = directory_.entries()[*index].transform;
    }
    return chain;
}

Transforms::Resolved Transforms::read_link(const Entry &entry, const Resolved &outer) {
    if (!outer.damage.empty()) {
        return outer;
    }
    const std::string place = "transformation matrix at directory line " + std::to_string(entry.line) + ": ";
    if (!entry.damage.empty()) {
        return {{}, place + entry.damage};
    }
    try {
        return {compose(outer.transform, read_matrix(data_.take(entry))), {}};
    } catch (const Error &error) {
        return {{}, place + error.what()};
    }
}

Transforms::Resolved Transforms::value_of(int64_t pointer) {
    Resolved value;
    const std::vector<size_t> chain = unresolved_chain(pointer, value);
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        value = read_link(directory_.entries()[*link], value);
        resolved_[*link] = value;
    }
    return value;
}

const Transform &Transforms::resolve(int64_t pointer) {
    const Resolved value = value_of(pointer);
    std::optional<size_t> index = directory_.find(pointer);
    while (index && asked_.insert(*index).second) {
        index = directory_.find(directory_.entries()[*index].transform);
    }
    if (!value.damage.empty()) {
        fail(Status::syntax, "%s", value.damage.c_str());
    }
    return resolved_.at(*directory_.find(pointer)).transform;
}

void Transforms::check(int64_t pointer) {
    if (const Resolved value = value_of(pointer); !value.damage.empty()) {
        fail(value.reason, "%s", value.damage.c_str());
    }
}

bool Transforms::used(size_t index) const noexcept {
    const auto found = resolved_.find(index);
    return found != resolved_.end() && found->second.damage.empty() && asked_.contains(index);
}

} // namespace nrb::io::iges
