// SPDX-License-Identifier: MIT
#include "io/iges/source.h"

#include "io/faces/make_face.h"
#include "io/unit_factor.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

Units units_of(const Global &global, const ReadSettings &settings) {
    const double factor = unit_factor(global.metres_per_unit, settings);
    return {factor, settings.tolerance > 0 ? settings.tolerance : factor * global.resolution,
            global.all_digits};
}

} // namespace

Source::Source(std::span<const char> bytes, const Sections &sections, const Global &global,
               const ReadSettings &settings)
    : directory_(sections.directory), data_(sections.parameter, global.delimiters),
      transforms_(directory_, data_), names_(directory_, data_),
      entities_(bytes.size(), directory_, data_, transforms_, names_),
      geometry_(entities_, units_of(global, settings)), settings_(settings) {
    entities_.share_among(std::ranges::count(directory_.entries(), int{offset_surface_type}, &Entry::type));
    model_.metres_per_unit = settings.unit > 0 ? settings.unit : global.metres_per_unit;
}

void Source::check(const Entry &entry) {
    if (!entry.damage.empty()) {
        fail(Status::syntax, "%s", entry.damage.c_str());
    }
}

void Source::tell(const Entry &entry, Status reason, const std::string &text) {
    add_note(entry.line, reason, label_of(entry) + text);
}

void Source::tell_approximation(const Entry &entry, double distance) {
    if (distance > 0) {
        tell(entry, Status::tolerance, note_on_surface(distance, geometry_.units().resolution));
    }
}

void Source::note_error(const Entry &entry, const Error &error) {
    const std::string label = label_of(entry), text = error.what();
    add_note(entry.line, error.status(), text.starts_with(label) ? text : label + text);
}

void Source::add_note(int64_t pointer, Status reason, std::string text) {
    const std::optional<size_t> index = directory_.find(pointer);
    const int type = index ? directory_.entries()[*index].type : 0;
    model_.notes.push_back({type, pointer, reason, std::move(text)});
}

// Which entities have been used is known only at the end.
bool Source::used(const model::Note &note) const noexcept {
    const std::optional<size_t> index = directory_.find(note.line);
    return index && (transforms_.used(*index) || names_.used(*index));
}

model::Model Source::finished() {
    for (const Remark &remark : geometry_.remarks()) {
        tell(directory_.entries()[*directory_.find(remark.pointer)], remark.reason, remark.text);
    }
    std::erase_if(model_.notes, [this](const model::Note &note) { return used(note); });
    std::ranges::stable_sort(model_.notes, {}, &model::Note::line);
    return std::move(model_);
}

} // namespace nrb::io::iges
