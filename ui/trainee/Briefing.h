#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"

class QPushButton;
class QTextBrowser;

namespace sagara::ui::console {

/// What a trainee is told before she takes the watch: objective, briefing, ship, tasks, criteria.
class Briefing final : public QWidget {
    Q_OBJECT

public:
    Briefing(const core::World& world, std::size_t ship, QWidget* parent = nullptr);
    /// Once the watch is taken the button goes back to the bridge.
    void setTaken();

Q_SIGNALS:
    void watchTaken();

private:
    QTextBrowser* m_text;
    QPushButton* m_take;
};

/// No word of events, threats or anything a trainer keeps to himself.
QString traineeBriefing(const core::World& world, std::size_t ship);

}  // namespace sagara::ui::console
