#pragma once

#include <memory>

#include "ui/roster/RosterPort.h"
#include "ui/theme/Page.h"

class QLabel;

namespace sagara::ui::roster {

class AssessorForm;
class FieldNote;
class RowsView;

/// What came of a run: the automatic score, marked as advice, its tasks and deductions; beside it what the
/// assessor says.
class ResultPage final : public Page {
    Q_OBJECT

public:
    explicit ResultPage(std::unique_ptr<ResultPort> port, QWidget* parent = nullptr);

    void setColours(PaletteName palette) override;
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("result"); }

private:
    void refresh();
    void showScore();
    void signOff(const Entry& entry, std::int64_t by);
    void report();

    std::unique_ptr<ResultPort> m_port;
    Result m_result;
    PaletteName m_palette = PaletteName::Day;
    QLabel *m_title, *m_facts, *m_verdict, *m_score, *m_advice, *m_whyNot;
    RowsView *m_tasks, *m_losses;
    AssessorForm* m_assessor;
    FieldNote* m_trouble;
};

}  // namespace sagara::ui::roster
