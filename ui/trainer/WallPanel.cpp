#include "ui/trainer/WallPanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>

namespace sagara::ui {
namespace {

constexpr int kBeat_ms = 500;
enum Column { Name, Rate, Drawn, Skew, Lost, Restart, Columns };

QString number(double value, int decimals) { return QLocale::c().toString(value, 'f', decimals); }

}  // namespace

WallPanel::WallPanel(WallControl& wall, QWidget* parent)
    : QWidget(parent),
      m_wall(wall),
      m_layout(new QComboBox(this)),
      m_placement(new QComboBox(this)),
      m_start(new QPushButton(this)),
      m_state(new QLabel(this)),
      m_channels(new QTableWidget(0, Columns, this)),
      m_notes(new QListWidget(this)) {
    m_layout->setObjectName(QStringLiteral("wall-layout"));
    m_layout->setToolTip(tr("Which screens stand side by side"));
    m_layout->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_layout->setMinimumContentsLength(12);
    for (const WallControl::Layout& layout : wall.layouts()) {
        m_layout->addItem(QString::fromStdString(layout.name), QString::fromStdString(layout.id));
        if (layout.id == "desk-3x60") m_layout->setCurrentIndex(m_layout->count() - 1);
    }
    m_placement->setObjectName(QStringLiteral("wall-placement"));
    m_placement->addItem(tr("In windows"), static_cast<int>(WallPlacement::Windows));
    m_placement->addItem(tr("Full screen, one a monitor"), static_cast<int>(WallPlacement::FullScreen));
    m_placement->addItem(tr("Without a window"), static_cast<int>(WallPlacement::Hidden));
    m_placement->setToolTip(tr("Where the channels of this PC show their pictures"));
    m_start->setObjectName(QStringLiteral("wall-start"));
    m_state->setObjectName(QStringLiteral("wall-state"));
    m_state->setWordWrap(true);
    m_notes->setObjectName(QStringLiteral("wall-notes"));
    m_notes->setWordWrap(true);
    m_notes->setSelectionMode(QAbstractItemView::NoSelection);

    m_channels->setObjectName(QStringLiteral("wall-channels"));
    m_channels->setHorizontalHeaderLabels(
        {tr("Channel"), tr("1/s"), tr("ms"), tr("Skew"), tr("Lost"), QString()});
    const QString tips[] = {
        tr("Name in the layout, and whether it is in step: shown together with the others"),
        tr("Frames shown a second"), tr("Milliseconds from a frame being sent to its being drawn"),
        tr("Milliseconds behind the first channel to show the frame"), tr("How often it fell out of step")};
    for (int i = 0; i < Restart; ++i) m_channels->horizontalHeaderItem(i)->setToolTip(tips[i]);
    m_channels->verticalHeader()->hide();
    m_channels->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_channels->setSelectionMode(QAbstractItemView::NoSelection);
    m_channels->setFocusPolicy(Qt::NoFocus);
    m_channels->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_channels->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_channels->horizontalHeader()->setMinimumSectionSize(20);
    m_channels->verticalHeader()->setDefaultSectionSize(2 * fontMetrics().height() + 8);

    auto* const form = new QFormLayout;
    form->addRow(tr("Layout"), m_layout);
    form->addRow(tr("Pictures"), m_placement);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addLayout(form);
    layout->addWidget(m_start);
    layout->addWidget(m_state);
    layout->addWidget(m_channels, 2);
    layout->addWidget(new QLabel(tr("What happened on the wall"), this));
    layout->addWidget(m_notes, 1);

    connect(m_start, &QPushButton::clicked, this, &WallPanel::startOrStop);
    auto* const beat = new QTimer(this);
    connect(beat, &QTimer::timeout, this, &WallPanel::refresh);
    beat->start(kBeat_ms);
    refresh();
}

void WallPanel::startOrStop() {
    if (m_wall.status().running || m_asked) {
        m_asked = false;
        m_wall.stop();
    } else {
        m_asked = true;
        m_wall.start(m_layout->currentData().toString().toStdString(),
                     static_cast<WallPlacement>(m_placement->currentData().toInt()));
    }
    refresh();
}

void WallPanel::refresh() {
    const WallControl::Status status = m_wall.status();
    if (status.running || !status.trouble.empty()) m_asked = false;
    const bool on = status.running || m_asked;
    m_start->setText(on ? tr("Stop the wall") : tr("Start the wall"));
    m_layout->setEnabled(!on);
    m_placement->setEnabled(!on);
    fill(status);
    if (!status.running) {
        m_state->setText(
            m_asked ? tr("Starting ...")
            : status.trouble.empty()
                ? tr("The wall is off. Choose a layout and start it; the exercise may run already.")
                : QString::fromStdString(status.trouble));
        return;
    }
    double rate_Hz = 0.0;
    std::size_t inStep = 0;
    for (const WallControl::Channel& channel : status.channels) {
        rate_Hz = std::max(rate_Hz, channel.rate_Hz);
        inStep += channel.state == "in step" ? 1 : 0;
    }
    m_state->setText(tr("%1 of %2 channels in step, %3 frames/s. Channels of other PCs connect to port %4.")
                         .arg(inStep)
                         .arg(status.channels.size())
                         .arg(number(rate_Hz, 1))
                         .arg(status.port));
}

QWidget* WallPanel::restartButton(const std::string& channel) {
    auto* const button = new QPushButton(tr("↻"), m_channels);
    button->setObjectName(QStringLiteral("wall-restart-%1").arg(QString::fromStdString(channel)));
    button->setToolTip(tr("Start this channel's program again"));
    button->setAccessibleName(tr("Start %1 again").arg(QString::fromStdString(channel)));
    button->setStyleSheet(QStringLiteral("padding: 1px 4px; min-height: 16px;"));
    connect(button, &QPushButton::clicked, this, [this, channel] { m_wall.restart(channel); });
    return button;
}

void WallPanel::fill(const WallControl::Status& status) {
    const int rows = static_cast<int>(status.channels.size());
    if (m_channels->rowCount() != rows) {
        m_channels->setRowCount(rows);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < Restart; ++column)
                m_channels->setItem(row, column, new QTableWidgetItem);
            for (const int column : {Rate, Drawn, Skew, Lost})
                m_channels->item(row, column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            const auto& channel = status.channels[static_cast<std::size_t>(row)];
            if (channel.local) m_channels->setCellWidget(row, Restart, restartButton(channel.name));
        }
    }
    for (int row = 0; row < rows; ++row) {
        const WallControl::Channel& c = status.channels[static_cast<std::size_t>(row)];
        const QString texts[] = {
            QStringLiteral("%1\n%2").arg(QString::fromStdString(c.name), QString::fromStdString(c.state)),
            number(c.rate_Hz, 1), number(c.drawn_ms, 0), number(c.skew_ms, 1), QString::number(c.timesLost)};
        for (int column = 0; column < Restart; ++column)
            m_channels->item(row, column)->setText(texts[column]);
        m_channels->item(row, Name)->setToolTip(QString::fromStdString(c.reason));
    }
    while (m_notes->count() > static_cast<int>(status.notes.size())) delete m_notes->takeItem(0);
    for (int i = 0; i < static_cast<int>(status.notes.size()); ++i) {
        const QString text = QString::fromStdString(status.notes[static_cast<std::size_t>(i)]);
        if (i >= m_notes->count())
            m_notes->addItem(text), m_notes->scrollToBottom();
        else if (m_notes->item(i)->text() != text)
            m_notes->item(i)->setText(text);
    }
}

}  // namespace sagara::ui
