#pragma once

#include <QWidget>

#include "ui/debrief/Branch.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace sagara::ui {

class HelmPanel;

/// Sails the run that left the recorded one: start and freeze, pace, rudder, telegraph, pilot.
class SailPanel final : public QWidget {
    Q_OBJECT

public:
    explicit SailPanel(Branch& branch, QWidget* parent = nullptr);
    void refresh();

Q_SIGNALS:
    void compareWanted();
    void endWanted();

private:
    Branch& m_branch;
    QLabel* m_clock;
    QLabel* m_trouble;
    QPushButton* m_start;
    QComboBox* m_rate;
    HelmPanel* m_helm = nullptr;
};

}  // namespace sagara::ui
