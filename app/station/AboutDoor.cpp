#include "app/station/AboutDoor.h"

#include "app/files/Files.h"
#include "core/exercise/BuildId.h"
#include "db/DocumentRepository.h"

namespace sagara::station {
namespace {

using core::DocumentKind;

std::vector<std::string> idsOf(run::Store& store, DocumentKind kind) {
    if (store.database() == nullptr) return store.assets().ids(kind);
    std::vector<std::string> ids;
    const auto table = kind == DocumentKind::Area ? db::DocumentTable::Area : db::DocumentTable::Vessel;
    for (const auto& entry : db::DocumentRepository(*store.database(), table).inUse())
        ids.push_back(entry.key);
    return ids;
}

void addCredits(run::Store& store, DocumentKind kind, const QString& name, ui::AboutFacts& facts) {
    try {
        for (const std::string& id : idsOf(store, kind)) {
            const auto text = store.find(kind, id);
            const QStringList lines = text ? ui::attributionOf(*text) : QStringList();
            if (!lines.isEmpty()) facts.credits.append({name.arg(QString::fromStdString(id)), lines});
        }
    } catch (const db::DbError&) {
        // What cannot be read is named in ATTRIBUTION.md too.
    }
}

}  // namespace

std::filesystem::path helpFolder() { return files::assetFolder() / "help"; }

ui::AboutFacts aboutFacts(run::Store& store) {
    ui::AboutFacts facts;
    facts.version = QStringLiteral(SAGARA_VERSION);
    facts.buildId =
        QString::fromUtf8(core::coreBuildId().data(), static_cast<qsizetype>(core::coreBuildId().size()));
    const auto text = files::readTextFile(files::assetFolder() / "ATTRIBUTION.md");
    facts.attributions = text ? QString::fromStdString(*text) : QString();
    addCredits(store, DocumentKind::Area, ui::AboutDialog::tr("Area: %1"), facts);
    addCredits(store, DocumentKind::Vessel, ui::AboutDialog::tr("Vessel: %1"), facts);
    return facts;
}

}  // namespace sagara::station
