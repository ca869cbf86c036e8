#include "db/PersonRepository.h"

#include "db/Database.h"
#include "db/sql/Line.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;
using core::Result;

constexpr int kLongestName_characters = 80;
constexpr int kLongestNumber_characters = 40;
constexpr int kLongestNote_characters = 400;
constexpr Word<Role> kRoles[] = {
    {Role::Trainee, "trainee"}, {Role::Trainer, "trainer"}, {Role::Admin, "admin"}};
constexpr Word<AddError> kAddErrors[] = {
    {AddError::NameTaken, "somebody has this name already, expected another one"},
    {AddError::NameEmpty, "the name is empty, expected 1 to 80 characters"},
    {AddError::NameTooLong, "the name is too long, expected 1 to 80 characters"},
    {AddError::NameUnreadable, "the name holds control characters or is not UTF-8, expected letters"},
    {AddError::NumberTaken, "somebody has this number already, expected another one or none"},
    {AddError::NumberUnusable, "the number cannot be kept, expected up to 40 characters on one line"},
    {AddError::RankUnusable, "the rank cannot be kept, expected up to 40 characters on one line"},
    {AddError::NoteUnusable, "the note cannot be kept, expected up to 400 characters on one line"}};

const auto kSelect =
    u"SELECT id, name, role, created_utc, retired, number, rank, note, class_id FROM person "_s;

/// May be empty; nothing when it cannot be kept.
std::optional<std::string> optionalLine(std::string_view typed, int longest_characters) {
    Line line = checkedLine(typed, longest_characters);
    if (line.fault == LineFault::None || line.fault == LineFault::Empty) return std::move(line.text);
    return std::nullopt;
}

PersonRecord readPerson(const Query& row) {
    return {.id = row.id<PersonId>(u"id"_s),
            .name = row.text(u"name"_s),
            .role = row.word(u"role"_s, parseRole),
            .created = row.utc(u"created_utc"_s),
            .retired = row.flag(u"retired"_s),
            .number = row.text(u"number"_s),
            .rank = row.text(u"rank"_s),
            .note = row.text(u"note"_s),
            .schoolClass =
                row.isNull(u"class_id"_s) ? std::nullopt : std::optional(row.id<ClassId>(u"class_id"_s))};
}

std::optional<PersonRecord> readOne(Query row) {
    if (!row.next()) return std::nullopt;
    return readPerson(row);
}

std::vector<PersonRecord> readAll(Query row) {
    std::vector<PersonRecord> people;
    while (row.next()) people.push_back(readPerson(row));
    return people;
}

}  // namespace

std::string_view toText(Role role) { return wordOf(kRoles, role); }
std::optional<Role> parseRole(std::string_view text) { return valueOf(kRoles, text); }
std::string_view toText(AddError error) { return wordOf(kAddErrors, error); }

Result<std::string, AddError> personName(std::string_view text) {
    const Line name = checkedLine(text, kLongestName_characters);
    switch (name.fault) {
        case LineFault::None:
            return name.text;
        case LineFault::Empty:
            return AddError::NameEmpty;
        case LineFault::TooLong:
            return AddError::NameTooLong;
        case LineFault::Unreadable:
            break;
    }
    return AddError::NameUnreadable;
}

Result<NewPerson, AddError> personFields(const NewPerson& typed) {
    const auto name = personName(typed.name);
    if (!name) return name.error();
    const auto number = optionalLine(typed.number, kLongestNumber_characters);
    if (!number) return AddError::NumberUnusable;
    const auto rank = optionalLine(typed.rank, kLongestNumber_characters);
    if (!rank) return AddError::RankUnusable;
    const auto note = optionalLine(typed.note, kLongestNote_characters);
    if (!note) return AddError::NoteUnusable;
    return NewPerson{*name, typed.role, *number, *rank, *note, typed.schoolClass};
}

Result<PersonId, AddError> PersonRepository::add(std::string_view name, Role role, core::Utc now) {
    NewPerson person;
    person.name = name;
    person.role = role;
    return add(person, now);
}

Result<PersonId, AddError> PersonRepository::add(const NewPerson& person, core::Utc now) {
    const auto checked = personFields(person);
    if (!checked) return checked.error();
    const NewPerson& p = *checked;
    const Query insert(m_db.connection(),
                       u"INSERT INTO person (name, role, created_utc, number, rank, note, class_id) "
                       "VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING"_s,
                       p.name, toText(p.role), now, p.number, p.rank, p.note, p.schoolClass);
    if (insert.changedRows() == 0) return whyTaken(p);
    return PersonId{insert.newId()};
}

Result<PersonId, AddError> PersonRepository::change(PersonId id, const NewPerson& person) {
    const auto checked = personFields(person);
    if (!checked) return checked.error();
    const NewPerson& p = *checked;
    const std::int64_t changed =
        execute(m_db.connection(),
                u"UPDATE OR IGNORE person SET name = ?, role = ?, number = ?, rank = ?, note = ?, "
                "class_id = ? WHERE id = ?"_s,
                p.name, toText(p.role), p.number, p.rank, p.note, p.schoolClass, id);
    const auto other = findByName(p.name);
    if (changed == 0) return other && other->id != id ? AddError::NameTaken : AddError::NumberTaken;
    return id;
}

AddError PersonRepository::whyTaken(const NewPerson& person) const {
    return findByName(person.name) ? AddError::NameTaken : AddError::NumberTaken;
}

std::optional<PersonRecord> PersonRepository::find(PersonId id) const {
    return readOne(Query(m_db.connection(), kSelect + u"WHERE id = ?"_s, id));
}

std::optional<PersonRecord> PersonRepository::findByName(std::string_view name) const {
    return readOne(Query(m_db.connection(), kSelect + u"WHERE name = ? AND retired = 0"_s,
                         checkedLine(name, kLongestName_characters).text));
}

std::vector<PersonRecord> PersonRepository::inUse() const {
    return readAll(Query(m_db.connection(), kSelect + u"WHERE retired = 0 ORDER BY name"_s));
}

std::vector<PersonRecord> PersonRepository::all() const {
    return readAll(Query(m_db.connection(), kSelect + u"ORDER BY name, id"_s));
}

std::vector<PersonRecord> PersonRepository::of(ClassId schoolClass) const {
    return readAll(Query(m_db.connection(), kSelect + u"WHERE class_id = ? AND retired = 0 ORDER BY name"_s,
                         schoolClass));
}

void PersonRepository::move(PersonId id, std::optional<ClassId> schoolClass) {
    execute(m_db.connection(), u"UPDATE person SET class_id = ? WHERE id = ?"_s, schoolClass, id);
}

void PersonRepository::retire(PersonId id) {
    execute(m_db.connection(), u"UPDATE person SET retired = 1 WHERE id = ?"_s, id);
}

Result<PersonId, AddError> PersonRepository::restore(PersonId id) {
    if (execute(m_db.connection(), u"UPDATE OR IGNORE person SET retired = 0 WHERE id = ?"_s, id) == 1)
        return id;
    const auto person = find(id);
    return person && findByName(person->name) ? AddError::NameTaken : AddError::NumberTaken;
}

}  // namespace sagara::db
