// SPDX-License-Identifier: MIT
#include "io/step/write/write_contexts.h"

#include "io/step/units.h"

#include <optional>

namespace nrb::io::step {
namespace {

int64_t write_metre(ExchangeText &text, std::string_view prefix) {
    const int64_t number = text.begin_complex();
    text.part("LENGTH_UNIT");
    text.part("NAMED_UNIT", derived);
    const std::string word = "." + std::string(prefix) + ".";
    text.part("SI_UNIT", prefix.empty() ? unset : Word{word}, Word{".METRE."});
    text.end_complex();
    return number;
}

std::string_view name_of_unit(double metres) noexcept {
    struct Named {
        double metres;
        std::string_view name;
    };
    for (const Named &known : {Named{0.0254, "INCH"}, {0.3048, "FOOT"}, {0.9144, "YARD"}}) {
        if (known.metres == metres) {
            return known.name;
        }
    }
    return "UNIT OF LENGTH";
}

} // namespace

ContextWriter::ContextWriter(ExchangeText &text, double metres) : text_(text), metres_(metres) {
    write_length();
    angle_ = text_.begin_complex();
    text_.part("NAMED_UNIT", derived);
    text_.part("PLANE_ANGLE_UNIT");
    text_.part("SI_UNIT", unset, Word{".RADIAN."});
    text_.end_complex();
    solid_angle_ = text_.begin_complex();
    text_.part("NAMED_UNIT", derived);
    text_.part("SI_UNIT", unset, Word{".STERADIAN."});
    text_.part("SOLID_ANGLE_UNIT");
    text_.end_complex();
}

// A metre with a prefix, or what that is converted to.
void ContextWriter::write_length() {
    if (const std::optional<std::string_view> prefix = prefix_of(metres_)) {
        length_ = write_metre(text_, *prefix);
        return;
    }
    const int64_t metre = write_metre(text_, {});
    const int64_t factor =
        text_.add("LENGTH_MEASURE_WITH_UNIT", Measure{"LENGTH_MEASURE", metres_}, Ref{metre});
    const int64_t dimensions = text_.add("DIMENSIONAL_EXPONENTS", 1., 0., 0., 0., 0., 0., 0.);
    length_ = text_.begin_complex();
    text_.part("CONVERSION_BASED_UNIT", Text{name_of_unit(metres_)}, Ref{factor});
    text_.part("LENGTH_UNIT");
    text_.part("NAMED_UNIT", Ref{dimensions});
    text_.end_complex();
}

int64_t ContextWriter::context(double uncertainty) {
    const auto [known, fresh] = known_.try_emplace(uncertainty);
    if (!fresh) {
        return known->second;
    }
    const int64_t least[] = {text_.add("UNCERTAINTY_MEASURE_WITH_UNIT",
                                       Measure{"LENGTH_MEASURE", uncertainty}, Ref{length_},
                                       Text{"distance_accuracy_value"}, no_name)};
    const int64_t units[] = {length_, angle_, solid_angle_};
    known->second = text_.begin_complex();
    text_.part("GEOMETRIC_REPRESENTATION_CONTEXT", 3);
    text_.part("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT", Refs{least});
    text_.part("GLOBAL_UNIT_ASSIGNED_CONTEXT", Refs{units});
    text_.part("REPRESENTATION_CONTEXT", no_name, Text{"3D"});
    text_.end_complex();
    return known->second;
}

} // namespace nrb::io::step
