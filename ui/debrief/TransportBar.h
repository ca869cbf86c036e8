#pragma once

#include <QWidget>

#include "ui/debrief/Replay.h"
#include "ui/theme/PaletteName.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace sagara::ui {

/// Play, pace and steps of a replay, and its clocks.
class TransportBar final : public QWidget {
    Q_OBJECT

public:
    explicit TransportBar(QWidget* parent = nullptr);

    void setColours(PaletteName name);
    void setReplay(Replay& replay);
    /// `sailing`: something else is sailed meanwhile.
    void refresh(bool sailing, bool exactShown);

Q_SIGNALS:
    void stepWanted(double seconds);
    void markWanted(int direction);  ///< +1 the next, -1 the one before
    void playToggled();
    void noteWanted();
    void sailWanted();

private:
    QToolButton* button(const QString& name, const QString& text, const QString& icon, const QString& tip);

    Replay* m_replay = nullptr;
    PaletteName m_colours = PaletteName::Day;
    QToolButton* m_play;
    QToolButton *m_before, *m_next;
    QComboBox* m_rate;
    QLabel* m_clock;
    QLabel* m_place;
    QLabel* m_source;
    QPushButton* m_note;
    QPushButton* m_sail;
};

}  // namespace sagara::ui
