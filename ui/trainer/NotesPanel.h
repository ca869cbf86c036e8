#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace sagara::ui {

/// The trainer's bookmarks and notes, and what the trainee reports. All of them are in the recording.
class NotesPanel final : public QWidget {
    Q_OBJECT

public:
    explicit NotesPanel(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh();
    /// A bookmark at this moment, with what stands in the field.
    void bookmark();
    /// The cursor goes to the field.
    void beginNote();

private:
    void add(bool bookmark);

    ExerciseRun& m_run;
    QLineEdit* m_text;
    QPushButton* m_note;
    QPushButton* m_bookmark;
    QLabel* m_waiting;
    QListWidget* m_list;
    std::size_t m_events = 0;
    std::int64_t m_seen = 0;
    int m_given = 0;  ///< not carried out yet
};

}  // namespace sagara::ui
