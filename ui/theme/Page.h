#pragma once

#include <QWidget>

#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// A page of the station: the window shows one at a time, the one behind it when it is left. The window has
/// the way back; a page's own button of the name "back" is hidden there.
class Page : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// For what is painted by hand; ordinary widgets follow the application's palette. Called once before the
    /// page is shown and whenever the person changes it.
    virtual void setColours(PaletteName) {}
    /// Asked before the page is left. Who has something to lose asks the person here.
    virtual bool mayLeave() { return true; }
    /// assets/help/TOPIC.md is shown at F1.
    virtual QString helpTopic() const = 0;

Q_SIGNALS:
    /// The person wants to go back to the page before.
    void leaveWanted();
};

}  // namespace sagara::ui
