#include "ui/roster/RosterPage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/roster/AssignmentsPanel.h"
#include "ui/roster/Field.h"
#include "ui/roster/HistoryPanel.h"
#include "ui/roster/PeoplePanel.h"

namespace sagara::ui::roster {

RosterPage::RosterPage(std::unique_ptr<RosterPort> port, QWidget* parent)
    : Page(parent),
      m_port(std::move(port)),
      m_trouble(new QLabel(this)),
      m_tabs(new QTabWidget(this)),
      m_people(new PeoplePanel(*m_port, this)),
      m_assignments(new AssignmentsPanel(*m_port, this)),
      m_history(new HistoryPanel(*m_port, this)) {
    setWindowTitle(tr("Roster"));
    setObjectName(QStringLiteral("roster-page"));
    m_trouble->setObjectName(QStringLiteral("roster-trouble"));
    m_trouble->setWordWrap(true);
    m_tabs->setObjectName(QStringLiteral("roster-tabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_people, tr("&People"));
    m_tabs->addTab(m_assignments, tr("&Assigned missions"));
    m_tabs->addTab(m_history, tr("Run &history"));
    auto* const back = new QPushButton(tr("Back"), this);
    back->setObjectName(QStringLiteral("back"));
    back->setToolTip(tr("To the page before (Alt+Left)"));
    back->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Left));
    auto* const top = new QHBoxLayout;
    top->addWidget(back);
    top->addSpacing(12);
    top->addWidget(heading(tr("Roster"), 1.6, this));
    top->addSpacing(24);
    top->addWidget(m_trouble, 1);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 14, 20, 14);
    layout->addLayout(top);
    layout->addWidget(m_tabs, 1);
    connect(back, &QPushButton::clicked, this, &Page::leaveWanted);
    connect(m_people, &PeoplePanel::changedRoster, this, &RosterPage::refresh);
    connect(m_people, &PeoplePanel::assignWanted, this, [this](std::int64_t person) {
        m_tabs->setCurrentWidget(m_assignments);
        m_assignments->assignTo(person);
    });
    connect(m_people, &PeoplePanel::runsWanted, this, [this](std::int64_t person) {
        m_tabs->setCurrentWidget(m_history);
        m_history->showRunsOf(person);
    });
}

void RosterPage::setColours(PaletteName palette) {
    m_people->setColours(palette);
    m_assignments->setColours(palette);
    m_history->setColours(palette);
}

bool RosterPage::mayLeave() {
    if (!m_people->changed()) return true;
    return QMessageBox::question(this, tr("Roster"),
                                 tr("What was typed about this person is not saved. Leave it?")) ==
           QMessageBox::Yes;
}

void RosterPage::refresh() {
    m_people->refresh();
    m_assignments->refresh();
    m_history->refresh();
    m_trouble->setText(m_port->trouble());
}

void RosterPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (!m_people->changed()) refresh();
}

}  // namespace sagara::ui::roster
