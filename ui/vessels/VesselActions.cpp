// What may be done with the chosen vessel, or to make another.
#include <QFile>
#include <QFutureWatcher>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSaveFile>
#include <QTabWidget>
#include <QtConcurrent>

#include "core/base/Config.h"
#include "ui/pilotcard/PilotCardOf.h"
#include "ui/vessels/ModelDialog.h"
#include "ui/vessels/NewVesselDialog.h"
#include "ui/vessels/TrialsPanel.h"
#include "ui/vessels/VesselEditor.h"
#include "ui/vessels/VesselFile.h"
#include "ui/vessels/VesselsPage.h"

namespace sagara::ui {
namespace {

QString q(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

bool VesselsPage::mayOverwrite(const std::string& id) {
    const auto it =
        std::find_if(m_entries.begin(), m_entries.end(), [&](const auto& e) { return e.id == id; });
    if (it == m_entries.end() || !it->shipped) return true;
    return QMessageBox::question(
               this, tr("Vessels"),
               tr("“%1” is shipped with Sagara. Saving makes it the school's own: a newer Sagara will "
                  "not replace it, and “Back to the shipped one” undoes that. Save?")
                   .arg(q(it->name))) == QMessageBox::Yes;
}

Trouble VesselsPage::save(const std::string& id, const std::string& name, const std::string& text) {
    if (auto trouble = m_library.save(id, name, text)) return trouble;
    m_search->clear();
    m_vessel.reset();
    fillList();
    choose(id);
    showChosen();
    return std::nullopt;
}

std::string VesselsPage::freeId(const std::string& wanted) const {
    const auto taken = [&](const std::string& id) {
        return std::any_of(m_entries.begin(), m_entries.end(), [&](const auto& e) { return e.id == id; });
    };
    if (!taken(wanted)) return wanted;
    for (int i = 2;; ++i)
        if (const std::string id = wanted + "-" + std::to_string(i); !taken(id)) return id;
}

void VesselsPage::openNew() {
    auto* const dialog = new NewVesselDialog(
        m_colours, [this](const std::string& id) { return freeId(id) != id; },
        [this](const std::string& id, const std::string& name, const std::string& text) {
            return save(id, name, text);
        },
        this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void VesselsPage::openEditor() {
    const std::string before = chosen();
    auto* const dialog = new VesselEditor(
        m_text, m_colours,
        [this, before](const std::string& id, const std::string& name, const std::string& text) -> Trouble {
            if (id != before && freeId(id) != id)
                return "there is a vessel \"" + id + "\" already: choose another id";
            if (!mayOverwrite(id)) return "";
            return save(id, name, text);
        },
        this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void VesselsPage::openModel() {
    const std::string id = chosen(), name = m_vessel->name;
    auto* const dialog = new ModelDialog(
        m_text, m_library.ownModels(), m_colours, m_stageFor,
        [this, id, name](const std::string& text) -> Trouble {
            if (!mayOverwrite(id)) return "";
            return save(id, name, text);
        },
        this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_view->setVessel(std::nullopt);  // one scene: the dialog has it meanwhile
    connect(dialog, &QDialog::finished, m_view, [this] { m_view->setVessel(m_vessel); });
    dialog->open();
}

void VesselsPage::duplicate() {
    bool ok = false;
    const QString id =
        QInputDialog::getText(this, tr("Duplicate"), tr("Id of the copy: small letters, digits and '-'"),
                              QLineEdit::Normal, q(freeId(chosen() + "-copy")), &ok);
    if (!ok) return;
    const std::string wanted = id.trimmed().toStdString();
    if (!core::config::isId(wanted))
        return tell("\"" + wanted + "\" cannot be an id: 1 to 60 of a-z, 0-9 and '-'");
    if (freeId(wanted) != wanted)
        return tell("there is a vessel \"" + wanted + "\" already: choose another id");
    const std::string name = m_vessel->name + " (copy)";
    tell(save(wanted, name, renamed(m_text, wanted, name)));
}

void VesselsPage::retireOrRestore() {
    const std::string id = chosen();
    const auto it =
        std::find_if(m_entries.begin(), m_entries.end(), [&](const auto& e) { return e.id == id; });
    if (it == m_entries.end()) return;
    Trouble trouble;
    if (it->retired) {
        trouble = m_library.restore(id);
    } else {
        const std::vector<std::string> users = m_library.usedBy(id);
        if (!users.empty()) {
            QString names;
            for (const std::string& user : users) names += (names.isEmpty() ? QString() : tr(", ")) + q(user);
            return tell(tr("She is not deleted: used by %1. Give that scenario another vessel first.")
                            .arg(names)
                            .toStdString());
        }
        trouble = m_library.retire(id);
    }
    m_vessel.reset();
    fillList();
    showChosen();
    tell(trouble);
}

void VesselsPage::backToShipped() {
    if (QMessageBox::question(
            this, tr("Vessels"),
            tr("Put the shipped vessel in place of the school's own? The changes stay in the history "
               "of the database only.")) != QMessageBox::Yes)
        return;
    const Trouble trouble = m_library.backToShipped(chosen());
    m_vessel.reset();
    fillList();
    showChosen();
    tell(trouble);
}

Trouble VesselsPage::exportTo(const std::filesystem::path& path) const {
    const std::string text = vesselFileText({m_text, attachedFiles(m_text, m_library.ownModels())});
    QSaveFile file(q(path.string()));
    if (file.open(QIODevice::WriteOnly) &&
        file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
        file.commit())
        return std::nullopt;
    return path.string() + " cannot be written: " + file.errorString().toStdString();
}

Trouble VesselsPage::importFrom(const std::filesystem::path& path) {
    QFile in(q(path.string()));
    if (!in.open(QIODevice::ReadOnly))
        return path.string() + " cannot be read: " + in.errorString().toStdString();
    auto file = readVesselFile(path.filename().string(), in.readAll().toStdString());
    if (!file) return file.error();
    const core::Vessel vessel = core::loadVessel("import", file->text).value();
    // One that is there stays: the newcomer gets a name of her own.
    const std::string id = freeId(vessel.id);
    if (auto trouble = writeAttached(file->files, m_library.ownModels())) return trouble;
    return save(id, vessel.name, id == vessel.id ? file->text : renamed(file->text, id, vessel.name));
}

void VesselsPage::writePilotCard(const QString& file) {
    if (!m_vessel) return;
    if (!m_trials->trials()) {  // first the trials, with their progress to be seen
        m_cardWanted = file;
        m_tabs->setCurrentWidget(m_trials);
        m_trials->start();
        return;
    }
    auto* const watcher = new QFutureWatcher<QString>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, file] {
        const QString trouble = watcher->result();
        watcher->deleteLater();
        tell(trouble.isEmpty() ? Trouble() : Trouble(trouble.toStdString()));
        if (trouble.isEmpty()) Q_EMIT pilotCardWritten(file);
    });
    watcher->setFuture(QtConcurrent::run([vessel = *m_vessel, trials = *m_trials->trials(), date = m_today(),
                                          file] {
        try {
            report::writePilotCard(pilotCardOf(vessel, trials, date), QFile::encodeName(file).toStdString());
        } catch (const std::runtime_error& e) {
            return QString::fromUtf8(e.what());
        }
        return QString();
    }));
}

}  // namespace sagara::ui
