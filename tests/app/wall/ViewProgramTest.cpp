// `sagara-view` as people start it, and what it says when it cannot draw.
#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <cstdio>
#include <string>

namespace {

struct Outcome {
    int code;
    std::string output;  ///< both streams
};
Outcome view(const std::string& arguments, const std::string& environment = "") {
    const std::string command =
        "env -u DISPLAY " + environment + " " + SAGARA_VIEW + " " + arguments + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    Outcome outcome{};
    std::array<char, 4096> buffer;
    while (const auto n = fread(buffer.data(), 1, buffer.size(), pipe))
        outcome.output.append(buffer.data(), n);
    outcome.code = WEXITSTATUS(pclose(pipe));
    return outcome;
}

TEST(ViewProgram, PrintsTheFiguresOfABench) {
    const auto o = view("--offscreen --bench galle-entrance --size 160x90 --frames 3");
    ASSERT_EQ(o.code, 0) << o.output;
    for (const char* figure : {"frames/s", "p50", "p95", "p99", "max", "triangles", "draw calls", "MB"})
        EXPECT_NE(o.output.find(figure), std::string::npos) << figure << "\n" << o.output;
}

TEST(ViewProgram, WithoutGlSaysWhatToInstall) {
    const auto o =
        view("--offscreen --bench galle-entrance --frames 1", "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent");
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.output.find("no EGL display"), std::string::npos) << o.output;
    EXPECT_NE(o.output.find("apt-get install libogre-1.12-dev libgl1-mesa-dri"), std::string::npos)
        << o.output;
}

TEST(ViewProgram, WithoutAnXServerAWindowIsRefused) {
    const auto o = view("--windowed 320x180 --bench open-sea --frames 1");
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.output.find("DISPLAY is not set"), std::string::npos) << o.output;
    const auto wrong = view("--windowed 320x180 --bench open-sea --frames 1", "DISPLAY=:987");
    EXPECT_EQ(wrong.code, 3);
    EXPECT_NE(wrong.output.find(":987"), std::string::npos) << wrong.output;
}

TEST(ViewProgram, WrongRequestsAreAnswered) {
    EXPECT_EQ(view("").code, 2);
    EXPECT_EQ(view("--bench nowhere").code, 2);
    EXPECT_EQ(view("--shots /tmp --scenario nothing --offscreen").code, 2);
    EXPECT_EQ(view("--offscreen --bench open-sea --size 10").code, 2);
    EXPECT_EQ(view("--connect 127.0.0.1 --channel ahead").code, 2);
}

}  // namespace
