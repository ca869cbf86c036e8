#pragma once

#include <QWidget>
#include <array>

#include "ui/run/ExerciseRun.h"

class QLabel;

namespace sagara::ui::console {

/// What is reported from the bridge: to port control, anchored, man overboard.
class ReportPanel final : public QWidget {
    Q_OBJECT

public:
    ReportPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent = nullptr);

private:
    void report(core::ReportKind kind, const QString& text);

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    QLabel* m_last;
};

}  // namespace sagara::ui::console
