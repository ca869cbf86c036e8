#include "ui/roster/PersonForm.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/roster/Field.h"
#include "ui/roster/RosterCsv.h"
#include "ui/roster/RosterTexts.h"

namespace sagara::ui::roster {
namespace {

QLineEdit* lineEdit(const char* name, const QString& accepted, const QString& tip, QWidget* parent) {
    auto* const edit = new QLineEdit(parent);
    edit->setObjectName(QLatin1String(name));
    edit->setPlaceholderText(accepted);
    edit->setToolTip(tip);
    return edit;
}

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
    auto* const made = new QPushButton(text, parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
}

}  // namespace

PersonForm::PersonForm(QWidget* parent)
    : QWidget(parent),
      m_fields(new QWidget(this)),
      m_instead(hint({}, this)),
      m_title(heading({}, 1.2, this)),
      m_record(hint({}, this)),
      m_name(lineEdit("person-name", tr("1 to 80 characters"), tr("Full name; nobody else has it"), this)),
      m_number(lineEdit("person-number", tr("none"),
                        tr("Student or service number, up to 40 characters; nobody else has it"), this)),
      m_rank(lineEdit("person-rank", tr("none"), tr("Rank or grade, up to 40 characters"), this)),
      m_note(lineEdit("person-note", tr("e-mail address or remark"), tr("Up to 400 characters"), this)),
      m_nameNote(new FieldNote(this)),
      m_numberNote(new FieldNote(this)),
      m_rankNote(new FieldNote(this)),
      m_classNote(new FieldNote(this)),
      m_noteNote(new FieldNote(this)),
      m_trouble(new FieldNote(this)),
      m_class(new QComboBox(this)),
      m_role(new QComboBox(this)),
      m_save(button("person-save", tr("Save"), tr("Keeps what was typed (Ctrl+S)"), this)),
      m_cancel(button("person-cancel", tr("Cancel"), tr("Back to what was kept (Esc)"), this)),
      m_retire(button("person-retire", {}, {}, this)),
      m_assign(button("person-assign", tr("Assign a mission..."),
                      tr("A mission with a due date for this person"), this)),
      m_runs(button("person-runs", tr("Show runs"), tr("Every run of this person"), this)) {
    m_class->setObjectName(QStringLiteral("person-class"));
    m_class->setEditable(true);
    m_class->setInsertPolicy(QComboBox::NoInsert);
    m_class->setToolTip(tr("Choose a class or type the name of a new one; empty: none"));
    m_class->lineEdit()->setPlaceholderText(tr("none; type to make one"));
    for (QComboBox* choice : {m_class, m_role})
        choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_role->setObjectName(QStringLiteral("person-role"));
    m_role->setToolTip(tr("Trainers and administrators may sign off assessments"));
    for (const Role role : {Role::Trainee, Role::Trainer, Role::Admin})
        m_role->addItem(roleName(role), static_cast<int>(role));
    m_save->setProperty("primary", true);
    m_save->setShortcut(QKeySequence::Save);
    m_cancel->setShortcut(QKeySequence(Qt::Key_Escape));

    auto* const form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    const auto row = [&](const QString& label, QWidget* field, FieldNote* note) {
        form->addRow(label, field);
        if (note != nullptr) form->addRow(QString(), note);
    };
    row(tr("&Name"), m_name, m_nameNote);
    row(tr("N&umber"), m_number, m_numberNote);
    row(tr("Ran&k"), m_rank, m_rankNote);
    row(tr("C&lass"), m_class, m_classNote);
    row(tr("R&ole"), m_role, nullptr);
    row(tr("No&te"), m_note, m_noteNote);
    auto* const saving = new QHBoxLayout;
    saving->addWidget(m_cancel);
    saving->addWidget(m_save, 1);
    auto* const doing = new QHBoxLayout;
    doing->addWidget(m_assign, 1);
    doing->addWidget(m_runs, 1);
    auto* const inside = new QVBoxLayout(m_fields);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addWidget(m_title);
    inside->addWidget(m_record);
    inside->addLayout(form);
    inside->addWidget(m_trouble);
    inside->addLayout(saving);
    inside->addSpacing(12);
    inside->addLayout(doing);
    inside->addWidget(m_retire);
    inside->addStretch(1);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_instead);
    layout->addWidget(m_fields, 1);
    m_instead->setAlignment(Qt::AlignTop);

    for (QLineEdit* edit : {m_name, m_number, m_rank, m_note})
        connect(edit, &QLineEdit::textChanged, this, &PersonForm::check);
    connect(m_class, &QComboBox::currentTextChanged, this, &PersonForm::check);
    connect(m_role, &QComboBox::currentIndexChanged, this, &PersonForm::check);
    connect(m_save, &QPushButton::clicked, this, [this] { Q_EMIT saveWanted(typed()); });
    connect(m_cancel, &QPushButton::clicked, this, &PersonForm::cancelled);
    connect(m_retire, &QPushButton::clicked, this,
            [this] { Q_EMIT retireWanted(m_person.id, !m_person.retired); });
    connect(m_assign, &QPushButton::clicked, this, [this] { Q_EMIT assignWanted(m_person.id); });
    connect(m_runs, &QPushButton::clicked, this, [this] { Q_EMIT runsWanted(m_person.id); });
    clear({});
}

void PersonForm::setKnown(std::vector<Person> people, const std::vector<SchoolClass>& classes) {
    m_people = std::move(people);
    m_filling = true;
    const QString before = m_class->currentText();
    m_class->clear();
    m_class->addItem(QString());
    for (const SchoolClass& c : classes) m_class->addItem(c.name);
    m_class->setCurrentText(before);
    m_filling = false;
}

void PersonForm::show(const Person& person, const QString& record) {
    m_title->setText(person.name);
    m_record->setText(record);
    m_record->setVisible(!record.isEmpty());
    fill(person);
}

void PersonForm::startNew() {
    m_title->setText(tr("Somebody new"));
    m_record->hide();
    fill({});
    m_nameNote->say({});
    m_name->setFocus();
}

void PersonForm::clear(const QString& instead) {
    fill({});
    m_instead->setText(instead);
    m_instead->show();
    m_fields->hide();
}

void PersonForm::say(const QString& trouble) { m_trouble->say(trouble); }

void PersonForm::fill(const Person& person) {
    m_filling = true;
    m_person = person;
    m_name->setText(person.name);
    m_number->setText(person.number);
    m_rank->setText(person.rank);
    m_note->setText(person.note);
    m_class->setCurrentText(person.className);
    m_role->setCurrentIndex(m_role->findData(static_cast<int>(person.role)));
    m_filling = false;
    const bool known = person.id != 0;
    m_retire->setVisible(known);
    m_retire->setText(person.retired ? tr("Take back onto the roster") : tr("Retire from the roster"));
    m_retire->setToolTip(person.retired
                             ? tr("Shown and chosen again")
                             : tr("No longer shown or chosen; the runs stay, and it can be undone"));
    m_assign->setVisible(known && !person.retired);
    m_runs->setVisible(known);
    m_trouble->say({});
    m_instead->hide();
    m_fields->show();
    check();
}

Person PersonForm::typed() const {
    Person p = m_person;
    p.name = m_name->text().trimmed();
    p.number = m_number->text().trimmed();
    p.rank = m_rank->text().trimmed();
    p.note = m_note->text().trimmed();
    p.className = m_class->currentText().trimmed();
    p.role = static_cast<Role>(m_role->currentData().toInt());
    return p;
}

QString PersonForm::takenFault(const QString& value, QString Person::*member) const {
    if (value.isEmpty()) return {};
    for (const Person& p : m_people) {
        if (p.id == m_person.id || p.retired || p.*member != value) continue;
        return member == &Person::name ? tr("somebody has this name already, expected another one")
                                       : tr("%1 has this number, expected another one or none").arg(p.name);
    }
    return {};
}

void PersonForm::check() {
    if (m_filling) return;
    const Person p = typed();
    m_changed = p.name != m_person.name || p.number != m_person.number || p.rank != m_person.rank ||
                p.note != m_person.note || p.className != m_person.className || p.role != m_person.role;
    const auto first = [](const QString& a, const QString& b) { return a.isEmpty() ? b : a; };
    const QString nameIs = first(nameFault(p.name), takenFault(p.name, &Person::name));
    m_nameNote->say(m_changed ? nameIs : QString());
    m_numberNote->say(
        first(numberFault(p.number), m_person.retired ? QString() : takenFault(p.number, &Person::number)));
    m_rankNote->say(rankFault(p.rank));
    m_classNote->say(classFault(p.className));
    m_noteNote->say(noteFault(p.note));
    const bool sound =
        nameIs.isEmpty() && m_numberNote->ok() && m_rankNote->ok() && m_classNote->ok() && m_noteNote->ok();
    m_save->setEnabled(m_changed && sound);
    m_save->setText(m_person.id == 0 ? tr("Add to the roster") : tr("Save"));
    m_cancel->setEnabled(m_changed || m_person.id == 0);
    Q_EMIT changedNow(m_changed);
}

}  // namespace sagara::ui::roster
