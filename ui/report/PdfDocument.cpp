#include "ui/report/PdfDocument.h"

#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>
#include <cassert>
#include <stdexcept>

#include "ui/report/PageFrame.h"
#include "ui/report/Style.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr int kDotsPerMillimetre = 100;

QByteArray pdfOf(const std::vector<Sheet>& sheets, const QString& title, const DrawFooter& footer) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    pdf.setResolution(static_cast<int>(25.4 * kDotsPerMillimetre));
    pdf.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF()));
    pdf.setTitle(title);
    pdf.setCreator(QStringLiteral("Sagara"));
    QPainter painter(&pdf);
    painter.scale(kDotsPerMillimetre, kDotsPerMillimetre);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (i > 0) pdf.newPage();
        drawHeader(painter, sheets[i].title);
        sheets[i].draw(painter);
        footer(painter, i + 1, sheets.size());
    }
    painter.end();
    return buffer.data();
}

}  // namespace

void drawPlainFooter(QPainter& painter, const QString& first, const QString& second, std::size_t number,
                     std::size_t count) {
    const TextStyle style{7.5, colour::kQuiet};
    const double line_mm = page::kBottom_mm + 3.0;
    painter.setPen(linePen(colour::kRule, 0.15));
    painter.drawLine(QPointF(page::kLeft_mm, line_mm), QPointF(page::kRight_mm, line_mm));
    drawText(painter, {page::kLeft_mm, line_mm + 3.6}, Qt::AlignLeft,
             elided(first, style, page::kTextWidth_mm - 50.0), style);
    drawText(painter, {page::kLeft_mm, line_mm + 7.2}, Qt::AlignLeft, second, style);
    drawText(painter, {page::kRight_mm, line_mm + 3.6}, Qt::AlignRight,
             tr("page %1 of %2").arg(number).arg(count), style);
}

void writePdf(const std::vector<Sheet>& sheets, const QString& title, const DrawFooter& footer,
              const std::string& path) {
    assert(qGuiApp);  // fonts need it
    const QByteArray content = pdfOf(sheets, title, footer);
    QSaveFile file(QFile::decodeName(QByteArray::fromStdString(path)));
    file.setDirectWriteFallback(true);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit()) {
        throw std::runtime_error("cannot write " + title.toStdString() + " to " + path + ": " +
                                 file.errorString().toStdString());
    }
}

}  // namespace sagara::report
