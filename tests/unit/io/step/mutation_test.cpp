// No file makes the reader crash: a small file cut at every length, with every bit flipped, and with every byte changed to
// telling values, left out or doubled.
#include "support/step_reading.h"

namespace step_mutation_test {

namespace {

using namespace step_test;

// One of everything that the reader looks into.
const std::string &everything() {
    static const std::string text = [] {
        StepBuilder builder;
        const std::string at = builder.placement("1.,2.,3.", "0.,0.,1.", "1.,0.,0.");
        const std::string circle = builder.add("CIRCLE('\\X2\\00E9\\X0\\'," + at + ",2.)");
        const std::string plane = builder.add("PLANE(''," + at + ")");
        const std::string edge = builder.edge("3.,2.,3.", "3.,2.,3.", circle);
        const std::string face = builder.face(plane, {edge});
        const std::string arc = builder.add("TRIMMED_CURVE(''," + circle +
                                            ",(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(9.)),.T.,.PARAMETER.)");
        const std::string segment = builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + arc + ")");
        const std::string outline = builder.add("COMPOSITE_CURVE('',(" + segment + "),.F.)");
        const std::string a = builder.point("0.,0.,0."), b = builder.point("1.,0.,0.");
        builder.add("B_SPLINE_CURVE_WITH_KNOTS('',1,(" + a + "," + b + "),.U.,.F.,.F.,(2,2),(0.,1.),.U.)");
        builder.add("(B_SPLINE_CURVE(1,(" + a + "," + b +
                    "),.U.,.F.,.F.)BEZIER_CURVE()RATIONAL_B_SPLINE_CURVE((1.,2.))REPRESENTATION_ITEM('x'))");
        const std::string way = builder.vector("0.,0.,1.", "2.");
        const std::string sheet = builder.add("SURFACE_OF_LINEAR_EXTRUSION(''," + circle + "," + way + ")");
        builder.add("RECTANGULAR_TRIMMED_SURFACE(''," + sheet + ",0.,9.,0.,1.,.T.,.F.)");
        builder.add("BEZIER_SURFACE('',1,1,((" + a + "," + b + "),(" + b + "," + a + ")),.U.,.F.,.F.,.F.)");
        builder.shape(face + "," + outline, builder.context(builder.inch(), builder.degree()));
        return builder.text();
    }();
    return text;
}

// Whatever happens is a model or an Error that says something.
bool reads_or_throws(const std::string &text) {
    try {
        const nrb::model::Model document = read(text, {.unit = 0.001});
        return std::ranges::all_of(document.notes, [](const nrb::model::Note &note) {
            return note.line > 0 && !note.text.empty() && note.reason != nrb::Status::ok;
        });
    } catch (const nrb::Error &error) {
        const bool expected =
            (error.status() >= nrb::Status::format && error.status() <= nrb::Status::syntax) ||
            error.status() == nrb::Status::options;
        return expected && error.what()[0] != '\0';
    }
}

TEST(StepMutation, the_file_itself_is_good) {
    const nrb::model::Model document = read(everything());
    for (const nrb::model::Note &note : document.notes) {
        ADD_FAILURE() << note.text;
    }
    EXPECT_EQ(document.splines.size(), 7U);
    EXPECT_EQ(document.metres_per_unit, 0.0254);
}

TEST(StepMutation, every_truncation) {
    for (size_t length = 0; length + 2 < everything().size();
         ++length) { // without the last semicolon it is whole
        const Failure failure = failure_of(everything().substr(0, length));
        const bool told = failure.status == nrb::Status::truncated || failure.status == nrb::Status::syntax ||
                          (length < 12 && failure.status == nrb::Status::format);
        ASSERT_TRUE(told) << "cut at " << length << ": " << failure.text;
    }
}

TEST(StepMutation, every_bit_flipped) {
    for (size_t at = 0; at < everything().size(); ++at) {
        std::string text = everything();
        for (int bit = 0; bit < 8; ++bit) {
            text[at] = static_cast<char>(everything()[at] ^ (1 << bit));
            ASSERT_TRUE(reads_or_throws(text)) << "byte " << at << " bit " << bit;
        }
    }
}

TEST(StepMutation, every_byte_changed) {
    const std::string values("\0\xff\n(),;'#$*.9-/\\A ", 18);
    for (size_t at = 0; at < everything().size(); ++at) {
        std::string text = everything();
        for (const char value : values) {
            text[at] = value;
            ASSERT_TRUE(reads_or_throws(text)) << "byte " << at << " = " << static_cast<int>(value);
        }
    }
}

TEST(StepMutation, every_byte_left_out_or_doubled) {
    const std::string &original = everything();
    for (size_t at = 0; at < original.size(); ++at) {
        ASSERT_TRUE(reads_or_throws(original.substr(0, at) + original.substr(at + 1)))
            << "byte " << at << " left out";
        ASSERT_TRUE(reads_or_throws(original.substr(0, at + 1) + original.substr(at)))
            << "byte " << at << " doubled";
    }
}

// Every number in the data named by every reference: cycles and wrong kinds.
TEST(StepMutation, every_reference_to_everything) {
    const std::string &original = everything();
    for (size_t at = original.find("DATA;"); at != std::string::npos; at = original.find('#', at + 1)) {
        size_t end = at + 1;
        while (original[end] >= '0' && original[end] <= '9') {
            ++end;
        }
        if (original[at] != '#' || original[end] == '=') {
            continue;
        }
        for (int number = 1; number <= 60; ++number) {
            ASSERT_TRUE(
                reads_or_throws(original.substr(0, at + 1) + std::to_string(number) + original.substr(end)))
                << "#" << number << " at " << at;
        }
    }
}

} // namespace

} // namespace step_mutation_test
