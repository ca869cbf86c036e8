#pragma once

#include <QPainter>
#include <QString>

#include "ui/report/ReportData.h"

namespace sagara::report {

/// What is the same on every page: header with the page's title, footer with lesson, trainee, date and page
/// number.
void drawHeader(QPainter& painter, const QString& title);
void drawFooter(QPainter& painter, const RunReport& report, std::size_t page, std::size_t pages);

}  // namespace sagara::report
