#include "ui/start/StartPage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QFormLayout>
#include <QFutureWatcher>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>

namespace sagara::ui {
namespace {

QString html(const std::string& utf8) { return QString::fromStdString(utf8).toHtmlEscaped(); }

QLabel* heading(const QString& text, double scale, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(scale * font.pointSizeF());
    font.setBold(true);
    label->setFont(font);
    return label;
}

}  // namespace

QString briefingHtml(const core::World& world) {
    const core::Mission& m = world.mission;
    QString text = QStringLiteral("<h2>%1</h2><p><b>%2</b></p><p>%3</p>")
                       .arg(html(world.scenarioName), html(m.objective), html(m.briefing));
    if (!m.tasks.empty()) {
        text += QStringLiteral("<h3>%1</h3><ol>").arg(StartPage::tr("Tasks"));
        for (const auto& task : m.tasks) text += QStringLiteral("<li>%1</li>").arg(html(task->title()));
        text += QStringLiteral("</ol>");
    }
    if (!m.criteria.empty()) {
        text += QStringLiteral("<h3>%1</h3><ul>")
                    .arg(StartPage::tr("Graded, %1 of 100 points to pass").arg(m.passScore, 0, 'f', 0));
        for (const auto& criterion : m.criteria) {
            const auto& terms = criterion->terms();
            text += QStringLiteral("<li>%1</li>")
                        .arg(terms.fails ? StartPage::tr("%1 (a breach fails the run)").arg(html(terms.title))
                                         : html(terms.title));
        }
        text += QStringLiteral("</ul>");
    }
    return text + QStringLiteral("<p><i>%1. %2</i></p>").arg(html(m.competenceCode), html(world.area.notice));
}

StartPage::StartPage(For whom, std::vector<ScenarioEntry> scenarios, Documents documents, QWidget* parent)
    : Page(parent),
      m_for(whom),
      m_scenarios(std::move(scenarios)),
      m_documents(std::move(documents)),
      m_list(new QListWidget(this)),
      m_briefing(new QTextBrowser(this)),
      m_level(new QComboBox(this)),
      m_type(new QComboBox(this)),
      m_trainee(new QLineEdit(this)),
      m_pilot(new QCheckBox(tr("The scripted pilot has the ship at the start"), this)),
      m_open(new QPushButton(whom == For::Trainer ? tr("Open the desk") : tr("Go to the bridge"), this)),
      m_trouble(new QLabel(this)) {
    setWindowTitle(whom == For::Trainer ? tr("Run a lesson") : tr("Take a watch"));
    m_pilot->setVisible(whom == For::Trainer);
    m_open->setProperty("primary", true);
    m_list->setObjectName(QStringLiteral("scenarios"));
    m_open->setObjectName(QStringLiteral("open"));
    m_open->setDefault(true);
    m_open->setMinimumHeight(40);
    m_pilot->setObjectName(QStringLiteral("pilot"));
    m_trouble->setObjectName(QStringLiteral("trouble"));
    m_trouble->setWordWrap(true);
    m_trainee->setObjectName(QStringLiteral("trainee"));
    m_trainee->setPlaceholderText(tr("nobody named"));
    m_trainee->setToolTip(tr("Added to the roster when new"));
    for (int i = 1; i <= core::kLevels; ++i) m_level->addItem(tr("Level %1").arg(i), i);
    m_level->setCurrentIndex(2);
    m_level->setToolTip(tr("Weather, visibility, traffic and the time allowed"));
    const std::pair<QString, const char*> types[] = {{tr("Training"), "train"},
                                                     {tr("Assessment (counts as a grade)"), "assess"},
                                                     {tr("Familiarisation"), "familiarise"}};
    for (const auto& [name, type] : types) m_type->addItem(name, QString::fromLatin1(type));

    auto* const form = new QFormLayout;
    form->addRow(tr("Difficulty"), m_level);
    form->addRow(tr("Run as"), m_type);
    form->addRow(tr("Trainee"), m_trainee);
    if (whom == For::Trainer) form->addRow(m_pilot);
    auto* const left = new QVBoxLayout;
    left->addWidget(heading(tr("Exercises"), 1.2, this));
    left->addWidget(m_list, 1);
    left->addLayout(form);
    left->addWidget(m_trouble);
    left->addWidget(m_open);
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(24);
    layout->addLayout(left, 2);
    layout->addWidget(m_briefing, 3);

    for (const ScenarioEntry& entry : m_scenarios) m_list->addItem(QString::fromStdString(entry.name));
    connect(m_list, &QListWidget::currentRowChanged, this, &StartPage::prepare);
    connect(m_list, &QListWidget::itemActivated, this, &StartPage::open);
    connect(m_open, &QPushButton::clicked, this, &StartPage::open);
    if (m_scenarios.empty()) {
        m_briefing->setPlainText(
            tr("There is no exercise in the database. Start once with the shipped assets in place."));
        m_open->setEnabled(false);
    } else {
        m_list->setCurrentRow(0);
    }
}

void StartPage::setNames(const QStringList& names) {
    auto* const completer = new QCompleter(names, this);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    completer->setFilterMode(Qt::MatchContains);
    m_trainee->setCompleter(completer);
}

void StartPage::setTrouble(const QString& trouble) { m_trouble->setText(trouble); }

void StartPage::prepare(int row) {
    if (row < 0) return;
    setTrouble({});
    m_exercise = {};
    m_openWhenBuilt = false;
    const int asked = ++m_asked;
    auto documents = m_documents(m_scenarios[static_cast<std::size_t>(row)].id);
    if (!documents) return refuse(documents.error());
    m_open->setEnabled(true);
    m_briefing->setPlainText(tr("Preparing the exercise ..."));
    auto* const watcher = new QFutureWatcher<Built>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, asked] {
        watcher->deleteLater();
        if (asked == m_asked) take(watcher->result());  // else another was chosen meanwhile
    });
    watcher->setFuture(
        QtConcurrent::run([documents = std::move(documents).value()] { return prepareExercise(documents); }));
}

void StartPage::take(const Built& built) {
    if (!built) return refuse(built.error());
    m_exercise = built.value();
    m_pilot->setEnabled(m_for == For::Trainer && !m_exercise.world->pilot.empty());
    m_briefing->setHtml(briefingHtml(*m_exercise.world));
    if (m_openWhenBuilt) open();
}

void StartPage::refuse(const std::string& why) {
    m_open->setEnabled(false);
    m_briefing->setPlainText(tr("This scenario cannot be sailed:\n\n%1").arg(QString::fromStdString(why)));
}

void StartPage::open() {
    const int row = m_list->currentRow();
    if (row < 0 || !m_open->isEnabled()) return;
    m_openWhenBuilt = !m_exercise.world;
    if (m_openWhenBuilt) return;
    Q_EMIT chosen({m_scenarios[static_cast<std::size_t>(row)].id, m_level->currentData().toInt(),
                   m_type->currentData().toString().toStdString(), m_trainee->text().trimmed().toStdString(),
                   m_pilot->isEnabled() && m_pilot->isChecked(), m_exercise});
}

}  // namespace sagara::ui
