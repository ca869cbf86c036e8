// A window of the station with two views of one scene, without an X server (render/headless stands in for
// GLX).
#include "ui/viewport/ViewportWidget.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QHBoxLayout>
#include <QSignalSpy>
#include <QTest>
#include <cstdlib>

#include "core/exercise/Snapshot.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::ui {
namespace {

class ViewportWindow : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_world = test::lessonWorld();
        auto stage = render::Stage::open({SAGARA_ASSETS, render::Preset::Low, true});
        ASSERT_TRUE(stage) << stage.error();
        s_stage = std::move(stage).value();
        ASSERT_FALSE(s_stage->show(s_world));
    }
    static void TearDownTestSuite() { s_stage.reset(); }

    void SetUp() override {
        auto* const layout = new QHBoxLayout(&m_window);
        for (ViewportWidget*& view : m_views) {
            view = new ViewportWidget(s_stage->addViewport(16, 16));
            layout->addWidget(view);
        }
        m_views[1]->setCameraKind(CameraKind::Chase);
        m_window.resize(800, 300);
        m_window.show();
        QApplication::processEvents();
    }
    void draw() {
        for (ViewportWidget* view : m_views) view->aim(*s_world, m_moment);
        const auto trouble = s_stage->draw(m_moment);
        ASSERT_FALSE(trouble) << *trouble;
        for (ViewportWidget* view : m_views) view->refresh();
        QApplication::processEvents();
    }
    /// As many colours as a picture of sea and sky has.
    static int coloursOf(QWidget& widget) {
        const QImage image = widget.grab().toImage();
        QSet<QRgb> colours;
        for (int y = 0; y < image.height(); y += 3)
            for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y));
        return static_cast<int>(colours.size());
    }

    static inline std::shared_ptr<const core::World> s_world;
    static inline std::unique_ptr<render::Stage> s_stage;
    render::Moment m_moment = render::momentOf(core::view(*s_world, core::startState(*s_world, 3)));
    QWidget m_window;
    std::array<ViewportWidget*, 2> m_views{};
};

TEST_F(ViewportWindow, SaysSoBeforeThereIsAPicture) { EXPECT_LT(coloursOf(*m_views[0]), 60); }

TEST_F(ViewportWindow, ShowsTheSceneFromTwoCameras) {
    draw();
    EXPECT_GT(coloursOf(*m_views[0]), 200);
    EXPECT_GT(coloursOf(*m_views[1]), 200);
    EXPECT_NE(m_views[0]->grab().toImage(), m_views[1]->grab().toImage());
    if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
        m_window.grab().save(QString::fromUtf8(folder) + QStringLiteral("/viewport-window.png"));
}

TEST_F(ViewportWindow, ThePictureTakesTheSizeOfTheWindow) {
    draw();
    m_window.resize(1000, 400);
    QApplication::processEvents();
    draw();
    const QImage shown = m_views[0]->grab().toImage();
    EXPECT_EQ(shown.width(), m_views[0]->width());
    EXPECT_GT(coloursOf(*m_views[0]), 200);
}

TEST_F(ViewportWindow, DraggingTurnsTheHead) {
    draw();
    const QPoint middle = m_views[0]->rect().center();
    QTest::mousePress(m_views[0], Qt::LeftButton, {}, middle);
    QMouseEvent drag(QEvent::MouseMove, QPointF(middle + QPoint(-100, 0)), QPointF(), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(m_views[0], &drag);
    QTest::mouseRelease(m_views[0], Qt::LeftButton, {}, middle + QPoint(-100, 0));
    EXPECT_NEAR(m_views[0]->rig().yaw_rad(), 100.0 * kViewportFov_rad / m_views[0]->width(), 1e-9);
}

TEST_F(ViewportWindow, AClickTakesABearing) {
    draw();
    QSignalSpy bearings(m_views[0], &ViewportWidget::bearingTaken);
    QTest::mouseClick(m_views[0], Qt::LeftButton, {}, m_views[0]->rect().center());
    ASSERT_EQ(bearings.size(), 1);
    const double heading_rad = m_moment.ships[0].heading_rad;
    EXPECT_NEAR(std::remainder(bearings[0][0].toDouble() - heading_rad, 2.0 * M_PI), 0.0, 0.02);
}

TEST_F(ViewportWindow, KeysTurnMagnifyAndMove) {
    draw();
    QTest::keyClick(m_views[0], Qt::Key_Right);
    EXPECT_GT(m_views[0]->rig().yaw_rad(), 0.0);
    QTest::keyClick(m_views[0], Qt::Key_B);
    EXPECT_EQ(m_views[0]->rig().magnification(), 7.0);
    QTest::keyClick(m_views[0], Qt::Key_Home);
    EXPECT_EQ(m_views[0]->rig().magnification(), 1.0);
    m_views[0]->setCameraKind(CameraKind::Free);
    QTest::keyClick(m_views[0], Qt::Key_W);
    draw();
    EXPECT_GT(coloursOf(*m_views[0]), 200);
}

}  // namespace
}  // namespace sagara::ui

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
