#include "db/DocumentRepository.h"

#include "core/base/Hash.h"
#include "db/Database.h"
#include "db/Transaction.h"
#include "db/sql/Failure.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

constexpr Word<DocumentTable> kTables[] = {
    {DocumentTable::Vessel, "vessel"}, {DocumentTable::Area, "area"}, {DocumentTable::Scenario, "scenario"}};
constexpr Word<Origin> kOrigins[] = {{Origin::Shipped, "shipped"}, {Origin::User, "user"}};

QString nameOf(DocumentTable table) {
    const std::string_view name = toText(table);
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

std::string hashText(std::string_view text) { return core::toHex(core::hashOf(text)); }

DocumentEntry readEntry(const Query& row) {
    return {.key = row.text(u"key"_s),
            .name = row.text(u"name"_s),
            .contentHash = row.hash(u"content_hash"_s),
            .origin = row.word(u"origin"_s, parseOrigin),
            .retired = row.flag(u"retired"_s),
            .changed = row.utc(u"changed_utc"_s)};
}

std::string readText(const Query& row, const Database& db) {
    std::string text = row.bytes(u"document"_s);
    if (core::hashOf(text) == row.hash(u"content_hash"_s)) return text;
    throw problem(DbError::Kind::Damaged, db.connection().file(),
                  "document " + row.text(u"key"_s) + " is not the one that was stored");
}

}  // namespace

std::string_view toText(DocumentTable table) { return wordOf(kTables, table); }
std::string_view toText(Origin origin) { return wordOf(kOrigins, origin); }
std::optional<Origin> parseOrigin(std::string_view text) { return valueOf(kOrigins, text); }

std::optional<Document> DocumentRepository::find(std::string_view key) const {
    Query row(
        m_db.connection(),
        u"SELECT key, name, content_hash, origin, retired, changed_utc, CAST(document AS BLOB) AS document "
        "FROM %1 WHERE key = ?"_s.arg(nameOf(m_table)),
        key);
    if (!row.next()) return std::nullopt;
    return Document{readEntry(row), readText(row, m_db)};
}

std::optional<DocumentEntry> DocumentRepository::entry(std::string_view key) const {
    Query row(m_db.connection(),
              u"SELECT key, name, content_hash, origin, retired, changed_utc FROM %1 WHERE key = ?"_s.arg(
                  nameOf(m_table)),
              key);
    if (!row.next()) return std::nullopt;
    return readEntry(row);
}

std::vector<DocumentEntry> DocumentRepository::inUse() const {
    Query row(m_db.connection(),
              u"SELECT key, name, content_hash, origin, retired, changed_utc FROM %1 "
              "WHERE retired = 0 ORDER BY name, key"_s.arg(nameOf(m_table)));
    std::vector<DocumentEntry> entries;
    while (row.next()) entries.push_back(readEntry(row));
    return entries;
}

std::vector<DocumentEntry> DocumentRepository::all() const {
    Query row(
        m_db.connection(),
        u"SELECT key, name, content_hash, origin, retired, changed_utc FROM %1 ORDER BY name, key"_s.arg(
            nameOf(m_table)));
    std::vector<DocumentEntry> entries;
    while (row.next()) entries.push_back(readEntry(row));
    return entries;
}

std::optional<DocumentVersion> DocumentRepository::findByHash(std::uint64_t contentHash) const {
    const std::string hash = core::toHex(contentHash);
    Query row(m_db.connection(),
              u"SELECT key, content_hash, CAST(document AS BLOB) AS document FROM %1 WHERE content_hash = ? "
              "UNION ALL "
              "SELECT key, content_hash, CAST(document AS BLOB) AS document FROM document_history "
              "WHERE document_table = ? AND content_hash = ? LIMIT 1"_s.arg(nameOf(m_table)),
              hash, toText(m_table), hash);
    if (!row.next()) return std::nullopt;
    return DocumentVersion{row.text(u"key"_s), readText(row, m_db)};
}

bool DocumentRepository::put(const NewDocument& document, core::Utc now) {
    if (holds(document)) return false;  // the usual case at start, and no reason to wait for the write lock
    Transaction transaction(m_db);
    keepOldText(document, now);
    write(document, now);
    transaction.commit();
    return true;
}

bool DocumentRepository::holds(const NewDocument& document) const {
    const std::optional<DocumentEntry> stored = entry(document.key);
    return stored && stored->contentHash == core::hashOf(document.text) && stored->name == document.name &&
           stored->origin == document.origin;
}

void DocumentRepository::keepOldText(const NewDocument& document, core::Utc now) {
    execute(
        m_db.connection(),
        u"INSERT INTO document_history (document_table, key, content_hash, document, replaced_utc) "
        "SELECT ?, key, content_hash, document, ? FROM %1 WHERE key = ? AND content_hash <> ? "
        "ON CONFLICT (document_table, content_hash, key) DO UPDATE SET replaced_utc = excluded.replaced_utc"_s
            .arg(nameOf(m_table)),
        toText(m_table), now, document.key, hashText(document.text));
}

void DocumentRepository::write(const NewDocument& document, core::Utc now) {
    execute(
        m_db.connection(),
        u"INSERT INTO %1 (key, name, document, content_hash, origin, changed_utc) "
        "VALUES (?, ?, CAST(? AS TEXT), ?, ?, ?) "
        "ON CONFLICT (key) DO UPDATE SET name = excluded.name, document = excluded.document, "
        "content_hash = excluded.content_hash, origin = excluded.origin, changed_utc = excluded.changed_utc"_s
            .arg(nameOf(m_table)),
        document.key, document.name, Bytes{document.text}, hashText(document.text), toText(document.origin),
        now);
}

void DocumentRepository::retire(std::string_view key) { setRetired(key, true); }
void DocumentRepository::restore(std::string_view key) { setRetired(key, false); }

void DocumentRepository::setRetired(std::string_view key, bool retired) {
    execute(m_db.connection(), u"UPDATE %1 SET retired = ? WHERE key = ?"_s.arg(nameOf(m_table)), retired,
            key);
}

}  // namespace sagara::db
