#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/base/Utc.h"
#include "db/ClassRepository.h"

namespace sagara::db {

class Database;

enum class PersonId : std::int64_t {};
enum class Role { Trainee, Trainer, Admin };
std::string_view toText(Role role);
std::optional<Role> parseRole(std::string_view text);

/// What the school writes down about somebody.
struct NewPerson {
    std::string name;
    Role role = Role::Trainee;
    std::string number;  ///< student or service number; empty: none
    std::string rank;
    std::string note;  ///< an address, a remark; one line
    std::optional<ClassId> schoolClass;
};

struct PersonRecord {
    PersonId id{};
    std::string name;
    Role role = Role::Trainee;
    core::Utc created;
    bool retired = false;
    std::string number;
    std::string rank;
    std::string note;
    std::optional<ClassId> schoolClass;
};

enum class AddError {
    NameTaken,
    NameEmpty,
    NameTooLong,
    NameUnreadable,
    NumberTaken,
    NumberUnusable,
    RankUnusable,
    NoteUnusable
};
/// For a person at the keyboard: what is wrong and what is accepted.
std::string_view toText(AddError error);

/// A name as the roster keeps it, without blanks around it; or why it cannot be one (not NameTaken).
core::Result<std::string, AddError> personName(std::string_view text);
/// All the fields so; or what is wrong with the first that cannot be kept (not NameTaken, NumberTaken).
core::Result<NewPerson, AddError> personFields(const NewPerson& typed);

/// People of this school. All SQL about table `person` is in this class's .cpp file.
class PersonRepository final {
public:
    explicit PersonRepository(Database& db) : m_db(db) {}

    /// Blanks around the name are dropped; it holds 1 to 80 characters of valid UTF-8 and no control
    /// characters, and nobody in use has it, to the letter.
    core::Result<PersonId, AddError> add(std::string_view name, Role role, core::Utc now);
    /// Number (up to 40 characters, nobody in use has it), rank (40) and note (400) may be empty.
    core::Result<PersonId, AddError> add(const NewPerson& person, core::Utc now);
    core::Result<PersonId, AddError> change(PersonId id, const NewPerson& person);
    std::optional<PersonRecord> find(PersonId id) const;
    std::optional<PersonRecord> findByName(
        std::string_view name) const;                         ///< in use; blanks around it are dropped
    std::vector<PersonRecord> inUse() const;                  ///< by name
    std::vector<PersonRecord> all() const;                    ///< retired ones too, by name
    std::vector<PersonRecord> of(ClassId schoolClass) const;  ///< in use, by name
    void move(PersonId id, std::optional<ClassId> schoolClass);
    void retire(PersonId id);  ///< hidden, name and number are free again; the runs stay theirs
    /// In use again, unless somebody has the name or the number by now.
    core::Result<PersonId, AddError> restore(PersonId id);

private:
    AddError whyTaken(const NewPerson& person) const;

    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
