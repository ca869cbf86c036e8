#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "Program.h"

namespace sagara::run::test {

using Arguments = std::vector<std::string>;

/// A folder of its own for every test, with a data folder in it, and sagara-sim to run there.
class SimTest : public ::testing::Test {
protected:
    SimTest();
    ~SimTest() override;

    /// Path of a file of this test.
    std::string at(std::string_view name) const { return (m_folder / name).string(); }
    std::filesystem::path data() const { return m_folder / "data"; }
    std::filesystem::path database() const { return data() / "sagara.db"; }

    /// The arguments and --data.
    Arguments withData(Arguments arguments) const;
    /// Runs to the end.
    Outcome sim(const Arguments& arguments, const std::function<void()>& before = {}) const;
    /// The same, of which success is expected.
    Outcome simDone(const Arguments& arguments) const;
    nlohmann::json simJson(Arguments arguments) const;

    void write(std::string_view name, std::string_view text) const;
    std::string read(std::string_view name) const;

    std::filesystem::path m_folder;
};

/// `run` of the lesson, fast, for so many seconds.
Arguments lesson(const char* seconds, Arguments more = {});

/// "state-hash: HEX" of the last line.
std::string hashIn(const Outcome& outcome);

std::vector<std::string> linesOf(const std::string& text);

/// Names of what lies in a folder, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

/// Text of the given files, for comparing before with after.
std::string bytesOf(const std::filesystem::path& file);

}  // namespace sagara::run::test
