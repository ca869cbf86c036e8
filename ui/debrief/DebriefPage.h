#pragma once

#include <memory>

#include "ui/debrief/DebriefDesk.h"
#include "ui/theme/Page.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;
class QTimer;

namespace sagara::ui {

/// The debriefing of one recording: opens it aside, with a bar and a way out, then shows its desk.
class DebriefPage final : public Page {
    Q_OBJECT

public:
    /// `name`: of the recording, for the person who waits.
    DebriefPage(DebriefPorts ports, const QString& name, QWidget* parent = nullptr);
    ~DebriefPage() override;

    void setColours(PaletteName name) override;
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("debrief"); }

    DebriefDesk* desk() const { return m_desk; }  ///< null until it is opened
    QString trouble() const;                      ///< why it cannot be opened; empty otherwise

Q_SIGNALS:
    void opened();
    void failed();

private:
    struct Opening;
    void showDesk(OpenedRecording recording);
    void fail(const QString& why);

    DebriefPorts m_ports;
    PaletteName m_colours = PaletteName::Day;
    std::shared_ptr<OpenProgress> m_progress;
    QStackedLayout* m_stack;
    QLabel* m_words;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    QTimer* m_poll;
    DebriefDesk* m_desk = nullptr;
};

}  // namespace sagara::ui
