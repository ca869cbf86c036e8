#include "ui/vessels/VesselEditor.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <nlohmann/json.hpp>

#include "core/identify/TrialTrip.h"
#include "ui/vessels/DocumentTree.h"

namespace sagara::ui {
namespace {

using Json = nlohmann::ordered_json;

/// "a.b[0].c" as a JSON pointer.
std::string pointerOf(const std::string& path) {
    std::string pointer = "/";
    for (const char c : path) {
        if (c == '.' || c == '[')
            pointer += '/';
        else if (c != ']')
            pointer += c;
    }
    return pointer;
}

}  // namespace

std::string acceptedAt(const std::string& text, const std::string& path) {
    Json json = Json::parse(text, nullptr, false);
    const Json::json_pointer pointer(pointerOf(path));
    if (path.empty() || !json.is_object() || !json.contains(pointer)) return {};
    Json& value = json.at(pointer);
    if (value.is_structured()) return {};
    if (value.is_number())
        value = 1e30;
    else
        value = "?";
    const auto probe = core::loadVessel("probe", json.dump());
    if (probe) return {};
    for (const core::config::Problem& p : probe.error().list())
        if (p.path == path) return p.expected;
    return {};
}

VesselEditor::VesselEditor(const std::string& text, PaletteName colours, Save save, QWidget* parent)
    : QDialog(parent),
      m_save(std::move(save)),
      m_tree(new DocumentTree(DocumentTree::Use::Edit, this)),
      m_filter(new QLineEdit(this)),
      m_problems(new QListWidget(this)),
      m_state(new QLabel(this)),
      m_hint(new QLabel(this)),
      m_add(new QPushButton(tr("Add another"), this)),
      m_remove(new QPushButton(tr("Remove"), this)),
      m_undo(new QPushButton(tr("Undo"), this)),
      m_redo(new QPushButton(tr("Redo"), this)),
      m_ok(new QPushButton(tr("Save"), this)) {
    setWindowTitle(tr("Edit vessel"));
    setObjectName(QStringLiteral("vesselEditor"));
    resize(1080, 660);
    m_tree->setColours(colours);
    m_filter->setPlaceholderText(tr("Find a field"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setToolTip(tr("Shows the fields with this in their name or value"));
    m_problems->setObjectName(QStringLiteral("problems"));
    m_problems->setMaximumHeight(110);
    m_problems->setToolTip(tr("What is wrong with the document. Choose one to go to its field."));
    m_hint->setObjectName(QStringLiteral("hint"));
    m_hint->setWordWrap(true);
    m_ok->setObjectName(QStringLiteral("save"));
    m_ok->setProperty("primary", true);
    m_add->setToolTip(
        tr("Another propeller, rudder, line, anchor, term or station like the chosen one (Ctrl+N)"));
    m_remove->setToolTip(tr("Takes the chosen item out of its list (Ctrl+Delete)"));
    m_undo->setToolTip(tr("Takes the last change back (Ctrl+Z)"));
    m_redo->setToolTip(tr("Makes it again (Ctrl+Y)"));
    for (QPushButton* button : {m_add, m_remove, m_undo, m_redo}) button->setAutoDefault(false);
    m_add->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_N));
    m_remove->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Delete));
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Y));
    m_ok->setShortcut(QKeySequence::Save);
    m_ok->setAutoDefault(false);
    auto* const cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAutoDefault(false);

    auto* const top = new QHBoxLayout;
    top->addWidget(m_filter, 1);
    for (QPushButton* button : {m_add, m_remove, m_undo, m_redo}) top->addWidget(button);
    auto* const bottom = new QHBoxLayout;
    bottom->addWidget(m_state, 1);
    bottom->addWidget(cancel);
    bottom->addWidget(m_ok);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_tree, 1);
    layout->addWidget(m_hint);
    layout->addWidget(m_problems);
    layout->addLayout(bottom);

    connect(m_filter, &QLineEdit::textChanged, m_tree, &DocumentTree::setFilter);
    connect(m_tree, &DocumentTree::edited, this, [this] {
        note();
        check();
    });
    connect(m_tree, &QTreeWidget::currentItemChanged, this, [this] { showHint(); });
    connect(m_problems, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row < 0) return;
        const std::string path = m_problems->item(row)->data(Qt::UserRole).toString().toStdString();
        if (!m_tree->choose(path)) m_tree->choose(path.substr(0, path.find_last_of(".[")));
    });
    connect(m_add, &QPushButton::clicked, this, [this] { m_tree->addLikeCurrent(); });
    connect(m_remove, &QPushButton::clicked, this, [this] { m_tree->removeCurrent(); });
    connect(m_undo, &QPushButton::clicked, this, [this] { go(-1); });
    connect(m_redo, &QPushButton::clicked, this, [this] { go(1); });
    connect(m_ok, &QPushButton::clicked, this, &VesselEditor::accept);
    connect(cancel, &QPushButton::clicked, this, &VesselEditor::reject);

    m_tree->setDocument(text);
    m_history.push_back(m_tree->text());
    m_tree->expandToDepth(0);
    check();
    showHint();
}

std::string VesselEditor::text() const { return m_tree->text(); }

void VesselEditor::note() {
    m_history.resize(m_at + 1);
    m_history.push_back(m_tree->text());
    m_at = m_history.size() - 1;
}

void VesselEditor::go(std::ptrdiff_t steps) {
    const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(m_at) + steps;
    if (to < 0 || to >= static_cast<std::ptrdiff_t>(m_history.size())) return;
    m_at = static_cast<std::size_t>(to);
    m_tree->setDocument(m_history[m_at]);
    check();
}

void VesselEditor::check() {
    const auto vessel = core::loadSeaworthy("vessel", m_tree->text());
    const core::config::Problems problems = vessel ? core::config::Problems() : vessel.error();
    m_problemCount = problems.size();
    m_tree->setProblems(problems);
    m_problems->clear();
    for (const core::config::Problem& p : problems.list()) {
        auto* const item =
            new QListWidgetItem(tr("%1 %2; accepted: %3")
                                    .arg(QString::fromStdString(p.path), QString::fromStdString(p.found),
                                         QString::fromStdString(p.expected)),
                                m_problems);
        item->setData(Qt::UserRole, QString::fromStdString(p.path));
    }
    m_problems->setVisible(m_problemCount > 0);
    const bool changed = m_history[m_at] != m_history.front();
    m_state->setText(m_problemCount > 0
                         ? (m_problemCount == 1 ? tr("One problem: mend it to save")
                                                : tr("%1 problems: mend them to save").arg(m_problemCount))
                     : changed ? tr("Changed. Nothing is wrong.")
                               : tr("Not changed."));
    m_ok->setEnabled(m_problemCount == 0 && changed);
    m_ok->setToolTip(m_problemCount > 0 ? tr("Not while the document has problems")
                                        : tr("Saves the vessel as the school's own (Ctrl+S)"));
    m_undo->setEnabled(m_at > 0);
    m_redo->setEnabled(m_at + 1 < m_history.size());
}

void VesselEditor::showHint() {
    const std::string path = m_tree->currentPath();
    m_add->setEnabled(m_tree->canAdd());
    m_remove->setEnabled(m_tree->canRemove());
    if (path.empty()) {
        m_hint->setText(
            tr("Choose a field and type. Say in source and quality of its group where a number "
               "comes from: measured, fitted, published, estimated, or tuned by whom and when."));
        return;
    }
    const std::string accepted = acceptedAt(m_tree->text(), path);
    m_hint->setText(accepted.empty()
                        ? QString::fromStdString(path)
                        : tr("%1: %2").arg(QString::fromStdString(path), QString::fromStdString(accepted)));
}

void VesselEditor::accept() {
    const auto vessel = core::loadSeaworthy("vessel", m_tree->text());
    if (!vessel) return;
    if (const auto trouble = m_save(vessel->id, vessel->name, m_tree->text())) {
        if (!trouble->empty()) QMessageBox::warning(this, windowTitle(), QString::fromStdString(*trouble));
        return;
    }
    QDialog::accept();
}

void VesselEditor::reject() {
    if (m_history[m_at] != m_history.front() &&
        QMessageBox::question(this, windowTitle(), tr("Leave without saving the changes?")) !=
            QMessageBox::Yes)
        return;
    QDialog::reject();
}

}  // namespace sagara::ui
