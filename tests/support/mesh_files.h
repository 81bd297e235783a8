// Readers of mesh files for tests, which know no more of the writers than the formats say: STL, OBJ, PLY and VTU as soups of
// triangles.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace support::mesh_files {

using Point = std::array<double, 3>;

struct Triangle {
    std::array<Point, 3> corners{}, normals{}; // of facets three times
    int64_t face = -1, part = -1;
    std::array<int, 3> colour{-1, -1, -1};
};
using Soup = std::vector<Triangle>;

inline Point minus(const Point &a, const Point &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double volume(const Soup &soup) {
    double sum = 0;
    for (const Triangle &t : soup) {
        const Point &o = soup.front().corners[0];
        sum += dot(minus(t.corners[0], o), cross(minus(t.corners[1], o), minus(t.corners[2], o))) / 6;
    }
    return sum;
}

// Sides without exactly one counterpart the other way.
inline int64_t open_sides(const Soup &soup) {
    std::map<std::pair<Point, Point>, int64_t> sides;
    for (const Triangle &t : soup) {
        for (size_t k = 0; k < 3; ++k) {
            const Point &a = t.corners[k], &b = t.corners[(k + 1) % 3];
            ++sides[{a, b}];
            --sides[{b, a}];
        }
    }
    int64_t open = 0;
    for (const auto &[side, count] : sides) {
        open += count != 0 ? 1 : 0;
    }
    return open;
}

// Numbers with the lowest byte first, one after the other.
class Bytes {
public:
    explicit Bytes(const std::string &bytes, size_t place = 0) : bytes_(bytes), place_(place) {}

    template <class T>
    T take() {
        if (place_ + sizeof(T) > bytes_.size()) {
            throw std::runtime_error("the file ends too early");
        }
        char raw[sizeof(T)];
        for (size_t i = 0; i < sizeof(T); ++i) {
            const bool little = std::endian::native == std::endian::little;
            raw[little ? i : sizeof(T) - 1 - i] = bytes_[place_ + i];
        }
        place_ += sizeof(T);
        T value;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }
    template <class T>
    Point point() {
        const T x = take<T>(), y = take<T>(), z = take<T>();
        return {x, y, z};
    }
    [[nodiscard]] size_t place() const { return place_; }
    [[nodiscard]] bool ended() const { return place_ == bytes_.size(); }

private:
    const std::string &bytes_;
    size_t place_;
};

inline void require(bool holds, const char *what) {
    if (!holds) {
        throw std::runtime_error(what);
    }
}

inline Soup read_stl(const std::string &file) {
    require(file.substr(0, 5) != "solid", "binary STL that begins as text does");
    Bytes in(file, 80);
    Soup soup(in.take<uint32_t>());
    for (Triangle &t : soup) {
        t.normals.fill(in.point<float>());
        for (Point &corner : t.corners) {
            corner = in.point<float>();
        }
        require(in.take<uint16_t>() == 0, "attributes of a facet");
    }
    require(in.ended(), "bytes behind the facets");
    return soup;
}

class Words {
public:
    explicit Words(const std::string &text) : in_(text) { in_.imbue(std::locale::classic()); }
    std::string next() {
        std::string word;
        require(static_cast<bool>(in_ >> word), "the text ends too early");
        return word;
    }
    void expect(const char *word) { require(next() == word, word); }
    Point point() {
        Point x{};
        for (double &value : x) {
            value = std::strtod(next().c_str(), nullptr);
        }
        return x;
    }
    bool ended() { return (in_ >> std::ws).eof(); }

private:
    std::istringstream in_;
};

inline Soup read_stl_text(const std::string &file) {
    Words in(file);
    Soup soup;
    in.expect("solid");
    in.next();
    for (std::string word = in.next(); word == "facet"; word = in.next()) {
        Triangle t;
        in.expect("normal");
        t.normals.fill(in.point());
        in.expect("outer");
        in.expect("loop");
        for (Point &corner : t.corners) {
            in.expect("vertex");
            corner = in.point();
        }
        in.expect("endloop");
        in.expect("endfacet");
        soup.push_back(t);
    }
    in.next();
    require(in.ended(), "words behind endsolid");
    return soup;
}

struct Obj {
    Soup soup; // faces and parts counted by groups and objects
    std::vector<std::string> objects, groups, materials;
    size_t points = 0;
};

inline Obj read_obj(const std::string &file) {
    Obj obj;
    std::vector<Point> points, normals;
    std::istringstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        Words in(line);
        const std::string word = line.empty() || line[0] == '#' ? "#" : in.next();
        if (word == "v") {
            points.push_back(in.point());
        } else if (word == "vn") {
            normals.push_back(in.point());
        } else if (word == "o") {
            obj.objects.push_back(in.next());
        } else if (word == "g") {
            obj.groups.push_back(in.next());
        } else if (word == "usemtl") {
            obj.materials.push_back(in.next());
        } else if (word == "f") {
            Triangle t;
            for (size_t k = 0; k < 3; ++k) {
                const std::string corner = in.next();
                const size_t slash = corner.find("//");
                t.corners[k] = points.at(std::stoul(corner) - 1);
                t.normals[k] = normals.at(std::stoul(corner.substr(slash + 2)) - 1);
            }
            t.face = std::ssize(obj.groups) - 1;
            t.part = std::ssize(obj.objects) - 1;
            obj.soup.push_back(t);
        } else {
            require(word == "#", "a line of an unknown kind");
        }
        require(word == "#" || in.ended(), "more in a line");
    }
    obj.points = points.size();
    return obj;
}

// In the order in which the header has the properties.
inline Soup read_ply(const std::string &file) {
    const std::string end = "end_header\n";
    const size_t start = file.find(end) + end.size();
    Words head(file.substr(0, start));
    head.expect("ply");
    head.expect("format");
    head.expect("binary_little_endian");
    std::string word;
    std::vector<std::string> elements;
    std::vector<size_t> counts;
    std::vector<std::vector<std::pair<std::string, std::string>>> properties; // name and type
    while ((word = head.next()) != "end_header") {
        if (word == "element") {
            elements.push_back(head.next());
            counts.push_back(std::stoul(head.next()));
            properties.emplace_back();
        } else if (word == "property") {
            std::string type = head.next();
            if (type == "list") {
                head.expect("uchar");
                head.expect("int");
            }
            properties.back().emplace_back(head.next(), type);
        }
    }
    require(elements == std::vector<std::string>{"vertex", "face"}, "elements");
    Bytes in(file, start);
    std::vector<std::map<std::string, double>> vertices(counts[0]);
    const auto number = [&in](const std::string &type) -> double {
        return type == "double"  ? in.take<double>()
               : type == "float" ? double{in.take<float>()}
               : type == "int"   ? double{static_cast<double>(in.take<int32_t>())}
                                 : double{static_cast<double>(in.take<uint8_t>())};
    };
    for (auto &vertex : vertices) {
        for (const auto &[name, type] : properties[0]) {
            vertex[name] = number(type);
        }
    }
    require(properties[1].size() == 1, "properties of faces");
    Soup soup(counts[1]);
    for (Triangle &t : soup) {
        require(in.take<uint8_t>() == 3, "corners of a triangle");
        for (size_t k = 0; k < 3; ++k) {
            auto &vertex = vertices.at(static_cast<size_t>(in.take<int32_t>()));
            t.corners[k] = {vertex.at("x"), vertex.at("y"), vertex.at("z")};
            t.normals[k] = {vertex.at("nx"), vertex.at("ny"), vertex.at("nz")};
            const auto face = static_cast<int64_t>(vertex.at("face_number"));
            require(k == 0 || face == t.face, "a triangle of one face");
            t.face = face;
            if (vertex.count("red") == 1) {
                t.colour = {static_cast<int>(vertex["red"]), static_cast<int>(vertex["green"]),
                            static_cast<int>(vertex["blue"])};
            }
        }
    }
    require(in.ended(), "bytes behind the faces");
    return soup;
}

// An element of VTK's XML, up to its '>'.
struct Tag {
    std::string name;
    std::map<std::string, std::string> attributes;
};

inline std::vector<Tag> read_tags(const std::string &text) {
    std::vector<Tag> tags;
    for (size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::string inside = text.substr(at + 1, text.find('>', at) - at - 1);
        Tag tag;
        size_t place = inside.find_first_of(" /", 1);
        tag.name = inside.substr(0, place);
        while ((place = inside.find('=', place)) != std::string::npos) {
            const size_t name = inside.rfind(' ', place) + 1, close = inside.find('"', place + 2);
            tag.attributes[inside.substr(name, place - name)] = inside.substr(place + 2, close - place - 2);
            place = close;
        }
        tags.push_back(tag);
    }
    return tags;
}

struct Vtu {
    std::map<std::string, std::vector<double>> arrays;
    std::map<std::string, std::map<std::string, std::string>> sections; // their attributes
    size_t points = 0, cells = 0;
};

inline Vtu read_vtu(const std::string &file) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const size_t start = file.find(mark) + mark.size();
    Vtu vtu;
    size_t end = start;
    for (const Tag &tag : read_tags(file.substr(0, start - 1))) {
        vtu.sections[tag.name] = tag.attributes;
        if (tag.name == "Piece") {
            vtu.points = std::stoul(tag.attributes.at("NumberOfPoints"));
            vtu.cells = std::stoul(tag.attributes.at("NumberOfCells"));
        }
        if (tag.name != "DataArray") {
            continue;
        }
        require(tag.attributes.at("format") == "appended", "an array that is not appended");
        Bytes in(file, start + std::stoul(tag.attributes.at("offset")));
        require(in.place() == end, "a gap between arrays");
        const auto size = in.take<uint64_t>();
        const std::string type = tag.attributes.at("type");
        std::vector<double> &values = vtu.arrays[tag.attributes.at("Name")];
        for (end = in.place() + size; in.place() < end;) {
            values.push_back(type == "Float64"   ? in.take<double>()
                             : type == "Float32" ? double{in.take<float>()}
                             : type == "Int64"   ? static_cast<double>(in.take<int64_t>())
                             : type == "Int32"   ? static_cast<double>(in.take<int32_t>())
                                                 : static_cast<double>(in.take<uint8_t>()));
        }
    }
    require(file.substr(end) == "\n</AppendedData>\n</VTKFile>\n", "the end of the file");
    return vtu;
}

inline Soup triangles_of(const Vtu &vtu) {
    Soup soup(vtu.cells);
    const auto row = [](const std::vector<double> &values, size_t i) {
        return Point{values.at(3 * i), values.at(3 * i + 1), values.at(3 * i + 2)};
    };
    for (size_t i = 0; i < soup.size(); ++i) {
        Triangle &t = soup[i];
        require(vtu.arrays.at("types").at(i) == 5 &&
                    vtu.arrays.at("offsets").at(i) == 3 * (static_cast<double>(i) + 1),
                "cells that are no triangles");
        for (size_t k = 0; k < 3; ++k) {
            const auto vertex = static_cast<size_t>(vtu.arrays.at("connectivity").at(3 * i + k));
            t.corners[k] = row(vtu.arrays.at("Points"), vertex);
            t.normals[k] = row(vtu.arrays.at("normals"), vertex);
        }
        t.face = static_cast<int64_t>(vtu.arrays.at("face").at(i));
        t.part = static_cast<int64_t>(vtu.arrays.at("part").at(i));
        if (vtu.arrays.count("colour") == 1) {
            const Point colour = row(vtu.arrays.at("colour"), i);
            t.colour = {static_cast<int>(colour[0]), static_cast<int>(colour[1]),
                        static_cast<int>(colour[2])};
        }
    }
    return soup;
}

} // namespace support::mesh_files
