#include "ui/roster/AssignmentsPanel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/AssignmentForm.h"
#include "ui/roster/Field.h"
#include "ui/roster/RosterTexts.h"
#include "ui/roster/Rows.h"

namespace sagara::ui::roster {
namespace {

constexpr int kForm_px = 340;
constexpr int kNotWithdrawn = -1;

Cell timeCell(core::Utc instant) {
    Cell cell(dateTime(instant));
    cell.order = qlonglong(instant.unix_s);
    return cell;
}

Cell stateCell(State state) {
    const Tone tone = state == State::Done        ? Tone::Good
                      : state == State::Late      ? Tone::Bad
                      : state == State::Withdrawn ? Tone::Quiet
                                                  : Tone::Attention;
    return {stateName(state), tone};
}

Row rowOf(const Assignment& a) {
    const auto done =
        std::count_if(a.members.begin(), a.members.end(), [](const Member& m) { return m.done.has_value(); });
    Cell howMany(AssignmentsPanel::tr("%1 of %2").arg(done).arg(a.members.size()));
    howMany.order = double(done) / double(std::max<std::size_t>(1, a.members.size()));
    Cell whom(a.forWhom);
    whom.tip = a.classId != 0 ? AssignmentsPanel::tr("A class") : QString();
    return {a.id,
            {a.mission, whom, typeName(a.type), QString::number(a.level), timeCell(a.due), stateCell(a.state),
             howMany, a.assignedBy.isEmpty() ? QStringLiteral("-") : a.assignedBy}};
}

}  // namespace

AssignmentsPanel::AssignmentsPanel(RosterPort& port, QWidget* parent)
    : QWidget(parent),
      m_port(port),
      m_state(new QComboBox(this)),
      m_table(new RowsView(QStringLiteral("assignments"),
                           {{tr("Mission"), {}, false, true},
                            {tr("For"), tr("A person, or a class"), false, true},
                            {tr("Run as"), tr("Only an assessment counts as a grade")},
                            {tr("Level"), tr("1 to 5, the least that counts"), true},
                            {tr("Due by"), tr("By this computer's clock")},
                            {tr("State"), tr("Worked out from the runs")},
                            {tr("Done"), tr("How many of those it was given to have sailed it"), true},
                            {tr("Assigned by")}},
                           this)),
      m_members(new RowsView(QStringLiteral("members"),
                             {{tr("Person"), {}, false, true},
                              {tr("State")},
                              {tr("Done on"), tr("End of the first run that fulfilled it")}},
                             this)),
      m_membersTitle(heading(tr("Who has sailed it"), 1.0, this)),
      m_trouble(new FieldNote(this)),
      m_withdraw(new QPushButton(tr("Withdraw"), this)),
      m_form(new AssignmentForm(this)) {
    m_state->setObjectName(QStringLiteral("assignment-state"));
    m_state->setToolTip(tr("Which missions are shown"));
    m_state->addItem(tr("Open, late and done"), kNotWithdrawn);
    for (const State state : {State::Open, State::Late, State::Done, State::Withdrawn})
        m_state->addItem(tr("Only %1").arg(stateName(state)), static_cast<int>(state));
    m_withdraw->setObjectName(QStringLiteral("withdraw"));
    m_withdraw->setToolTip(tr("The selected mission need not be sailed any more; the runs stay"));
    m_members->setEmptyText(tr("Select a mission above to see who has sailed it."));
    auto* const doing = new QHBoxLayout;
    doing->addWidget(m_state);
    doing->addStretch(1);
    doing->addWidget(m_withdraw);
    auto* const left = new QVBoxLayout;
    left->setSpacing(6);
    left->addLayout(doing);
    left->addWidget(m_table, 3);
    left->addWidget(m_trouble);
    left->addWidget(m_membersTitle);
    left->addWidget(m_members, 2);
    auto* const scroll = new QScrollArea(this);
    scroll->setWidget(m_form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedWidth(kForm_px);
    auto* const layout = new QHBoxLayout(this);
    layout->setSpacing(20);
    layout->addLayout(left, 1);
    layout->addWidget(scroll);

    connect(m_state, &QComboBox::activated, this, &AssignmentsPanel::showAssignments);
    connect(m_table, &RowsView::chosen, this, &AssignmentsPanel::showMembers);
    connect(m_withdraw, &QPushButton::clicked, this, [this] {
        const Trouble trouble = m_port.withdraw(m_table->selectedId());
        refresh();
        m_trouble->say(trouble.value_or(QString()));
    });
    connect(m_form, &AssignmentForm::assignWanted, this, [this](const NewAssignment& wanted) {
        if (const Trouble trouble = m_port.assign(wanted)) return m_form->say(*trouble);
        refresh();
    });
}

void AssignmentsPanel::setColours(PaletteName palette) {
    m_table->setColours(palette);
    m_members->setColours(palette);
}

void AssignmentsPanel::assignTo(std::int64_t person) { m_form->choosePerson(person); }

void AssignmentsPanel::refresh() {
    m_trouble->say({});
    m_assignments = m_port.assignments();
    m_form->setChoices(m_port.people(), m_port.classes(), m_port.missions(), m_port.now());
    showAssignments();
}

void AssignmentsPanel::showAssignments() {
    const int wanted = m_state->currentData().toInt();
    std::vector<Row> rows;
    for (const Assignment& a : m_assignments) {
        const bool shown =
            wanted == kNotWithdrawn ? a.state != State::Withdrawn : static_cast<int>(a.state) == wanted;
        if (shown) rows.push_back(rowOf(a));
    }
    m_table->setEmptyText(!m_port.trouble().isEmpty() ? tr("The missions cannot be read just now.")
                          : m_assignments.empty()
                              ? tr("No mission has been assigned yet. Choose one on the right, for whom and "
                                   "by when, and press Assign.")
                              : tr("No mission is in this state. Choose another above."));
    m_table->show(std::move(rows));
    showMembers();
}

void AssignmentsPanel::showMembers() {
    const Assignment* const a = chosen();
    m_withdraw->setEnabled(a != nullptr && a->state != State::Withdrawn);
    std::vector<Row> rows;
    if (a != nullptr) {
        std::int64_t id = 0;
        for (const Member& m : a->members)
            rows.push_back(
                {++id, {m.name, stateCell(m.state), m.done ? timeCell(*m.done) : Cell(QStringLiteral("-"))}});
    }
    m_members->setEmptyText(a == nullptr ? tr("Select a mission above to see who has sailed it.")
                                         : tr("Nobody is in this class. Move people to it under People."));
    m_members->show(std::move(rows));
}

const Assignment* AssignmentsPanel::chosen() const {
    const std::int64_t id = m_table->selectedId();
    const auto known = std::find_if(m_assignments.begin(), m_assignments.end(),
                                    [id](const Assignment& a) { return a.id == id; });
    return known == m_assignments.end() ? nullptr : &*known;
}

}  // namespace sagara::ui::roster
