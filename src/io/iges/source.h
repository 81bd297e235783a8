// SPDX-License-Identifier: MIT
// A file as its readers see it: directory, names, shapes within limits, and notes.
#pragma once

#include "base/watch.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/read_settings.h"
#include "model/model.h"

#include <span>
#include <string>

namespace nrb::io::iges {

class Source {
public:
    // Throws Status::options for a unit that cannot be reached. The sections must outlive this.
    Source(std::span<const char> bytes, const Sections &sections, const Global &global,
           const ReadSettings &settings);
    Source(const Source &) = delete;
    Source &operator=(const Source &) = delete;

protected:
    // Calls read(entry) for every entry that is not damaged; what it throws becomes a note.
    template <class Read>
    void read_all(Read &&read) {
        Steps steps(std::ssize(directory_.entries()));
        for (const Entry &entry : directory_.entries()) {
            try {
                check(entry);
                read(entry);
            } catch (const Error &error) {
                note_error(entry, error);
            }
            steps.next(work_of_an_entity);
        }
    }

    // With the label of the entity before the text.
    void tell(const Entry &entry, Status reason, const std::string &text);
    // The same, unless the message begins with it.
    void note_error(const Entry &entry, const Error &error);
    // The text begins with the label.
    void add_note(int64_t pointer, Status reason, std::string text);
    // The model with its notes in the order of the directory, but for those on what has become part of something: matrices and
    // names.
    model::Model finished();

    Directory directory_;
    ParameterData data_;
    Transforms transforms_;
    Names names_;
    Entities entities_;
    Geometry geometry_;
    model::Model model_;

private:
    static constexpr int64_t work_of_an_entity = 1000; // beyond what its parameters count
    static void check(const Entry &entry);
    [[nodiscard]] bool used(const model::Note &note) const noexcept;
};

} // namespace nrb::io::iges
