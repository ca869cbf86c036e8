#include "ui/roster/AssignmentForm.h"

#include <QComboBox>
#include <QDateTimeEdit>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/Field.h"
#include "ui/roster/RosterTexts.h"

namespace sagara::ui::roster {
namespace {

constexpr int kLevels = 5;
constexpr int kUsualLevel = 3;
constexpr qint64 kUsualTime_days = 7;

QComboBox* box(const char* name, const QString& tip, QWidget* parent) {
    auto* const made = new QComboBox(parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(12);
    return made;
}

/// A class is kept as a negative number, so that one box holds both.
std::int64_t idOf(const QComboBox& choice) { return choice.currentData().toLongLong(); }

void refill(QComboBox& choice, const std::function<void()>& fill) {
    const QVariant before = choice.currentData();
    choice.clear();
    fill();
    choice.setCurrentIndex(before.isValid() ? choice.findData(before) : -1);
}

}  // namespace

AssignmentForm::AssignmentForm(QWidget* parent)
    : QWidget(parent),
      m_mission(box("assign-mission", tr("What is to be sailed"), this)),
      m_whom(box("assign-whom", tr("One person, or everybody who is in a class by then"), this)),
      m_type(box("assign-type", tr("Only an assessment counts as a grade"), this)),
      m_level(box("assign-level",
                  tr("The least difficulty that counts: weather, visibility, traffic and the "
                     "time allowed"),
                  this)),
      m_by(box("assign-by", tr("The trainer who gives it"), this)),
      m_due(new QDateTimeEdit(this)),
      m_missionNote(new FieldNote(this)),
      m_whomNote(new FieldNote(this)),
      m_dueNote(new FieldNote(this)),
      m_trouble(new FieldNote(this)),
      m_assign(new QPushButton(tr("Assign"), this)) {
    m_mission->setPlaceholderText(tr("Choose a mission"));
    m_whom->setPlaceholderText(tr("Choose a person or a class"));
    for (const char* type : {"train", "assess", "familiarise", "self-study"})
        m_type->addItem(typeName(QLatin1String(type)), QLatin1String(type));
    for (int i = 1; i <= kLevels; ++i) m_level->addItem(tr("Level %1 or harder").arg(i), i);
    m_level->setItemText(kLevels - 1, tr("Level %1").arg(kLevels));
    m_level->setCurrentIndex(kUsualLevel - 1);
    m_due->setObjectName(QStringLiteral("assign-due"));
    m_due->setCalendarPopup(true);
    m_due->setDisplayFormat(QStringLiteral("d MMM yyyy HH:mm"));
    m_due->setToolTip(tr("Day and time by this computer's clock; later than now"));
    m_assign->setObjectName(QStringLiteral("assign"));
    m_assign->setProperty("primary", true);
    m_assign->setToolTip(tr("Gives the mission; it can be withdrawn later"));

    auto* const form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&Mission"), m_mission);
    form->addRow(QString(), m_missionNote);
    form->addRow(tr("&For"), m_whom);
    form->addRow(QString(), m_whomNote);
    form->addRow(tr("&Due by"), m_due);
    form->addRow(QString(), m_dueNote);
    form->addRow(tr("&Run as"), m_type);
    form->addRow(tr("&Level"), m_level);
    form->addRow(tr("Assigned &by"), m_by);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heading(tr("Assign a mission"), 1.2, this));
    layout->addLayout(form);
    layout->addWidget(m_trouble);
    layout->addWidget(m_assign);
    layout->addWidget(
        hint(tr("It is done when it was sailed to the end, as this kind of run, at this level or "
                "a harder one, begun after it was given. Passed or not is the grade's business."),
             this));
    layout->addStretch(1);
    for (QComboBox* choice : {m_mission, m_whom, m_type, m_level})
        connect(choice, &QComboBox::currentIndexChanged, this, &AssignmentForm::check);
    connect(m_due, &QDateTimeEdit::dateTimeChanged, this, &AssignmentForm::check);
    connect(m_assign, &QPushButton::clicked, this, [this] { Q_EMIT assignWanted(typed()); });
}

void AssignmentForm::setChoices(const std::vector<Person>& people, const std::vector<SchoolClass>& classes,
                                const std::vector<Mission>& missions, core::Utc now) {
    m_now = now;
    refill(*m_mission, [&] {
        for (const Mission& m : missions) m_mission->addItem(m.name, m.key);
    });
    refill(*m_whom, [&] {
        for (const SchoolClass& c : classes) m_whom->addItem(tr("Class %1").arg(c.name), qlonglong(-c.id));
        if (!classes.empty()) m_whom->insertSeparator(m_whom->count());
        for (const Person& p : people)
            if (!p.retired && p.role == Role::Trainee)
                m_whom->addItem(p.rank.isEmpty() ? p.name : tr("%1, %2").arg(p.name, p.rank),
                                qlonglong(p.id));
    });
    refill(*m_by, [&] {
        m_by->addItem(tr("nobody named"), qlonglong(0));
        for (const Person& p : people)
            if (!p.retired && p.role != Role::Trainee) m_by->addItem(p.name, qlonglong(p.id));
    });
    m_by->setCurrentIndex(std::max(0, m_by->currentIndex()));
    const QDateTime today = QDateTime::fromSecsSinceEpoch(now.unix_s);
    if (m_due->dateTime() <= today) m_due->setDateTime({today.date().addDays(kUsualTime_days), QTime(17, 0)});
    check();
}

void AssignmentForm::choosePerson(std::int64_t id) {
    m_whom->setCurrentIndex(m_whom->findData(qlonglong(id)));
    m_mission->setFocus();
}

void AssignmentForm::say(const QString& trouble) { m_trouble->say(trouble); }

NewAssignment AssignmentForm::typed() const {
    NewAssignment a;
    a.mission = {m_mission->currentData().toString(), m_mission->currentText()};
    const std::int64_t whom = idOf(*m_whom);
    (whom < 0 ? a.classId : a.personId) = std::abs(whom);
    a.due = {m_due->dateTime().toSecsSinceEpoch()};
    a.type = m_type->currentData().toString();
    a.level = m_level->currentData().toInt();
    a.assignedBy = idOf(*m_by);
    return a;
}

void AssignmentForm::check() {
    m_trouble->say({});
    const bool missions = m_mission->count() > 0, anybody = m_whom->count() > 0;
    m_missionNote->say(missions ? QString() : tr("there is no mission; write one in the editor"));
    m_whomNote->say(anybody ? QString() : tr("there are no trainees; add them under People"));
    const bool later = m_due->dateTime().toSecsSinceEpoch() > m_now.unix_s;
    m_dueNote->say(later ? QString() : tr("that is in the past, expected a later day or time"));
    m_assign->setEnabled(later && m_mission->currentIndex() >= 0 && m_whom->currentIndex() >= 0);
}

}  // namespace sagara::ui::roster
