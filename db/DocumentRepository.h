#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Utc.h"

namespace sagara::db {

class Database;

enum class DocumentTable { Vessel, Area, Scenario };
enum class Origin { Shipped, User };
std::string_view toText(DocumentTable table);  ///< also the name of the table
std::string_view toText(Origin origin);
std::optional<Origin> parseOrigin(std::string_view text);

struct NewDocument {
    std::string key;   ///< the document's own id, such as "patrol51"; not empty
    std::string name;  ///< shown to people
    std::string text;  ///< the JSON as given, to the byte
    Origin origin = Origin::Shipped;
};

/// A row without its text, which may be megabytes.
struct DocumentEntry {
    std::string key;
    std::string name;
    std::uint64_t contentHash = 0;  ///< core::hashOf the text
    Origin origin = Origin::Shipped;
    bool retired = false;
    core::Utc changed;
};

struct Document {
    DocumentEntry entry;
    std::string text;
};

/// The text that a content hash names, be it the present or a replaced one.
struct DocumentVersion {
    std::string key;
    std::string text;
};

/// Vessels, areas or scenarios known to this installation: three tables of one shape, and what was replaced
/// in them. A document is named by its key; nothing is ever lost, so a recording finds the very text it was
/// made with. A text that no longer fits its hash throws DbError Damaged.
class DocumentRepository final {
public:
    DocumentRepository(Database& db, DocumentTable table) : m_db(db), m_table(table) {}

    std::optional<Document> find(std::string_view key) const;  ///< retired ones too
    std::optional<DocumentEntry> entry(std::string_view key) const;
    std::vector<DocumentEntry> inUse() const;  ///< by name
    std::vector<DocumentEntry> all() const;    ///< by name, retired ones too
    std::optional<DocumentVersion> findByHash(std::uint64_t contentHash) const;

    /// Inserts, or replaces what has this key and keeps the old text. False when all was so already. A
    /// retired document stays retired. Whether a shipped document may replace a user's own is for the caller
    /// to decide.
    bool put(const NewDocument& document, core::Utc now);
    void retire(std::string_view key);  ///< hidden; old exercises still replay
    void restore(std::string_view key);

private:
    bool holds(const NewDocument& document) const;
    void keepOldText(const NewDocument& document, core::Utc now);
    void write(const NewDocument& document, core::Utc now);
    void setRetired(std::string_view key, bool retired);

    Database& m_db;  ///< outlives every repository
    DocumentTable m_table;
};

}  // namespace sagara::db
