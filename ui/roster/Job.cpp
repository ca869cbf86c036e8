#include "ui/roster/Job.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFutureWatcher>
#include <QMessageBox>
#include <QProgressDialog>
#include <QStandardPaths>
#include <QTimer>
#include <QtConcurrentRun>
#include <memory>

namespace sagara::ui::roster {
namespace {

constexpr int kLook_ms = 80;

QString text(const char* source) { return QCoreApplication::translate("roster", source); }

}  // namespace

void runJob(QWidget* parent, const QString& title, Job job, std::function<void(const QString&)> done) {
    auto* const bar = new QProgressDialog(title, text("Cancel"), 0, 100, parent);
    bar->setObjectName(QStringLiteral("progress"));
    bar->setWindowTitle(title);
    bar->setWindowModality(Qt::WindowModal);
    bar->setAutoReset(false);
    bar->setAutoClose(false);
    bar->setMinimumDuration(300);
    bar->setAttribute(Qt::WA_DeleteOnClose);
    const auto control = std::make_shared<JobControl>();
    QObject::connect(bar, &QProgressDialog::canceled, bar, [control] { control->cancel(); });
    auto* const look = new QTimer(bar);
    QObject::connect(look, &QTimer::timeout, bar, [bar, control] { bar->setValue(control->percent()); });
    look->start(kLook_ms);
    auto* const watcher = new QFutureWatcher<QString>(bar);
    QObject::connect(watcher, &QFutureWatcher<QString>::finished, bar,
                     [bar, watcher, control, done = std::move(done)] {
                         const QString trouble = watcher->result();
                         const bool cancelled = control->cancelled();
                         bar->setParent(nullptr);
                         bar->deleteLater();
                         if (!cancelled) done(trouble);
                     });
    watcher->setFuture(QtConcurrent::run([control, job = std::move(job)] { return job(*control); }));
}

void writeReport(QWidget* parent, const QString& suggestedName,
                 std::function<Job(const QString& file)> make) {
    auto* const dialog = new QFileDialog(parent, text("Write the report"));
    dialog->setObjectName(QStringLiteral("report-file"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(text("PDF (*.pdf)"));
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->setDirectory(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    dialog->selectFile(suggestedName);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, [parent, make](const QString& file) {
        runJob(parent, text("Writing the report..."), make(file), [parent, file](const QString& trouble) {
            auto* const box = new QMessageBox(
                trouble.isEmpty() ? QMessageBox::Information : QMessageBox::Warning, text("Report"),
                trouble.isEmpty() ? text("The report is in %1.").arg(QDir::toNativeSeparators(file))
                                  : trouble,
                QMessageBox::Ok, parent);
            box->setObjectName(QStringLiteral("report-done"));
            box->setAttribute(Qt::WA_DeleteOnClose);
            box->open();
        });
    });
    dialog->open();
}

}  // namespace sagara::ui::roster
