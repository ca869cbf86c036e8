#pragma once

#include <QElapsedTimer>
#include <QKeySequence>
#include <functional>
#include <map>
#include <memory>

#include "render/scene/Stage.h"
#include "ui/demo/DemoCameras.h"
#include "ui/demo/DemoDirector.h"
#include "ui/demo/DemoHelm.h"
#include "ui/demo/DemoLog.h"
#include "ui/demo/DemoOverlay.h"
#include "ui/demo/PinPad.h"
#include "ui/run/ExerciseRun.h"
#include "ui/theme/Page.h"

class QTimer;

namespace sagara::ui {

class ViewportWidget;

/// The lessons of the exhibition. Nothing of them is written anywhere.
class DemoExercises {
public:
    virtual ~DemoExercises() = default;
    virtual std::size_t count() const = 0;
    /// The one a visitor gets while the pilot casts off or anchors: she is under way from its start.
    virtual std::size_t helmLesson() const = 0;
    /// Puts `run` back to the first State of that lesson, frozen; the pilot takes her with the first tick.
    virtual void begin(std::size_t lesson) = 0;
    virtual ExerciseRun& run() = 0;  ///< the same object for all lessons; has one from the first `begin` on
};

/// The projector wall, if there is one.
class DemoWall {
public:
    virtual ~DemoWall() = default;
    /// After every `begin`: shows the run from now on, whose world may be another one.
    virtual void show() = 0;
};

struct DemoPorts {
    std::unique_ptr<DemoExercises> exercises;  ///< at least one lesson
    /// The 3D scene showing that world; null where there is none.
    std::function<render::Stage*(const std::shared_ptr<const core::World>&)> stageFor;
    std::unique_ptr<DemoWall> wall;  ///< may be null; goes before the exercises
    /// Nothing while no joystick is plugged in.
    std::function<std::optional<StickReading>()> stick;
};

struct DemoSettings {
    DemoTiming timing;
    QKeySequence chord{Qt::CTRL | Qt::SHIFT | Qt::Key_Q};
    std::string pin = "0000";
    bool fullScreen = true;
    std::filesystem::path log;  ///< empty: none
    double logEvery_s = 60.0;
};

/// The exhibition: see README.md. Runs by its own timers from when it is first shown.
class DemoPage final : public Page {
    Q_OBJECT

public:
    DemoPage(DemoPorts ports, DemoSettings settings, QWidget* parent = nullptr);
    ~DemoPage() override;

    void setColours(PaletteName palette) override;
    bool mayLeave() override;  ///< only with the PIN: asks for it
    QString helpTopic() const override { return QStringLiteral("demo"); }

    const DemoDirector& director() const { return m_director; }
    const DemoFigures& figures() const { return m_figures; }
    std::size_t lesson() const { return m_lesson; }
    const DemoCamera& camera() const { return m_camera; }
    ExerciseRun& run() { return m_ports.exercises->run(); }
    void drawView();              ///< by a timer, and by tests
    void beat(double elapsed_s);  ///< by a timer, and by tests

Q_SIGNALS:
    /// The run stands at its first State and has not begun.
    void atFirstState();

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent*) override;

private:
    void begin(std::size_t lesson);
    void checkFirstState();
    void showWorld();
    void touch();
    void perform(DemoDirector::Act act);
    void takeHelm();
    void give(const DemoHelm::Orders& orders);
    void pollStick();
    void judge(double elapsed_s);
    void caption();
    void leave();
    bool onPassage() const;

    DemoPorts m_ports;
    DemoSettings m_settings;
    DemoDirector m_director;
    DemoLock m_lock;
    DemoHelm m_helm;
    DemoScore m_score;
    DemoLog m_log;
    DemoFigures m_figures;
    std::size_t m_lesson = 0;
    std::map<std::size_t, std::uint64_t> m_firstHashes;
    std::shared_ptr<const core::World> m_world;  ///< that the scene shows
    render::Stage* m_stage = nullptr;
    ViewportWidget* m_view = nullptr;
    PaletteName m_palette = PaletteName::Day;
    DemoOverlay* m_overlay;
    PinPad* m_pad;
    DemoCamera m_camera;
    Hints m_hints;
    std::optional<StickReading> m_stick;
    std::size_t m_eventsSeen = 0;
    QElapsedTimer m_sinceBeat, m_sinceFrame;
    QTimer* m_frames;
    QTimer* m_beats;
    bool m_released = false;
    bool m_begun = false;
};

}  // namespace sagara::ui
