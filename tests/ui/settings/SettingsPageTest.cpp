#include "ui/settings/SettingsPage.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QHostAddress>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QUdpSocket>
#include <cstdlib>

#include "VirtualStick.h"
#include "ui/settings/AxisBar.h"
#include "ui/settings/StoredSettings.h"
#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

enum { Display, Sound, Controls, Keyboard, Nmea, Demo, Data };

/// Settings of somebody else, so that a test can look at them after the page has gone.
class SharedSettings final : public SettingsStore {
public:
    explicit SharedSettings(MemorySettings& kept) : m_kept(kept) {}
    std::optional<std::string> get(std::string_view key) const override { return m_kept.get(key); }
    void put(std::string_view key, std::string_view value) override { m_kept.put(key, value); }
    QString trouble() const override { return m_kept.trouble(); }

private:
    MemorySettings& m_kept;
};

class Settings : public testing::Test {
protected:
    void SetUp() override { open(); }
    void open() {
        applyTheme(*qApp, PaletteName::Day);
        page = std::make_unique<SettingsPage>(
            std::make_unique<SharedSettings>(store), input, sound,
            [this](PaletteName palette) {
                applyTheme(*qApp, palette);
                page->setColours(palette);
                chosen = palette;
            },
            DataPlaces{QStringLiteral("/home/school/.local/share/sagara"),
                       QStringLiteral("/home/school/.local/share/sagara/sagara.db"),
                       {},
                       QStringLiteral("/home/school/.local/share/sagara/recordings")});
        page->setColours(PaletteName::Day);
        page->resize(1280, 720);
        page->show();
    }
    template <typename Widget>
    Widget* find(const QString& name) {
        auto* const widget = page->findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name.toStdString();
        return widget;
    }
    template <typename Widget>
    Widget* find(const char* name) {
        return find<Widget>(QString::fromLatin1(name));
    }
    void choose(const char* name, int data) {
        auto* const box = find<QComboBox>(name);
        box->setCurrentIndex(box->findData(data));
        Q_EMIT box->activated(box->currentIndex());
    }
    void poll() {
        input.joysticks().poll();
        QTest::qWait(60);  // the page looks 30 times a second
    }
    void picture(const char* name) {
        const char* const folder = std::getenv("SAGARA_UI_PICTURES");
        if (folder == nullptr) return;
        for (const PaletteName palette : {PaletteName::Day, PaletteName::Night}) {
            for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
                applyTheme(*qApp, palette);
                page->setColours(palette);
                page->resize(size);
                QTest::qWait(80);
                const QString file =
                    QStringLiteral("%1/settings-%2-%3-%4.png")
                        .arg(QString::fromUtf8(folder), QString::fromLatin1(name),
                             palette == PaletteName::Day ? QStringLiteral("day") : QStringLiteral("night"))
                        .arg(size.width());
                page->grab().save(file);
            }
        }
        applyTheme(*qApp, PaletteName::Day);
        page->setColours(PaletteName::Day);
        page->resize(1280, 720);
    }

    MemorySettings store;
    BridgeInput input;
    SoundBoard sound;
    std::unique_ptr<SettingsPage> page;
    PaletteName chosen = PaletteName::Day;
};

TEST_F(Settings, ThePaletteIsTakenAtOnceAndKept) {
    QTest::mouseClick(find<QPushButton>("palette-2"), Qt::LeftButton);
    EXPECT_EQ(chosen, PaletteName::Night);
    EXPECT_EQ(storedPalette(store), PaletteName::Night);
    EXPECT_TRUE(find<QPushButton>("palette-2")->isChecked());
    EXPECT_FALSE(find<QPushButton>("palette-0")->isChecked());
    picture("display");
}

TEST_F(Settings, MuteAndVolumeAreTakenAndKept) {
    page->openSection(Sound);
    find<QSlider>("sound-volume")->setValue(20);
    find<QCheckBox>("sound-muted")->click();
    EXPECT_DOUBLE_EQ(sound.volume(), 0.2);
    EXPECT_TRUE(sound.muted());
    EXPECT_EQ(store.get("sound.volume_percent"), "20");
    EXPECT_EQ(store.get("sound.muted"), "1");
    EXPECT_FALSE(find<QPushButton>("sound-test")->isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([this] { return sound.status().device == SoundBoard::Device::Found; }));
    QTest::qWait(80);
    EXPECT_EQ(find<QLabel>("sound-device")->text(), QString::fromStdString(sound.status().name));
    picture("sound");
}

TEST_F(Settings, WithoutADeviceItSaysWhatToDo) {
    page->openSection(Controls);
    EXPECT_TRUE(find<QLabel>("no-device")->isVisible());
    EXPECT_FALSE(find<QComboBox>("devices")->isEnabled());
    picture("controls-empty");
}

TEST_F(Settings, AStickAppearsMovesIsMappedAndDisappears) {
    page->openSection(Controls);
    auto stick = std::make_unique<test::VirtualStick>(3, 4, 1);
    poll();
    ASSERT_EQ(find<QComboBox>("devices")->count(), 1);
    stick->setAxis(1, -0.6);
    stick->setAxis(0, 0.4);
    stick->setButton(1, true);
    poll();
    EXPECT_NEAR(find<AxisBar>("axis-bar-1")->value(), -(0.6 - 0.03) / 0.97, 1e-3);
    picture("controls");

    choose("axis-use-1", static_cast<int>(AxisUse::Telegraph));
    choose("axis-shaft-1", 1);
    find<QCheckBox>("axis-inverted-1")->click();
    find<QSpinBox>("axis-dead-1")->setValue(10);
    choose("button-action-2", static_cast<int>(BridgeAction::Bookmark));
    const JoystickInfo device = input.joysticks().devices().at(0);
    const ControlMap map = input.mapOf(device);
    EXPECT_EQ(map.axes[1].use, AxisUse::Telegraph);
    EXPECT_EQ(map.axes[1].shaft, 1);
    EXPECT_TRUE(map.axes[1].calibration.inverted);
    EXPECT_DOUBLE_EQ(map.axes[1].calibration.deadZone, 0.1);
    EXPECT_EQ(map.buttons[2].action, BridgeAction::Bookmark);
    EXPECT_EQ(controlMapOf(store.get("input.device." + device.model).value_or("")), map);

    QTest::mouseClick(find<QPushButton>("usual-map"), Qt::LeftButton);
    EXPECT_EQ(input.mapOf(device), usualMap(3, 4, 1));
    stick->unplug();
    poll();
    EXPECT_TRUE(find<QLabel>("no-device")->isVisible());
}

TEST_F(Settings, NoShipObeysAStickWhileThePageIsOpen) {
    QSignalSpy helm(&input, &BridgeInput::helmWanted);
    test::VirtualStick stick(1, 0, 0);
    poll();
    stick.setAxis(0, 0.8);
    poll();
    EXPECT_TRUE(helm.isEmpty());
    page->hide();
    poll();
    EXPECT_TRUE(helm.isEmpty());  // closing the page is no order
    stick.setAxis(0, 0.5);
    poll();
    EXPECT_EQ(helm.size(), 1);
}

TEST_F(Settings, AnAxisIsCalibratedInTwoSteps) {
    page->openSection(Controls);
    test::VirtualStick stick(2, 0, 0);
    poll();
    stick.setAxis(0, 0.1);
    poll();
    QTest::mouseClick(find<QPushButton>("calibrate-0"), Qt::LeftButton);
    poll();
    auto* const next = find<QPushButton>("calibration-next");
    EXPECT_TRUE(find<QLabel>("calibration-step")->text().contains(QStringLiteral("1 of 2")));
    QTest::mouseClick(next, Qt::LeftButton);
    EXPECT_FALSE(next->isEnabled());
    for (const double raw : {-0.8, 0.9, 0.3}) {
        stick.setAxis(0, raw);
        poll();
    }
    EXPECT_TRUE(next->isEnabled());
    picture("calibrate");
    QTest::mouseClick(next, Qt::LeftButton);
    const AxisCalibration found = input.mapOf(input.joysticks().devices().at(0)).axes[0].calibration;
    EXPECT_NEAR(found.least, -0.8, 1e-3);
    EXPECT_NEAR(found.centre, 0.1, 1e-3);
    EXPECT_NEAR(found.most, 0.9, 1e-3);
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(page->findChild<QWidget*>(QStringLiteral("calibration")), nullptr);

    QTest::mouseClick(find<QPushButton>("calibrate-1"), Qt::LeftButton);
    QTest::mouseClick(find<QPushButton>("calibration-cancel"), Qt::LeftButton);
    EXPECT_EQ(input.mapOf(input.joysticks().devices().at(0)).axes[1].calibration, AxisCalibration{});
    QTest::mouseClick(find<QPushButton>("calibrate-1"), Qt::LeftButton);
    stick.unplug();
    poll();  // pulled out half way
    EXPECT_TRUE(find<QLabel>("no-device")->isVisible());
}

TEST_F(Settings, AKeyIsSetAndOneThatIsTakenIsRefusedWithTheReason) {
    page->openSection(Keyboard);
    auto* const horn = find<QKeySequenceEdit>("key-horn");
    horn->setKeySequence(QKeySequence(Qt::Key_F5));
    EXPECT_EQ(holderOf(input.keys(), QKeySequence(Qt::Key_F5)), BridgeAction::Horn);
    EXPECT_EQ(keyMapOf(store.get("input.keys").value_or("")), input.keys());
    horn->setKeySequence(QKeySequence(Qt::Key_Left));
    EXPECT_TRUE(find<QLabel>("keys-trouble")->text().contains(QStringLiteral("Rudder 5° to port")));
    EXPECT_EQ(horn->keySequence(), QKeySequence(Qt::Key_F5));
    picture("keyboard");
    QTest::mouseClick(find<QToolButton>("clear-horn"), Qt::LeftButton);
    EXPECT_FALSE(holderOf(input.keys(), QKeySequence(Qt::Key_F5)));
    QTest::mouseClick(find<QPushButton>("usual-keys"), Qt::LeftButton);
    EXPECT_EQ(input.keys(), usualKeys());
    EXPECT_EQ(horn->keySequence(), QKeySequence(Qt::Key_H));
}

TEST_F(Settings, NmeaIsListenedToAndItsErrorsAreShown) {
    page->openSection(Nmea);
    QUdpSocket probe;
    probe.bind(QHostAddress::LocalHost, 0);
    const int port = probe.localPort();
    probe.close();
    find<QSpinBox>("nmea-udp-port")->setValue(port);
    choose("nmea-source", static_cast<int>(NmeaSource::Udp));
    EXPECT_EQ(input.nmea().settings().udpPort, port);
    EXPECT_EQ(nmeaSettingsOf(store.get("input.nmea").value_or("")).source, NmeaSource::Udp);
    EXPECT_FALSE(find<QComboBox>("nmea-baud")->isEnabled());
    QUdpSocket bridge;
    const auto send = [&](const std::string& text) {
        bridge.writeDatagram(QByteArray::fromStdString(text), QHostAddress::LocalHost,
                             static_cast<quint16>(port));
    };
    send(withChecksum("IIROR,5.0,A,,V,B"));
    send("$IIROR,9.9,A,,V,B*00\r\n");
    ASSERT_TRUE(QTest::qWaitFor([this] { return input.nmea().counts().errors == 1; }));
    QTest::qWait(80);
    EXPECT_EQ(find<QLabel>("nmea-counts")->text(),
              QStringLiteral("orders: 1, other sentences: 0, errors: 1"));
    EXPECT_EQ(find<QLabel>("nmea-last")->text(), QStringLiteral("$IIROR,9.9,A,,V,B*00"));
    EXPECT_TRUE(find<QLabel>("nmea-error")->text().contains(QStringLiteral("checksum is wrong")));
    picture("nmea");
}

TEST_F(Settings, AnAddressThatIsNoneIsRefusedAtItsField) {
    page->openSection(Nmea);
    find<QCheckBox>("nmea-output")->click();
    auto* const host = find<QLineEdit>("nmea-host");
    host->setText(QStringLiteral("the office"));
    Q_EMIT host->editingFinished();
    EXPECT_TRUE(find<QLabel>("nmea-host-trouble")->isVisible());
    EXPECT_EQ(input.nmea().settings().outputHost, QStringLiteral("127.0.0.1"));
    host->setText(QStringLiteral("192.168.1.255"));
    Q_EMIT host->editingFinished();
    EXPECT_FALSE(find<QLabel>("nmea-host-trouble")->isVisible());
    EXPECT_EQ(input.nmea().settings().outputHost, QStringLiteral("192.168.1.255"));
    EXPECT_TRUE(input.nmea().settings().output);
}

TEST_F(Settings, ThePinIsKeptWhenItIsOneAndTheUsualOneIsSaid) {
    page->openSection(Demo);
    EXPECT_TRUE(find<QLabel>("demo-usual")->isVisible());
    picture("demo");
    auto* const pin = find<QLineEdit>("demo-pin");
    pin->selectAll();
    QTest::keyClicks(pin, QStringLiteral("47x"));
    EXPECT_TRUE(find<QLabel>("demo-pin-trouble")->isVisible());
    EXPECT_EQ(storedPin(store), QStringLiteral("0000"));
    pin->selectAll();
    QTest::keyClicks(pin, QStringLiteral("4711"));
    EXPECT_FALSE(find<QLabel>("demo-pin-trouble")->isVisible());
    EXPECT_FALSE(find<QLabel>("demo-usual")->isVisible());
    EXPECT_EQ(store.get("demo.pin"), "4711");
    auto* const chord = find<QKeySequenceEdit>("demo-chord");
    chord->setKeySequence(QKeySequence(Qt::Key_Q));
    EXPECT_TRUE(find<QLabel>("demo-chord-trouble")->isVisible());
    EXPECT_EQ(chord->keySequence(), usualDemoChord());
    chord->setKeySequence(QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_X));
    EXPECT_EQ(store.get("demo.chord"), "Ctrl+Alt+X");
}

TEST_F(Settings, ASecondVisitShowsWhatTheFirstLeft) {
    find<QSlider>("sound-volume")->setValue(15);
    find<QLineEdit>("demo-pin")->setText(QStringLiteral("1234"));
    storePin(store, QStringLiteral("1234"));
    open();
    EXPECT_EQ(find<QSlider>("sound-volume")->value(), 15);
    EXPECT_EQ(find<QLineEdit>("demo-pin")->text(), QStringLiteral("1234"));
}

TEST_F(Settings, EverythingHasATooltipAndIsReachedByKeyboard) {
    const test::VirtualStick stick(2, 2, 1);
    poll();
    for (QWidget* const widget : page->findChildren<QWidget*>()) {
        if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith(QStringLiteral("qt_")))
            continue;
        const bool control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                             qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QSlider*>(widget) ||
                             qobject_cast<QKeySequenceEdit*>(widget);
        if (!control || qobject_cast<QComboBox*>(widget->parent()) != nullptr) continue;
        EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->objectName().toStdString();
        EXPECT_TRUE((widget->focusPolicy() & Qt::TabFocus) != 0) << widget->objectName().toStdString();
    }
}

TEST_F(Settings, EverySectionHasItsHelpAndTheWayBackIsThere) {
    for (int i = Display; i <= Data; ++i) {
        page->openSection(i);
        EXPECT_FALSE(page->helpTopic().isEmpty());
    }
    picture("data");
    QSignalSpy left(page.get(), &Page::leaveWanted);
    QTest::mouseClick(find<QPushButton>("back"), Qt::LeftButton);
    EXPECT_EQ(left.size(), 1);
}

}  // namespace
}  // namespace sagara::ui
