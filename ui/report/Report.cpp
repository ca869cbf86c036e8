#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <cassert>
#include <iterator>
#include <stdexcept>

#include "ui/report/ChartPage.h"
#include "ui/report/DeductionPages.h"
#include "ui/report/PageFrame.h"
#include "ui/report/PlotsPage.h"
#include "ui/report/ReportData.h"
#include "ui/report/Sound.h"
#include "ui/report/SummaryPage.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr int kDotsPerMillimetre = 100;

void append(std::vector<Sheet>& to, std::vector<Sheet> more) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The report from first to last page. A new page is one line here.
std::vector<Sheet> sheetsOf(const RunReport& report) {
    std::vector<Sheet> sheets = summarySheets(report);
    sheets.push_back(chartSheet(report));
    sheets.push_back(plotsSheet(report));
    append(sheets, deductionSheets(report));
    return sheets;
}

void setUp(QPdfWriter& pdf, const RunReport& report) {
    pdf.setResolution(static_cast<int>(25.4 * kDotsPerMillimetre));
    pdf.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF()));
    pdf.setTitle(fromStd(report.scenarioName) + QStringLiteral(" · ") + tr("Report of a run"));
    pdf.setCreator(QStringLiteral("Sagara"));
}

void drawSheets(QPdfWriter& pdf, const std::vector<Sheet>& sheets, const RunReport& report) {
    QPainter painter(&pdf);
    painter.scale(kDotsPerMillimetre, kDotsPerMillimetre);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (i > 0) pdf.newPage();
        drawHeader(painter, sheets[i].title);
        sheets[i].draw(painter);
        drawFooter(painter, report, i + 1, sheets.size());
    }
}

QByteArray pdfOf(const RunReport& report) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    setUp(pdf, report);
    drawSheets(pdf, sheetsOf(report), report);
    return buffer.data();
}

}  // namespace

void writeReport(const RunReport& report, const std::string& path) {
    assert(qGuiApp);  // fonts need it
    const QByteArray content = pdfOf(withoutBadPoints(report));
    QSaveFile file(QFile::decodeName(QByteArray::fromStdString(path)));  // whole or not at all
    file.setDirectWriteFallback(true);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit()) {
        throw std::runtime_error("cannot write the report to " + path + ": " +
                                 file.errorString().toStdString());
    }
}

}  // namespace sagara::report
