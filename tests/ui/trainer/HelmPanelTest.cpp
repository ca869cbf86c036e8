// Pitch and azimuth drives worked from the trainer's desk.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <cstdlib>

#include "SteppedRun.h"
#include "core/base/Units.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/trainer/HelmPanel.h"
#include "ui/trainer/Instruments.h"

namespace sagara::ui {
namespace {

/// Helm panel and readings of a vessel in open water.
class Panels {
public:
    explicit Panels(const char* vessel) : run(worldWith(vessel)), helm(run, 0), readings(*run.world(), 0) {
        run.start();
        helm.resize(330, 420);
        helm.show();
        readings.show();
        sail(0.1);
    }
    void sail(double seconds) {
        run.sail(seconds);
        helm.refresh();
        readings.show(*run.latest());
    }
    QSlider* slider(const char* name) { return helm.findChild<QSlider*>(QString::fromLatin1(name)); }
    template <typename Wanted>
    const Wanted& last() {
        return std::get<Wanted>(run.given().back());
    }
    bool says(const QWidget& panel, const QString& text) {
        for (const QLabel* label : panel.findChildren<QLabel*>())
            if (label->text() == text) return true;
        return false;
    }
    void keep(const char* name) {
        const char* const folder = std::getenv("SAGARA_UI_PICTURES");
        if (folder == nullptr) return;
        const QString path = QStringLiteral("%1/desk-%2-%3.png").arg(QString::fromUtf8(folder));
        readings.resize(330, 420);
        QApplication::processEvents();
        helm.grab().save(path.arg(QLatin1String(name), QStringLiteral("helm")));
        readings.grab().save(path.arg(QLatin1String(name), QStringLiteral("readings")));
    }

    test::SteppedRun run;
    HelmPanel helm;
    Instruments readings;

private:
    static std::shared_ptr<const core::World> worldWith(const char* vessel) {
        const QString json = QStringLiteral("\"%1\"").arg(QLatin1String(vessel));
        return test::worldOf(
            test::with(test::openWaterScenario(1, 0), "/ownShips/0/vessel", json.toStdString()));
    }
};

TEST(HelmPanel, HasSlidersForPitchAndDrivesOnlyWhereTheyAre) {
    Panels patrol("patrol51"), ferry("ferry86"), tug("tug30");
    EXPECT_EQ(patrol.slider("pitch-0"), nullptr);
    EXPECT_EQ(patrol.slider("azimuth-0"), nullptr);
    EXPECT_NE(ferry.slider("pitch-1"), nullptr);
    EXPECT_EQ(ferry.slider("azimuth-1"), nullptr);
    EXPECT_NE(tug.slider("azimuth-1"), nullptr);
    EXPECT_EQ(tug.slider("pitch-1"), nullptr);
}

TEST(HelmPanel, OrdersPitchUntilTheTelegraphTakesItBack) {
    Panels ferry("ferry86");
    QSlider* const pitch = ferry.slider("pitch-0");
    EXPECT_EQ(pitch->minimum(), -17) << "85 % astern";
    EXPECT_EQ(pitch->maximum(), 20);
    pitch->setValue(6);
    EXPECT_EQ(ferry.last<core::PitchOrder>().shaft, 0);
    EXPECT_NEAR(ferry.last<core::PitchOrder>().pitch, 0.3, 1e-12);
    ferry.sail(60.0);
    EXPECT_EQ(pitch->value(), 6);
    EXPECT_TRUE(ferry.says(ferry.helm, QStringLiteral("Pitch, port: 30 %")));
    EXPECT_TRUE(ferry.says(ferry.readings, QStringLiteral("30 (30)")));
    ferry.keep("ferry86");
    ferry.run.give(0, core::TelegraphOrder{0, core::TelegraphStep::Stop});
    const std::size_t given = ferry.run.given().size();
    ferry.sail(0.1);
    EXPECT_EQ(pitch->value(), 0);
    EXPECT_EQ(ferry.run.given().size(), given) << "following gives no order";
}

TEST(HelmPanel, TurnsAnAzimuthDrive) {
    Panels tug("tug30");
    tug.slider("azimuth-1")->setValue(-18);
    EXPECT_EQ(tug.last<core::AzimuthOrder>().shaft, 1);
    EXPECT_NEAR(tug.last<core::AzimuthOrder>().angle_rad, -90.0 * core::kDegree_rad, 1e-12);
    tug.sail(30.0);
    EXPECT_TRUE(tug.says(tug.helm, QStringLiteral("Drive, starboard: 270°")));
    EXPECT_TRUE(tug.says(tug.readings, QStringLiteral("270 (270)")));
    tug.keep("tug30");
}

}  // namespace
}  // namespace sagara::ui
