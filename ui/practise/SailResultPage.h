#pragma once

#include <functional>
#include <optional>

#include "ui/practise/SailResult.h"
#include "ui/theme/Page.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace sagara::ui {

/// What came of a run sailed alone: score, tasks, every loss of points with its replay.
class SailResultPage final : public Page {
    Q_OBJECT

public:
    struct Ports {
        /// The debriefing at that second. The error is for a person.
        std::function<std::optional<std::string>(double time_s)> replay;
        std::function<std::optional<std::string>()> again;  ///< the same once more
    };
    SailResultPage(SailResult result, Ports ports, QWidget* parent = nullptr);

    QString helpTopic() const override { return QStringLiteral("practise"); }
    /// Where the replay of a loss begins: a little before it, to see it come.
    static double replayFrom_s(double loss_s);

private:
    QWidget* head();
    QTableWidget* taskTable();
    QTableWidget* lossTable();
    void run(const std::function<std::optional<std::string>()>& act);

    SailResult m_result;
    Ports m_ports;
    QLabel* m_trouble;
};

}  // namespace sagara::ui
