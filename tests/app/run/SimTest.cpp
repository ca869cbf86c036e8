#include "SimTest.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace sagara::run::test {

namespace fs = std::filesystem;

SimTest::SimTest() {
    std::string name = (fs::temp_directory_path() / "sagara-sim-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("mkdtemp " + name);
    m_folder = fs::canonical(name);
}

SimTest::~SimTest() {
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
}

Arguments SimTest::withData(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--data", data().string()});
    return arguments;
}

Outcome SimTest::sim(const Arguments& arguments, const std::function<void()>& before) const {
    return Program(withData(arguments), m_folder, before).wait();
}

Outcome SimTest::simDone(const Arguments& arguments) const {
    Outcome outcome = sim(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err << "signal " << outcome.signal;
    return outcome;
}

nlohmann::json SimTest::simJson(Arguments arguments) const {
    arguments.emplace_back("--json");
    const Outcome outcome = simDone(arguments);
    auto json = nlohmann::json::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << outcome.out;
    return json;
}

void SimTest::write(std::string_view name, std::string_view text) const {
    std::ofstream file(at(name), std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    EXPECT_TRUE(file.flush()) << name;
}

std::string SimTest::read(std::string_view name) const { return bytesOf(at(name)); }

Arguments lesson(const char* seconds, Arguments more) {
    Arguments all{"run", "--scenario", "basic-navigation", "--fast", "--duration-s", seconds};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::string hashIn(const Outcome& outcome) {
    const std::vector<std::string> lines = linesOf(outcome.out);
    const std::string head = "state-hash: ";
    if (lines.empty() || lines.back().rfind(head, 0) != 0) return "no hash in: " + outcome.out + outcome.err;
    return lines.back().substr(head.size());
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    EXPECT_TRUE(in) << file;
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace sagara::run::test
