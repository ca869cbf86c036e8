#pragma once

#include <QWidget>
#include <vector>

#include "ui/debrief/Comparison.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace sagara::ui {

/// Two runs side by side, from the second where they part.
class ComparePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ComparePanel(QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void show(const std::vector<ComparisonRow>& rows, const QString& about, bool maySailOn);
    using QWidget::show;

Q_SIGNALS:
    void picked(core::SimTime time);
    void sailOnWanted();
    void closeWanted();

private:
    QLabel* m_about;
    QLabel* m_legend;
    QTableWidget* m_table;
    QPushButton* m_sailOn;
};

}  // namespace sagara::ui
