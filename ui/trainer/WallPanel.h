#pragma once

#include <QWidget>

#include "ui/run/WallControl.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace sagara::ui {

/// The wall from the trainer's desk: which layout, on or off, how each channel does, starting one again.
class WallPanel final : public QWidget {
    Q_OBJECT

public:
    explicit WallPanel(WallControl& wall, QWidget* parent = nullptr);
    void refresh();  ///< by a timer of its own, and by tests

private:
    void startOrStop();
    void fill(const WallControl::Status& status);
    QWidget* restartButton(const std::string& channel);

    WallControl& m_wall;
    QComboBox* m_layout;
    QComboBox* m_placement;
    QPushButton* m_start;
    QLabel* m_state;
    QTableWidget* m_channels;
    QListWidget* m_notes;
    bool m_asked = false;  ///< to run, and nothing heard of it yet
};

}  // namespace sagara::ui
