#include "ui/editor/SectionAids.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>

#include "core/assess/MissionContext.h"
#include "core/base/Units.h"
#include "core/sea/Beaufort.h"
#include "ui/chart/Format.h"
#include "ui/editor/FieldEntries.h"

namespace sagara::ui::editor {

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
    QString text = sea ? words("Wind sea %1 m high, %2 s.")
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
            html += words(", swell %1 m").arg(chart::number(times("seaFactor", "weather.swells[0].height_m"), 1));
        if (!ships.isEmpty())
            html += (level == 1 ? words("; ships: %1") : words("; and %1")).arg(ships.join(QStringLiteral(", ")));
        html += QStringLiteral("</p>");
    }
    m_says->setText(html);
}

}  // namespace sagara::ui::editor
