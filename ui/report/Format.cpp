#include "ui/report/Format.h"

#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <array>
#include <cmath>

namespace sagara::report {
namespace {

using namespace Qt::StringLiterals;

const QChar kDash(0x2013), kMinus(0x2212);

QDateTime localOf(core::Utc instant, int utcOffset_min) {
    return QDateTime::fromSecsSinceEpoch(instant.unix_s, Qt::OffsetFromUTC, utcOffset_min * 60);
}

QString english(const QDateTime& time, const QString& format) {
    return QLocale(QLocale::English, QLocale::UnitedKingdom).toString(time, format);
}

QString zoneOffset(int utcOffset_min) {
    const int size_min = std::abs(utcOffset_min);
    return u"UTC%1%2:%3"_s.arg(utcOffset_min < 0 ? kMinus : QLatin1Char('+'))
        .arg(size_min / 60, 2, 10, QLatin1Char('0'))
        .arg(size_min % 60, 2, 10, QLatin1Char('0'));
}

int decimalsFor(const DeductionLine& line) {
    struct UnitDecimals {
        const char* unit;
        int decimals;
    };
    static constexpr std::array<UnitDecimals, 8> kKnown{
        {{"kn", 1}, {"M", 3}, {"m/s", 2}, {"min", 1}, {"kJ", 0}, {"", 0}, {"s", 0}, {"°", 0}}};
    for (const UnitDecimals& known : kKnown) {
        if (line.unit == known.unit) return known.decimals;
    }
    return std::abs(line.value) < 100.0 ? 1 : 0;
}

}  // namespace

QString clockTime(double time_s) {
    if (!std::isfinite(time_s)) return QString(kDash);
    const auto seconds = std::llround(std::max(0.0, time_s));
    return u"%1:%2"_s.arg(seconds / 60, 2, 10, QLatin1Char('0')).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString localTime(core::Utc instant, int utcOffset_min, const std::string& zone) {
    const QString name = zone.empty() ? QString() : QString::fromStdString(zone) + u", "_s;
    return english(localOf(instant, utcOffset_min), u"d MMMM yyyy, HH:mm"_s) +
           u" (%1%2)"_s.arg(name, zoneOffset(utcOffset_min));
}

QString utcTime(core::Utc instant) { return english(localOf(instant, 0), u"d MMMM yyyy, HH:mm 'UTC'"_s); }

QString localDate(core::Utc instant, int utcOffset_min) {
    return english(localOf(instant, utcOffset_min), u"d MMMM yyyy"_s);
}

ValueAndLimit valueAndLimit(const DeductionLine& line) {
    const QString unit = line.unit.empty() ? QString() : u' ' + QString::fromStdString(line.unit);
    int decimals = decimalsFor(line);
    while (decimals < 4 && line.value != line.limit &&
           number(line.value, decimals) == number(line.limit, decimals)) {
        ++decimals;
    }
    return {number(line.value, decimals) + unit, number(line.limit, decimals) + unit};
}

QString ranges(const std::vector<int>& numbers) {
    QStringList parts;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        const QString first = QString::number(numbers[i]);
        if (last == i) parts << first;
        if (last == i + 1) parts << first << QString::number(numbers[last]);
        if (last > i + 1) parts << first + kDash + QString::number(numbers[last]);
        i = last + 1;
    }
    return parts.join(u", "_s);
}

}  // namespace sagara::report
