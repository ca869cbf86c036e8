#include "app/station/DemoDoor.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/files/BuildScenario.h"
#include "app/station/DemoRun.h"
#include "app/station/DemoStationWall.h"
#include "app/station/SettingsDoor.h"
#include "ui/settings/StoredSettings.h"

namespace sagara::station {
namespace {

ui::DemoSettings settingsOf(run::Store& store, const DemoOptions& options) {
    ui::DemoSettings settings;
    settings.timing = options.timing;
    settings.fullScreen = options.fullScreen;
    const auto kept = settingsStore(store);
    settings.pin = ui::storedPin(*kept).toStdString();
    settings.chord = ui::storedChord(*kept);
    settings.log = qEnvironmentVariable("SAGARA_DEMO_LOG").toStdString();
    bool given = false;
    const double every_s = qEnvironmentVariable("SAGARA_DEMO_LOG_EVERY").toDouble(&given);
    if (given && every_s >= 1.0) settings.logEvery_s = every_s;
    return settings;
}

class TroublePage final : public ui::Page {
public:
    explicit TroublePage(const QString& trouble) {
        auto* const words = new QLabel(tr("The exhibition cannot begin.\n\n%1").arg(trouble), this);
        words->setObjectName(QStringLiteral("trouble"));
        words->setWordWrap(true);
        auto* const back = new QPushButton(tr("Back"), this);
        back->setToolTip(tr("Back to the start page"));
        auto* const layout = new QVBoxLayout(this);
        layout->setContentsMargins(40, 40, 40, 40);
        layout->addWidget(words);
        layout->addWidget(back, 0, Qt::AlignLeft);
        layout->addStretch();
        connect(back, &QPushButton::clicked, this, &Page::leaveWanted);
    }
    QString helpTopic() const override { return QStringLiteral("demo"); }
};

}  // namespace

core::Result<ui::Page*, std::string> openDemo(Frame& frame, DemoOptions options) {
    std::vector<std::shared_ptr<const core::World>> worlds;
    std::string troubles;
    for (const std::string& scenario : options.scenarios) {
        auto world = files::buildScenario(frame.store(), scenario);
        if (world && !(*world)->ships.empty())
            worlds.push_back(std::move(world).value());
        else
            troubles += world ? scenario + " has no own ship\n" : world.error() + "\n";
    }
    // One lesson is enough for a show; a broken one is left out.
    if (worlds.empty()) return troubles.empty() ? std::string("no lesson is chosen for it") : troubles;
    ui::DemoPorts ports;
    auto lessons = std::make_unique<DemoLessons>(std::move(worlds), options.level);
    if (!options.wallLayout.empty())
        ports.wall =
            std::make_unique<DemoStationWall>(lessons->demoRun(), options.wallLayout, options.wallPlacement);
    ports.exercises = std::move(lessons);
    ports.stageFor = [&frame](const std::shared_ptr<const core::World>& world) {
        return frame.stageFor(world);
    };
    ports.stick = options.stick;
    auto* const page = new ui::DemoPage(std::move(ports), settingsOf(frame.store(), options));
    page->setColours(frame.colours());
    return static_cast<ui::Page*>(page);
}

ui::Page* demoPage(Frame& frame, DemoOptions options) {
    auto page = openDemo(frame, std::move(options));
    return page ? *page : new TroublePage(QString::fromStdString(page.error()));
}

}  // namespace sagara::station
