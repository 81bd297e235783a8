// SPDX-License-Identifier: MIT
#include "io/iges/write/write_assembly.h"

#include "base/error.h"
#include "io/iges/text.h"
#include "io/iges/types.h"
#include "io/written/index_of_error.h"
#include "io/written/similarity.h"
#include "model/placing.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace nrb::io::iges {
namespace {

// x -> R (s x + T), which readers evaluate by multiplying the matrix R with the scale s.
struct Stated {
    std::array<double, 12> rows; // R and T
    double scale;
};

// A scale computed from a matrix is rounded to 12 digits, which restores a scale with no more digits than
// that.
double stated_scale(double size) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, size, std::chars_format::scientific, 11);
    double rounded = size;
    std::from_chars(digits, end.ptr, rounded);
    return is_one(rounded) ? 1 : rounded;
}

// The matrix divided by its scale; a mere translation needs no matrix.
Stated stated(const std::array<double, 12> &placement, double size) {
    Stated result{placement, stated_scale(size)};
    for (size_t i = 0; i < 12; ++i) {
        if (i % 4 != 3) {
            result.rows[i] = placement[i] / result.scale;
        }
    }
    return result;
}
bool only_moves(const std::array<double, 12> &rows) noexcept {
    return rows[0] == 1 && rows[5] == 1 && rows[10] == 1 && rows[1] == 0 && rows[2] == 0 && rows[4] == 0 &&
           rows[6] == 0 && rows[8] == 0 && rows[9] == 0;
}

} // namespace

bool first_is_whole(const model::Model &model) {
    if (model.parts.empty()) {
        return true;
    }
    const auto of_first =
        std::ranges::count_if(model.uses, [](const model::Use &use) { return use.part == 0; });
    return of_first <= 1 && std::ranges::none_of(model.uses, [](const model::Use &use) {
               return use.part == 0 && (use.parent >= 0 || !is_identity(use.placement) || !use.name.empty());
           });
}

AssemblyWriter::AssemblyWriter(GeometryWriter &geometry, const model::Model &model,
                               std::vector<std::vector<int64_t>> items)
    : geometry_(geometry), text_(geometry.text()), model_(model), items_(std::move(items)),
      first_(first_is_whole(model) ? 1 : 0) {}

void AssemblyWriter::run() {
    std::vector<model::Use> uses = model_.uses;
    model::place_the_rest(model_.parts.size(), uses);
    find_depths(uses);
    first_pointer_ = text_.reserve(std::ssize(items_) - first_);
    for (size_t i = 0; i < uses.size(); ++i) {
        if (!is_whole(uses[i].part)) {
            named("uses", i, [&] { place(uses[i]); });
        }
    }
    for (int64_t i = first_; i < std::ssize(items_); ++i) {
        write_subfigure(i);
    }
}

void AssemblyWriter::place(const model::Use &use) {
    const double size = scale_of(columns_of(use.placement));
    if (size == 0) {
        fail(Status::matrix, "its placement is no similarity, which IGES needs");
    }
    const auto [rows, scale] = stated(use.placement, std::fabs(size));
    const bool moves = only_moves(rows), inside = !is_whole(use.parent);
    const int64_t turned = moves ? 0 : geometry_.matrix(rows);
    const double length = moves ? geometry_.length() : 0;
    const int64_t number =
        text_.begin({subfigure_instance_type, 0, inside ? dependent : independent, 0, turned});
    text_.put(pointer(use.part), length * rows[3], length * rows[7], length * rows[11], scale);
    text_.end_named(use.name);
    if (inside) {
        items_[static_cast<size_t>(use.parent)].push_back(number);
    }
}

// Sets how deeply subfigures are nested in each part: 0 for a part without others. Proceeds from the
// innermost parts outwards.
void AssemblyWriter::find_depths(const std::vector<model::Use> &uses) {
    depths_.assign(items_.size(), 0);
    std::vector<std::vector<int64_t>> parents(items_.size());
    std::vector<int64_t> waiting(items_.size(), 0); // uses in a part that are not counted yet
    for (const model::Use &use : uses) {
        if (use.parent >= 0) {
            parents[static_cast<size_t>(use.part)].push_back(use.parent);
            ++waiting[static_cast<size_t>(use.parent)];
        }
    }
    std::vector<size_t> ready;
    for (size_t i = 0; i < items_.size(); ++i) {
        if (waiting[i] == 0) {
            ready.push_back(i);
        }
    }
    while (!ready.empty()) {
        const size_t part = ready.back();
        ready.pop_back();
        for (const int64_t above : parents[part]) {
            const auto parent = static_cast<size_t>(above);
            depths_[parent] = std::max(depths_[parent], depths_[part] + 1);
            if (--waiting[parent] == 0) {
                ready.push_back(parent);
            }
        }
    }
}

void AssemblyWriter::write_subfigure(int64_t part) {
    const auto index = static_cast<size_t>(part);
    text_.begin(pointer(part), {subfigure_type, 0, definition});
    const std::string name = printable(trim(model_.parts[index].name));
    text_.put(depths_[index], std::string_view(name));
    text_.put_list(items_[index]);
    text_.end();
}

} // namespace nrb::io::iges
