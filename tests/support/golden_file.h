// Files of golden values: splines, with values of them.
#pragma once

#include "support/spline_data.h"

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace support {

// Words of a golden file; lines that start with # are comments. Streams do not read hexadecimal floats,
// strtod does. What is no number, or missing, throws std::runtime_error.
class GoldenWords {
public:
    explicit GoldenWords(const std::string &path);
    bool next(std::string &word) { return static_cast<bool>(text_ >> word); }
    double number();
    int whole() { return static_cast<int>(number()); }
    std::vector<double> numbers(int64_t n);
    SplineData spline(); // what follows the word "spline"

private:
    std::stringstream text_;
};

} // namespace support
