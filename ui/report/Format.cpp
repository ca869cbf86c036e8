#include "ui/report/Format.h"

#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <array>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::report {
namespace {

using namespace Qt::StringLiterals;

const QChar kDash(0x2013), kMinus(0x2212), kDegree(0xb0);

QDateTime localOf(core::Utc instant, int utcOffset_min) {
    return QDateTime::fromSecsSinceEpoch(instant.unix_s, Qt::OffsetFromUTC, utcOffset_min * 60);
}

QString english(const QDateTime& time, const QString& format) {
    return QLocale(QLocale::English, QLocale::UnitedKingdom).toString(time, format);
}

/// "006°01.95'" of an angle that is not negative. Rounded once, so that minutes never read 60.
QString degreesAndMinutes(double angle_deg, int decimals) {
    if (!std::isfinite(angle_deg)) return QString(kDash);
    const double perDegree = 60.0 * std::pow(10.0, decimals);
    const auto units = static_cast<long long>(std::llround(angle_deg * perDegree));
    const auto whole = static_cast<long long>(std::llround(perDegree));
    const double minutes = static_cast<double>(units % whole) / (perDegree / 60.0);
    const int width = decimals > 0 ? decimals + 3 : 2;
    return u"%1%2%3'"_s.arg(units / whole, 3, 10, QLatin1Char('0'))
        .arg(kDegree)
        .arg(minutes, width, 'f', decimals, QLatin1Char('0'));
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

QString number(double value, int decimals) {
    if (!std::isfinite(value)) return QString(kDash);
    QString digits = QString::number(std::abs(value), 'f', decimals);
    const bool zero = digits.count(u'0') + digits.count(u'.') == digits.size();
    return value < 0.0 && !zero ? kMinus + digits : digits;
}

QString shortNumber(double value, int mostDecimals) {
    QString digits = number(value, mostDecimals);
    if (!digits.contains(u'.')) return digits;
    while (digits.endsWith(u'0')) digits.chop(1);
    if (digits.endsWith(u'.')) digits.chop(1);
    return digits;
}

QString clockTime(double time_s) {
    if (!std::isfinite(time_s)) return QString(kDash);
    const auto seconds = std::llround(std::max(0.0, time_s));
    return u"%1:%2"_s.arg(seconds / 60, 2, 10, QLatin1Char('0')).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString bearing(double angle_deg) {
    if (!std::isfinite(angle_deg)) return QString(kDash);
    const auto whole = std::llround(core::wrapTwoPi(angle_deg * core::kDegree_rad) / core::kDegree_rad) % 360;
    return u"%1"_s.arg(whole, 3, 10, QLatin1Char('0'));
}

QString latitude(double lat_deg, int decimals) {
    return degreesAndMinutes(std::abs(lat_deg), decimals) + (lat_deg < 0.0 ? u'S' : u'N');
}

QString longitude(double lon_deg, int decimals) {
    return degreesAndMinutes(std::abs(lon_deg), decimals) + (lon_deg < 0.0 ? u'W' : u'E');
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
