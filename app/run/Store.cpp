#include "app/run/Store.h"

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/files/Files.h"
#include "app/run/DatabaseTables.h"
#include "core/base/Config.h"
#include "core/seakeeping/SeaHulls.h"
#include "db/DocumentRepository.h"
#include "db/Transaction.h"

namespace sagara::run {
namespace {

constexpr std::array kKinds{core::DocumentKind::Vessel, core::DocumentKind::Area,
                            core::DocumentKind::Scenario};

db::DocumentTable tableOf(core::DocumentKind kind) {
    switch (kind) {
        case core::DocumentKind::Vessel:
            return db::DocumentTable::Vessel;
        case core::DocumentKind::Area:
            return db::DocumentTable::Area;
        case core::DocumentKind::Scenario:
            return db::DocumentTable::Scenario;
        case core::DocumentKind::Picture:
            break;  // not in the database
    }
    return db::DocumentTable::Vessel;
}

/// The "name" of a document, or its id.
std::string nameIn(const std::string& text, const std::string& id) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    return json.is_object() ? json.value("name", id) : id;
}

}  // namespace

core::Utc now() {
    return {
        std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
            .count()};
}

Store::Store(db::DataFolder folder)
    : m_folder(std::move(folder)),
      m_hulls(std::make_shared<core::SeaHulls>(std::make_shared<DatabaseTables>(m_folder.database()))),
      m_assets(files::assetFolder()) {}

core::Result<std::unique_ptr<Store>, std::string> Store::open(
    const std::optional<std::filesystem::path>& dataFolder) {
    auto folder = db::DataFolder::open(dataFolder);
    if (!folder) return folder.error();
    std::unique_ptr<Store> store(new Store(std::move(folder).value()));
    store->openDatabase();
    return store;
}

void Store::openDatabase() {
    try {
        m_database = std::make_unique<db::Database>(m_folder.database());
        takeInAssets();
    } catch (const db::DbError& e) {
        m_trouble = e.what();
        m_database.reset();
    }
}

void Store::takeInAssets() {
    db::Transaction transaction(*m_database);
    for (const core::DocumentKind kind : kKinds) {
        db::DocumentRepository documents(*m_database, tableOf(kind));
        for (const std::string& id : m_assets.ids(kind)) {
            const auto text = m_assets.find(kind, id);
            const auto known = documents.entry(id);
            const bool ownedByUser = known && known->origin == db::Origin::User;
            if (!text || ownedByUser ||
                (known && known->contentHash == core::hashOf(std::string_view(*text))))
                continue;
            documents.put({id, nameIn(*text, id), *text, db::Origin::Shipped}, now());
        }
    }
    transaction.commit();
}

std::optional<std::string> Store::find(core::DocumentKind kind, const std::string& id) const {
    if (!m_database || kind == core::DocumentKind::Picture) return m_assets.find(kind, id);
    auto document = db::DocumentRepository(*m_database, tableOf(kind)).find(id);
    if (!document) return std::nullopt;
    return std::move(document->text);
}

}  // namespace sagara::run
