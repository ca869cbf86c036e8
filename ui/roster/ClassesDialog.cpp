#include "ui/roster/ClassesDialog.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/Field.h"
#include "ui/roster/RosterCsv.h"
#include "ui/roster/Rows.h"

namespace sagara::ui::roster {

ClassesDialog::ClassesDialog(RosterPort& port, QWidget* parent)
    : QDialog(parent),
      m_port(port),
      m_table(new RowsView(QStringLiteral("class-list"),
                           {{tr("Class"), {}, false, true}, {tr("People"), tr("How many are in it"), true}},
                           this)),
      m_name(new QLineEdit(this)),
      m_note(new FieldNote(this)),
      m_add(new QPushButton(tr("Add"), this)),
      m_rename(new QPushButton(tr("Rename"), this)),
      m_retire(new QPushButton(tr("Retire"), this)) {
    setObjectName(QStringLiteral("classes-dialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Classes"));
    resize(460, 420);
    m_table->setEmptyText(tr("There is no class yet. Type a name below and add it."));
    m_name->setObjectName(QStringLiteral("class-name"));
    m_name->setPlaceholderText(tr("Name of a class, 1 to 80 characters"));
    m_add->setObjectName(QStringLiteral("class-add"));
    m_add->setProperty("primary", true);
    m_add->setToolTip(tr("Makes a new class of that name"));
    m_rename->setObjectName(QStringLiteral("class-rename"));
    m_rename->setToolTip(tr("Gives the selected class that name"));
    m_retire->setObjectName(QStringLiteral("class-retire"));
    m_retire->setToolTip(tr("The selected class can no longer be chosen; it must be empty"));
    auto* const close = new QPushButton(tr("Close"), this);
    auto* const doing = new QHBoxLayout;
    for (QPushButton* b : {m_add, m_rename, m_retire}) doing->addWidget(b);
    doing->addStretch(1);
    doing->addWidget(close);
    for (QPushButton* b : {m_rename, m_retire, close}) b->setAutoDefault(false);
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_name);
    layout->addWidget(m_note);
    layout->addLayout(doing);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_name, &QLineEdit::textChanged, this, &ClassesDialog::check);
    connect(m_table, &RowsView::chosen, this, [this] {
        const std::int64_t id = m_table->selectedId();
        for (const SchoolClass& c : m_classes)
            if (c.id == id) m_name->setText(c.name);
        check();
    });
    connect(m_add, &QPushButton::clicked, this, [this] { done(m_port.addClass(m_name->text().trimmed())); });
    connect(m_rename, &QPushButton::clicked, this,
            [this] { done(m_port.renameClass(m_table->selectedId(), m_name->text().trimmed())); });
    connect(m_retire, &QPushButton::clicked, this,
            [this] { done(m_port.retireClass(m_table->selectedId())); });
    refresh();
}

void ClassesDialog::refresh() {
    m_classes = m_port.classes();
    std::vector<Row> rows;
    for (const SchoolClass& c : m_classes) {
        Cell people(QString::number(c.people));
        people.order = c.people;
        rows.push_back({c.id, {c.name, people}});
    }
    m_table->show(std::move(rows));
    check();
}

void ClassesDialog::check() {
    const QString name = m_name->text().trimmed();
    const std::int64_t id = m_table->selectedId();
    const auto same = std::find_if(m_classes.begin(), m_classes.end(),
                                   [&](const SchoolClass& c) { return c.name == name; });
    const auto chosen =
        std::find_if(m_classes.begin(), m_classes.end(), [&](const SchoolClass& c) { return c.id == id; });
    const bool taken = same != m_classes.end();
    QString fault = name.isEmpty() ? QString() : classFault(name);
    if (taken && same->id != id) fault = tr("a class has this name already, expected another one");
    m_note->say(fault);
    const bool sound = !name.isEmpty() && fault.isEmpty() && !taken;
    m_add->setEnabled(sound);
    m_rename->setEnabled(sound && chosen != m_classes.end());
    m_retire->setEnabled(chosen != m_classes.end() && chosen->people == 0);
}

void ClassesDialog::done(const Trouble& trouble) {
    if (trouble) return m_note->say(*trouble);
    m_name->clear();
    m_table->clearSelection();
    refresh();
}

}  // namespace sagara::ui::roster
