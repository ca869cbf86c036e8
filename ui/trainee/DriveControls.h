#pragma once

#include <QWidget>

#include "core/exercise/Snapshot.h"

namespace sagara::ui::console {

class AzimuthDial;
class PitchLever;
class ShaftTelegraph;

/// What one shaft is worked with: its telegraph, and beside it what her document says of it, a lever for
/// blades that turn, a dial for an azimuth drive.
class DriveControls final : public QWidget {
    Q_OBJECT

public:
    /// `shaft` counted from port; the propulsion outlives it.
    DriveControls(const core::Propulsion& propulsion, std::size_t shaft, QWidget* parent = nullptr);
    ShaftTelegraph& telegraph() { return *m_telegraph; }
    PitchLever* pitch() { return m_pitch; }       ///< null: fixed blades
    AzimuthDial* azimuth() { return m_azimuth; }  ///< null: a shaft
    void setUnit(double unit);
    /// Orders are shown only when those on their way have arrived.
    void show(const core::OwnShipView& own, bool settled);
    using QWidget::show;

private:
    const core::PropulsionUnit& m_unit;
    std::size_t m_shaft;
    ShaftTelegraph* m_telegraph;
    PitchLever* m_pitch = nullptr;
    AzimuthDial* m_azimuth = nullptr;
};

}  // namespace sagara::ui::console
