#pragma once

#include "ui/editor/EditorContext.h"
#include "ui/theme/Page.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace sagara::ui::editor {

class Library;
class Workbench;
struct NewScenario;

/// The editor's page: chooses a scenario, edits it, stores it.
class EditorPage final : public Page {
    Q_OBJECT
public:
    /// `scenarioId` empty: the list, and new ones. The port outlives the page.
    EditorPage(EditorPort& port, const std::string& scenarioId, QWidget* parent = nullptr);

    void setColours(PaletteName colours) override;
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("editor"); }

    ScenarioDraft& draft() { return m_draft; }
    Workbench& workbench() { return *m_workbench; }
    /// The error is for the person.
    std::optional<QString> open(const std::string& id);
    std::optional<QString> importFile(const QString& file);
    std::optional<QString> exportFile(const QString& file);
    void begin(const NewScenario& choice);
    /// False when it could not be stored or the person did not want to.
    bool save();

private:
    QWidget* bench();
    void addFileButtons(QWidget& bar);
    void saveAs();
    void importChosen();
    void exportChosen();
    void toLibrary();
    void say(const QString& text);
    void nameTitle();
    void placeNewShip();
    bool mayBeReplaced(const std::string& id);

    EditorPort& m_port;
    ScenarioDraft m_draft;
    EditorContext m_context;
    QStackedWidget* m_stack;
    Library* m_library;
    Workbench* m_workbench;
    QLabel* m_title;
    QLabel* m_status;
    QPushButton* m_save;
    QToolButton* m_undo;
    QToolButton* m_redo;
    std::string m_storedId;  ///< under which it was opened or last saved; empty: not yet
    bool m_direct;           ///< opened with one scenario: back leaves the page
    bool m_placeShip = false;
};

}  // namespace sagara::ui::editor
