#include "ui/editor/SectionAids.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "core/assess/MissionContext.h"
#include "core/base/Units.h"
#include "core/sea/Beaufort.h"
#include "ui/chart/Format.h"
#include "ui/chart/Marks.h"
#include "ui/editor/DraftMarks.h"
#include "ui/editor/FieldEntries.h"
#include "ui/widgets/ChartPalette.h"

namespace sagara::ui::editor {
namespace {

constexpr int kIcon_px = 22, kColumns = 3;

}  // namespace

WeatherAid::WeatherAid(EditorContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_beaufort(new QComboBox(this)), m_says(new QLabel(this)) {
    m_beaufort->setObjectName(QStringLiteral("beaufort"));
    m_beaufort->setToolTip(words("Sets the wind speed to the middle of the number's band, in knots"));
    for (int i = 0; i <= core::kBeaufortMax; ++i) {
        const auto name = core::beaufortName(i);
        m_beaufort->addItem(words("%1 %2, %3 kn")
                                .arg(i)
                                .arg(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())),
                                     chart::number(core::windOfBeaufort_mps(i) / core::kKnot_mps, 0)));
    }
    keepWheelForPage(*m_beaufort);
    m_says->setObjectName(QStringLiteral("sea-says"));
    m_says->setWordWrap(true);
    auto* const layout = new QFormLayout(this);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->addRow(words("Beaufort"), m_beaufort);
    layout->addRow(m_says);
    connect(m_beaufort, &QComboBox::activated, this, &WeatherAid::take);
    connect(&context.draft(), &ScenarioDraft::changed, this, &WeatherAid::load);
    connect(&context, &EditorContext::areaChanged, this, &WeatherAid::load);
    load();
}

void WeatherAid::load() {
    const Json& document = m_context.draft().document();
    const double wind_mps = core::kKnot_mps * numberAt(document, "weather.wind.speed_kn", 0.0);
    const QSignalBlocker quiet(m_beaufort);
    m_beaufort->setCurrentIndex(core::beaufortOfWind(wind_mps));
    const bool ocean = textAt(document, "weather.exposure") == "ocean";
    const auto sea = core::windSea(wind_mps, 0.0, ocean ? core::Exposure::Ocean : core::Exposure::Inshore);
    QString text =
        sea ? words("Wind sea %1 m high, %2 s.")
                  .arg(chart::number(sea->significantHeight_m, 1), chart::number(sea->peakPeriod_s, 1))
            : words("No wind sea.");
    const auto start = core::parseUtc(textAt(document, "startUtc"));
    if (const core::Area* area = m_context.area().get(); area && start) {
        const core::TidePrediction tide(area->meanTideLevel_m, area->tide, *start);
        text += words(" Tide at the start %1 m above %2; it follows from date and time.")
                    .arg(chart::number(tide.height_m({}), 2), QString::fromStdString(area->depthDatum));
    }
    m_says->setText(text);
}

void WeatherAid::take(int number) {
    const double wind_kn = std::round(10.0 * core::windOfBeaufort_mps(number) / core::kKnot_mps) / 10.0;
    m_context.draft().set("weather.wind.speed_kn", wind_kn, words("Beaufort %1").arg(number));
}

LevelsAid::LevelsAid(EditorContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_says(new QLabel(this)) {
    m_says->setObjectName(QStringLiteral("levels-say"));
    m_says->setWordWrap(true);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->addWidget(m_says);
    connect(&context.draft(), &ScenarioDraft::changed, this, &LevelsAid::load);
    load();
}

void LevelsAid::load() {
    const Json& document = m_context.draft().document();
    QString html;
    for (int level = 1; level <= core::kLevels; ++level) {
        const std::string row = join("levels", static_cast<std::size_t>(level - 1));
        const auto times = [&](const char* factor, const char* path) {
            return numberAt(document, join(row, factor), 1.0) * numberAt(document, path, 0.0);
        };
        QStringList ships;
        for (std::size_t i = 0; i < sizeAt(document, "traffic"); ++i) {
            const std::string target = join("traffic", i);
            const Json* hidden = editor::find(document, join(target, "onEvent"));
            const bool onEvent = hidden && hidden->is_boolean() && hidden->get<bool>();
            if (!onEvent && static_cast<int>(numberAt(document, join(target, "fromLevel"), 1.0)) == level)
                ships << QString::fromStdString(textAt(document, join(target, "name"))).toHtmlEscaped();
        }
        html += words("<p><b>Level %1:</b> wind %2 kn, visibility %3 M")
                    .arg(level)
                    .arg(chart::number(times("windFactor", "weather.wind.speed_kn"), 0),
                         chart::shortNumber(times("visibilityFactor", "weather.visibility_M"), 1));
        if (sizeAt(document, "weather.swells") > 0)
            html +=
                words(", swell %1 m").arg(chart::number(times("seaFactor", "weather.swells[0].height_m"), 1));
        if (!ships.isEmpty())
            html +=
                (level == 1 ? words("; ships: %1") : words("; and %1")).arg(ships.join(QStringLiteral(", ")));
        html += QStringLiteral("</p>");
    }
    m_says->setText(html);
}

MarksAid::MarksAid(EditorContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_buttons(new QButtonGroup(this)) {
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 4);
    grid->setSpacing(4);
    const std::vector<Option>& kinds = markKinds();
    m_kind = kinds.front().value;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        auto* const button = new QToolButton(this);
        button->setObjectName(QString::fromStdString("mark-kind." + kinds[i].value));
        button->setText(kinds[i].label);
        button->setToolTip(words("Click on the chart to place: %1").arg(kinds[i].label));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setIconSize({kIcon_px, kIcon_px});
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        grid->addWidget(button, static_cast<int>(i) / kColumns, static_cast<int>(i) % kColumns);
        m_buttons->addButton(button, static_cast<int>(i));
    }
    connect(m_buttons, &QButtonGroup::idClicked, this, [this](int index) {
        m_kind = markKinds()[static_cast<std::size_t>(index)].value;
        Q_EMIT kindChosen();
    });
    connect(&context, &EditorContext::coloursChanged, this, &MarksAid::paintIcons);
    connect(&context, &EditorContext::areaChanged, this, &MarksAid::paintIcons);
    paintIcons();
}

void MarksAid::setAdding(bool on) {
    m_buttons->setExclusive(on);
    for (QAbstractButton* button : m_buttons->buttons())
        button->setChecked(on && button->objectName() == QString::fromStdString("mark-kind." + m_kind));
}

/// As the chart draws them.
void MarksAid::paintIcons() {
    const core::Area* const area = m_context.area().get();
    const std::string region = area ? area->ialaRegion : "A";
    const double ratio = devicePixelRatioF();
    for (QAbstractButton* button : m_buttons->buttons()) {
        const std::string& kind = markKinds()[static_cast<std::size_t>(m_buttons->id(button))].value;
        QPixmap picture(QSizeF(ratio * kIcon_px, ratio * kIcon_px).toSize());
        picture.setDevicePixelRatio(ratio);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        const core::Mark mark = markOf(Json{{"kind", kind}}, core::LocalFrame({}));
        chart::drawMark(painter, {0.5 * kIcon_px, 0.5 * kIcon_px}, chart::chartMarkOf(mark, region),
                        0.72 * kIcon_px, chartPalette(m_context.colours()).marks);
        painter.end();
        button->setIcon(QIcon(picture));
    }
}

}  // namespace sagara::ui::editor
