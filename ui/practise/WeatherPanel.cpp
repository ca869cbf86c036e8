#include "ui/practise/WeatherPanel.h"

#include <QComboBox>
#include <QDateTime>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QTimeEdit>
#include <cmath>

namespace sagara::ui {
namespace {

constexpr double kRain[] = {0.0, 0.25, 0.6, 1.0};

QDateTime instant(const std::string& utc) {
    return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toUTC();
}

}  // namespace

WeatherPanel::WeatherPanel(QWidget* parent)
    : QWidget(parent),
      m_wind(new QSpinBox(this)),
      m_windFrom(new QSpinBox(this)),
      m_swell(new QDoubleSpinBox(this)),
      m_period(new QSpinBox(this)),
      m_swellFrom(new QSpinBox(this)),
      m_visibility(new QDoubleSpinBox(this)),
      m_rain(new QComboBox(this)),
      m_time(new QTimeEdit(this)) {
    const auto whole = [](QSpinBox* box, const char* name, int low, int high, const QString& unit,
                          const QString& tip) {
        box->setObjectName(QString::fromLatin1(name));
        box->setRange(low, high);
        box->setSuffix(unit);
        box->setToolTip(tip);
        box->setAccessibleName(tip);
    };
    whole(m_wind, "wind", 0, 60, tr(" kn"), tr("Mean wind, 0 to 60 kn; the difficulty changes it"));
    whole(m_windFrom, "wind-from", 0, 359, tr("°"), tr("Where the wind comes from, 0 to 359° true"));
    whole(m_period, "swell-period", 4, 20, tr(" s"), tr("Period of the swell, 4 to 20 s"));
    whole(m_swellFrom, "swell-from", 0, 359, tr("°"), tr("Where the swell comes from, 0 to 359° true"));
    for (QSpinBox* box : {m_windFrom, m_swellFrom}) {
        box->setWrapping(true);
        box->setPrefix(tr("from "));
    }
    const auto broken = [](QDoubleSpinBox* box, const char* name, double low, double high,
                           const QString& unit, const QString& tip) {
        box->setObjectName(QString::fromLatin1(name));
        box->setRange(low, high);
        box->setDecimals(1);
        box->setSingleStep(0.5);
        box->setSuffix(unit);
        box->setToolTip(tip);
        box->setAccessibleName(tip);
    };
    broken(m_swell, "swell", 0.0, 6.0, tr(" m"),
           tr("Significant height of the swell, 0 to 6 m; the wind raises its own sea"));
    broken(m_visibility, "visibility", 0.1, 20.0, tr(" M"), tr("Visibility, 0.1 to 20 nautical miles"));
    m_rain->setObjectName(QStringLiteral("rain"));
    m_rain->setToolTip(tr("How hard it rains"));
    m_rain->addItems({tr("No rain"), tr("Light rain"), tr("Rain"), tr("Heavy rain")});
    m_time->setObjectName(QStringLiteral("local-time"));
    m_time->setDisplayFormat(QStringLiteral("HH:mm"));
    m_time->setToolTip(tr("Local time at the start, hours and minutes; sun, moon and lights follow"));
    m_time->setAccessibleName(tr("Local time at the start"));

    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(6);
    const auto row = [&](int at, const QString& name, const QList<QWidget*>& fields) {
        auto* const label = new QLabel(name, this);
        label->setBuddy(fields.front());
        grid->addWidget(label, at, 0);
        for (int i = 0; i < fields.size(); ++i) grid->addWidget(fields[i], at, 1 + i);
    };
    row(0, tr("&Wind"), {m_wind, m_windFrom});
    row(1, tr("Swe&ll"), {m_swell, m_swellFrom, m_period});
    row(2, tr("&Visibility"), {m_visibility, m_rain});
    row(3, tr("Local &time"), {m_time});
    for (int column = 1; column <= 3; ++column) grid->setColumnStretch(column, 1);

    for (QSpinBox* box : {m_wind, m_windFrom, m_period, m_swellFrom})
        connect(box, &QSpinBox::valueChanged, this, &WeatherPanel::changed);
    for (QDoubleSpinBox* box : {m_swell, m_visibility})
        connect(box, &QDoubleSpinBox::valueChanged, this, &WeatherPanel::changed);
    connect(m_rain, &QComboBox::currentIndexChanged, this, &WeatherPanel::changed);
    connect(m_time, &QTimeEdit::timeChanged, this, &WeatherPanel::changed);
    setWeather({});
}

void WeatherPanel::setUtcOffset(int minutes) { m_utcOffset_min = minutes; }

void WeatherPanel::setWeather(const SailWeather& w) {
    const QSignalBlocker quiet(this);
    m_wind->setValue(static_cast<int>(std::lround(w.wind_kn)));
    m_windFrom->setValue(static_cast<int>(std::lround(w.windFrom_deg)) % 360);
    m_swell->setValue(w.swell_m);
    m_period->setValue(static_cast<int>(std::lround(w.swellPeriod_s)));
    m_swellFrom->setValue(static_cast<int>(std::lround(w.swellFrom_deg)) % 360);
    m_visibility->setValue(w.visibility_M);
    int rain = 0;
    for (int i = 1; i < m_rain->count(); ++i)
        if (std::abs(kRain[i] - w.rain) < std::abs(kRain[rain] - w.rain)) rain = i;
    m_rain->setCurrentIndex(rain);
    const QDateTime local = instant(w.startUtc).addSecs(60 * m_utcOffset_min);
    m_date = local.date().toString(Qt::ISODate);
    m_time->setTime(local.time());
}

SailWeather WeatherPanel::weather() const {
    SailWeather w;
    w.wind_kn = m_wind->value();
    w.windFrom_deg = m_windFrom->value();
    w.swell_m = m_swell->value();
    w.swellPeriod_s = m_period->value();
    w.swellFrom_deg = m_swellFrom->value();
    w.visibility_M = m_visibility->value();
    w.rain = kRain[m_rain->currentIndex()];
    const QDateTime local(QDate::fromString(m_date, Qt::ISODate), m_time->time(), Qt::UTC);
    w.startUtc = local.addSecs(-60 * m_utcOffset_min).toString(Qt::ISODate).toStdString();
    return w;
}

}  // namespace sagara::ui
