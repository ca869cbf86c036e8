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

enum class PersonId : std::int64_t {};
enum class Role { Trainee, Trainer, Admin };
std::string_view toText(Role role);
std::optional<Role> parseRole(std::string_view text);

struct PersonRecord {
    PersonId id{};
    std::string name;
    Role role = Role::Trainee;
    core::Utc created;
    bool retired = false;
};

enum class AddError { NameTaken, NameEmpty, NameTooLong, NameUnreadable };
/// For a person at the keyboard: what is wrong and what is accepted.
std::string_view toText(AddError error);

/// A name as the roster keeps it, without blanks around it; or why it cannot be one (not NameTaken).
core::Result<std::string, AddError> personName(std::string_view text);

/// People of this school. All SQL about table `person` is in this class's .cpp file.
class PersonRepository final {
public:
    explicit PersonRepository(Database& db) : m_db(db) {}

    /// Blanks around the name are dropped; it holds 1 to 80 characters of valid UTF-8 and no control
    /// characters, and nobody in use has it, to the letter.
    core::Result<PersonId, AddError> add(std::string_view name, Role role, core::Utc now);
    std::optional<PersonRecord> find(PersonId id) const;
    std::optional<PersonRecord> findByName(
        std::string_view name) const;         ///< in use; blanks around it are dropped
    std::vector<PersonRecord> inUse() const;  ///< by name
    void retire(PersonId id);                 ///< hidden, the name is free again; the runs stay theirs

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
