// Runs a fuzz target without a fuzzer: on every file of a corpus folder, on fixed mutations of each, and on
// noise. The inputs are the same on every run and machine. An input that ends the program is left in the file
// failing_input.
#include "support/scale.h"

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>
#include <vector>
#ifdef NURBS_SANITIZED
#include <sanitizer/common_interface_defs.h>
#endif

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

namespace {

using Bytes = std::vector<uint8_t>;

// Splitmix64 (Steele, Lea, Flood 2014): one multiplication-mixed counter, the same everywhere.
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint64_t next() {
        uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }
    size_t below(size_t bound) { return bound == 0 ? 0 : static_cast<size_t>(next() % bound); }
    uint8_t byte() { return static_cast<uint8_t>(next()); }

private:
    uint64_t state_;
};

using Offset = Bytes::difference_type;

Offset place(Random &random, const Bytes &bytes) {
    return static_cast<Offset>(random.below(bytes.size()));
}

void flip_bit(Bytes &bytes, Random &random) {
    const size_t at = random.below(bytes.size());
    bytes[at] = static_cast<uint8_t>(bytes[at] ^ (1U << random.below(8)));
}

// Bytes that mean something to a text format or to a reader of numbers.
void set_byte(Bytes &bytes, Random &random) {
    static constexpr char telling[] = {'\0', '\xff', '0', '9', '-', '+', '.', 'e', 'D',  'H',
                                       ',',  ';',    ' ', 'S', 'G', 'P', 'T', '1', '\n', '\r'};
    bytes[random.below(bytes.size())] = random.below(4) == 0
                                            ? random.byte()
                                            : static_cast<uint8_t>(telling[random.below(std::size(telling))]);
}

void truncate(Bytes &bytes, Random &random) {
    bytes.resize(random.below(bytes.size()));
}

void erase_part(Bytes &bytes, Random &random) {
    const Offset from = place(random, bytes);
    const auto left = static_cast<size_t>(std::distance(bytes.begin() + from, bytes.end()));
    bytes.erase(bytes.begin() + from,
                bytes.begin() + from + static_cast<Offset>(random.below(std::min<size_t>(left, 161))));
}

void repeat_part(Bytes &bytes, Random &random) {
    const size_t from = random.below(bytes.size());
    const size_t length = random.below(std::min<size_t>(bytes.size() - from, 161));
    const Bytes part(bytes.begin() + static_cast<Offset>(from),
                     bytes.begin() + static_cast<Offset>(from + length));
    bytes.insert(bytes.begin() + place(random, bytes), part.begin(), part.end());
}

Bytes mutated(Bytes bytes, Random &random) {
    using Mutation = void (*)(Bytes &, Random &);
    static constexpr Mutation mutations[] = {flip_bit, set_byte, set_byte, truncate, erase_part, repeat_part};
    const size_t steps = 1 + random.below(3);
    for (size_t step = 0; step < steps && !bytes.empty(); ++step) {
        mutations[random.below(std::size(mutations))](bytes, random);
    }
    return bytes;
}

// The input being run, for the handlers below; they may use nothing but system calls.
const Bytes *current = nullptr;

void keep_failing_input() {
    const int file = open("failing_input", O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (current == nullptr || file < 0) {
        return;
    }
    static constexpr char message[] = "replay: the failing input is in the file failing_input\n";
    const bool kept = write(file, current->data(), current->size()) == static_cast<ssize_t>(current->size());
    if (kept && write(STDERR_FILENO, message, sizeof message - 1) < 0) {
        _exit(2);
    }
}

void on_signal(int) {
    keep_failing_input();
    _exit(1);
}

void watch_for_failures() {
    std::signal(SIGABRT, on_signal);
    std::signal(SIGILL, on_signal);
#ifdef NURBS_SANITIZED
    __sanitizer_set_death_callback(keep_failing_input);
#else
    std::signal(SIGSEGV, on_signal);
    std::signal(SIGBUS, on_signal);
    std::signal(SIGFPE, on_signal);
#endif
}

// The buffer has exactly the input's size, so that a sanitizer sees the first byte read past it.
void run(const Bytes &bytes) {
    const Bytes exact(bytes);
    current = &exact;
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
    current = nullptr;
}

// Small files get many mutations and large ones few: about the same number of bytes for each, within limits.
size_t mutation_count(size_t size) {
    return std::clamp<size_t>((size_t{8} << 20) / (size + 1), 200, 2000);
}

void run_with_mutations(const Bytes &bytes, int64_t part, Random &random) {
    run(bytes);
    const int64_t count = support::scaled(static_cast<int64_t>(mutation_count(bytes.size())) / part);
    for (int64_t i = 0; i < count; ++i) {
        run(mutated(bytes, random));
    }
}

void run_noise(int64_t part, Random &random) {
    const auto largest = static_cast<size_t>(support::scaled(1000));
    for (size_t size = 0; size < largest; size += static_cast<size_t>(part)) {
        Bytes noise(size);
        std::generate(noise.begin(), noise.end(), [&] { return random.byte(); });
        run(noise);
    }
}

std::vector<std::filesystem::path> corpus_files(const char *folder) {
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

Bytes contents(const std::filesystem::path &path) {
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

} // namespace

int main(int argc, char **argv) {
    const int64_t part = argc == 3 ? std::strtoll(argv[2], nullptr, 10) : 1;
    if (argc < 2 || argc > 3 || part < 1) {
        std::fprintf(stderr,
                     "usage: %s CORPUS_FOLDER_OR_FILE [PART]: 1 / PART of the mutations and of the noise\n",
                     argv[0]);
        return 2;
    }
    watch_for_failures();
    Random random(1);
    if (std::filesystem::is_regular_file(argv[1])) {
        run(contents(argv[1]));
        return 0;
    }
    if (!std::filesystem::is_directory(argv[1])) {
        std::fprintf(stderr, "there is no corpus in %s\n", argv[1]);
        return 1;
    }
    const auto files = corpus_files(argv[1]);
    for (const auto &file : files) {
        std::printf("%s\n", file.c_str());
        std::fflush(stdout);
        run_with_mutations(contents(file), part, random);
    }
    run_noise(part, random);
    std::printf("%zu files replayed\n", files.size());
    return files.empty() ? 1 : 0;
}
