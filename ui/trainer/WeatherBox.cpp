#include "ui/trainer/WeatherBox.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using core::Weather;

/// 0 to 359.
double degrees(double rad) { return std::fmod(std::round(core::wrapTwoPi(rad) / core::kDegree_rad), 360.0); }

}  // namespace

WeatherBox::WeatherBox(ExerciseRun& run, QWidget* parent)
    : QGroupBox(tr("Weather"), parent),
      m_run(run),
      m_ramp(new QDoubleSpinBox(this)),
      m_apply(new QPushButton(this)) {
    add(QStringLiteral("wind"), 100.0, 0, tr("kn"), tr("Mean speed of the wind"),
        [](const Weather& w) { return w.wind.speed_mps / core::kKnot_mps; });
    add(QStringLiteral("wind-from"), 359.0, 0, tr("°"), tr("Where the wind comes from"),
        [](const Weather& w) { return degrees(w.wind.windFrom_rad); });
    add(QStringLiteral("gusts"), 50.0, 0, tr("%"), tr("How much gusts add to the mean and take from it"),
        [](const Weather& w) { return 100.0 * w.wind.gustiness; });
    add(
        QStringLiteral("visibility"), 30.0, 2, tr("M"), tr("How far one sees; below 0.5 M it is fog"),
        [](const Weather& w) { return w.visibility_m / core::kNauticalMile_m; }, 0.05);
    add(QStringLiteral("rain"), 100.0, 0, tr("%"), tr("100 % is a tropical downpour"),
        [](const Weather& w) { return 100.0 * w.rain; });
    add(QStringLiteral("current"), 15.0, 1, tr("kn"), tr("How fast the current sets"),
        [](const Weather& w) { return core::length(w.current) / core::kKnot_mps; });
    add(QStringLiteral("current-to"), 359.0, 0, tr("°"), tr("Where the current sets to"),
        [](const Weather& w) { return degrees(std::atan2(w.current.east_m, w.current.north_m)); });
    for (std::size_t i = 0; i < core::kMostSwells; ++i) {
        const QString id = QStringLiteral("swell%1-").arg(i + 1);
        add(id + QStringLiteral("height"), 15.0, 1, tr("m"), tr("Significant height; 0: no such swell"),
            [i](const Weather& w) { return w.swells[i].significantHeight_m; });
        add(
            id + QStringLiteral("period"), 25.0, 1, tr("s"), tr("Peak period"),
            [i](const Weather& w) {
                return w.swells[i].significantHeight_m > 0.0 ? w.swells[i].peakPeriod_s : 10.0;
            },
            2.0);
        add(id + QStringLiteral("from"), 359.0, 0, tr("°"), tr("Where the swell comes from"),
            [i](const Weather& w) { return degrees(w.swells[i].wavesTo_rad + core::kPi); });
    }
    auto* const grid = new QGridLayout(this);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    place(*grid, tr("Wind, from"), {Wind, WindFrom});
    place(*grid, tr("Gusts, rain"), {Gusts, Rain});
    place(*grid, tr("Visibility"), {Visibility});
    place(*grid, tr("Current, to"), {Current, CurrentTo});
    for (std::size_t i = 0; i < core::kMostSwells; ++i) {
        const std::size_t first = Swell1 + kPerSwell * i;
        place(*grid, tr("Swell %1, period").arg(i + 1), {first, first + 1});
        place(*grid, tr("   comes from"), {first + 2});
    }
    m_ramp->setObjectName(QStringLiteral("weather-ramp"));
    m_ramp->setRange(0.0, 3600.0);
    m_ramp->setDecimals(0);
    m_ramp->setValue(60.0);
    m_ramp->setSuffix(tr(" s"));
    m_ramp->setToolTip(tr("How long the change takes, 0 to 3600 s"));
    const int row = grid->rowCount();
    grid->addWidget(new QLabel(tr("Change within"), this), row, 0);
    grid->addWidget(m_ramp, row, 1);
    m_apply->setText(tr("Change"));
    m_apply->setObjectName(QStringLiteral("apply-weather"));
    m_apply->setToolTip(tr("Orders the figures you have touched (in bold); the others stay"));
    grid->addWidget(m_apply, row, 2);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    connect(m_apply, &QPushButton::clicked, this, &WeatherBox::apply);
    refresh(*run.latest());
}

void WeatherBox::add(const QString& id, double most, int decimals, const QString& unit, const QString& tip,
                     std::function<double(const core::Weather&)> now, double least) {
    auto* const spin = new QDoubleSpinBox(this);
    spin->setObjectName(id);
    spin->setRange(least, most);
    spin->setDecimals(decimals);
    spin->setSingleStep(decimals > 0 ? 0.5 : 1.0);
    spin->setSuffix(QLatin1Char(' ') + unit);
    spin->setToolTip(tr("%1; %2 to %3 %4").arg(tip).arg(least).arg(most).arg(unit));
    spin->setWrapping(most == 359.0);
    spin->setMinimumWidth(70);
    const std::size_t index = m_fields.size();
    m_fields.push_back({spin, std::move(now), false});
    connect(spin, &QDoubleSpinBox::valueChanged, this, [this, index, spin] {
        m_fields[index].touched = true;
        QFont font = spin->font();
        font.setBold(true);
        spin->setFont(font);
        m_apply->setEnabled(true);
    });
}

void WeatherBox::place(QGridLayout& grid, const QString& name, std::initializer_list<std::size_t> fields) {
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(name, this), row, 0);
    int column = 1;
    for (const std::size_t field : fields) grid.addWidget(m_fields[field].spin, row, column++);
}

bool WeatherBox::touched(std::size_t first, std::size_t count) const {
    for (std::size_t i = first; i < first + count; ++i)
        if (m_fields[i].touched) return true;
    return false;
}
bool WeatherBox::any() const { return touched(0, m_fields.size()); }
double WeatherBox::value(std::size_t field) const { return m_fields[field].spin->value(); }

core::WeatherOrder WeatherBox::order() const {
    core::WeatherOrder order;
    if (touched(Wind, 1)) order.windSpeed_mps = value(Wind) * core::kKnot_mps;
    if (touched(WindFrom, 1)) order.windFrom_rad = value(WindFrom) * core::kDegree_rad;
    if (touched(Gusts, 1)) order.gustiness = 0.01 * value(Gusts);
    if (touched(Visibility, 1)) order.visibility_m = value(Visibility) * core::kNauticalMile_m;
    if (touched(Rain, 1)) order.rain = 0.01 * value(Rain);
    if (touched(Current, 2))
        order.current =
            value(Current) * core::kKnot_mps * core::unitVector(value(CurrentTo) * core::kDegree_rad);
    for (std::size_t i = 0; i < core::kMostSwells; ++i) {
        const std::size_t first = Swell1 + kPerSwell * i;
        if (!touched(first, kPerSwell)) continue;
        core::WaveSystem swell = m_run.latest()->weather.swells[i];
        if (swell.significantHeight_m == 0.0) swell.gamma = 3.3, swell.spreading = 25.0;  // as documents say
        swell.significantHeight_m = value(first);
        swell.peakPeriod_s = value(first + 1);
        swell.wavesTo_rad = core::wrapTwoPi(value(first + 2) * core::kDegree_rad + core::kPi);
        order.swells[i] = swell;
    }
    order.ramp_s = m_ramp->value();
    return order;
}

void WeatherBox::apply() {
    if (!any()) return;
    m_orderedAt = m_run.latest()->tick;
    m_run.give(0, order());
    for (Field& field : m_fields) {
        field.touched = false;
        field.spin->setFont(font());
    }
    m_apply->setEnabled(false);
}

void WeatherBox::refresh(const core::Snapshot& now) {
    m_apply->setEnabled(any());
    if (now.tick >= m_orderedAt && now.tick <= m_orderedAt + 2) return;  // not carried out yet
    for (Field& field : m_fields) {
        if (field.touched || field.spin->hasFocus()) continue;
        const QSignalBlocker quiet(field.spin);
        field.spin->setValue(field.now(now.weather));
    }
}

}  // namespace sagara::ui
