#include "ui/editor/EditorPage.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/Config.h"
#include "ui/editor/FieldText.h"
#include "ui/editor/Library.h"
#include "ui/editor/Workbench.h"

namespace sagara::ui::editor {
namespace {

std::string textOf(const Json& document) { return document.dump(2) + "\n"; }

}  // namespace

EditorPage::EditorPage(EditorPort& port, const std::string& scenarioId, QWidget* parent)
    : Page(parent),
      m_port(port),
      m_context(port, m_draft),
      m_stack(new QStackedWidget(this)),
      m_library(new Library(m_context, this)),
      m_workbench(new Workbench(m_context, this)),
      m_title(new QLabel(this)),
      m_status(new QLabel(this)),
      m_save(new QPushButton(tr("Save"), this)),
      m_undo(new QToolButton(this)),
      m_redo(new QToolButton(this)),
      m_direct(!scenarioId.empty()) {
    setObjectName(QStringLiteral("editor"));
    setWindowTitle(tr("Scenario editor"));
    m_stack->addWidget(m_library);
    m_stack->addWidget(bench());
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_stack);
    connect(m_library, &Library::leaveWanted, this, &Page::leaveWanted);
    connect(m_library, &Library::importWanted, this, &EditorPage::importChosen);
    connect(m_library, &Library::newWanted, this, &EditorPage::begin);
    connect(m_library, &Library::openWanted, this, [this](const std::string& id) {
        if (const auto trouble = open(id)) say(*trouble);
    });
    connect(&m_draft, &ScenarioDraft::changed, this, &EditorPage::nameTitle);
    connect(&m_draft, &ScenarioDraft::savedChanged, this, &EditorPage::nameTitle);
    connect(&m_context, &EditorContext::said, this, &EditorPage::say);
    connect(&m_context, &EditorContext::areaChanged, this, &EditorPage::placeNewShip);
    setColours(PaletteName::Day);
    if (!m_direct) return;
    if (const auto trouble = open(scenarioId)) {
        m_direct = false;
        say(*trouble);
    }
}

QWidget* EditorPage::bench() {
    auto* const page = new QWidget(this);
    auto* const bar = new QWidget(page);
    addFileButtons(*bar);
    m_status->setObjectName(QStringLiteral("status"));
    m_status->setWordWrap(true);
    auto* const layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(bar);
    layout->addWidget(m_status);
    layout->addWidget(m_workbench, 1);
    m_status->hide();
    return page;
}

void EditorPage::addFileButtons(QWidget& bar) {
    auto* const row = new QHBoxLayout(&bar);
    row->setContentsMargins(0, 0, 0, 0);
    const auto push = [&](QPushButton* b, const char* name, const QString& tip, auto&& work) {
        b->setObjectName(QString::fromLatin1(name));
        b->setToolTip(tip);
        connect(b, &QPushButton::clicked, this, work);
        row->addWidget(b);
    };
    push(new QPushButton(tr("Back"), &bar), "bench-back", tr("To the list of scenarios"), [this] { toLibrary(); });
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setObjectName(QStringLiteral("bench-title"));
    row->addWidget(m_title, 1);
    const auto step = [&](QToolButton* b, const char* name, const QString& text, bool undo) {
        b->setObjectName(QString::fromLatin1(name));
        b->setText(text);
        QUndoStack& history = m_draft.history();
        connect(b, &QToolButton::clicked, &history, undo ? &QUndoStack::undo : &QUndoStack::redo);
        connect(&history, undo ? &QUndoStack::canUndoChanged : &QUndoStack::canRedoChanged, b, &QWidget::setEnabled);
        connect(&history, undo ? &QUndoStack::undoTextChanged : &QUndoStack::redoTextChanged, b,
                [b, text](const QString& what) { b->setToolTip(what.isEmpty() ? text : QStringLiteral("%1: %2").arg(text, what)); });
        b->setEnabled(false);
        row->addWidget(b);
    };
    step(m_undo, "undo", tr("Undo"), true);
    step(m_redo, "redo", tr("Redo"), false);
    push(new QPushButton(tr("Import …"), &bar), "import", tr("Open a scenario from a file (JSON)"), [this] {
        if (mayLeave()) importChosen();
    });
    push(new QPushButton(tr("Export …"), &bar), "export", tr("Write the scenario to a file (JSON)"), [this] { exportChosen(); });
    push(new QPushButton(tr("Save as …"), &bar), "save-as", tr("Store it under another id and name"), [this] { saveAs(); });
    push(m_save, "save", tr("Store it in the database (Ctrl+S)"), [this] { (void)save(); });
    m_save->setProperty("primary", true);
    const auto key = [&](QKeySequence::StandardKey keys, auto&& work) {
        auto* const shortcut = new QShortcut(keys, this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, work);
    };
    key(QKeySequence::Save, [this] {
        if (m_stack->currentIndex() == 1) (void)save();
    });
    key(QKeySequence::Undo, [this] { m_draft.history().undo(); });
    key(QKeySequence::Redo, [this] { m_draft.history().redo(); });
}

void EditorPage::setColours(PaletteName colours) {
    m_context.setColours(colours);
    m_workbench->setColours(colours);
}

void EditorPage::say(const QString& trouble) {
    m_status->setText(trouble);
    m_status->setVisible(!trouble.isEmpty());
    m_library->setTrouble(m_stack->currentIndex() == 0 ? trouble : QString());
}

void EditorPage::nameTitle() {
    const std::string id = textAt(m_draft.document(), "id");
    const QString name = QString::fromStdString(textAt(m_draft.document(), "name", id));
    m_title->setText(m_draft.isSaved() ? tr("%1 (%2)").arg(name, QString::fromStdString(id))
                                       : tr("%1 (%2), not saved").arg(name, QString::fromStdString(id)));
    m_save->setEnabled(!m_draft.isSaved());
}

// documents

std::optional<QString> EditorPage::open(const std::string& id) {
    const auto text = m_port.text(core::DocumentKind::Scenario, id);
    if (!text) return tr("There is no scenario \"%1\".").arg(QString::fromStdString(id));
    Json document = Json::parse(*text, nullptr, false);
    if (!document.is_object()) return tr("The scenario \"%1\" is damaged: it is no JSON object.").arg(QString::fromStdString(id));
    m_storedId = id;
    m_placeShip = false;
    m_draft.reset(std::move(document), true);
    m_stack->setCurrentIndex(1);
    m_workbench->begin();
    say({});
    return std::nullopt;
}

void EditorPage::begin(const NewScenario& choice) {
    m_storedId.clear();
    m_placeShip = true;
    m_draft.reset(emptyScenario(choice), false);
    m_stack->setCurrentIndex(1);
    m_workbench->begin();
    say({});
    placeNewShip();
}

/// When the area of a new scenario has been read: the ship at an anchorage, or where the chart has its middle.
void EditorPage::placeNewShip() {
    if (!m_placeShip || !m_context.area() || m_draft.history().count() > 0) return;
    m_placeShip = false;
    const core::Area& area = *m_context.area();
    core::NorthEast at;
    double deepest_m = -1e9;
    for (const core::Place& place : area.places) {
        const double depth_m = area.isLand(place.position) ? -1e9 : area.depth_m(place.position);
        const double merit_m = depth_m + (place.kind.find("anchorage") != std::string::npos ? 1000.0 : 0.0);
        if (merit_m <= deepest_m) continue;
        deepest_m = merit_m;
        at = place.position;
    }
    Json document = m_draft.document();
    put(document, "ownShips[0].at", positionJson(area.frame.toGeo(at)));
    m_draft.reset(std::move(document), false);
    m_workbench->begin();
}

std::optional<QString> EditorPage::importFile(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) return tr("%1 cannot be read: %2").arg(name, file.errorString());
    Json document = Json::parse(file.readAll().toStdString(), nullptr, false);
    if (!document.is_object() || textAt(document, "document") != "scenario")
        return tr("%1 is not a scenario: a JSON file with \"document\": \"scenario\" is expected.").arg(name);
    m_storedId.clear();
    m_placeShip = false;
    m_draft.reset(std::move(document), false);
    m_stack->setCurrentIndex(1);
    m_workbench->begin();
    say(tr("Read from %1. It is not in the database until you save it.").arg(name));
    return std::nullopt;
}

std::optional<QString> EditorPage::exportFile(const QString& name) {
    QSaveFile file(name);
    const QByteArray text = QByteArray::fromStdString(textOf(m_draft.document()));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return tr("%1 cannot be written: %2").arg(name, file.errorString());
    return std::nullopt;
}

bool EditorPage::mayBeReplaced(const std::string& id) {
    m_context.forgetLists();
    const auto& known = m_context.listed(core::DocumentKind::Scenario);
    const auto it = std::find_if(known.begin(), known.end(), [&](const auto& e) { return e.id == id; });
    if (id == m_storedId || it == known.end()) return true;
    QMessageBox box(QMessageBox::Question, tr("Save"),
                    tr("There is a scenario \"%1\" (%2) already. Replace it?")
                        .arg(QString::fromStdString(id), QString::fromStdString(it->name)),
                    QMessageBox::Yes | QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("replace"));
    return box.exec() == QMessageBox::Yes;
}

bool EditorPage::save() {
    const std::string id = textAt(m_draft.document(), "id");
    if (!core::config::isId(id)) {
        say(tr("It cannot be saved: its id must be 1 to 60 letters a-z, digits and hyphens."));
        m_workbench->reveal("id");
        return false;
    }
    if (!mayBeReplaced(id)) return false;
    const std::string name = textAt(m_draft.document(), "name", id);
    if (const auto trouble = m_port.save(id, name, textOf(m_draft.document()))) {
        say(tr("It was not saved: %1").arg(QString::fromStdString(*trouble)));
        return false;
    }
    m_storedId = id;
    m_draft.markSaved();
    const auto& validator = m_workbench->validator();
    const bool sound = validator.upToDate() && validator.problems().empty();
    say(sound || !validator.upToDate() ? tr("Saved as \"%1\".").arg(QString::fromStdString(id))
                                        : tr("Saved as \"%1\"; it cannot be run until its problems are mended.").arg(QString::fromStdString(id)));
    return true;
}

void EditorPage::saveAs() {
    auto* const dialog = new QDialog(this);
    dialog->setObjectName(QStringLiteral("save-as-dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save as"));
    auto* const name = new QLineEdit(QString::fromStdString(textAt(m_draft.document(), "name")), dialog);
    auto* const id = new QLineEdit(QString::fromStdString(textAt(m_draft.document(), "id") + "-2").left(60), dialog);
    name->setObjectName(QStringLiteral("save-as-name"));
    name->setToolTip(tr("As it stands in lists"));
    id->setObjectName(QStringLiteral("save-as-id"));
    id->setToolTip(tr("1 to 60 letters a-z, digits and hyphens"));
    auto* const note = new QLabel(tr("Id: 1 to 60 letters a-z, digits and hyphens."), dialog);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, dialog);
    auto* const layout = new QFormLayout(dialog);
    layout->addRow(tr("Name"), name);
    layout->addRow(tr("Id"), id);
    layout->addRow(QString(), note);
    layout->addRow(buttons);
    const auto check = [=] {
        const bool good = core::config::isId(id->text().toStdString()) && !name->text().trimmed().isEmpty();
        buttons->button(QDialogButtonBox::Save)->setEnabled(good);
    };
    connect(id, &QLineEdit::textChanged, dialog, check);
    connect(name, &QLineEdit::textChanged, dialog, check);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this, dialog, id, name] {
        m_draft.edit(tr("another id"), [&](Json& document) {
            document["id"] = id->text().toStdString();
            document["name"] = name->text().trimmed().toStdString();
        });
        m_storedId.clear();
        dialog->accept();
        (void)save();
    });
    check();
    dialog->open();
}

void EditorPage::importChosen() {
    const QString name = QFileDialog::getOpenFileName(this, tr("Import a scenario"), {}, tr("Scenario (*.json)"));
    if (name.isEmpty()) return;
    if (const auto trouble = importFile(name)) say(*trouble);
}

void EditorPage::exportChosen() {
    const QString proposal = QString::fromStdString(textAt(m_draft.document(), "id", "scenario")) + QStringLiteral(".json");
    const QString name = QFileDialog::getSaveFileName(this, tr("Export the scenario"), proposal, tr("Scenario (*.json)"));
    if (name.isEmpty()) return;
    say(exportFile(name).value_or(tr("Written to %1.").arg(name)));
}

bool EditorPage::mayLeave() {
    if (m_stack->currentIndex() == 0 || m_draft.isSaved() || (m_storedId.empty() && m_draft.history().count() == 0))
        return true;
    QMessageBox box(QMessageBox::Question, tr("Scenario editor"),
                    tr("The scenario has been changed and is not saved."),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("unsaved"));
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void EditorPage::toLibrary() {
    if (m_direct) return Q_EMIT leaveWanted();  // who shows the page asks mayLeave
    if (!mayLeave()) return;
    m_library->refresh();
    m_stack->setCurrentIndex(0);
    m_draft.reset(Json::object(), true);
    say({});
}

}  // namespace sagara::ui::editor
