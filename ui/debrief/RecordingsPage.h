#pragma once

#include <QDateTime>
#include <functional>
#include <optional>
#include <vector>

#include "ui/theme/Page.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace sagara::ui {

/// A recorded run as it is listed.
struct RecordingEntry {
    QDateTime started;
    QString scenario;
    QString trainee;  ///< empty: nobody named
    QString type;     ///< in words
    std::optional<double> score;
    bool passed = false;
    double length_s = 0.0;
    QString state;  ///< in words; empty: finished
    QString file;   ///< path
    bool present = true;
};

/// What the page asks of the station.
struct RecordingsPorts {
    std::function<std::vector<RecordingEntry>()> list;  ///< newest first
    /// Opens the debriefing; what went wrong, or nothing.
    std::function<std::optional<QString>(const QString& file)> open;
    QString folder;   ///< where "Open a file" begins
    QString trouble;  ///< why the list may be empty: the database cannot be used
};

/// Recordings of this installation, newest first, to be debriefed; or any file.
class RecordingsPage final : public Page {
    Q_OBJECT

public:
    explicit RecordingsPage(RecordingsPorts ports, QWidget* parent = nullptr);

    QString helpTopic() const override { return QStringLiteral("debrief"); }
    void refresh();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fill();
    void chooseFile();
    void openFile(const QString& file);
    void openCurrent();
    void tell(const QString& words);

    RecordingsPorts m_ports;
    std::vector<RecordingEntry> m_entries;
    QLineEdit* m_search;
    QTableWidget* m_table;
    QLabel* m_empty;
    QLabel* m_trouble;
    QPushButton* m_open;
};

}  // namespace sagara::ui
