#pragma once

#include <QWidget>
#include <vector>

#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace sagara::ui::console {

class TensionBar;

/// Every anchor of an own ship: cable out in shackles, strain, and the orders to the forecastle.
class AnchorPanel final : public QWidget {
    Q_OBJECT

public:
    AnchorPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void show(const core::OwnShipView& ship);
    using QWidget::show;

private:
    void addRow(std::size_t anchor);
    void order(std::size_t anchor, core::AnchorAction action);

    struct Row {
        QLabel* state;
        TensionBar* strain;
        QDoubleSpinBox* shackles;           ///< brake on at
        std::vector<QToolButton*> buttons;  ///< in the order of core::AnchorAction
    };
    ExerciseRun& m_run;
    std::uint8_t m_ship;
    std::vector<Row> m_rows;
};

}  // namespace sagara::ui::console
