// Files are written whole or not at all, and nothing else is left behind.
#include "base/error.h"
#include "base/watch.h"
#include "io/file.h"

#include <algorithm>
#include <climits>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace write_file_test {
namespace {

namespace fs = std::filesystem;
using namespace nrb;

class WriteFile : public testing::Test {
protected:
    WriteFile() { fs::create_directory(folder_); }
    ~WriteFile() override {
        fs::permissions(folder_, fs::perms::owner_all);
        fs::remove_all(folder_);
    }

    [[nodiscard]] std::string path(const std::string &name) const { return folder_ / name; }
    [[nodiscard]] std::string contents(const std::string &name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto &entry : fs::directory_iterator(folder_)) {
            found.push_back(entry.path().filename());
        }
        std::sort(found.begin(), found.end());
        return found;
    }
    void make(const std::string &name, const std::string &text) const { std::ofstream(path(name)) << text; }
    static void expect_refused(const std::string &path, const std::string &text) {
        try {
            io::write_whole_file(path.c_str(), "new");
            ADD_FAILURE() << path << " is written";
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), Status::file);
            EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
        }
    }

    fs::path folder_ = fs::temp_directory_path() / ("write_file_test_" + std::to_string(::getpid()));
};

TEST_F(WriteFile, MakesAndReplacesFiles) {
    const std::string large(5 << 20, 'x');
    for (const std::string &text : {std::string("first"), large, std::string()}) {
        io::write_whole_file(path("a").c_str(), text);
        EXPECT_TRUE(contents("a") == text);
        EXPECT_EQ(names(), std::vector<std::string>{"a"});
    }
}

TEST_F(WriteFile, KeepsPermissionsAndLinks) {
    make("a", "old");
    fs::permissions(path("a"), fs::perms(0640));
    fs::create_symlink("a", path("link"));
    io::write_whole_file(path("link").c_str(), "new");
    EXPECT_EQ(contents("a"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms(0640));
    EXPECT_EQ(names(), (std::vector<std::string>{"a", "link"}));
}

TEST_F(WriteFile, NamesMayBeAsLongAsTheSystemAllows) {
    const std::string longest(NAME_MAX, 'a');
    for (const std::string text : {"first", "second"}) {
        io::write_whole_file(path(longest).c_str(), text);
        EXPECT_EQ(contents(longest), text);
        EXPECT_EQ(names(), std::vector<std::string>{longest});
    }
}

// A link to a file that is not there yet stays one, and so does a link to such a link.
TEST_F(WriteFile, MakesWhatLinksLeadTo) {
    fs::create_directory(path("far"));
    fs::create_symlink("far/a", path("link"));
    fs::create_symlink(path("link"), path("far/link"));
    for (const std::string text : {"first", "second"}) {
        io::write_whole_file(path("far/link").c_str(), text);
        EXPECT_EQ(contents("far/a"), text);
        EXPECT_FALSE(fs::is_symlink(path("far/a")));
        EXPECT_TRUE(fs::is_symlink(path("link")) && fs::is_symlink(path("far/link")));
    }
    EXPECT_EQ(names(), (std::vector<std::string>{"far", "link"}));
}

TEST_F(WriteFile, RefusesLinksThatLeadNowhere) {
    fs::create_symlink("none/a", path("link"));
    fs::create_symlink("turn", path("turn"));
    expect_refused(path("link"), "No such file");
    expect_refused(path("turn"), "levels of symbolic links");
    EXPECT_EQ(names(), (std::vector<std::string>{"link", "turn"}));
}

TEST_F(WriteFile, RefusesWhatCannotBe) {
    expect_refused(path("none/a"), "No such file");
    expect_refused(folder_, "directory");
    expect_refused("", "No such file");
    EXPECT_EQ(names(), std::vector<std::string>());
}

TEST_F(WriteFile, LeavesFilesThatMayNotBeWritten) {
    if (::geteuid() == 0) {
        GTEST_SKIP() << "permissions do not hold for root";
    }
    make("a", "old");
    fs::permissions(path("a"), fs::perms(0440));
    expect_refused(path("a"), "ermission");
    EXPECT_EQ(contents("a"), "old");
    EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

// A full disk is told, and a device stays one.
TEST_F(WriteFile, WritesToDevices) {
    io::write_whole_file("/dev/null", "text");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    if (fs::exists("/dev/full")) {
        expect_refused("/dev/full", "No space");
    }
}

TEST_F(WriteFile, WritesIntoPipes) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    io::write_whole_file(("/dev/fd/" + std::to_string(ends[1])).c_str(), "text");
    char text[5] = "";
    EXPECT_EQ(::read(ends[0], text, 4), 4);
    EXPECT_STREQ(text, "text");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_F(WriteFile, AnEndedCallLeavesTheOldFile) {
    make("a", "old");
    const std::string large(8 << 20, 'x');
    const Watch watch({.work = 1 << 20, .progress = nullptr, .user = nullptr});
    EXPECT_THROW(io::write_whole_file(path("a").c_str(), large), CallEnded);
    EXPECT_EQ(contents("a"), "old");
    EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

} // namespace
} // namespace write_file_test
