#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/base/Utc.h"

namespace sagara::db {

class Database;

enum class ClassId : std::int64_t {};

struct ClassRecord {
    ClassId id{};
    std::string name;
    core::Utc created;
    bool retired = false;
};

enum class ClassError { NameTaken, NameEmpty, NameTooLong, NameUnreadable };
/// For a person at the keyboard: what is wrong and what is accepted.
std::string_view toText(ClassError error);

/// Classes (courses, groups, watches) that people of the roster belong to. All SQL about table `class` is in
/// this class's .cpp file.
class ClassRepository final {
public:
    explicit ClassRepository(Database& db) : m_db(db) {}

    /// Blanks around the name are dropped; it holds 1 to 80 characters and no class in use has it.
    core::Result<ClassId, ClassError> add(std::string_view name, core::Utc now);
    core::Result<ClassId, ClassError> rename(ClassId id, std::string_view name);
    std::optional<ClassRecord> find(ClassId id) const;
    std::optional<ClassRecord> findByName(std::string_view name) const;  ///< in use
    std::vector<ClassRecord> inUse() const;                              ///< by name
    void retire(ClassId id);  ///< hidden, the name is free again; its people stay in it until moved

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
