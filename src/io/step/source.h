// SPDX-License-Identifier: MIT
// A file as its readers see it: units, names, notes, and the curves and surfaces that belong to no face.
#pragma once

#include "base/watch.h"
#include "io/read_settings.h"
#include "io/step/contexts.h"
#include "io/step/geometry/geometry.h"
#include "io/step/layers.h"
#include "io/step/structure/exchange.h"
#include "model/model.h"
#include "model/shapes/surface_spline.h"

#include <string>
#include <vector>

namespace nrb::io::step {

class Source {
public:
    // Throws Status::format for schemas of other kinds, options for a unit that cannot be reached. The file must outlive this.
    Source(const Exchange &file, const ReadSettings &settings);

protected:
    // Calls add(place) for the instances that are wanted; what it throws becomes a note.
    template <class Wants, class Add>
    void read_all(Wants &&wants, Add &&add) {
        Steps steps(instances_.size());
        for (int64_t place = 0; place < instances_.size(); ++place) {
            const bool wanted = wants(place);
            if (wanted) {
                try {
                    add(place);
                } catch (const Error &error) {
                    note_error(instances_[place], error);
                }
            }
            steps.next(wanted ? work_of_an_entity : 1);
        }
    }
    [[nodiscard]] bool is(int64_t place, Kind kind) const noexcept {
        return instances_[place].kind() == kind;
    }

    // The measures of what stands at a place, as factors to the unit of the model.
    [[nodiscard]] Units units_of(int64_t place) const;

    // What make() returns. Splines count before they are kept, whoever shares their points.
    template <class Make>
    SplinePtr made(const Instance &instance, Make &&make) {
        return naming(instances_, instance, [&] {
            entities_.spend(Entities::size_of_a_shape);
            SplinePtr spline = make();
            entities_.spend(spline->point_count() * spline->width());
            return spline;
        });
    }
    template <class Make>
    SplinePtr made_surface(const Instance &instance, Make &&make) {
        double distance = 0;
        SplinePtr spline = made(instance, [&] {
            model::MadeSurface surface = make();
            distance = surface.distance;
            return surface.spline;
        });
        note_approximation(instance, distance, units_of(instances_.find(instance.number())).tolerance);
        return spline;
    }

    // The curves and surfaces that nothing else is made of.
    std::vector<model::NamedSpline> free_splines(const Layers &layers);

    // What shapes consist of and is not read, and, if they are not, where parts are placed.
    void note_items(bool placements_read);
    void note_unread(const Instance &instance, const char *what);
    // With the label of the instance, unless the message begins with it.
    void note_error(const Instance &instance, const Error &error);
    // Of a surface that is so far from the one of the file, unless that is 0; `stated`: the tolerance of that.
    void note_approximation(const Instance &instance, double distance, double stated);
    void add_note(int64_t number, Status reason, const char *text);
    // The model with its notes in the order of their instances.
    model::Model finished();

    const Instances &instances_;
    Entities entities_;
    ReadSettings settings_;
    Contexts contexts_;
    std::vector<bool> part_; // find_parts()
    model::Model model_;

private:
    static constexpr int64_t work_of_an_entity = 1000; // beyond what its numbers count
    void note_item(const Instance &owner, int64_t number);

    double tolerance_; // 0: those of the contexts
};

} // namespace nrb::io::step
