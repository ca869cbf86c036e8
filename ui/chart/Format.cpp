#include "ui/chart/Format.h"

#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::chart {
namespace {

using namespace Qt::StringLiterals;

const QChar kDash(0x2013), kMinus(0x2212), kDegree(0xb0), kFixedSpace(0xa0);

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

QString naturalScale(double denominator) {
    if (!std::isfinite(denominator)) return QString(kDash);
    const QString digits = QString::number(std::llround(denominator));
    QString grouped;
    for (qsizetype i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) grouped += kFixedSpace;
        grouped += digits[i];
    }
    return u"1:"_s + grouped;
}

}  // namespace sagara::chart
