#include "ui/debrief/DebriefPage.h"

#include <QFutureWatcher>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QTimer>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>

#include "ui/widgets/PreparedExercise.h"

namespace sagara::ui {
/// What the thread that opens gives back.
struct DebriefPage::Opening {
    OpenedRecording recording;
    std::string error;
};

DebriefPage::DebriefPage(DebriefPorts ports, const QString& name, QWidget* parent)
    : Page(parent),
      m_ports(std::move(ports)),
      m_progress(std::make_shared<OpenProgress>()),
      m_stack(new QStackedLayout(this)),
      m_words(new QLabel(this)),
      m_bar(new QProgressBar(this)),
      m_cancel(new QPushButton(tr("Cancel"), this)),
      m_poll(new QTimer(this)) {
    setObjectName(QStringLiteral("debrief-page"));
    setWindowTitle(tr("Debrief: %1").arg(name));
    auto* const wait = new QWidget(this);
    auto* const layout = new QVBoxLayout(wait);
    layout->addStretch(1);
    m_words->setObjectName(QStringLiteral("opening"));
    m_words->setText(tr("Opening %1").arg(name));
    m_words->setAlignment(Qt::AlignCenter);
    m_words->setWordWrap(true);
    m_bar->setRange(0, 1000);
    m_bar->setMaximumWidth(420);
    m_bar->setTextVisible(false);
    m_cancel->setObjectName(QStringLiteral("cancel-opening"));
    m_cancel->setMaximumWidth(160);
    layout->addWidget(m_words);
    layout->addWidget(m_bar, 0, Qt::AlignHCenter);
    layout->addSpacing(12);
    layout->addWidget(m_cancel, 0, Qt::AlignHCenter);
    layout->addStretch(2);
    m_stack->addWidget(wait);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_progress->cancelled = true;
        Q_EMIT leaveWanted();
    });
    connect(m_poll, &QTimer::timeout, this, [this] { m_bar->setValue(m_progress->permille); });
    m_poll->start(100);

    auto* const watcher = new QFutureWatcher<std::shared_ptr<Opening>>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] {
        m_poll->stop();
        const std::shared_ptr<Opening> opening = watcher->result();
        watcher->deleteLater();
        if (m_progress->cancelled) return;
        if (!opening->recording.replay) return fail(QString::fromStdString(opening->error));
        showDesk(std::move(opening->recording));
    });
    watcher->setFuture(QtConcurrent::run([open = m_ports.open, progress = m_progress] {
        auto opening = std::make_shared<Opening>();
        auto replay = open(*progress);
        if (!replay) {
            opening->error = replay.error();
            return opening;
        }
        const auto world = (*replay)->world();
        opening->recording.chart = prepareChart(world);
        progress->permille = 950;
        opening->recording.plots =
            std::make_shared<const PlotData>(plotData(*world, (*replay)->track(), nullptr));
        opening->recording.replay = std::move(replay).value();
        return opening;
    }));
}

DebriefPage::~DebriefPage() { m_progress->cancelled = true; }

void DebriefPage::showDesk(OpenedRecording recording) {
    m_desk = new DebriefDesk(m_ports, std::move(recording), this);
    m_desk->setObjectName(QStringLiteral("debrief-desk"));
    m_desk->setColours(m_colours);
    m_stack->addWidget(m_desk);
    m_stack->setCurrentWidget(m_desk);
    Q_EMIT opened();
}

void DebriefPage::fail(const QString& why) {
    m_words->setText(tr("This recording cannot be opened.\n\n%1").arg(why));
    m_bar->hide();
    m_cancel->setText(tr("Back"));
    Q_EMIT failed();
}

QString DebriefPage::trouble() const { return m_bar->isHidden() ? m_words->text() : QString(); }

void DebriefPage::setColours(PaletteName name) {
    m_colours = name;
    if (m_desk != nullptr) m_desk->setColours(name);
}

bool DebriefPage::mayLeave() { return m_desk == nullptr || m_desk->mayLeave(); }

}  // namespace sagara::ui
