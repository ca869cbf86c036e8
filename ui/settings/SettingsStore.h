#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sagara::ui {

/// Where settings are kept, by key. Texts only; a value that makes no sense to its reader counts as not
/// there.
struct SettingsStore {
    virtual ~SettingsStore() = default;
    virtual std::optional<std::string> get(std::string_view key) const = 0;
    virtual void put(std::string_view key, std::string_view value) = 0;
    /// Empty when settings outlast the program; otherwise why they do not.
    virtual QString trouble() const = 0;
};

/// Until the program ends.
class MemorySettings final : public SettingsStore {
public:
    explicit MemorySettings(QString why = {}) : m_why(std::move(why)) {}
    std::optional<std::string> get(std::string_view key) const override {
        const auto found = m_values.find(key);
        return found == m_values.end() ? std::nullopt : std::optional<std::string>(found->second);
    }
    void put(std::string_view key, std::string_view value) override {
        m_values.insert_or_assign(std::string(key), std::string(value));
    }
    QString trouble() const override { return m_why; }

private:
    QString m_why;
    std::map<std::string, std::string, std::less<>> m_values;
};

}  // namespace sagara::ui
