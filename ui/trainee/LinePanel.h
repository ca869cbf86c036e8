#pragma once

#include <QWidget>
#include <vector>

#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QToolButton;

namespace sagara::ui::console {

class TensionBar;

/// A row for every mooring line of an own ship: how it stands, its tension, and the orders to the deck.
class LinePanel final : public QWidget {
    Q_OBJECT

public:
    LinePanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void show(const core::OwnShipView& ship);
    using QWidget::show;

private:
    void addRow(std::size_t line);

    struct Row {
        QLabel* state;
        TensionBar* tension;
        std::vector<QToolButton*> buttons;  ///< in the order of core::LineAction
    };
    ExerciseRun& m_run;
    std::uint8_t m_ship;
    std::vector<Row> m_rows;
};

/// "fore-spring" as people read it: "Fore spring".
QString spokenName(const std::string& id);

}  // namespace sagara::ui::console
