#pragma once

#include <QFutureWatcher>
#include <functional>

#include "ui/theme/Page.h"
#include "ui/vessels/DatabaseCare.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace sagara::ui {

/// What the database is, and how it is checked, copied and put back.
class DatabasePage final : public Page {
    Q_OBJECT

public:
    explicit DatabasePage(DatabaseCare& care, QWidget* parent = nullptr);
    ~DatabasePage() override;

    void setColours(PaletteName name) override;
    bool mayLeave() override { return !m_busy; }
    QString helpTopic() const override { return QStringLiteral("database"); }

    void check();
    void backupTo(const std::filesystem::path& file);
    /// Asks, checks the backup aside, then puts it in place. `asked`: the person has said yes already.
    void restoreFrom(const std::filesystem::path& file, bool asked = false);
    bool busy() const { return m_busy; }

private:
    using Work = std::function<std::vector<std::string>()>;
    using Then = std::function<void(const std::vector<std::string>&)>;
    void aside(const QString& what, Work work, Then then);
    void showFacts();
    void say(const QString& text, bool bad);

    DatabaseCare& m_care;
    PaletteName m_colours = PaletteName::Day;
    QLabel *m_file, *m_size, *m_version, *m_state;
    QTableWidget* m_rows;
    QPushButton *m_check, *m_backup, *m_restore;
    QProgressBar* m_bar;
    QFutureWatcher<std::vector<std::string>> m_watcher;
    Then m_then;
    bool m_busy = false;
    bool m_bad = false;
};

}  // namespace sagara::ui
