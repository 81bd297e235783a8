#include "support/golden_file.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace support {

GoldenWords::GoldenWords(const std::string &path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with('#')) {
            text_ << line << '\n';
        }
    }
}

double GoldenWords::number() {
    std::string word;
    char *end = nullptr;
    const double value = next(word) ? std::strtod(word.c_str(), &end) : 0;
    if (end == nullptr || *end != '\0') {
        throw std::runtime_error("a golden file has \"" + word + "\" for a number");
    }
    return value;
}

std::vector<double> GoldenWords::numbers(int64_t n) {
    std::vector<double> values(static_cast<size_t>(n));
    std::generate(values.begin(), values.end(), [&] { return number(); });
    return values;
}

SplineData GoldenWords::spline() {
    SplineData data;
    const int axes = whole();
    data.dim = whole();
    const bool rational = whole() != 0;
    for (int k = 0; k < axes; ++k) {
        data.degrees.push_back(whole());
    }
    for (int k = 0; k < axes; ++k) {
        data.counts.push_back(whole());
    }
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        data.knots.push_back(numbers(data.counts[k] + data.degrees[k] + 1));
    }
    data.points = numbers(data.point_count() * data.dim);
    data.weights = numbers(rational ? data.point_count() : 0);
    return data;
}

} // namespace support
