// SPDX-License-Identifier: MIT
#include "io/mesh_formats/vtu.h"

#include <string_view>

namespace nrb::io::vtu {

namespace {

struct TypeInfo {
    std::string_view name;
    int64_t size;
};

TypeInfo info_of(NumberType type) noexcept {
    constexpr TypeInfo all[] = {{"UInt8", 1}, {"Int32", 4}, {"Int64", 8}, {"Float32", 4}, {"Float64", 8}};
    return all[static_cast<size_t>(type)];
}

int64_t bytes_of(const Array &array) noexcept {
    return array.rows * array.components * info_of(array.type).size;
}

// Writes the sections of the XML, which say for each array where its bytes are in the data after the XML, and
// then the arrays in the same order.
class Sections {
public:
    explicit Sections(Blocks &out) : out_(out) {}

    void section(std::string_view name, const std::vector<const Array *> &arrays) {
        out_.text("<");
        out_.text(name);
        for (const Array *array : arrays) {
            if (!array->role.empty()) {
                attribute(array->role, array->name);
            }
        }
        out_.text(">\n");
        for (const Array *array : arrays) {
            add(*array);
        }
        out_.text("</");
        out_.text(name);
        out_.text(">\n");
    }

    // Writes each array after its length in bytes.
    void write_arrays() const {
        for (const Array *array : all_) {
            out_.bytes(static_cast<uint64_t>(bytes_of(*array)));
            array->write(out_);
        }
    }

private:
    void attribute(std::string_view name, std::string_view value) {
        for (const std::string_view part :
             {std::string_view(" "), name, std::string_view("=\""), value, std::string_view("\"")}) {
            out_.text(part);
        }
    }
    void attribute(std::string_view name, int64_t value) {
        out_.text(" ");
        out_.text(name);
        out_.text("=\"");
        out_.digits(value);
        out_.text("\"");
    }
    void add(const Array &array) {
        out_.text("<DataArray");
        attribute("type", info_of(array.type).name);
        attribute("Name", array.name);
        attribute("NumberOfComponents", array.components);
        attribute("format", "appended");
        attribute("offset", place_);
        out_.text("/>\n");
        place_ += static_cast<int64_t>(sizeof(uint64_t)) + bytes_of(array);
        all_.push_back(&array);
    }

    Blocks &out_;
    std::vector<const Array *> all_;
    int64_t place_ = 0;
};

std::vector<const Array *> pointers_to(const std::vector<Array> &arrays) {
    std::vector<const Array *> pointers;
    pointers.reserve(arrays.size());
    for (const Array &array : arrays) {
        pointers.push_back(&array);
    }
    return pointers;
}

void write_head(const Grid &grid, Blocks &out) {
    out.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"");
    out.text(grid.higher_order ? "2.2" : "1.0");
    out.text("\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
             "<Piece NumberOfPoints=\"");
    out.digits(grid.points.rows);
    out.text("\" NumberOfCells=\"");
    out.digits(grid.types.rows);
    out.text("\">\n");
}

} // namespace

Array even_offsets(int64_t cells, int64_t points_each) {
    const auto write = [=](Blocks &out) {
        for (int64_t i = 1; i <= cells; ++i) {
            out.bytes(i * points_each);
        }
    };
    return {"offsets", NumberType::int64, 1, cells, write};
}

Array even_types(int64_t cells, uint8_t type) {
    const auto write = [=](Blocks &out) {
        for (int64_t i = 0; i < cells; ++i) {
            out.bytes(type);
        }
    };
    return {"types", NumberType::uint8, 1, cells, write};
}

void write(const Grid &grid, Blocks &out) {
    write_head(grid, out);
    Sections sections(out);
    sections.section("PointData", pointers_to(grid.point_data));
    sections.section("CellData", pointers_to(grid.cell_data));
    sections.section("Points", {&grid.points});
    sections.section("Cells", {&grid.connectivity, &grid.offsets, &grid.types});
    out.text("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    sections.write_arrays();
    out.text("\n</AppendedData>\n</VTKFile>\n");
}

} // namespace nrb::io::vtu
