#pragma once

#include <QString>

/// Numbers, directions and places as they are printed and shown. A value that is not a number reads as a
/// dash.
namespace sagara::chart {

/// With a true minus sign, and never "-0".
QString number(double value, int decimals);
/// As many decimals as needed, `mostDecimals` at most: 4, 0.5, 2.25.
QString shortNumber(double value, int mostDecimals);
/// Three figures, 000 to 359.
QString bearing(double angle_deg);

/// "006°01.95'N"
QString latitude(double lat_deg, int decimals);
QString longitude(double lon_deg, int decimals);

/// "1:15 000", with spaces that do not break.
QString naturalScale(double denominator);

}  // namespace sagara::chart
