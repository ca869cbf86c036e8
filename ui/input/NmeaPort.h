#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <string>

#include "core/exercise/Snapshot.h"
#include "ui/input/NmeaOrders.h"

class QElapsedTimer;
class QSerialPort;
class QTimer;
class QUdpSocket;

namespace sagara::ui {

enum class NmeaSource { Off, Udp, Serial };

struct NmeaSettings {
    NmeaSource source = NmeaSource::Off;
    QString serialPort;
    int baud = 4800;  ///< what NMEA 0183 says
    int udpPort = 10110;
    bool output = false;
    QString outputHost = QStringLiteral("127.0.0.1");  ///< an address; 255.255.255.255 for all of the network
    int outputPort = 10111;
    int output_Hz = 2;  ///< 1 to 5
    friend bool operator==(const NmeaSettings&, const NmeaSettings&) = default;
};
std::string textOf(const NmeaSettings& settings);
/// What is missing or out of range stays as usual.
NmeaSettings nmeaSettingsOf(std::string_view text);

/// Lines to and from a home-made bridge and instruments. Never waits; a serial port that goes away is looked
/// for every two seconds.
class NmeaPort final : public QObject {
    Q_OBJECT

public:
    explicit NmeaPort(QObject* parent = nullptr);
    ~NmeaPort() override;

    void open(const NmeaSettings& settings);
    const NmeaSettings& settings() const { return m_settings; }
    /// Why nothing comes in or goes out; empty when all is well or off.
    QString trouble() const;

    /// As if it had come from the line.
    void feed(std::string_view bytes);
    /// Sends what the sensors say, at most output_Hz times a second of the wall clock.
    void report(const core::World& world, const core::Snapshot& now, std::size_t ship = 0);

    struct Counts {
        int orders = 0;   ///< understood and passed on
        int ignored = 0;  ///< right, but no order
        int errors = 0;   ///< malformed
        int sent = 0;     ///< datagrams
    };
    const Counts& counts() const { return m_counts; }
    const QString& lastSentence() const { return m_last; }
    const QString& lastError() const { return m_lastError; }

Q_SIGNALS:
    void ordered(const sagara::ui::NmeaOrder& order);
    void changed();  ///< counts, last sentence, trouble
    void lost(const QString& device);

private:
    void openSerial();
    void take(const std::string& line);

    NmeaSettings m_settings;
    NmeaLines m_lines;
    std::unique_ptr<QSerialPort> m_serial;
    std::unique_ptr<QUdpSocket> m_udp;
    std::unique_ptr<QUdpSocket> m_out;
    std::unique_ptr<QElapsedTimer> m_sentAgo;
    QTimer* m_again;
    QString m_inTrouble;
    QString m_outTrouble;
    Counts m_counts;
    QString m_last;
    QString m_lastError;
};

}  // namespace sagara::ui
