#include "app/station/EditorDoor.h"

#include "db/DbError.h"
#include "db/DocumentRepository.h"
#include "ui/editor/EditorPage.h"

namespace sagara::station {
namespace {

using ui::editor::EditorPort;

db::DocumentTable tableOf(core::DocumentKind kind) {
    if (kind == core::DocumentKind::Area) return db::DocumentTable::Area;
    return kind == core::DocumentKind::Vessel ? db::DocumentTable::Vessel : db::DocumentTable::Scenario;
}

class StoreDocuments final : public EditorPort {
public:
    explicit StoreDocuments(run::Store& store) : m_store(store) {}

    std::vector<Entry> list(core::DocumentKind kind) const override {
        std::vector<Entry> entries;
        db::Database* const database = m_store.database();
        try {
            if (database != nullptr && kind != core::DocumentKind::Picture) {
                for (const auto& e : db::DocumentRepository(*database, tableOf(kind)).inUse())
                    entries.push_back({e.key, e.name, e.origin == db::Origin::Shipped});
                return entries;
            }
        } catch (const db::DbError&) {  // what is shipped is there all the same
            entries.clear();
        }
        for (const std::string& id : m_store.assets().ids(kind)) entries.push_back({id, id, true});
        return entries;
    }

    std::optional<std::string> text(core::DocumentKind kind, const std::string& id) const override {
        try {
            return m_store.find(kind, id);
        } catch (const db::DbError&) {
            return m_store.assets().find(kind, id);
        }
    }

    std::shared_ptr<core::SeaHulls> hulls() const override { return m_store.hulls(); }

    std::optional<std::string> save(const std::string& id, const std::string& name,
                                    const std::string& text) override {
        if (m_store.database() == nullptr) return "there is no database: " + m_store.trouble();
        try {
            db::DocumentRepository scenarios(*m_store.database(), db::DocumentTable::Scenario);
            scenarios.put({id, name, text, db::Origin::User}, run::now());
            scenarios.restore(id);
        } catch (const db::DbError& e) {
            return e.what();
        }
        return std::nullopt;
    }

private:
    run::Store& m_store;
};

/// The page with what it looks at.
class EditorHolder final : public QObject {
public:
    EditorHolder(run::Store& store, QObject* parent) : QObject(parent), documents(store) {}
    StoreDocuments documents;
};

}  // namespace

ui::Page* editorPage(Frame& frame, const std::string& scenarioId) {
    auto* const holder = new EditorHolder(frame.store(), nullptr);
    auto* const page = new ui::editor::EditorPage(holder->documents, scenarioId);
    holder->setParent(page);  // goes with it, after its own destructor
    page->setColours(frame.colours());
    return page;
}

}  // namespace sagara::station
