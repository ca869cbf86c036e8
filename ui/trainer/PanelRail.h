#pragma once

#include <QWidget>
#include <vector>

#include "ui/theme/PaletteName.h"

class QButtonGroup;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace sagara::ui {

/// Panels of which one is seen, chosen by a column of tabs with icons at their left. Ctrl+1 to Ctrl+9 choose
/// too.
class PanelRail final : public QWidget {
    Q_OBJECT

public:
    explicit PanelRail(QWidget* parent = nullptr);
    /// `name`: the panel is found and shown by it. `icon`: of themedIcon. The rail takes the panel.
    void add(const QString& name, const QString& title, const QString& icon, QWidget* panel,
             bool scrolls = true);
    void showPanel(const QString& name);
    QString shown() const;
    void setColours(PaletteName name);

private:
    struct Tab {
        QString name;
        QString icon;
        QToolButton* button;
    };
    QVBoxLayout* m_column;
    QButtonGroup* m_buttons;
    QStackedWidget* m_stack;
    std::vector<Tab> m_tabs;
};

}  // namespace sagara::ui
