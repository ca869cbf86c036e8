#pragma once

#include <QWidget>

#include "ui/demo/DemoLock.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QPushButton;

namespace sagara::ui {

/// The numeric pad over the exhibition. Digits by mouse, touch or keyboard.
class PinPad final : public QWidget {
    Q_OBJECT

public:
    explicit PinPad(DemoLock& lock, QWidget* parent);
    void open();
    /// Counts the wait down and hides when the lock has closed itself.
    void advance(double elapsed_s);
    void fit(QSize page, PaletteName palette);  ///< in the middle of it, sized by its height

Q_SIGNALS:
    void opened();  ///< the right PIN

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void type(char digit);
    void refresh();
    void cancel();

    DemoLock& m_lock;
    PaletteName m_palette = PaletteName::Day;
    QLabel* m_title;
    QLabel* m_dots;
    QLabel* m_message;
    std::vector<QPushButton*> m_digits;
};

}  // namespace sagara::ui
