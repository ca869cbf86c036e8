#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/base/Utc.h"
#include "ui/chart/Format.h"
#include "ui/report/ReportData.h"

/// Numbers, times and places as they are printed. A value that is not a number prints as a dash.
namespace sagara::report {

using chart::bearing;
using chart::latitude;
using chart::longitude;
using chart::number;
using chart::shortNumber;

/// "07:05"; minutes may pass 99.
QString clockTime(double time_s);

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
