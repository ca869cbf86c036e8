#include "app/station/Station.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/files/BuildScenario.h"
#include "app/station/DebriefDoor.h"
#include "app/station/DeskPage.h"
#include "app/station/Doors.h"
#include "app/station/KeptTables.h"
#include "app/station/RosterDoor.h"
#include "app/station/SettingsDoor.h"
#include "db/RunRepository.h"
#include "ui/help/HelpWindow.h"
#include "ui/settings/StoredSettings.h"
#include "ui/theme/Theme.h"

namespace sagara::station {
namespace {

constexpr const char* kPalettes[] = {"day", "dusk", "night"};
constexpr int kBar_px = 40;

std::optional<db::RunId> runOf(run::Store& store, const std::filesystem::path& recording) {
    if (store.database() == nullptr) return std::nullopt;
    try {
        const auto run =
            db::RunRepository(*store.database()).findByRecording(store.folder().nameOf(recording));
        return run ? std::optional(run->id) : std::nullopt;
    } catch (const db::DbError&) {
        return std::nullopt;
    }
}

/// Nothing where there can be no pictures: the station works without.
std::unique_ptr<render::Stage> openStage(const render::StageOptions& options) {
    auto stage = render::Stage::open(options);
    if (!stage) return nullptr;
    return std::move(stage).value();
}

}  // namespace

render::Preset presetOfThisMachine() {
    std::error_code ignored;
    const bool card = std::filesystem::exists("/dev/dri/renderD128", ignored);
    return card ? render::Preset::Medium : render::Preset::Low;
}

Station::Station(run::Store& store, render::StageOptions stage)
    : m_store(store),
      m_stageOptions(std::move(stage)),
      m_settings(settingsStore(store)),
      m_stageComing(std::async(std::launch::async, openStage, m_stageOptions)),
      m_stack(new QStackedWidget(this)) {
    setObjectName(QStringLiteral("station"));
    m_bar = makeBar();
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_stack, 1);
    ui::applySettings(*m_settings, m_input, m_sound);
    setColours(ui::storedPalette(*m_settings));
    openPage(homePage(*this));
    resize(1280, 720);
    if (const auto kept = m_settings->get("ui.geometry"))
        restoreGeometry(QByteArray::fromBase64(QByteArray::fromStdString(*kept)));
}

Station::~Station() {
    while (!m_pages.empty()) {  // before the stage they look at
        delete m_pages.back();
        m_pages.pop_back();
    }
    qDeleteAll(findChildren<ui::Page*>());  // replaced ones that were still waiting to go
}

QWidget* Station::makeBar() {
    auto* const bar = new QWidget(this);
    bar->setFixedHeight(kBar_px);
    auto* const layout = new QHBoxLayout(bar);
    layout->setContentsMargins(8, 2, 8, 2);
    const auto button = [&](const char* name, const QString& icon, const QString& tip) {
        auto* const b = new QToolButton(bar);
        b->setObjectName(QString::fromLatin1(name));
        b->setAutoRaise(true);
        b->setIconSize({24, 24});
        b->setToolTip(tip);
        b->setAccessibleName(tip);
        b->setFocusPolicy(Qt::TabFocus);
        m_icons.emplace_back(b, icon);
        return b;
    };
    m_back = button("back", QStringLiteral("media-skip-previous-google-f"), tr("Back (Esc)"));
    connect(m_back, &QToolButton::clicked, this, [this] { leavePage(); });
    m_title = new QLabel(bar);
    m_title->setObjectName(QStringLiteral("title"));
    QFont font = m_title->font();
    font.setBold(true);
    font.setPointSizeF(1.15 * font.pointSizeF());
    m_title->setFont(font);
    layout->addWidget(m_back);
    layout->addWidget(m_title, 1);
    const QString tips[] = {tr("Day colours"), tr("Dusk colours"), tr("Night colours")};
    const char* const icons[] = {"palette-day", "palette-dusk", "palette-night"};
    for (int i = 0; i < 3; ++i) {
        auto* const b = button(kPalettes[i], QString::fromLatin1(icons[i]), tips[i]);
        b->setCheckable(true);
        connect(b, &QToolButton::clicked, this, [this, i] { setColours(static_cast<ui::PaletteName>(i)); });
        layout->addWidget(b);
    }
    layout->addSpacing(8);
    auto* const settings = button("settings", QStringLiteral("settings-iec"), tr("Settings"));
    connect(settings, &QToolButton::clicked, this, [this] { openSettings(); });
    layout->addWidget(settings);
    auto* const help = button("help", QStringLiteral("help"), tr("Help to this page (F1)"));
    auto* const menu = new QMenu(help);
    menu->addAction(tr("Help to this page"), this, &Station::help);
    menu->addAction(tr("About Sagara"), this, [this] { about(*this); })
        ->setObjectName(QStringLiteral("about"));
    help->setMenu(menu);
    help->setPopupMode(QToolButton::MenuButtonPopup);
    connect(help, &QToolButton::clicked, this, &Station::help);
    layout->addWidget(help);
    return bar;
}

render::Stage* Station::stageFor(const std::shared_ptr<const core::World>& world) {
    if (m_stageComing.valid()) m_stage = m_stageComing.get();
    if (!m_stage) return nullptr;
    if (m_staged.lock() == world) return m_stage.get();
    m_stage->showSoon(world);
    m_staged = world;
    return m_stage.get();
}

ui::Page* Station::page() const { return m_pages.empty() ? nullptr : m_pages.back(); }

void Station::openPage(ui::Page* page) {
    page->setParent(this);
    page->setColours(m_colours);
    for (auto* const back : page->findChildren<QPushButton*>(QStringLiteral("back")))
        back->hide();  // the bar has the way back
    m_pages.push_back(page);
    m_stack->addWidget(page);
    // Queued: the page asks for it in the middle of its own work.
    connect(
        page, &ui::Page::leaveWanted, this,
        [this, page] {
            if (this->page() == page) leavePage();
        },
        Qt::QueuedConnection);
    connect(page, &QWidget::windowTitleChanged, this, &Station::refreshBar);
    keepTables(*page, settingsStore(m_store));
    showTop();
}

void Station::replacePage(ui::Page* page) {
    ui::Page* const gone = m_pages.back();
    m_pages.pop_back();
    m_stack->removeWidget(gone);
    gone->hide();
    gone->deleteLater();
    openPage(page);
}

void Station::showTop() {
    setBarShown(true);
    m_stack->setCurrentWidget(m_pages.back());
    m_pages.back()->setFocus();
    refreshBar();
}

void Station::refreshBar() {
    const QString title = m_pages.empty() ? QString() : m_pages.back()->windowTitle();
    m_title->setText(m_pages.size() > 1 ? title : QString());
    m_back->setVisible(m_pages.size() > 1);
    setWindowTitle(m_pages.size() > 1 && !title.isEmpty() ? tr("%1 - Sagara").arg(title) : tr("Sagara"));
}

void Station::setBarShown(bool shown) { m_bar->setVisible(shown); }

void Station::dropTop() {
    ui::Page* const gone = m_pages.back();
    m_pages.pop_back();
    m_stack->removeWidget(gone);
    delete gone;
    showTop();
}

bool Station::leavePage() {
    if (m_pages.size() < 2 || !m_pages.back()->mayLeave()) return false;
    dropTop();
    return true;
}

bool Station::leaveAll() {
    while (m_pages.size() > 1)
        if (!leavePage()) return false;
    return true;
}

std::optional<std::string> Station::openRun(const RunRequest& request) {
    const auto world = files::buildScenario(m_store, request.scenario, request.seed);
    if (!world) return world.error();
    return openDesk(request, {*world, nullptr});
}

std::optional<std::string> Station::openDesk(const RunRequest& request,
                                             const ui::PreparedExercise& exercise) {
    auto run = StationRun::open(m_store, request, exercise.world);
    if (!run) return run.error();
    openPage(new DeskPage(*this, std::move(run).value(), exercise.chart));
    return std::nullopt;
}

std::optional<std::string> Station::openDebrief(const std::filesystem::path& recording) {
    const std::optional<db::RunId> filed = runOf(m_store, recording);
    std::function<void()> openResult;
    if (filed) openResult = [this, run = *filed] { openPage(resultPage(*this, run)); };
    const auto page = debriefPage(*this, recording, openResult);
    if (!page) return page.error();
    openPage(page.value());
    return std::nullopt;
}

void Station::setColours(ui::PaletteName name) {
    m_colours = name;
    ui::applyTheme(*qApp, name);
    for (const auto& [button, icon] : m_icons) button->setIcon(ui::themedIcon(icon, name));
    for (int i = 0; i < 3; ++i)
        m_bar->findChild<QToolButton*>(QString::fromLatin1(kPalettes[i]))
            ->setChecked(i == static_cast<int>(name));
    for (ui::Page* page : m_pages) page->setColours(name);
    if (ui::storedPalette(*m_settings) != name) ui::storePalette(*m_settings, name);
}

void Station::openSettings() {
    ui::Page* const page =
        settingsPage(*this, m_input, m_sound, [this](ui::PaletteName name) { setColours(name); });
    page->setWindowTitle(tr("Settings"));
    openPage(page);
}

void Station::help() {
    if (page() != nullptr) ui::showHelp(this, files::assetFolder() / "help", page()->helpTopic(), m_colours);
}

void Station::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F1) return help();
    if (event->key() == Qt::Key_Escape && m_bar->isVisible()) {
        leavePage();
        return;
    }
    QWidget::keyPressEvent(event);
}

void Station::closeEvent(QCloseEvent* event) {
    for (auto page = m_pages.rbegin(); page != m_pages.rend(); ++page)
        if (!(*page)->mayLeave()) return event->ignore();
    m_settings->put("ui.geometry", saveGeometry().toBase64().toStdString());
    event->accept();
}

}  // namespace sagara::station
