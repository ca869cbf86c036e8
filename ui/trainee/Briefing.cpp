#include "ui/trainee/Briefing.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "core/base/Units.h"
#include "ui/run/RunTexts.h"

namespace sagara::ui::console {
namespace {

QString html(const std::string& utf8) { return QString::fromStdString(utf8).toHtmlEscaped(); }

QString row(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td style='padding-right:14px'>%1</td><td>%2</td></tr>").arg(name, value);
}

QString shipTable(const core::World& world, std::size_t ship) {
    const core::OwnShip& own = *world.ships[ship];
    const core::Hull& hull = own.vessel.hull;
    return QStringLiteral("<table>") +
           row(Briefing::tr("Ship"), html(own.name) + QStringLiteral(", ") + html(own.vessel.name)) +
           row(Briefing::tr("Length, beam, draught"), Briefing::tr("%1 m, %2 m, %3 m")
                                                          .arg(hull.lengthOverall_m, 0, 'f', 1)
                                                          .arg(hull.beam_m, 0, 'f', 1)
                                                          .arg(hull.draught_m, 0, 'f', 1)) +
           row(Briefing::tr("Shafts, anchors"),
               Briefing::tr("%1, %2").arg(own.shaftCount()).arg(own.anchorCount())) +
           row(Briefing::tr("Begins"),
               Briefing::tr("%1 local, %2").arg(localTime(world, {}), utcTime(world, {}))) +
           QStringLiteral("</table>");
}

}  // namespace

QString traineeBriefing(const core::World& world, std::size_t ship) {
    const core::Mission& m = world.mission;
    QString text = QStringLiteral("<h1>%1</h1>").arg(html(world.scenarioName));
    if (!m.objective.empty()) text += QStringLiteral("<p><b>%1</b></p>").arg(html(m.objective));
    if (!m.briefing.empty()) text += QStringLiteral("<p>%1</p>").arg(html(m.briefing));
    text += shipTable(world, ship);
    if (!m.tasks.empty()) {
        text += QStringLiteral("<h3>%1</h3><ol>").arg(Briefing::tr("Tasks"));
        for (const auto& task : m.tasks) text += QStringLiteral("<li>%1</li>").arg(html(task->title()));
        text += QStringLiteral("</ol>");
    }
    if (!m.criteria.empty()) {
        text += QStringLiteral("<h3>%1</h3><ul>")
                    .arg(Briefing::tr("Graded, %1 of 100 points to pass").arg(m.passScore, 0, 'f', 0));
        for (const auto& criterion : m.criteria) {
            const auto& terms = criterion->terms();
            text += QStringLiteral("<li>%1</li>")
                        .arg(terms.fails ? Briefing::tr("%1 (a breach fails the run)").arg(html(terms.title))
                                         : html(terms.title));
        }
        text += QStringLiteral("</ul>");
    }
    if (m.tasks.empty() && m.criteria.empty())
        text += QStringLiteral("<p>%1</p>").arg(Briefing::tr("Nothing is graded: get to know the ship."));
    if (!m.competenceCode.empty()) text += QStringLiteral("<p><i>%1</i></p>").arg(html(m.competenceCode));
    return text + QStringLiteral("<p><i>%1</i></p>").arg(html(world.area.notice));
}

Briefing::Briefing(const core::World& world, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_text(new QTextBrowser(this)), m_take(new QPushButton(tr("Take the watch"), this)) {
    m_text->setObjectName(QStringLiteral("briefing"));
    m_text->setHtml(traineeBriefing(world, ship));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->document()->setDocumentMargin(18.0);
    m_take->setObjectName(QStringLiteral("take-watch"));
    m_take->setProperty("primary", true);
    m_take->setDefault(true);
    m_take->setMinimumSize(240, 48);
    m_take->setToolTip(tr("To the bridge (Enter). The briefing can be read again from there"));
    connect(m_take, &QPushButton::clicked, this, &Briefing::watchTaken);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(24, 16, 24, 16);
    auto* const middle = new QHBoxLayout;
    m_text->setMaximumWidth(980);
    middle->addStretch();
    middle->addWidget(m_text, 100);
    middle->addStretch();
    column->addLayout(middle, 1);
    auto* const foot = new QHBoxLayout;
    foot->addStretch();
    foot->addWidget(m_take);
    foot->addStretch();
    column->addLayout(foot);
}

void Briefing::setTaken() { m_take->setText(tr("Back to the bridge")); }

}  // namespace sagara::ui::console
