#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/LocalFrame.h"
#include "core/base/Problems.h"
#include "core/base/Result.h"

/// Reading a document (JSON) that a person may have written. Every field is read before anything is refused,
/// so the author sees all mistakes at once, each with its path.
namespace sagara::core::config {

/// Accepted interval, both ends included, and the unit named in messages.
struct Range {
    double low;
    double high;
    const char* unit = "";
};

/// A value inside a parsed document. Cheap to copy; valid while its Document lives.
class Node {
public:
    const std::string& path() const { return m_path; }
    void problem(std::string found, std::string expected) const;
    /// The value itself as a list of exactly `count` numbers; empty after a problem.
    std::vector<double> numbers(std::size_t count, Range range) const;

private:
    friend class Document;
    friend class Reader;
    Node(const nlohmann::json* json, std::string path, Problems* problems)
        : m_json(json), m_path(std::move(path)), m_problems(problems) {}
    const nlohmann::json* m_json;  ///< null where the document has nothing: reads give defaults, quietly
    std::string m_path;
    Problems* m_problems;
};

/// A parsed text and the problems found in it so far.
class Document {
public:
    /// Malformed JSON is one problem with its line and column; the root is then empty.
    Document(std::string name, std::string_view text);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    Node root();
    /// Checks "document" and "version" at the root; false when they are not these, with the problem noted.
    bool isKind(std::string_view kind, int newestVersion);
    int version() const { return m_version; }
    Problems& problems() { return m_problems; }
    bool wellFormed() const { return m_json != nullptr; }

    template <typename T>
    Result<T, Problems> finish(T value) const {
        if (!m_problems.empty()) return m_problems;
        return value;
    }

private:
    Problems m_problems;
    std::unique_ptr<nlohmann::json> m_json;
    int m_version = 0;
};

/// Reads the members of one object; a key may lead on into one ("to.lat", "between[1]"). A problem is noted
/// and a harmless value returned; `Document::finish` refuses.
class Reader {
public:
    explicit Reader(Node node);

    bool has(std::string_view key) const;
    double number(std::string_view key, Range range);
    double numberOr(std::string_view key, double fallback, Range range);
    int integer(std::string_view key, int low, int high);
    int integerOr(std::string_view key, int fallback, int low, int high);
    bool flagOr(std::string_view key, bool fallback);
    std::string text(std::string_view key);  ///< not empty
    std::string textOr(std::string_view key, std::string fallback);
    std::string id(std::string_view key);  ///< see isId
    /// {"lat": .., "lon": ..}
    GeoPoint geoPoint(std::string_view key);
    /// Exactly `count` numbers, or any number of them when count is 0.
    std::vector<double> numbers(std::string_view key, std::size_t count, Range range);
    std::vector<std::string> texts(std::string_view key);
    std::vector<GeoPoint> geoPoints(std::string_view key, std::size_t atLeast);

    Node child(std::string_view key);                ///< an object that must be there
    std::vector<Node> list(std::string_view key);    ///< an array that must be there
    std::vector<Node> listOr(std::string_view key);  ///< an array, empty when absent

    template <typename E>
    struct Choice {
        const char* name;
        E value;
    };
    /// One of the named values, or nothing after a problem.
    template <typename E>
    std::optional<E> choiceIfKnown(std::string_view key, std::initializer_list<Choice<E>> choices) {
        std::vector<const char*> names;
        for (const auto& c : choices) names.push_back(c.name);
        const std::size_t index = choiceIndex(key, names);
        return index < names.size() ? std::optional<E>(std::data(choices)[index].value) : std::nullopt;
    }
    /// One of the named values; the first is returned after a problem.
    template <typename E>
    E choice(std::string_view key, std::initializer_list<Choice<E>> choices) {
        return choiceIfKnown(key, choices).value_or(std::data(choices)[0].value);
    }

    void problem(std::string_view key, std::string found, std::string expected);
    /// Whether nothing has been wrong since this reader was made: whether it makes sense to compare its
    /// values.
    bool sound() const;
    void rejectUnknownKeys();

private:
    const nlohmann::json* find(std::string_view key);
    const nlohmann::json* require(std::string_view key, const char* expected);
    std::string pathOf(std::string_view key) const;
    double checked(const nlohmann::json& value, const std::string& path, Range range);
    /// names.size() after a problem.
    std::size_t choiceIndex(std::string_view key, std::span<const char* const> names);
    std::vector<Node> items(const nlohmann::json* array, std::string_view key);

    Node m_node;
    std::size_t m_problemsBefore;
    std::set<std::string, std::less<>> m_known;
};

/// Whether it can name a document or a thing in one: 1 to 60 of a-z, 0-9 and '-'.
bool isId(std::string_view id);

/// Shortest decimal form that reads back the same.
std::string formatNumber(double value);

}  // namespace sagara::core::config
