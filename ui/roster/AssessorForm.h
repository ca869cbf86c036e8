#pragma once

#include <QWidget>

#include "ui/roster/RosterTypes.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace sagara::ui::roster {

class FieldNote;

/// The assessor's part: comment, overruling with a reason, sign-off. After that it can only be read.
class AssessorForm final : public QWidget {
    Q_OBJECT

public:
    explicit AssessorForm(QWidget* parent = nullptr);

    void show(const Result& result, const std::vector<Person>& assessors);
    bool changed() const;
    void say(const QString& trouble);
    using QWidget::show;

Q_SIGNALS:
    void saveWanted(const Entry& entry);
    void signOffWanted(const Entry& entry, std::int64_t by);

private:
    Entry typed() const;
    void check();
    void fillAssessors(const std::vector<Person>& assessors);

    Entry m_kept;
    bool m_open = false;  ///< may be changed
    bool m_filling = false;
    QPlainTextEdit *m_comment, *m_reason;
    QCheckBox* m_overrule;
    QWidget* m_overruling;
    QDoubleSpinBox* m_score;
    QComboBox *m_passed, *m_by;
    FieldNote *m_commentNote, *m_reasonNote, *m_byNote, *m_trouble;
    QLabel* m_state;
    QWidget* m_signing;
    QPushButton *m_save, *m_sign;
};

}  // namespace sagara::ui::roster
