// SPDX-License-Identifier: MIT
// What the readers of a file share: directory, names, shapes within limits, and notes.
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
    // Throws Status::options for a unit that cannot be converted to. The sections must outlive this object.
    Source(std::span<const char> bytes, const Sections &sections, const Global &global,
           const ReadSettings &settings);
    Source(const Source &) = delete;
    Source &operator=(const Source &) = delete;

protected:
    // Calls read(entry) for the wanted entries that are not damaged; errors it throws become notes.
    template <class Wants, class Read>
    void read_all(Wants &&wants, Read &&read) {
        Steps steps(std::ssize(directory_.entries()));
        for (const Entry &entry : directory_.entries()) {
            const bool wanted = wants(entry);
            if (wanted) {
                try {
                    check(entry);
                    read(entry);
                } catch (const Error &error) {
                    note_error(entry, error);
                }
            }
            steps.next(wanted ? work_of_an_entity : 1);
        }
    }
    [[nodiscard]] size_t index_of(const Entry &entry) const noexcept {
        return static_cast<size_t>(&entry - directory_.entries().data());
    }

    // Adds a note, with the label of the entity before the text.
    void tell(const Entry &entry, Status reason, const std::string &text);
    // Adds a note on the distance of a spline from an offset surface, unless that is 0.
    void tell_approximation(const Entry &entry, double distance);
    // Adds a note on an error, with the label unless the message begins with it.
    void note_error(const Entry &entry, const Error &error);
    // Adds a note whose text begins with the label.
    void add_note(int64_t pointer, Status reason, std::string text);
    // The model with its notes in the order of the directory. Includes notes on shapes that could not be made
    // exactly; excludes those on matrices and names that have been used.
    model::Model finished();

    Directory directory_;
    ParameterData data_;
    Transforms transforms_;
    Names names_;
    Entities entities_;
    Geometry geometry_;
    model::Model model_;
    ReadSettings settings_;

private:
    static constexpr int64_t work_of_an_entity = 1000; // beyond what is counted for its parameters
    static void check(const Entry &entry);
    [[nodiscard]] bool used(const model::Note &note) const noexcept;
};

} // namespace nrb::io::iges
