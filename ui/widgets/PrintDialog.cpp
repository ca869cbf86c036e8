#include <QFileDialog>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QStandardPaths>

#include "ui/widgets/PrintChart.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {
namespace {

void tellTrouble(QWidget* parent, const QString& what) {
    QMessageBox::warning(parent, tr("Print chart"), what);
}

void toFile(QWidget* parent, const ChartSheet& sheet) {
    QString name = sheet.title.simplified();
    name.replace(QLatin1Char('/'), QLatin1Char('-'));
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString file = QFileDialog::getSaveFileName(
        parent, tr("Save the chart"), folder + QLatin1Char('/') + name + QStringLiteral(".pdf"),
        tr("PDF (*.pdf)"));
    if (file.isEmpty()) return;
    if (const auto trouble = writeChartPdf(file, sheet)) tellTrouble(parent, *trouble);
}

void toPrinter(QWidget* parent, const ChartSheet& sheet) {
    QPrinter printer(QPrinter::HighResolution);
    printer.setDocName(sheet.title);
    printer.setPageOrientation(QPageLayout::Landscape);
    QPrintDialog dialog(&printer, parent);
    if (dialog.exec() != QDialog::Accepted) return;
    if (!printChartSheet(printer, sheet)) tellTrouble(parent, tr("The printer does not take the page."));
}

}  // namespace

void askAndPrint(QWidget* parent, const ChartSheet& sheet) {
    QMessageBox box(QMessageBox::NoIcon, tr("Print chart"),
                    tr("What the chart shows now is printed, with graticule, compass rose and scale."),
                    QMessageBox::Cancel, parent);
    box.setObjectName(QStringLiteral("print-chart"));
    QPushButton* const pdf = box.addButton(tr("Save as PDF…"), QMessageBox::AcceptRole);
    QPushButton* const paper = box.addButton(tr("Print…"), QMessageBox::AcceptRole);
    pdf->setToolTip(tr("A4, lying"));
    paper->setToolTip(tr("Choose the printer, the paper and how it lies"));
    box.exec();
    if (box.clickedButton() == pdf) toFile(parent, sheet);
    if (box.clickedButton() == paper) toPrinter(parent, sheet);
}

}  // namespace sagara::ui
