#include "ui/input/NmeaPort.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QNetworkDatagram>
#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>
#include <array>
#include <random>

#include "tests/support/exercise/Lesson.h"

namespace sagara::ui {
namespace {

int freePort() {
    QUdpSocket probe;
    probe.bind(QHostAddress::LocalHost, 0);
    return probe.localPort();
}

TEST(NmeaPort, OrdersComeInByUdpAndMistakesAreCounted) {
    NmeaPort port;
    NmeaSettings settings;
    settings.source = NmeaSource::Udp;
    settings.udpPort = freePort();
    port.open(settings);
    ASSERT_TRUE(port.trouble().isEmpty()) << port.trouble().toStdString();
    QSignalSpy ordered(&port, &NmeaPort::ordered);
    QUdpSocket bridge;
    const auto send = [&](const std::string& text) {
        bridge.writeDatagram(QByteArray::fromStdString(text), QHostAddress::LocalHost,
                             static_cast<quint16>(settings.udpPort));
    };
    send(withChecksum("IIROR,5.0,A,,V,B"));  // no line end: a datagram is whole
    send("$IIROR,5.0,A,,V,B*00\r\n");
    send(withChecksum("IIROR,far,A,,V,B") + "\r\n" + withChecksum("IIHDT,1.0,T") + "\r\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return port.counts().ignored == 1; }));
    EXPECT_EQ(ordered.size(), 1);
    EXPECT_EQ(port.counts().orders, 1);
    EXPECT_EQ(port.counts().errors, 2);
    EXPECT_EQ(port.lastSentence(), QString::fromStdString(withChecksum("IIHDT,1.0,T")));
    EXPECT_TRUE(port.lastError().contains(QStringLiteral("expected -90 to 90 degrees")));
}

TEST(NmeaPort, APortThatIsTakenAndADeviceThatIsNotThereAreSaid) {
    QUdpSocket holder;
    ASSERT_TRUE(holder.bind(QHostAddress::AnyIPv4, 0, QUdpSocket::DontShareAddress));
    NmeaPort port;
    NmeaSettings settings;
    settings.source = NmeaSource::Udp;
    settings.udpPort = holder.localPort();
    port.open(settings);
    EXPECT_TRUE(port.trouble().contains(QString::number(settings.udpPort)));
    settings.source = NmeaSource::Serial;
    settings.serialPort = QStringLiteral("ttyThatIsNotThere");
    port.open(settings);
    EXPECT_TRUE(port.trouble().contains(settings.serialPort));
    port.open({});
    EXPECT_TRUE(port.trouble().isEmpty());
}

TEST(NmeaPort, ASerialLineIsReadAndItsLossIsTold) {
    int bridge = -1;
    int line = -1;
    std::array<char, 64> name{};
    ASSERT_EQ(openpty(&bridge, &line, name.data(), nullptr, nullptr), 0);
    ::close(line);
    NmeaPort port;
    QSignalSpy lost(&port, &NmeaPort::lost);
    NmeaSettings settings;
    settings.source = NmeaSource::Serial;
    settings.serialPort = QString::fromLatin1(name.data());
    port.open(settings);
    ASSERT_TRUE(port.trouble().isEmpty()) << port.trouble().toStdString();
    const std::string text = withChecksum("IIETL,,O,02,,B,0") + "\r\n";
    ASSERT_EQ(::write(bridge, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    EXPECT_TRUE(QTest::qWaitFor([&] { return port.counts().orders == 1; }));
    ::close(bridge);
    EXPECT_TRUE(QTest::qWaitFor([&] { return lost.size() == 1; }));
    EXPECT_TRUE(port.trouble().contains(settings.serialPort));
}

TEST(NmeaPort, NoiseOnTheLineIsCountedAndShownAsDots) {
    NmeaPort port;
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        std::string bytes(random() % 200, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        port.feed(bytes);
    }
    EXPECT_GT(port.counts().errors, 500);
    EXPECT_EQ(port.counts().orders, 0);
    for (const QChar c : port.lastSentence()) EXPECT_TRUE(c.unicode() >= 32 && c.unicode() <= 126);
    port.feed("\n");
    port.feed(withChecksum("PSGR,ACK") + "\n");
    EXPECT_EQ(port.counts().orders, 1);
}

TEST(NmeaPort, SensorsGoOutAtTheirPace) {
    QUdpSocket instrument;
    ASSERT_TRUE(instrument.bind(QHostAddress::LocalHost, 0));
    NmeaPort port;
    NmeaSettings settings;
    settings.output = true;
    settings.outputPort = instrument.localPort();
    settings.output_Hz = 5;
    port.open(settings);
    const auto world = test::lessonWorld();
    const core::Snapshot now = core::view(*world, core::startState(*world, 1));
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 700) {
        port.report(*world, now);
        QTest::qWait(10);
    }
    EXPECT_GE(port.counts().sent, 2);
    EXPECT_LE(port.counts().sent, 4);  // 0, 200, 400, 600 ms
    ASSERT_TRUE(QTest::qWaitFor([&] { return instrument.hasPendingDatagrams(); }));
    const QByteArray bytes = instrument.receiveDatagram().data();
    EXPECT_TRUE(bytes.startsWith("$IIHDT,"));
    EXPECT_TRUE(bytes.endsWith("\r\n"));
    EXPECT_LT(bytes.size(), 1400);  // one packet of an Ethernet
}

}  // namespace
}  // namespace sagara::ui
