#include "ui/settings/NmeaSection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHostAddress>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSerialPortInfo>
#include <QSignalBlocker>
#include <QSpinBox>

#include "ui/settings/StoredSettings.h"

namespace sagara::ui {
namespace {

void name(QWidget* widget, const char* objectName, const QString& tip) {
    widget->setObjectName(QString::fromLatin1(objectName));
    widget->setToolTip(tip);
}

void tell(QLabel* label, const QString& text) {
    if (label->text() != text) label->setText(text);
}

}  // namespace

NmeaSection::NmeaSection(SettingsStore& store, BridgeInput& input, QWidget* parent)
    : Section(tr("NMEA 0183"), QStringLiteral("conning-iec"), parent),
      m_store(store),
      m_port(input.nmea()),
      m_source(new QComboBox(this)),
      m_udpPort(new QSpinBox(this)),
      m_serialPort(new QComboBox(this)),
      m_look(new QPushButton(tr("Look again"), this)),
      m_baud(new QComboBox(this)),
      m_state(complaint("nmea-trouble")),
      m_last(new QLabel(this)),
      m_counts(new QLabel(this)),
      m_error(complaint("nmea-error")),
      m_output(new QCheckBox(tr("Send what the ship's sensors say"), this)),
      m_host(new QLineEdit(this)),
      m_hostTrouble(complaint("nmea-host-trouble")),
      m_outputPort(new QSpinBox(this)),
      m_rate(new QSpinBox(this)),
      m_sent(new QLabel(this)) {
    name(m_source, "nmea-source", tr("Where orders to helm, engines and thrusters come from"));
    m_source->addItem(tr("off"), static_cast<int>(NmeaSource::Off));
    m_source->addItem(tr("network (UDP)"), static_cast<int>(NmeaSource::Udp));
    m_source->addItem(tr("serial port"), static_cast<int>(NmeaSource::Serial));
    name(m_udpPort, "nmea-udp-port", tr("UDP port that is listened on, 1 to 65535; 10110 is usual"));
    name(m_serialPort, "nmea-serial-port", tr("Serial port the bridge is connected to"));
    name(m_look, "nmea-look", tr("List the serial ports of this computer again"));
    name(m_baud, "nmea-baud", tr("Bits a second: 4800 by the standard, 38400 for high-speed lines"));
    name(m_output, "nmea-output", tr("HDT, ROT, VHW, VTG, GGA, GLL, ZDA, DBT, DPT, MWV, RSA and RPM by UDP"));
    name(m_host, "nmea-host", tr("IP address of the instruments, or 255.255.255.255 for the whole network"));
    name(m_outputPort, "nmea-output-port", tr("UDP port the instruments listen on, 1 to 65535"));
    name(m_rate, "nmea-rate", tr("How often, 1 to 5 times a second"));
    m_last->setObjectName(QStringLiteral("nmea-last"));
    m_counts->setObjectName(QStringLiteral("nmea-counts"));
    m_sent->setObjectName(QStringLiteral("nmea-sent"));

    const NmeaSettings& now = m_port.settings();
    for (QSpinBox* const port : {m_udpPort, m_outputPort}) port->setRange(1, 65535);
    for (const int baud : {4800, 9600, 19200, 38400, 57600, 115200})
        m_baud->addItem(QString::number(baud), baud);
    if (m_baud->findData(now.baud) < 0) m_baud->addItem(QString::number(now.baud), now.baud);
    m_rate->setRange(1, 5);
    for (QWidget* const field :
         std::initializer_list<QWidget*>{m_source, m_udpPort, m_baud, m_host, m_outputPort, m_rate})
        field->setFixedWidth(200);
    m_serialPort->setFixedWidth(320);
    m_rate->setSuffix(tr(" a second"));
    m_source->setCurrentIndex(m_source->findData(static_cast<int>(now.source)));
    m_udpPort->setValue(now.udpPort);
    m_baud->setCurrentIndex(m_baud->findData(now.baud));
    m_output->setChecked(now.output);
    m_host->setText(now.outputHost);
    m_outputPort->setValue(now.outputPort);
    m_rate->setValue(now.output_Hz);
    listPorts();

    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(inputGroup());
    layout->addWidget(outputGroup());
    layout->addStretch();
    for (QComboBox* const box : {m_source, m_serialPort, m_baud})
        connect(box, &QComboBox::activated, this, &NmeaSection::take);
    for (QSpinBox* const box : {m_udpPort, m_outputPort, m_rate})
        connect(box, &QSpinBox::editingFinished, this, &NmeaSection::take);
    connect(m_host, &QLineEdit::editingFinished, this, &NmeaSection::take);
    connect(m_output, &QCheckBox::toggled, this, &NmeaSection::take);
    connect(m_look, &QPushButton::clicked, this, [this] {
        listPorts();
        take();
    });
    enable();
    refresh();
}

QGroupBox* NmeaSection::inputGroup() {
    auto* const group = new QGroupBox(tr("Orders from a home-made bridge"), this);
    auto* const form = new QFormLayout(group);
    form->addRow(tr("Comes by"), m_source);
    form->addRow(tr("UDP port"), m_udpPort);
    auto* const serial = new QHBoxLayout;
    serial->addWidget(m_serialPort);
    serial->addWidget(m_look);
    serial->addStretch();
    form->addRow(tr("Serial port"), serial);
    form->addRow(tr("Baud rate"), m_baud);
    m_last->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_last->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_last->setToolTip(tr("The sentence that came last"));
    m_last->setMinimumWidth(100);
    m_counts->setToolTip(tr("Since the source was chosen"));
    form->addRow(m_state);
    form->addRow(tr("Last sentence"), m_last);
    form->addRow(tr("Received"), m_counts);
    form->addRow(m_error);
    form->addRow(
        note(tr("Understood: ROR and HTC (rudder), ETL and PRC (engines), TRC (thrusters), PSGR "
                "(horn, look, acknowledge, bookmark). Each must carry its checksum. F1 shows them.")));
    return group;
}

QGroupBox* NmeaSection::outputGroup() {
    auto* const group = new QGroupBox(tr("Instruments"), this);
    auto* const form = new QFormLayout(group);
    form->addRow(m_output);
    form->addRow(tr("To address"), m_host);
    form->addRow(m_hostTrouble);
    form->addRow(tr("UDP port"), m_outputPort);
    form->addRow(tr("Rate"), m_rate);
    form->addRow(tr("Sent"), m_sent);
    return group;
}

void NmeaSection::listPorts() {
    const QSignalBlocker quiet(m_serialPort);
    m_serialPort->clear();
    const QString chosen = m_port.settings().serialPort;
    const auto ports = QSerialPortInfo::availablePorts();
    for (const QSerialPortInfo& port : ports) {
        const QString what = port.description();
        m_serialPort->addItem(what.isEmpty() ? port.portName() : tr("%1 (%2)").arg(port.portName(), what),
                              port.portName());
    }
    if (!chosen.isEmpty() && m_serialPort->findData(chosen) < 0)
        m_serialPort->addItem(tr("%1 (not plugged in)").arg(chosen), chosen);
    m_serialPort->setPlaceholderText(tr("no serial port found: plug the bridge in and look again"));
    m_serialPort->setCurrentIndex(chosen.isEmpty() ? (m_serialPort->count() > 0 ? 0 : -1)
                                                   : m_serialPort->findData(chosen));
}

void NmeaSection::take() {
    const QHostAddress address(m_host->text().trimmed());
    const bool right = !address.isNull() && address.protocol() == QAbstractSocket::IPv4Protocol;
    say(m_hostTrouble, right
                           ? QString()
                           : tr("\"%1\" is not accepted: four numbers from 0 to 255 with dots between them, "
                                "for example 192.168.1.255.")
                                 .arg(m_host->text()));
    NmeaSettings settings = m_port.settings();
    settings.source = static_cast<NmeaSource>(m_source->currentData().toInt());
    settings.udpPort = m_udpPort->value();
    settings.serialPort = m_serialPort->currentData().toString();
    settings.baud = m_baud->currentData().toInt();
    settings.output = m_output->isChecked();
    if (right) settings.outputHost = address.toString();
    settings.outputPort = m_outputPort->value();
    settings.output_Hz = m_rate->value();
    enable();
    if (settings == m_port.settings()) return;
    m_port.open(settings);
    storeNmea(m_store, settings);
    refresh();
}

void NmeaSection::enable() {
    const auto source = static_cast<NmeaSource>(m_source->currentData().toInt());
    m_udpPort->setEnabled(source == NmeaSource::Udp);
    for (QWidget* const widget : std::initializer_list<QWidget*>{m_serialPort, m_look, m_baud})
        widget->setEnabled(source == NmeaSource::Serial);
    for (QWidget* const widget : std::initializer_list<QWidget*>{m_host, m_outputPort, m_rate})
        widget->setEnabled(m_output->isChecked());
}

void NmeaSection::refresh() {
    const NmeaPort::Counts& counts = m_port.counts();
    const bool off = m_port.settings().source == NmeaSource::Off;
    say(m_state, m_port.trouble());
    tell(m_last, off                               ? tr("off")
                 : m_port.lastSentence().isEmpty() ? tr("nothing yet")
                                                   : m_port.lastSentence());
    tell(m_counts, off ? tr("nothing")
                       : tr("orders: %1, other sentences: %2, errors: %3")
                             .arg(counts.orders)
                             .arg(counts.ignored)
                             .arg(counts.errors));
    say(m_error, m_port.lastError().isEmpty() ? QString() : tr("Last error: %1").arg(m_port.lastError()));
    tell(m_sent, !m_port.settings().output ? tr("off")
                 : counts.sent == 0        ? tr("nothing yet; sent while an exercise runs")
                                           : tr("%1 times").arg(counts.sent));
}

}  // namespace sagara::ui
