// Writes small STEP files for tests: instances are numbered as they are added, and named by what add() returns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace step_test {

class StepBuilder {
public:
    // Adds an instance, and returns its name, such as "#3".
    std::string add(const std::string &entity) {
        instances_.push_back(next() + "=" + entity + ";");
        return "#" + std::to_string(instances_.size());
    }

    // The name that the next instance will have.
    [[nodiscard]] std::string next() const { return "#" + std::to_string(instances_.size() + 1); }

    // Coordinates as they stand in the file: "1.,2.,3.".
    std::string point(const std::string &coordinates) {
        return add("CARTESIAN_POINT('',(" + coordinates + "))");
    }
    std::string direction(const std::string &ratios) { return add("DIRECTION('',(" + ratios + "))"); }
    std::string vector(const std::string &ratios, const std::string &magnitude) {
        const std::string way = direction(ratios);
        return add("VECTOR(''," + way + "," + magnitude + ")");
    }
    std::string placement(const std::string &origin, const std::string &axis, const std::string &x) {
        const std::string o = point(origin), z = direction(axis), r = direction(x);
        return add("AXIS2_PLACEMENT_3D(''," + o + "," + z + "," + r + ")");
    }
    // At (1, 2, 3), with X along y and Z along x.
    std::string some_placement() { return placement("1.,2.,3.", "1.,0.,0.", "0.,1.,0."); }

    std::string vertex(const std::string &coordinates) {
        const std::string at = point(coordinates);
        return add("VERTEX_POINT(''," + at + ")");
    }
    std::string edge(const std::string &start, const std::string &end, const std::string &curve,
                     const std::string &sense = ".T.") {
        const std::string first = vertex(start), last = start == end ? first : vertex(end);
        return add("EDGE_CURVE(''," + first + "," + last + "," + curve + "," + sense + ")");
    }
    std::string straight_edge(const std::string &start, const std::string &end, const std::string &way) {
        const std::string from = point(start), along = vector(way, "1.");
        return edge(start, end, add("LINE(''," + from + "," + along + ")"));
    }
    // A face with one loop of edges.
    std::string face(const std::string &surface, const std::vector<std::string> &edges,
                     const std::string &name = "") {
        std::string loop;
        for (const std::string &edge : edges) {
            loop += (loop.empty() ? "" : ",") + add("ORIENTED_EDGE('',*,*," + edge + ",.T.)");
        }
        loop = add("EDGE_LOOP('',(" + loop + "))");
        const std::string bound = add("FACE_OUTER_BOUND(''," + loop + ",.T.)");
        return add("ADVANCED_FACE('" + name + "',(" + bound + ")," + surface + ",.T.)");
    }

    // A context of these units, and a representation of items in it.
    std::string context(const std::string &length, const std::string &angle) {
        return add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," +
                   angle + "))REPRESENTATION_CONTEXT('',''))");
    }
    std::string millimetre() { return add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"); }
    std::string metre() { return add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))"); }
    std::string radian() { return add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))"); }
    std::string inch() {
        const std::string factor = add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)," + millimetre() + ")");
        return add("(CONVERSION_BASED_UNIT('INCH'," + factor + ")LENGTH_UNIT()NAMED_UNIT(*))");
    }
    std::string degree() {
        const std::string factor =
            add("PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925199)," + radian() + ")");
        return add("(CONVERSION_BASED_UNIT('DEGREE'," + factor + ")NAMED_UNIT(*)PLANE_ANGLE_UNIT())");
    }
    std::string shape(const std::string &items, const std::string &context) {
        return add("SHAPE_REPRESENTATION('',(" + items + ")," + context + ")");
    }

    [[nodiscard]] std::string data() const {
        std::string text;
        for (const std::string &instance : instances_) {
            text += instance + "\n";
        }
        return text;
    }
    [[nodiscard]] std::string text() const { return around(data()); }

    // The rest of a file around a data section.
    static std::string around(const std::string &data, const std::string &schema = "AUTOMOTIVE_DESIGN") {
        return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','',(''),(''),'','','');"
               "\n"
               "FILE_SCHEMA(('" +
               schema + "'));\nENDSEC;\nDATA;\n" + data + "ENDSEC;\nEND-ISO-10303-21;\n";
    }

private:
    std::vector<std::string> instances_;
};

} // namespace step_test
