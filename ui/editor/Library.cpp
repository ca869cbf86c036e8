#include "ui/editor/Library.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/Config.h"

namespace sagara::ui::editor {

Library::Library(EditorContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_list(new QListWidget(this)),
      m_open(new QPushButton(words("Open"), this)),
      m_id(new QLineEdit(this)),
      m_name(new QLineEdit(this)),
      m_area(new QComboBox(this)),
      m_vessel(new QComboBox(this)),
      m_create(new QPushButton(words("Create"), this)),
      m_idNote(new QLabel(this)),
      m_trouble(new QLabel(this)) {
    auto* const back = new QPushButton(words("Back"), this);
    back->setObjectName(QStringLiteral("back"));
    back->setToolTip(words("To the page before"));
    connect(back, &QPushButton::clicked, this, &Library::leaveWanted);
    auto* const title = new QLabel(words("Scenario editor"), this);
    QFont font = title->font();
    font.setPointSizeF(1.6 * font.pointSizeF());
    font.setBold(true);
    title->setFont(font);
    m_trouble->setObjectName(QStringLiteral("trouble"));
    m_trouble->setWordWrap(true);
    m_trouble->hide();
    auto* const head = new QHBoxLayout;
    head->addWidget(back);
    head->addWidget(title, 1);
    auto* const both = new QHBoxLayout;
    both->setSpacing(16);
    both->addWidget(openSide(), 3);
    both->addWidget(newSide(), 2);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(head);
    layout->addWidget(m_trouble);
    layout->addLayout(both, 1);
    refresh();
}

QWidget* Library::openSide() {
    auto* const box = new QGroupBox(words("Open a scenario"), this);
    auto* const layout = new QVBoxLayout(box);
    m_list->setObjectName(QStringLiteral("library"));
    m_list->setToolTip(words("Scenarios of this installation; double-click opens one"));
    m_list->setSpacing(2);
    m_open->setObjectName(QStringLiteral("library-open"));
    m_open->setToolTip(words("Open the chosen scenario for editing"));
    m_open->setProperty("primary", true);
    auto* const import = new QPushButton(words("Import a file …"), box);
    import->setObjectName(QStringLiteral("library-import"));
    import->setToolTip(words("Open a scenario that was exported as one file (JSON)"));
    auto* const row = new QHBoxLayout;
    row->addWidget(m_open);
    row->addWidget(import);
    row->addStretch(1);
    layout->addWidget(m_list, 1);
    layout->addLayout(row);
    const auto open = [this] {
        if (m_list->currentItem()) Q_EMIT openWanted(m_list->currentItem()->data(Qt::UserRole).toString().toStdString());
    };
    connect(m_open, &QPushButton::clicked, this, open);
    connect(m_list, &QListWidget::itemActivated, this, open);
    connect(import, &QPushButton::clicked, this, &Library::importWanted);
    return box;
}

QWidget* Library::newSide() {
    auto* const box = new QGroupBox(words("New, empty scenario"), this);
    auto* const layout = new QFormLayout(box);
    layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_name->setObjectName(QStringLiteral("new-name"));
    m_name->setPlaceholderText(words("My first lesson"));
    m_name->setToolTip(words("As it stands in lists"));
    m_id->setObjectName(QStringLiteral("new-id"));
    m_id->setPlaceholderText(QStringLiteral("my-first-lesson"));
    m_id->setToolTip(words("Names it in the database (1 to 60 letters a-z, digits and hyphens)"));
    m_idNote->setWordWrap(true);
    m_idNote->setObjectName(QStringLiteral("new-note"));
    m_area->setObjectName(QStringLiteral("new-area"));
    m_area->setToolTip(words("Where it takes place"));
    m_vessel->setObjectName(QStringLiteral("new-vessel"));
    m_vessel->setToolTip(words("What is sailed"));
    m_create->setObjectName(QStringLiteral("new-create"));
    m_create->setToolTip(words("Begin with an empty scenario; it is stored when you save it"));
    layout->addRow(words("Name"), m_name);
    layout->addRow(words("Id"), m_id);
    layout->addRow(QString(), m_idNote);
    layout->addRow(words("Area"), m_area);
    layout->addRow(words("Vessel"), m_vessel);
    layout->addRow(QString(), m_create);
    connect(m_name, &QLineEdit::textEdited, this, [this](const QString& name) {  // a first proposal for the id
        QString id;
        for (const QChar c : name.toLower().simplified()) {
            const bool plain = (c >= u'a' && c <= u'z') || (c >= u'0' && c <= u'9');
            id += plain ? c : QChar(u'-');
        }
        if (!m_id->isModified()) m_id->setText(id.left(60));
        checkNew();
    });
    connect(m_id, &QLineEdit::textChanged, this, &Library::checkNew);
    connect(m_create, &QPushButton::clicked, this, &Library::create);
    return box;
}

void Library::refresh() {
    m_context.forgetLists();
    const auto fill = [&](QComboBox& combo, core::DocumentKind kind) {
        const QVariant last = combo.currentData();
        combo.clear();
        for (const auto& e : m_context.listed(kind))
            combo.addItem(QString::fromStdString(e.name), QString::fromStdString(e.id));
        if (combo.findData(last) >= 0) combo.setCurrentIndex(combo.findData(last));
    };
    fill(*m_area, core::DocumentKind::Area);
    fill(*m_vessel, core::DocumentKind::Vessel);
    m_list->clear();
    for (const auto& e : m_context.listed(core::DocumentKind::Scenario)) {
        const QString whose = e.shipped ? words("shipped with Sagara") : words("your own");
        auto* const item = new QListWidgetItem(
            QStringLiteral("%1\n%2, %3").arg(QString::fromStdString(e.name), QString::fromStdString(e.id), whose), m_list);
        item->setData(Qt::UserRole, QString::fromStdString(e.id));
    }
    if (m_list->count() > 0) m_list->setCurrentRow(0);
    m_open->setEnabled(m_list->count() > 0);
    checkNew();
}

void Library::checkNew() {
    const std::string id = m_id->text().toStdString();
    const auto& known = m_context.listed(core::DocumentKind::Scenario);
    const bool taken = std::any_of(known.begin(), known.end(), [&](const auto& e) { return e.id == id; });
    QString note;
    if (id.empty()) note = words("Give it a name.");
    else if (!core::config::isId(id)) note = words("Id: 1 to 60 letters a-z, digits and hyphens.");
    else if (taken) note = words("There is a scenario \"%1\" already: choose another id.").arg(m_id->text());
    else if (m_area->count() == 0 || m_vessel->count() == 0) note = words("There is no area or no vessel to begin with.");
    m_idNote->setText(note);
    m_idNote->setVisible(!note.isEmpty());
    m_create->setEnabled(note.isEmpty());
}

void Library::create() {
    const QString name = m_name->text().trimmed().isEmpty() ? m_id->text() : m_name->text().trimmed();
    Q_EMIT newWanted({m_id->text().toStdString(), name.toStdString(), m_area->currentData().toString().toStdString(),
                      m_vessel->currentData().toString().toStdString()});
}

void Library::setTrouble(const QString& text) {
    m_trouble->setText(text);
    m_trouble->setVisible(!text.isEmpty());
}

}  // namespace sagara::ui::editor
