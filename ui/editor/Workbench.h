#pragma once

#include <QWidget>

#include "ui/editor/DraftChart.h"
#include "ui/editor/ScenarioFields.h"
#include "ui/editor/Validator.h"

class QLabel;
class QListWidget;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace sagara::ui {
class ChartWidget;
}

namespace sagara::ui::editor {

class DryRunPanel;
class MarksAid;
class ObjectForm;
class ProblemList;

/// VIEW of the draft: the pages of the form, the chart with its handles, the problems.
class Workbench final : public QWidget {
    Q_OBJECT
public:
    Workbench(EditorContext& context, QWidget* parent);

    void setColours(PaletteName colours);
    /// Another document is open: the first page, and the chart at what there is.
    void begin();
    void openSection(const std::string& id);
    /// Goes to the page and the field of a path.
    void reveal(const std::string& path);
    const Validator& validator() const { return m_validator; }

private:
    struct Page {
        QScrollArea* area = nullptr;
        ObjectForm* form = nullptr;  ///< null: the dry run
    };
    QWidget* chartSide();
    void addPages();
    void addChartTools(QWidget& bar);
    const std::string& section() const;
    const Page& page() const;  ///< that is open
    void loadPage();
    void refreshChart();
    void areaRead();
    void fitToDraft();
    void dragged(int handle, core::NorthEast to);
    void clicked(core::NorthEast place);
    void addWaypoint(core::GeoPoint place);
    void addTargetPoint(core::GeoPoint place);
    void addMark(core::GeoPoint place);
    void showProblems();

    EditorContext& m_context;
    Validator m_validator;
    std::vector<Section> m_sections;
    std::string m_dryRunId = "dry-run";
    QListWidget* m_list;
    ChartWidget* m_chart;
    ProblemList* m_problems;
    QStackedWidget* m_stack;
    std::vector<Page> m_pages;
    DryRunPanel* m_dryRun;
    QToolButton* m_add = nullptr;
    MarksAid* m_marks = nullptr;
    DraftPicture m_picture;
    bool m_fitWanted = false;
};

}  // namespace sagara::ui::editor
