#pragma once

#include <QWidget>

#include "ui/editor/EditorContext.h"
#include "ui/editor/ScenarioFields.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace sagara::ui::editor {

/// VIEW: which scenario is to be edited: one that is there, a new one, one in a file.
class Library final : public QWidget {
    Q_OBJECT
public:
    Library(EditorContext& context, QWidget* parent);
    void refresh();
    void setTrouble(const QString& text);

Q_SIGNALS:
    void openWanted(const std::string& id);
    void newWanted(const sagara::ui::editor::NewScenario& choice);
    void importWanted();
    void leaveWanted();

private:
    QWidget* openSide();
    QWidget* newSide();
    void create();
    void checkNew();

    EditorContext& m_context;
    QListWidget* m_list;
    QPushButton* m_open;
    QLineEdit* m_id;
    QLineEdit* m_name;
    QComboBox* m_area;
    QComboBox* m_vessel;
    QPushButton* m_create;
    QLabel* m_idNote;
    QLabel* m_trouble;
};

}  // namespace sagara::ui::editor
