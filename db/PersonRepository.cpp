#include "db/PersonRepository.h"

#include <algorithm>

#include "db/Database.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;
using core::Result;

constexpr int kLongestName_characters = 80;
constexpr Word<Role> kRoles[] = {
    {Role::Trainee, "trainee"}, {Role::Trainer, "trainer"}, {Role::Admin, "admin"}};
constexpr Word<AddError> kAddErrors[] = {
    {AddError::NameTaken, "somebody has this name already, expected another one"},
    {AddError::NameEmpty, "the name is empty, expected 1 to 80 characters"},
    {AddError::NameTooLong, "the name is too long, expected 1 to 80 characters"},
    {AddError::NameUnreadable, "the name holds control characters or is not UTF-8, expected letters"}};

QString asText(std::string_view name) { return QString::fromUtf8(name.data(), qsizetype(name.size())); }

/// Bytes that are not UTF-8 come back as replacement characters.
bool isUtf8(std::string_view name) { return asText(name).toStdString() == name; }

bool hasControlCharacter(const QString& text) {
    return std::any_of(text.begin(), text.end(),
                       [](QChar c) { return c.category() == QChar::Other_Control; });
}

PersonRecord readPerson(const Query& row) {
    return {.id = row.id<PersonId>(u"id"_s),
            .name = row.text(u"name"_s),
            .role = row.word(u"role"_s, parseRole),
            .created = row.utc(u"created_utc"_s),
            .retired = row.flag(u"retired"_s)};
}

}  // namespace

std::string_view toText(Role role) { return wordOf(kRoles, role); }
std::optional<Role> parseRole(std::string_view text) { return valueOf(kRoles, text); }
std::string_view toText(AddError error) { return wordOf(kAddErrors, error); }

Result<std::string, AddError> personName(std::string_view text) {
    const QString name = asText(text).trimmed();
    if (!isUtf8(text) || hasControlCharacter(name)) return AddError::NameUnreadable;
    if (name.isEmpty()) return AddError::NameEmpty;
    if (name.toUcs4().size() > kLongestName_characters) return AddError::NameTooLong;
    return name.toStdString();
}

Result<PersonId, AddError> PersonRepository::add(std::string_view name, Role role, core::Utc now) {
    const Result<std::string, AddError> checked = personName(name);
    if (!checked) return checked.error();
    const Query insert(
        m_db.connection(),
        u"INSERT INTO person (name, role, created_utc) VALUES (?, ?, ?) ON CONFLICT DO NOTHING"_s, *checked,
        toText(role), now);
    if (insert.changedRows() == 0) return AddError::NameTaken;
    return PersonId{insert.newId()};
}

std::optional<PersonRecord> PersonRepository::find(PersonId id) const {
    Query row(m_db.connection(), u"SELECT id, name, role, created_utc, retired FROM person WHERE id = ?"_s,
              id);
    if (!row.next()) return std::nullopt;
    return readPerson(row);
}

std::optional<PersonRecord> PersonRepository::findByName(std::string_view name) const {
    Query row(m_db.connection(),
              u"SELECT id, name, role, created_utc, retired FROM person WHERE name = ? AND retired = 0"_s,
              asText(name).trimmed().toStdString());
    if (!row.next()) return std::nullopt;
    return readPerson(row);
}

std::vector<PersonRecord> PersonRepository::inUse() const {
    Query row(m_db.connection(),
              u"SELECT id, name, role, created_utc, retired FROM person WHERE retired = 0 ORDER BY name"_s);
    std::vector<PersonRecord> people;
    while (row.next()) people.push_back(readPerson(row));
    return people;
}

void PersonRepository::retire(PersonId id) {
    execute(m_db.connection(), u"UPDATE person SET retired = 1 WHERE id = ?"_s, id);
}

}  // namespace sagara::db
