#include "db/ClassRepository.h"

#include "db/Database.h"
#include "db/sql/Line.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;
using core::Result;

constexpr int kLongestName_characters = 80;
constexpr Word<ClassError> kErrors[] = {
    {ClassError::NameTaken, "a class has this name already, expected another one"},
    {ClassError::NameEmpty, "the name of the class is empty, expected 1 to 80 characters"},
    {ClassError::NameTooLong, "the name of the class is too long, expected 1 to 80 characters"},
    {ClassError::NameUnreadable,
     "the name of the class holds control characters or is not UTF-8, expected letters"}};

const auto kSelect = u"SELECT id, name, created_utc, retired FROM class "_s;

Result<std::string, ClassError> className(std::string_view typed) {
    const Line line = checkedLine(typed, kLongestName_characters);
    switch (line.fault) {
        case LineFault::None:
            return line.text;
        case LineFault::Empty:
            return ClassError::NameEmpty;
        case LineFault::TooLong:
            return ClassError::NameTooLong;
        case LineFault::Unreadable:
            break;
    }
    return ClassError::NameUnreadable;
}

ClassRecord readClass(const Query& row) {
    return {.id = row.id<ClassId>(u"id"_s),
            .name = row.text(u"name"_s),
            .created = row.utc(u"created_utc"_s),
            .retired = row.flag(u"retired"_s)};
}

std::optional<ClassRecord> readOne(Query row) {
    if (!row.next()) return std::nullopt;
    return readClass(row);
}

}  // namespace

std::string_view toText(ClassError error) { return wordOf(kErrors, error); }

Result<ClassId, ClassError> ClassRepository::add(std::string_view typed, core::Utc now) {
    const auto name = className(typed);
    if (!name) return name.error();
    const Query insert(m_db.connection(),
                       u"INSERT INTO class (name, created_utc) VALUES (?, ?) ON CONFLICT DO NOTHING"_s, *name,
                       now);
    if (insert.changedRows() == 0) return ClassError::NameTaken;
    return ClassId{insert.newId()};
}

Result<ClassId, ClassError> ClassRepository::rename(ClassId id, std::string_view typed) {
    const auto name = className(typed);
    if (!name) return name.error();
    if (execute(m_db.connection(), u"UPDATE OR IGNORE class SET name = ? WHERE id = ?"_s, *name, id) == 0)
        return ClassError::NameTaken;
    return id;
}

std::optional<ClassRecord> ClassRepository::find(ClassId id) const {
    return readOne(Query(m_db.connection(), kSelect + u"WHERE id = ?"_s, id));
}

std::optional<ClassRecord> ClassRepository::findByName(std::string_view name) const {
    const Line line = checkedLine(name, kLongestName_characters);
    return readOne(Query(m_db.connection(), kSelect + u"WHERE name = ? AND retired = 0"_s, line.text));
}

std::vector<ClassRecord> ClassRepository::inUse() const {
    Query row(m_db.connection(), kSelect + u"WHERE retired = 0 ORDER BY name"_s);
    std::vector<ClassRecord> classes;
    while (row.next()) classes.push_back(readClass(row));
    return classes;
}

void ClassRepository::retire(ClassId id) {
    execute(m_db.connection(), u"UPDATE class SET retired = 1 WHERE id = ?"_s, id);
}

}  // namespace sagara::db
