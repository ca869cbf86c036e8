#pragma once

#include "ui/practise/PractisePorts.h"
#include "ui/theme/Page.h"
#include "ui/widgets/PreparedExercise.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTabWidget;
class QTextBrowser;

namespace sagara::ui {

class FreeSailPanel;
class PersonPanel;
class WeatherPanel;

/// Choosing what to sail alone. Exercises are built aside; the page stays usable meanwhile.
class PractisePage final : public Page {
    Q_OBJECT

public:
    explicit PractisePage(PractisePorts ports, QWidget* parent = nullptr);
    ~PractisePage() override;

    QString helpTopic() const override { return QStringLiteral("practise"); }
    void refresh();  ///< after a run: history and best

protected:
    void showEvent(QShowEvent*) override;

private:
    using Then = std::function<void(PreparedExercise)>;

    QWidget* choiceColumn();
    QWidget* previewColumn();
    bool free() const;
    std::string lesson() const;
    void lookAtLesson();
    void takeLessonWeather();
    void showPreview();
    void chooseAssignment(const QString& scenario, int level);
    void setSail();
    void sail(const PreparedExercise& exercise);
    /// Builds it aside and goes on with it unless something else was begun meanwhile.
    void build(core::NamedText scenario, const QString& doing, Then then);
    void setBusy(const QString& doing);
    void setTrouble(const QString& trouble);
    void enable();

    PractisePorts m_ports;
    PersonPanel* m_person;
    QTabWidget* m_tabs;
    QListWidget* m_lessons;
    FreeSailPanel* m_free;
    QComboBox* m_level;
    QCheckBox* m_ownWeather;
    WeatherPanel* m_weather;
    QCheckBox* m_prediction;
    QCheckBox* m_hints;
    QTextBrowser* m_preview;
    QLabel* m_best;
    QWidget* m_busy;
    QLabel* m_doing;
    QLabel* m_trouble;
    QPushButton* m_sail;
    PreparedExercise m_lesson;  ///< the one chosen, as it is written; empty while it is being built
    int m_token = 0;
};

}  // namespace sagara::ui
