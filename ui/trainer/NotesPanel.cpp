#include "ui/trainer/NotesPanel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/run/RunTexts.h"

namespace sagara::ui {

NotesPanel::NotesPanel(ExerciseRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_text(new QLineEdit(this)),
      m_note(new QPushButton(tr("Note"), this)),
      m_bookmark(new QPushButton(tr("Bookmark"), this)),
      m_waiting(new QLabel(this)),
      m_list(new QListWidget(this)) {
    m_text->setObjectName(QStringLiteral("note-text"));
    m_text->setMaxLength(120);
    m_text->setPlaceholderText(tr("What you see, for the debriefing"));
    m_text->setToolTip(tr("At most 120 letters; Enter keeps it with this moment (Ctrl+N comes here)"));
    m_note->setObjectName(QStringLiteral("add-note"));
    m_note->setToolTip(tr("Keeps the words with this moment (Enter)"));
    m_bookmark->setObjectName(QStringLiteral("add-bookmark"));
    m_bookmark->setToolTip(tr("Marks this moment, with the words or without (Ctrl+B)"));
    m_list->setObjectName(QStringLiteral("notes-list"));
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
    m_list->setWordWrap(true);
    m_waiting->setObjectName(QStringLiteral("notes-state"));
    m_waiting->setWordWrap(true);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(m_note);
    buttons->addWidget(m_bookmark);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_text);
    layout->addLayout(buttons);
    layout->addWidget(m_waiting);
    layout->addWidget(m_list, 1);
    connect(m_text, &QLineEdit::returnPressed, this, [this] { add(false); });
    connect(m_text, &QLineEdit::textChanged, this, [this] { refresh(); });
    connect(m_note, &QPushButton::clicked, this, [this] { add(false); });
    connect(m_bookmark, &QPushButton::clicked, this, &NotesPanel::bookmark);
    refresh();
}

void NotesPanel::bookmark() { add(true); }

void NotesPanel::beginNote() { m_text->setFocus(Qt::ShortcutFocusReason); }

void NotesPanel::add(bool bookmark) {
    const QString text = m_text->text().simplified();
    if (m_run.over() || (text.isEmpty() && !bookmark)) return;
    m_run.give(0, core::NoteOrder{text.toStdString(), bookmark});
    ++m_given;
    m_text->clear();
    refresh();
}

void NotesPanel::refresh() {
    const auto now = m_run.latest();
    if (now->tick < m_seen) {  // somebody went back
        m_list->clear();
        m_events = 0;
        m_given = 0;
    }
    m_seen = now->tick;
    for (const core::Event& event : m_run.eventsFrom(m_events)) {
        ++m_events;
        const bool note = event.kind == core::EventKind::NoteMade;
        if (!note && event.kind != core::EventKind::Reported) continue;
        if (note) m_given = std::max(0, m_given - 1);
        m_list->addItem(tr("%1  %2").arg(elapsed(event.time()), eventText(*m_run.world(), event)));
        m_list->scrollToBottom();
    }
    const bool over = m_run.over();
    m_text->setEnabled(!over);
    m_bookmark->setEnabled(!over);
    m_note->setEnabled(!over && !m_text->text().simplified().isEmpty());
    QString state;
    if (over)
        state = tr("The exercise is over; nothing can be added.");
    else if (m_given > 0)
        state = tr("%1 waiting: kept as soon as the exercise goes on.").arg(m_given);
    else if (m_list->count() == 0)
        state = tr("Nothing noted yet. Ctrl+B marks a moment, Ctrl+N begins a note.");
    m_waiting->setText(state);
    m_waiting->setVisible(!state.isEmpty());
}

}  // namespace sagara::ui
