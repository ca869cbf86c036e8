#pragma once

#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "ui/report/Flow.h"

namespace sagara::report {

/// What stands below every page: page number from 1, and how many there are.
using DrawFooter = std::function<void(QPainter&, std::size_t page, std::size_t pages)>;
/// The two lines of a footer: at the left, and the page number at the right.
void drawPlainFooter(QPainter& painter, const QString& first, const QString& second, std::size_t number,
                     std::size_t count);

/// Writes sheets as PDF, A4, with the header of all documents of Sagara: whole or not at all. Throws
/// std::runtime_error when the file cannot be written. Needs a QGuiApplication.
void writePdf(const std::vector<Sheet>& sheets, const QString& title, const DrawFooter& footer,
              const std::string& path);

}  // namespace sagara::report
