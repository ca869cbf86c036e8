#pragma once

#include <QWidget>
#include <array>

#include "core/exercise/Snapshot.h"

class QLabel;

namespace sagara::ui {

/// What a trainer wants to see all the time: heading, course, speed, turn, rudder, water under the keel,
/// wind. In a line; what has no room is left out from the right.
class ReadingStrip final : public QWidget {
    Q_OBJECT

public:
    ReadingStrip(const core::World& world, std::size_t ship, QWidget* parent = nullptr);
    void show(const core::Snapshot& now);
    using QWidget::show;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    static constexpr std::size_t kReadings = 7;
    const core::World& m_world;
    std::size_t m_ship;
    std::array<QWidget*, kReadings> m_cells{};
    std::array<QLabel*, kReadings> m_values{};
};

}  // namespace sagara::ui
