#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/exercise/Documents.h"
#include "ui/theme/Page.h"
#include "ui/widgets/PreparedExercise.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace sagara::ui {

/// What may be sailed, as the start page lists it.
struct ScenarioEntry {
    std::string id;
    std::string name;
};

/// What a person chose on the start page.
struct StartChoice {
    std::string scenario;
    int level = 3;
    std::string type;     ///< "train", "assess", ...
    std::string trainee;  ///< empty: nobody named
    bool pilot = false;
    PreparedExercise exercise;
};

/// Choosing an exercise: which, how hard, for whom, as what. Shows the briefing of what is chosen, which is
/// built aside; who opens it before that is done waits for it. A trainee finds no scripted pilot here.
class StartPage final : public Page {
    Q_OBJECT

public:
    /// The documents of a scenario, or what is wrong with it.
    using Documents = std::function<core::Result<core::ExerciseDocuments, std::string>(const std::string&)>;

    enum class For { Trainer, Trainee };
    StartPage(For whom, std::vector<ScenarioEntry> scenarios, Documents documents, QWidget* parent = nullptr);
    void setNames(const QStringList& names);  ///< of the roster, to choose from while typing
    QString helpTopic() const override { return QStringLiteral("lesson"); }
    void setTrouble(const QString& trouble);  ///< shown until the next choice; empty: none

Q_SIGNALS:
    void chosen(const sagara::ui::StartChoice& choice);

private:
    using Built = core::Result<PreparedExercise, std::string>;

    void prepare(int row);
    void take(const Built& built);
    void refuse(const std::string& why);
    void open();

    const For m_for;
    std::vector<ScenarioEntry> m_scenarios;
    Documents m_documents;
    PreparedExercise m_exercise;  ///< the one chosen; empty while it is built
    int m_asked = 0;              ///< counts what was chosen
    bool m_openWhenBuilt = false;
    QListWidget* m_list;
    QTextBrowser* m_briefing;
    QComboBox* m_level;
    QComboBox* m_type;
    QLineEdit* m_trainee;
    QCheckBox* m_pilot;
    QPushButton* m_open;
    QLabel* m_trouble;
};

/// The briefing as a trainer reads it: objective, briefing, tasks, what is graded.
QString briefingHtml(const core::World& world);

}  // namespace sagara::ui
