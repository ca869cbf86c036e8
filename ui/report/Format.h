#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/base/LocalFrame.h"
#include "core/base/Utc.h"
#include "ui/report/ReportData.h"

/// Numbers, times and places as they are printed. A value that is not a number prints as a dash.
namespace sagara::report {

/// With a true minus sign, and never "-0".
QString number(double value, int decimals);
/// As many decimals as needed, `mostDecimals` at most: 4, 0.5, 2.25.
QString shortNumber(double value, int mostDecimals);
/// "07:05"; minutes may pass 99.
QString clockTime(double time_s);
/// Three figures, 000 to 359.
QString bearing(double angle_deg);

/// "006°01.95'N"
QString latitude(double lat_deg, int decimals);
QString longitude(double lon_deg, int decimals);

/// "15 January 2027, 09:00 (Asia/Colombo, UTC+05:30)"
QString localTime(core::Utc instant, int utcOffset_min, const std::string& zone);
QString utcTime(core::Utc instant);
QString localDate(core::Utc instant, int utcOffset_min);

/// Value and limit of a deduction with the digits its unit deserves, and more where the two would read alike.
struct ValueAndLimit {
    QString value;
    QString limit;
};
ValueAndLimit valueAndLimit(const DeductionLine& line);

/// "1, 4-7" with an en dash; ascending input.
QString ranges(const std::vector<int>& numbers);

}  // namespace sagara::report
