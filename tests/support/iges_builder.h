// Writes small IGES files for tests: a directory of entities with their parameter data, and a global section
// of which single parameters can be changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace iges_test {

// The fields of a directory entry that tests vary.
struct Fields {
    int64_t transform = 0;
    std::string status = "00000000";
    int64_t form = 0;
    std::string label = "";
    int64_t subscript = 0;
    int64_t colour = 0;
    int64_t level = 0;
};

class IgesBuilder {
public:
    // Adds an entity whose parameters, without the type, are `data`; the result is its directory line.
    int64_t add(int type, const std::string &data, const Fields &fields = {}) {
        entities_.push_back({type, data, fields});
        return 2 * static_cast<int64_t>(entities_.size()) - 1;
    }

    // The directory line that the next added entity will have.
    [[nodiscard]] int64_t next() const { return 2 * static_cast<int64_t>(entities_.size()) + 1; }

    // Changes parameter `index` (from 1) of the global section to `text`, as it stands in the file.
    IgesBuilder &global(size_t index, const std::string &text) {
        globals_[index] = text;
        return *this;
    }

    // Other delimiters than comma and semicolon; entities' data still use commas and must have them nowhere
    // else.
    IgesBuilder &delimiters(char parameter, char record) {
        parameter_ = parameter;
        record_ = record;
        return global(1, std::string("1H") + parameter).global(2, std::string("1H") + record);
    }

    // The lines of the file, without line ends.
    [[nodiscard]] std::vector<std::string> lines() const {
        std::vector<std::string> result = {section_line("a test file", 'S', 1)};
        append_global(result);
        const size_t before_directory = result.size();
        append_entities(result);
        append_terminate(result, before_directory);
        return result;
    }

    [[nodiscard]] std::string text(const std::string &line_end = "\n") const {
        return join(lines(), line_end);
    }

    static std::string join(const std::vector<std::string> &lines, const std::string &line_end = "\n") {
        std::string result;
        for (const std::string &line : lines) {
            result += line + line_end;
        }
        return result;
    }

    // 72 columns of text, a section letter and a sequence number of seven digits.
    static std::string section_line(std::string text, char section, size_t sequence) {
        text.resize(72, ' ');
        return text + section + padded(static_cast<int64_t>(sequence), 7, '0');
    }

    static std::string padded(int64_t value, size_t width, char fill = ' ') {
        return padded(std::to_string(value), width, fill);
    }
    static std::string padded(const std::string &text, size_t width, char fill = ' ') {
        return text.size() >= width ? text : std::string(width - text.size(), fill) + text;
    }

private:
    struct Entity {
        int type;
        std::string data;
        Fields fields;
    };

    // Parameters up to the unit's name; millimetres.
    void append_global(std::vector<std::string> &result) const {
        std::vector<std::string> parameters = {
            "",     "",      "4Htest", "5Ha.igs", "1Hs", "1Hp",  "32", "38",  "6",
            "308",  "15",    "4Htest", "1.0",     "2",   "2HMM", "1",  "0.1", "15H20200101.000000",
            "1e-7", "1000.0"};
        for (const auto &[index, text] : globals_) {
            parameters.at(index - 1) = text;
        }
        std::string text;
        for (size_t i = 0; i < parameters.size(); ++i) {
            text += (i == 0 ? std::string() : std::string(1, parameter_)) + parameters[i];
        }
        append_section(result, text + record_, 72, 'G');
    }

    static void append_section(std::vector<std::string> &result, const std::string &text, size_t width,
                               char section) {
        for (size_t at = 0, sequence = 1; at < text.size(); at += width, ++sequence) {
            result.push_back(section_line(text.substr(at, width), section, sequence));
        }
    }

    // Longest start of `text` that ends behind a parameter delimiter within 64 columns; 64 if there is none.
    [[nodiscard]] size_t line_length(const std::string &text) const {
        constexpr size_t width = 64;
        if (text.size() <= width) {
            return text.size();
        }
        const size_t delimiter = text.rfind(parameter_, width - 1);
        return delimiter == std::string::npos ? width : delimiter + 1;
    }

    [[nodiscard]] std::vector<std::string> data_lines(const Entity &entity) const {
        std::string text = std::to_string(entity.type) + "," + entity.data;
        for (char &c : text) {
            c = c == ',' ? parameter_ : c;
        }
        text += record_;
        std::vector<std::string> result;
        while (!text.empty()) {
            const size_t length = line_length(text);
            result.push_back(text.substr(0, length));
            text.erase(0, length);
        }
        return result;
    }

    void append_entities(std::vector<std::string> &result) const {
        std::vector<std::string> data;
        size_t line = 1;
        for (const Entity &entity : entities_) {
            std::vector<std::string> own = data_lines(entity);
            append_directory(result, entity, data.size() + 1, own.size(), line);
            for (std::string &text : own) {
                text.resize(64, ' ');
                text += padded(static_cast<int64_t>(line), 8);
                data.push_back(section_line(text, 'P', data.size() + 1));
            }
            line += 2;
        }
        result.insert(result.end(), data.begin(), data.end());
    }

    static void append_directory(std::vector<std::string> &result, const Entity &entity, size_t data_line,
                                 size_t data_count, size_t line) {
        const Fields &fields = entity.fields;
        const std::string type = padded(entity.type, 8);
        const std::string zero = padded(0, 8);
        result.push_back(section_line(type + padded(static_cast<int64_t>(data_line), 8) + zero + zero +
                                          padded(fields.level, 8) + zero + padded(fields.transform, 8) +
                                          zero + padded(fields.status, 8),
                                      'D', line));
        result.push_back(section_line(type + zero + padded(fields.colour, 8) +
                                          padded(static_cast<int64_t>(data_count), 8) +
                                          padded(fields.form, 8) + std::string(16, ' ') +
                                          padded(fields.label, 8) + padded(fields.subscript, 8),
                                      'D', line + 1));
    }

    void append_terminate(std::vector<std::string> &result, size_t before_directory) const {
        const auto directory = static_cast<int64_t>(2 * entities_.size());
        const auto parameters = static_cast<int64_t>(result.size() - before_directory) - directory;
        const auto globals = static_cast<int64_t>(before_directory) - 1;
        result.push_back(section_line("S0000001G" + padded(globals, 7, '0') + "D" +
                                          padded(directory, 7, '0') + "P" + padded(parameters, 7, '0'),
                                      'T', 1));
    }

    std::vector<Entity> entities_;
    std::map<size_t, std::string> globals_;
    char parameter_ = ',';
    char record_ = ';';
};

// Parameters of a straight polynomial curve of degree 1 from (1, 2, 3) to (4, 6, 8) over [0, 1].
inline constexpr const char *line_126 = "1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.";

} // namespace iges_test
