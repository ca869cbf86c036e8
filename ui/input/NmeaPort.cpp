#include "ui/input/NmeaPort.h"

#include <QElapsedTimer>
#include <QHostAddress>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSerialPort>
#include <QTimer>
#include <QUdpSocket>

#include "ui/input/NmeaReports.h"

namespace sagara::ui {
namespace {

constexpr int kAgain_ms = 2000;
constexpr qint64 kMostDatagrams = 64;  ///< at a time; a flood must not hold up the window

QString sourceName(NmeaSource source) {
    return source == NmeaSource::Udp      ? QStringLiteral("udp")
           : source == NmeaSource::Serial ? QStringLiteral("serial")
                                          : QStringLiteral("off");
}

int within(const QJsonValue& value, int least, int most, int otherwise) {
    const int read = value.toInt(otherwise);
    return read >= least && read <= most ? read : otherwise;
}

/// What can be shown of a line: bytes that are not text as dots.
QString shown(const std::string& line) {
    QString text;
    for (const char c : line) text += c >= ' ' && c <= '~' ? QLatin1Char(c) : QLatin1Char('.');
    return text;
}

}  // namespace

std::string textOf(const NmeaSettings& s) {
    const QJsonObject all{{QStringLiteral("source"), sourceName(s.source)},
                          {QStringLiteral("serialPort"), s.serialPort},
                          {QStringLiteral("baud"), s.baud},
                          {QStringLiteral("udpPort"), s.udpPort},
                          {QStringLiteral("output"), s.output},
                          {QStringLiteral("outputHost"), s.outputHost},
                          {QStringLiteral("outputPort"), s.outputPort},
                          {QStringLiteral("output_Hz"), s.output_Hz}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

NmeaSettings nmeaSettingsOf(std::string_view text) {
    const QJsonObject all =
        QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size()))).object();
    NmeaSettings s;
    for (const NmeaSource source : {NmeaSource::Udp, NmeaSource::Serial})
        if (all[QStringLiteral("source")].toString() == sourceName(source)) s.source = source;
    s.serialPort = all[QStringLiteral("serialPort")].toString();
    s.baud = within(all[QStringLiteral("baud")], 300, 4'000'000, s.baud);
    s.udpPort = within(all[QStringLiteral("udpPort")], 1, 65535, s.udpPort);
    s.output = all[QStringLiteral("output")].toBool();
    const QString host = all[QStringLiteral("outputHost")].toString();
    if (!QHostAddress(host).isNull()) s.outputHost = host;
    s.outputPort = within(all[QStringLiteral("outputPort")], 1, 65535, s.outputPort);
    s.output_Hz = within(all[QStringLiteral("output_Hz")], 1, 5, s.output_Hz);
    return s;
}

NmeaPort::NmeaPort(QObject* parent)
    : QObject(parent), m_sentAgo(std::make_unique<QElapsedTimer>()), m_again(new QTimer(this)) {
    m_again->setInterval(kAgain_ms);
    connect(m_again, &QTimer::timeout, this, &NmeaPort::openSerial);
}

NmeaPort::~NmeaPort() {
    if (m_serial) m_serial->disconnect(this);  // closing reports an error, to whom there is nobody
}

QString NmeaPort::trouble() const { return m_inTrouble.isEmpty() ? m_outTrouble : m_inTrouble; }

void NmeaPort::open(const NmeaSettings& settings) {
    if (m_serial) m_serial->disconnect(this);
    m_serial.reset();
    m_udp.reset();
    m_out.reset();
    m_again->stop();
    m_settings = settings;
    m_lines = {};
    m_counts = {};
    m_last.clear();
    m_lastError.clear();
    m_inTrouble.clear();
    m_outTrouble.clear();
    m_sentAgo->invalidate();
    if (settings.source == NmeaSource::Serial) openSerial();
    if (settings.source == NmeaSource::Udp) {
        m_udp = std::make_unique<QUdpSocket>();
        if (!m_udp->bind(QHostAddress::AnyIPv4, static_cast<quint16>(settings.udpPort)))
            m_inTrouble =
                tr("UDP port %1 cannot be listened on: %2").arg(settings.udpPort).arg(m_udp->errorString());
        connect(m_udp.get(), &QUdpSocket::readyRead, this, [this] {
            for (qint64 i = 0; i < kMostDatagrams && m_udp->hasPendingDatagrams(); ++i) {
                QByteArray bytes(static_cast<qsizetype>(std::max<qint64>(0, m_udp->pendingDatagramSize())),
                                 '\0');
                const qint64 read = m_udp->readDatagram(bytes.data(), bytes.size());
                if (read <= 0) continue;
                feed({bytes.constData(), static_cast<std::size_t>(read)});
                feed("\n");  // a sentence does not go over the end of a datagram
            }
        });
    }
    if (settings.output) m_out = std::make_unique<QUdpSocket>();
    Q_EMIT changed();
}

void NmeaPort::openSerial() {
    if (m_serial && m_serial->isOpen()) return;
    if (m_settings.serialPort.isEmpty()) {
        m_inTrouble = tr("Choose the serial port the bridge is connected to.");
        return;
    }
    if (!m_serial) {
        m_serial = std::make_unique<QSerialPort>();
        connect(m_serial.get(), &QSerialPort::readyRead, this, [this] {
            const QByteArray bytes = m_serial->readAll();
            feed({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        });
        // Queued: the port may not be closed from within its own signal. A line that was pulled out shows as
        // either error, by the kind of its driver.
        connect(
            m_serial.get(), &QSerialPort::errorOccurred, this,
            [this](QSerialPort::SerialPortError error) {
                const bool gone = error == QSerialPort::ResourceError || error == QSerialPort::ReadError;
                if (!gone || !m_serial || !m_serial->isOpen()) return;
                m_serial->close();
                m_inTrouble = tr("%1 is gone; it is looked for again").arg(m_settings.serialPort);
                m_again->start();
                Q_EMIT lost(m_settings.serialPort);
                Q_EMIT changed();
            },
            Qt::QueuedConnection);
    }
    m_serial->setPortName(m_settings.serialPort);
    m_serial->setBaudRate(m_settings.baud);
    if (m_serial->open(QIODevice::ReadOnly)) {
        m_inTrouble.clear();
        m_again->stop();
    } else {
        m_inTrouble = tr("%1 cannot be opened: %2").arg(m_settings.serialPort, m_serial->errorString());
        m_again->start();
    }
    Q_EMIT changed();
}

void NmeaPort::feed(std::string_view bytes) {
    const auto lines = m_lines.feed(bytes);
    for (const std::string& line : lines) take(line);
    if (!lines.empty()) Q_EMIT changed();
}

void NmeaPort::take(const std::string& line) {
    m_last = shown(line);
    const auto sentence = parseSentence(line);
    if (!sentence) {
        ++m_counts.errors;
        m_lastError = tr("%1: %2").arg(m_last.left(40), QString::fromLatin1(faultText(sentence.error())));
        return;
    }
    const auto order = orderOf(*sentence);
    if (!order) {
        ++m_counts.errors;
        m_lastError = QString::fromStdString(order.error());
    } else if (!order->has_value()) {
        ++m_counts.ignored;
    } else {
        ++m_counts.orders;
        Q_EMIT ordered(**order);
    }
}

void NmeaPort::report(const core::World& world, const core::Snapshot& now, std::size_t ship) {
    if (!m_out) return;
    if (m_sentAgo->isValid() && m_sentAgo->elapsed() < 1000 / m_settings.output_Hz) return;
    m_sentAgo->start();
    QByteArray datagram;
    for (const std::string& line : nmeaReports(world, now, ship)) {
        datagram += QByteArray::fromStdString(line);
        datagram += "\r\n";
    }
    const auto port = static_cast<quint16>(m_settings.outputPort);
    const bool sent = m_out->writeDatagram(datagram, QHostAddress(m_settings.outputHost), port) > 0;
    m_outTrouble = sent
                       ? QString()
                       : tr("Nothing can be sent to %1: %2").arg(m_settings.outputHost, m_out->errorString());
    if (sent) ++m_counts.sent;
    Q_EMIT changed();
}

}  // namespace sagara::ui
