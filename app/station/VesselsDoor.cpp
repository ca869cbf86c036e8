#include "app/station/VesselsDoor.h"

#include <QApplication>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/files/AssetSource.h"
#include "db/DocumentRepository.h"
#include "ui/vessels/DatabasePage.h"
#include "ui/vessels/VesselsPage.h"

namespace sagara::station {
namespace {

using ui::Trouble;

/// The error of what a database function throws, or nothing.
template <typename Work>
Trouble attempt(Work&& work) {
    try {
        work();
        return std::nullopt;
    } catch (const db::DbError& e) {
        return e.what();
    }
}

class Library final : public ui::VesselLibrary {
public:
    explicit Library(run::Store& store) : m_store(store) {}

    std::vector<ui::VesselEntry> all() const override {
        std::vector<ui::VesselEntry> entries;
        if (m_store.database() == nullptr) {
            for (const std::string& id : m_store.assets().ids(core::DocumentKind::Vessel))
                entries.push_back({id, nameIn(text(id), id), true, false});
            return entries;
        }
        (void)attempt([&] {
            const db::DocumentRepository vessels(*m_store.database(), db::DocumentTable::Vessel);
            for (const db::DocumentEntry& e : vessels.all())
                entries.push_back({e.key, e.name, e.origin == db::Origin::Shipped, e.retired});
        });
        return entries;
    }

    std::string text(const std::string& id) const override {
        std::string found;
        (void)attempt([&] { found = m_store.find(core::DocumentKind::Vessel, id).value_or(""); });
        return found;
    }

    Trouble save(const std::string& id, const std::string& name, const std::string& text) override {
        return withVessels([&](db::DocumentRepository& vessels) {
            vessels.put({id, name, text, db::Origin::User}, run::now());
        });
    }
    Trouble retire(const std::string& id) override {
        return withVessels([&](db::DocumentRepository& vessels) { vessels.retire(id); });
    }
    Trouble restore(const std::string& id) override {
        return withVessels([&](db::DocumentRepository& vessels) { vessels.restore(id); });
    }

    std::vector<std::string> usedBy(const std::string& id) const override {
        std::vector<std::string> names;
        if (m_store.database() == nullptr) return names;
        (void)attempt([&] {
            db::DocumentRepository scenarios(*m_store.database(), db::DocumentTable::Scenario);
            for (const db::DocumentEntry& entry : scenarios.inUse()) {
                const auto document = scenarios.find(entry.key);
                if (document && sailsIn(document->text, id)) names.push_back(entry.name);
            }
        });
        return names;
    }

    bool isShippedToo(const std::string& id) const override {
        return m_store.assets().find(core::DocumentKind::Vessel, id).has_value();
    }
    Trouble backToShipped(const std::string& id) override {
        const auto text = m_store.assets().find(core::DocumentKind::Vessel, id);
        if (!text) return "Sagara ships no vessel \"" + id + "\"";
        return withVessels([&](db::DocumentRepository& vessels) {
            vessels.put({id, nameIn(*text, id), *text, db::Origin::Shipped}, run::now());
        });
    }

    std::filesystem::path shippedModels() const override { return files::assetFolder() / "models"; }
    std::filesystem::path ownModels() const override { return m_store.ownModels(); }
    std::string trouble() const override { return m_store.database() ? std::string() : m_store.trouble(); }

private:
    static std::string nameIn(const std::string& text, const std::string& id) {
        const auto json = nlohmann::json::parse(text, nullptr, false);
        return json.is_object() && json.contains("name") && json["name"].is_string()
                   ? json["name"].get<std::string>()
                   : id;
    }
    static bool sailsIn(const std::string& scenario, const std::string& vessel) {
        const auto json = nlohmann::json::parse(scenario, nullptr, false);
        if (!json.is_object() || !json.contains("ownShips") || !json["ownShips"].is_array()) return false;
        const auto& ships = json["ownShips"];
        return std::any_of(ships.begin(), ships.end(), [&](const auto& ship) {
            return ship.is_object() && ship.contains("vessel") && ship["vessel"] == vessel;
        });
    }
    template <typename Work>
    Trouble withVessels(Work&& work) {
        if (m_store.database() == nullptr) return m_store.trouble();
        return attempt([&] {
            db::DocumentRepository vessels(*m_store.database(), db::DocumentTable::Vessel);
            work(vessels);
        });
    }

    run::Store& m_store;
};

class Care final : public ui::DatabaseCare {
public:
    explicit Care(run::Store& store) : m_store(store) {}

    Facts facts() const override {
        Facts facts;
        facts.file = m_store.folder().database();
        facts.trouble = m_store.database() ? std::string() : m_store.trouble();
        if (m_store.database() == nullptr) return facts;
        const Trouble trouble = attempt([&] {
            const db::DatabaseInfo info = m_store.database()->info();
            facts.size_bytes = info.size_bytes;
            facts.schemaVersion = info.schemaVersion;
            for (const db::TableCount& count : info.counts) facts.rows.emplace_back(count.table, count.rows);
        });
        facts.trouble = trouble.value_or("");
        return facts;
    }

    /// A desk or a console of a run is somewhere in this program.
    bool runIsOn() const override {
        const auto widgets = QApplication::allWidgets();
        return std::any_of(widgets.begin(), widgets.end(), [](const QWidget* w) {
            return w->inherits("sagara::ui::TrainerDesk") || w->inherits("sagara::ui::TraineeConsole");
        });
    }

    // A Database is used by the thread that made it: these make their own.
    std::vector<std::string> checkIntegrity() const override {
        return told([&] { return db::Database(m_store.folder().database()).integrity(); });
    }
    std::vector<std::string> backupTo(const std::filesystem::path& copy) const override {
        return told([&] {
            if (copy == m_store.folder().database())
                return std::vector<std::string>{"that is the database itself: choose another file"};
            db::Database(m_store.folder().database()).backupTo(copy, db::Database::Existing::Overwrite);
            return std::vector<std::string>{};
        });
    }
    std::vector<std::string> checkBackup(const std::filesystem::path& backup) const override {
        return told([&] { return m_store.checkBackup(backup); });
    }
    std::optional<std::string> restore(const std::filesystem::path& backup) override {
        return m_store.restoreDatabase(backup);
    }
    std::filesystem::path keptCopy() const override { return m_store.keptDatabase(); }

private:
    template <typename Work>
    static std::vector<std::string> told(Work&& work) {
        try {
            return work();
        } catch (const db::DbError& e) {
            return {e.what()};
        }
    }
    run::Store& m_store;
};

/// The port lives as long as its page.
template <typename Port>
class Held final : public QObject {
public:
    Held(std::unique_ptr<Port> port, QObject* owner) : QObject(owner), m_port(std::move(port)) {}

private:
    std::unique_ptr<Port> m_port;
};

}  // namespace

ui::Page* vesselsPage(Frame& frame) {
    auto library = std::make_unique<Library>(frame.store());
    auto* const page = new ui::VesselsPage(
        *library, [&frame](const std::shared_ptr<const core::World>& world) { return frame.stageFor(world); },
        [] { return core::formatUtc(run::now()).substr(0, 10); });
    new Held<Library>(std::move(library), page);
    page->setColours(frame.colours());
    return page;
}

ui::Page* databasePage(Frame& frame) {
    auto care = std::make_unique<Care>(frame.store());
    auto* const page = new ui::DatabasePage(*care);
    new Held<Care>(std::move(care), page);
    page->setColours(frame.colours());
    return page;
}

}  // namespace sagara::station
