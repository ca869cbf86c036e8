#pragma once

#include <QWidget>
#include <array>

#include "ui/demo/DemoTexts.h"
#include "ui/theme/PaletteName.h"
#include "ui/theme/ThemeColours.h"

class QPushButton;

namespace sagara::ui {

/// What stands over the picture of the exhibition now.
struct DemoShown {
    QString lesson;
    QString camera;
    DemoCaption caption;
    bool invites = false;  ///< "Take the helm: press any key"
    struct Guide {
        double left_s = 0.0;
        QString rudder;
        QString engine;
        QString next;  ///< "Steer 271° to “Into the sea”"
    };
    std::optional<Guide> guide;
    struct Verdict {
        int stars = 1;
        QString sentence;
        QString sailed;
    };
    std::optional<Verdict> verdict;
    QString curtain;  ///< over everything, while the next lesson is set up
};

/// Captions, guide and score, readable from 3 m: all sizes follow the height of the screen. Transparent to
/// the mouse but for the helm's buttons.
class DemoOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit DemoOverlay(QWidget* parent);
    void display(DemoShown shown);
    const DemoShown& shown() const { return m_shown; }
    void setColours(PaletteName palette);

Q_SIGNALS:
    void pressed(int key);  ///< DemoHelm::Key

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    double unit() const;  ///< a hundredth of the height, less on narrow screens
    QFont font(double units, bool bold = false) const;
    QRectF band() const;
    QRectF guideFrame() const;
    void paintBrand(QPainter& painter) const;
    void paintBand(QPainter& painter) const;
    void paintInvitation(QPainter& painter) const;
    void paintGuide(QPainter& painter) const;
    void paintVerdict(QPainter& painter) const;
    void layOutButtons();
    void panel(QPainter& painter, const QRectF& frame) const;
    const ThemeColours& colours() const;

    DemoShown m_shown;
    PaletteName m_palette = PaletteName::Day;
    std::array<QPushButton*, 5> m_buttons{};
};

}  // namespace sagara::ui
