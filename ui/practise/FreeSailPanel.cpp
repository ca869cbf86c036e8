#include "ui/practise/FreeSailPanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QFutureWatcher>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QtConcurrent/QtConcurrentRun>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using AreaRead = std::pair<std::shared_ptr<const core::Area>, std::string>;

QComboBox* combo(const char* name, const QString& tip, QWidget* parent) {
    auto* const made = new QComboBox(parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(16);
    made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return made;
}

void fill(QComboBox* box, const std::vector<PractiseEntry>& entries) {
    for (const PractiseEntry& entry : entries)
        box->addItem(QString::fromStdString(entry.name), QString::fromStdString(entry.id));
}

}  // namespace

FreeSailPanel::FreeSailPanel(const PractisePorts& ports, QWidget* parent)
    : QWidget(parent),
      m_ports(ports),
      m_ship(combo("ship", tr("Ship, from the vessels of this installation"), this)),
      m_areas(combo("area", tr("Area"), this)),
      m_placeBox(combo("place", tr("Where to begin: places with room and water enough for this ship"), this)),
      m_heading(new QSpinBox(this)),
      m_speed(new QSpinBox(this)),
      m_traffic(combo("traffic", tr("Other ships, as in a lesson of this area"), this)),
      m_note(new QLabel(this)) {
    fill(m_ship, ports.vessels);
    fill(m_areas, ports.areas);
    m_traffic->addItem(tr("No other ships"), QString());
    for (const PractiseEntry& lesson : ports.lessons)
        m_traffic->addItem(tr("As in %1").arg(QString::fromStdString(lesson.name)),
                           QString::fromStdString(lesson.id));
    m_heading->setObjectName(QStringLiteral("heading"));
    m_heading->setRange(0, 359);
    m_heading->setWrapping(true);
    m_heading->setSuffix(tr("°T"));
    m_heading->setToolTip(tr("True heading at the start, 0 to 359°"));
    m_heading->setAccessibleName(tr("Heading"));
    m_speed->setObjectName(QStringLiteral("speed"));
    m_speed->setRange(0, 15);
    m_speed->setValue(6);
    m_speed->setSuffix(tr(" kn"));
    m_speed->setToolTip(tr("Speed through the water at the start, 0 to 15 kn"));
    m_speed->setAccessibleName(tr("Speed"));
    m_note->setWordWrap(true);
    m_note->setObjectName(QStringLiteral("place-note"));

    auto* const form = new QFormLayout(this);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->addRow(tr("&Ship"), m_ship);
    form->addRow(tr("&Area"), m_areas);
    form->setRowVisible(m_areas, ports.areas.size() > 1);
    form->addRow(tr("&Place"), m_placeBox);
    auto* const under = new QHBoxLayout;
    under->addWidget(m_heading, 1);
    under->addWidget(m_speed, 1);
    form->addRow(tr("Under way"), under);
    form->addRow(tr("T&raffic"), m_traffic);
    form->addRow(m_note);

    connect(m_ship, &QComboBox::currentIndexChanged, this, [this] { readVessel(); });
    connect(m_areas, &QComboBox::currentIndexChanged, this, [this] { readArea(); });
    connect(m_placeBox, &QComboBox::currentIndexChanged, this, [this] { showPlace(); });
    for (QSpinBox* box : {m_heading, m_speed})
        connect(box, &QSpinBox::valueChanged, this, &FreeSailPanel::changed);
    connect(m_traffic, &QComboBox::currentIndexChanged, this, &FreeSailPanel::changed);
    readVessel();
    readArea();
}

/// Megabytes of JSON: aside.
void FreeSailPanel::readArea() {
    m_area.reset();
    listPlaces();
    const std::string id = m_areas->currentData().toString().toStdString();
    auto text = m_ports.find(core::DocumentKind::Area, id);
    if (!text) return;
    auto* const watcher = new QFutureWatcher<AreaRead>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, id] {
        watcher->deleteLater();
        if (id != m_areas->currentData().toString().toStdString()) return;
        m_area = watcher->result().first;
        m_problem = QString::fromStdString(watcher->result().second);
        listPlaces();
    });
    watcher->setFuture(QtConcurrent::run([id, text = std::move(*text)]() -> AreaRead {
        auto area = core::loadArea(id, text);
        if (!area) return {nullptr, area.error().text()};
        return {std::make_shared<const core::Area>(std::move(area).value()), {}};
    }));
}

void FreeSailPanel::readVessel() {
    m_vessel.reset();
    m_problem.clear();
    const std::string id = m_ship->currentData().toString().toStdString();
    if (const auto text = m_ports.find(core::DocumentKind::Vessel, id)) {
        auto vessel = core::loadVessel(id, *text);
        if (vessel) m_vessel = std::move(vessel).value();
        if (!vessel) m_problem = QString::fromStdString(vessel.error().text());
    }
    listPlaces();
}

void FreeSailPanel::listPlaces() {
    const QString before = m_placeBox->currentData().toString();
    {
        const QSignalBlocker quiet(m_placeBox);
        m_placeBox->clear();
        m_places.clear();
        if (m_area && m_vessel) m_places = placesFor(*m_area, *m_vessel);
        for (const SailPlace& place : m_places)
            m_placeBox->addItem(QString::fromStdString(place.name), QString::fromStdString(place.id));
        if (const int at = m_placeBox->findData(before); at >= 0) m_placeBox->setCurrentIndex(at);
    }
    showPlace();
}

const SailPlace* FreeSailPanel::place() const {
    const int at = m_placeBox->currentIndex();
    return at >= 0 && at < static_cast<int>(m_places.size()) ? &m_places[static_cast<std::size_t>(at)]
                                                             : nullptr;
}

void FreeSailPanel::showPlace() {
    const SailPlace* const chosen = place();
    const bool atSea = chosen != nullptr && !chosen->alongside();
    for (QSpinBox* box : {m_heading, m_speed}) box->setEnabled(atSea);
    if (chosen != nullptr) m_heading->setValue(static_cast<int>(std::lround(chosen->heading_deg)) % 360);
    if (!m_problem.isEmpty())
        m_note->setText(m_problem);
    else if (!m_area)
        m_note->setText(tr("Reading the area…"));
    else if (chosen == nullptr)
        m_note->setText(tr("No place here has water enough for this ship. Choose another ship."));
    else
        m_note->setText(tr("%1 m of water at chart datum, she draws %2 m (modelled depths).%3")
                            .arg(chosen->depth_m, 0, 'f', 1)
                            .arg(m_vessel->hull.draught_m, 0, 'f', 1)
                            .arg(chosen->alongside()
                                     ? tr(" She lies port side to, on %1 lines.").arg(chosen->lines.size())
                                     : QString()));
    Q_EMIT changed();
}

std::optional<FreeSail> FreeSailPanel::sail() const {
    const SailPlace* const chosen = place();
    if (chosen == nullptr || !m_vessel || !m_area) return std::nullopt;
    FreeSail sail;
    sail.shipName = m_vessel->name;
    sail.vessel = m_ship->currentData().toString().toStdString();
    sail.area = m_areas->currentData().toString().toStdString();
    sail.place = *chosen;
    sail.heading_deg = m_heading->value();
    sail.speed_kn = m_speed->value();
    const QString lesson = m_traffic->currentData().toString();
    if (!lesson.isEmpty())
        if (const auto text = m_ports.find(core::DocumentKind::Scenario, lesson.toStdString()))
            sail.traffic = peacefulTraffic(*text);
    return sail;
}

QString FreeSailPanel::words() const {
    const SailPlace* const chosen = place();
    if (chosen == nullptr || !m_vessel) return m_note->text().toHtmlEscaped();
    const core::Hull& hull = m_vessel->hull;
    const QString start = chosen->alongside() ? tr("alongside, port side to the quay")
                                              : tr("heading %1°T at %2 kn")
                                                    .arg(m_heading->value(), 3, 10, QLatin1Char('0'))
                                                    .arg(m_speed->value());
    return tr("<h2>Free sailing</h2><p>The sea to yourself: no task, no limits, nothing is graded.</p>"
              "<h3>%1</h3><p>%2 m long, %3 m wide, draught %4 m.</p><h3>%5</h3><p>%6; %7 m of water.</p>"
              "<p><i>%8</i></p>")
        .arg(QString::fromStdString(m_vessel->name).toHtmlEscaped())
        .arg(hull.lengthOverall_m, 0, 'f', 1)
        .arg(hull.beam_m, 0, 'f', 1)
        .arg(hull.draught_m, 0, 'f', 1)
        .arg(QString::fromStdString(chosen->name).toHtmlEscaped(), start)
        .arg(chosen->depth_m, 0, 'f', 1)
        .arg(QString::fromStdString(m_area->notice).toHtmlEscaped());
}

}  // namespace sagara::ui
