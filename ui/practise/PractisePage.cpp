#include "ui/practise/PractisePage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QFutureWatcher>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>

#include "core/assess/Mission.h"
#include "ui/practise/FreeSailPanel.h"
#include "ui/practise/PersonPanel.h"
#include "ui/practise/WeatherPanel.h"

namespace sagara::ui {
namespace {

constexpr int kTabs_px = 330;

using Built = core::Result<PreparedExercise, std::string>;

QString html(const std::string& utf8) { return QString::fromStdString(utf8).toHtmlEscaped(); }

QString briefing(const core::World& world) {
    const core::Mission& m = world.mission;
    QString text = QStringLiteral("<h2>%1</h2><p><b>%2</b></p><p>%3</p>")
                       .arg(html(world.scenarioName), html(m.objective), html(m.briefing));
    if (!m.tasks.empty()) text += QStringLiteral("<h3>%1</h3><ol>").arg(PractisePage::tr("Tasks"));
    for (const auto& task : m.tasks) text += QStringLiteral("<li>%1</li>").arg(html(task->title()));
    if (!m.tasks.empty()) text += QStringLiteral("</ol>");
    if (m.criteria.empty()) return text;
    text += QStringLiteral("<h3>%1</h3><ul>")
                .arg(PractisePage::tr("Points are lost for (%1 of 100 to pass)").arg(m.passScore, 0, 'f', 0));
    for (const auto& criterion : m.criteria)
        text +=
            QStringLiteral("<li>%1%2</li>")
                .arg(html(criterion->terms().title),
                     criterion->terms().fails ? PractisePage::tr(" (a breach fails the run)") : QString());
    return text + QStringLiteral("</ul><p><i>%1</i></p>").arg(html(world.area.notice));
}

QLabel* heading(const QString& text, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

}  // namespace

PractisePage::PractisePage(PractisePorts ports, QWidget* parent)
    : Page(parent), m_ports(std::move(ports)), m_person(new PersonPanel(m_ports, this)) {
    setObjectName(QStringLiteral("practise"));
    setWindowTitle(tr("Practise"));
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(24, 16, 24, 16);
    layout->setSpacing(24);
    layout->addWidget(m_person, 3);
    layout->addWidget(choiceColumn(), 4);
    layout->addWidget(previewColumn(), 5);

    for (const PractiseEntry& lesson : m_ports.lessons) {
        auto* const item = new QListWidgetItem(QString::fromStdString(lesson.name), m_lessons);
        item->setData(Qt::UserRole, QString::fromStdString(lesson.id));
    }
    connect(m_lessons, &QListWidget::currentRowChanged, this, &PractisePage::lookAtLesson);
    connect(m_lessons, &QListWidget::itemActivated, m_sail, [this] { m_sail->setFocus(); });
    connect(m_person, &PersonPanel::changed, this, &PractisePage::showPreview);
    connect(m_person, &PersonPanel::assignmentChosen, this, &PractisePage::chooseAssignment);
    connect(m_tabs, &QTabWidget::currentChanged, this, [this] {
        setTrouble({});
        m_ownWeather->setVisible(!free());
        m_weather->setVisible(free() || m_ownWeather->isChecked());
        takeLessonWeather();
        showPreview();
    });
    connect(m_free, &FreeSailPanel::changed, this, [this] {
        if (m_free->area() != nullptr && free()) m_weather->setUtcOffset(m_free->area()->utcOffset_min);
        showPreview();
    });
    connect(m_ownWeather, &QCheckBox::toggled, this, [this](bool on) {
        m_weather->setVisible(on || free());
        takeLessonWeather();
    });
    connect(m_sail, &QPushButton::clicked, this, &PractisePage::setSail);
    if (m_lessons->count() > 0) m_lessons->setCurrentRow(0);
    if (m_lessons->count() == 0) m_tabs->setCurrentIndex(1);
    m_ownWeather->setVisible(!free());
    m_weather->setVisible(free());
    showPreview();
}

PractisePage::~PractisePage() = default;

QWidget* PractisePage::choiceColumn() {
    auto* const column = new QWidget(this);
    m_tabs = new QTabWidget(column);
    m_tabs->setObjectName(QStringLiteral("what"));
    m_tabs->setMaximumHeight(kTabs_px);
    m_lessons = new QListWidget(m_tabs);
    m_lessons->setObjectName(QStringLiteral("lessons"));
    m_lessons->setAccessibleName(tr("Lessons"));
    m_lessons->setFrameShape(QFrame::NoFrame);
    m_lessons->setStyleSheet(QStringLiteral("QListWidget::item { padding: 6px 4px; }"));
    m_free = new FreeSailPanel(m_ports, m_tabs);
    m_tabs->addTab(m_lessons, tr("A &lesson"));
    m_tabs->addTab(m_free, tr("&Free sailing"));
    m_level = new QComboBox(column);
    m_level->setObjectName(QStringLiteral("level"));
    m_level->setToolTip(tr("1 easy to 5 hard: wind, sea, visibility, other ships, time allowed"));
    for (int i = 1; i <= core::kLevels; ++i) m_level->addItem(tr("Level %1").arg(i), i);
    m_level->setCurrentIndex(2);
    m_ownWeather = new QCheckBox(tr("Weather and hour of my own"), column);
    m_ownWeather->setObjectName(QStringLiteral("own-weather"));
    m_ownWeather->setToolTip(tr("Sail this lesson in other weather or at another hour"));
    m_weather = new WeatherPanel(column);
    m_prediction = new QCheckBox(tr("Prediction on the chart"), column);
    m_prediction->setObjectName(QStringLiteral("prediction"));
    m_prediction->setToolTip(tr("Where she will be in the next 6 minutes if nobody touches anything"));
    m_prediction->setChecked(true);
    m_hints = new QCheckBox(tr("Hints from the mission"), column);
    m_hints->setObjectName(QStringLiteral("hints-wanted"));
    m_hints->setToolTip(tr("Next task, next waypoint, speed allowed here and ahead"));
    m_hints->setChecked(true);

    auto* const layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(heading(tr("What you sail"), column));
    layout->addWidget(m_tabs, 8);
    auto* const form = new QFormLayout;
    form->addRow(tr("&Difficulty"), m_level);
    layout->addLayout(form);
    layout->addWidget(m_ownWeather);
    layout->addWidget(m_weather);
    layout->addSpacing(4);
    layout->addWidget(heading(tr("Help on the way"), column));
    layout->addWidget(m_prediction);
    layout->addWidget(m_hints);
    layout->addStretch(1);
    return column;
}

QWidget* PractisePage::previewColumn() {
    auto* const column = new QWidget(this);
    m_preview = new QTextBrowser(column);
    m_preview->setObjectName(QStringLiteral("preview"));
    m_preview->document()->setDocumentMargin(14.0);
    m_best = heading({}, column);
    m_best->setObjectName(QStringLiteral("best"));
    m_best->setWordWrap(true);
    m_trouble = heading({}, column);
    m_trouble->setObjectName(QStringLiteral("trouble"));
    m_trouble->setWordWrap(true);
    m_trouble->hide();
    m_busy = new QWidget(column);
    m_doing = new QLabel(m_busy);
    auto* const bar = new QProgressBar(m_busy);
    bar->setRange(0, 0);
    bar->setTextVisible(false);
    auto* const cancel = new QPushButton(tr("Cancel"), m_busy);
    cancel->setObjectName(QStringLiteral("cancel"));
    connect(cancel, &QPushButton::clicked, this, [this] {
        ++m_token;
        setBusy({});
    });
    auto* const busy = new QHBoxLayout(m_busy);
    busy->setContentsMargins(0, 0, 0, 0);
    busy->addWidget(m_doing);
    busy->addWidget(bar, 1);
    busy->addWidget(cancel);
    m_busy->hide();
    m_sail = new QPushButton(tr("Set sail"), column);
    m_sail->setObjectName(QStringLiteral("set-sail"));
    m_sail->setProperty("primary", true);
    m_sail->setMinimumHeight(40);
    m_sail->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return));
    m_sail->setToolTip(tr("Begin the run, as self-study (Ctrl+Enter)"));
    auto* const layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_preview, 1);
    layout->addWidget(m_best);
    layout->addWidget(m_trouble);
    layout->addWidget(m_busy);
    layout->addWidget(m_sail);
    return column;
}

void PractisePage::showEvent(QShowEvent*) { refresh(); }

void PractisePage::refresh() { m_person->refresh(); }

bool PractisePage::free() const { return m_tabs->currentIndex() == 1; }

std::string PractisePage::lesson() const {
    const QListWidgetItem* const item = m_lessons->currentItem();
    return item ? item->data(Qt::UserRole).toString().toStdString() : std::string();
}

void PractisePage::chooseAssignment(const QString& scenario, int level) {
    for (int row = 0; row < m_lessons->count(); ++row) {
        if (m_lessons->item(row)->data(Qt::UserRole).toString() != scenario) continue;
        m_tabs->setCurrentIndex(0);
        m_lessons->setCurrentRow(row);
        m_level->setCurrentIndex(level - 1);
        return setTrouble({});
    }
    setTrouble(tr("This mission is not in this installation any more: ask your trainer."));
}

void PractisePage::lookAtLesson() {
    m_lesson = {};
    m_ownWeather->setChecked(false);
    setTrouble({});
    showPreview();
    const std::string id = lesson();
    if (id.empty()) return;
    const auto text = m_ports.find(core::DocumentKind::Scenario, id);
    if (!text) return setTrouble(tr("The lesson cannot be read."));
    build({id, *text}, tr("Reading the lesson"), [this](PreparedExercise exercise) {
        m_lesson = std::move(exercise);
        takeLessonWeather();
        showPreview();
    });
}

/// Not over what somebody has chosen.
void PractisePage::takeLessonWeather() {
    if (free() || !m_lesson.world || m_ownWeather->isChecked()) return;
    m_weather->setUtcOffset(m_lesson.world->area.utcOffset_min);
    m_weather->setWeather(sailWeatherOf(*m_lesson.world));
}

void PractisePage::showPreview() {
    if (m_ports.lessons.empty() && !free())
        m_preview->setHtml(
            tr("<p>There are no lessons yet. A trainer makes them under Teach; meanwhile sail freely.</p>"));
    else if (free())
        m_preview->setHtml(m_free->words());
    else
        m_preview->setHtml(m_lesson.world ? briefing(*m_lesson.world) : QString());
    m_best->setText(free() ? QString() : m_person->bestOf(lesson()));
    m_best->setVisible(!m_best->text().isEmpty());
    enable();
}

void PractisePage::enable() {
    const bool something = free() ? m_free->sail().has_value() : m_lesson.world != nullptr;
    m_sail->setEnabled(something && m_busy->isHidden() && m_person->problem().isEmpty());
}

void PractisePage::setBusy(const QString& doing) {
    m_busy->setVisible(!doing.isEmpty());
    m_doing->setText(doing);
    enable();
}

void PractisePage::setTrouble(const QString& trouble) {
    m_trouble->setText(trouble);
    m_trouble->setVisible(!trouble.isEmpty());
}

void PractisePage::build(core::NamedText scenario, const QString& doing, Then then) {
    auto documents = m_ports.documents(std::move(scenario));
    if (!documents) return setTrouble(QString::fromStdString(documents.error()));
    setBusy(doing);
    const int token = ++m_token;
    auto* const watcher = new QFutureWatcher<Built>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, token, then = std::move(then)] {
        watcher->deleteLater();
        if (token != m_token) return;  // given up, or something else was begun
        setBusy({});
        const Built built = watcher->result();
        if (!built) return setTrouble(QString::fromStdString(built.error()));
        then(built.value());
    });
    watcher->setFuture(
        QtConcurrent::run([documents = std::move(documents).value()] { return prepareExercise(documents); }));
}

void PractisePage::setSail() {
    setTrouble({});
    if (!free() && !m_ownWeather->isChecked()) return sail(m_lesson);
    core::NamedText scenario;
    if (free()) {
        auto chosen = m_free->sail();
        if (!chosen) return;
        chosen->weather = m_weather->weather();
        scenario = {"free-sailing", freeSailScenario(*chosen)};
    } else {
        const auto text = m_ports.find(core::DocumentKind::Scenario, lesson());
        if (!text) return setTrouble(tr("The lesson cannot be read."));
        scenario = {lesson(), withWeather(*text, m_weather->weather())};
    }
    build(std::move(scenario), tr("Setting up"),
          [this](const PreparedExercise& exercise) { sail(exercise); });
}

void PractisePage::sail(const PreparedExercise& exercise) {
    PractiseChoice choice;
    choice.person = m_person->person();
    choice.level = m_level->currentData().toInt();
    choice.prediction = m_prediction->isChecked();
    choice.hints = m_hints->isChecked();
    choice.chart = exercise.chart;
    if (const auto trouble = m_ports.sail(exercise.world, choice))
        setTrouble(QString::fromStdString(*trouble));
}

}  // namespace sagara::ui
