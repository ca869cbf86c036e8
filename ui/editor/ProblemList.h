#pragma once

#include <QWidget>

#include "core/base/Problems.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QListWidget;

namespace sagara::ui::editor {

struct Section;

/// VIEW: what is wrong with the draft, each leading to its field.
class ProblemList final : public QWidget {
    Q_OBJECT
public:
    ProblemList(const std::vector<Section>& sections, QWidget* parent);
    void show(const std::vector<core::config::Problem>& problems);
    void setChecking();
    void setColours(PaletteName colours);

Q_SIGNALS:
    void chosen(const std::string& path);

private:
    const std::vector<Section>& m_sections;
    QLabel* m_summary;
    QListWidget* m_list;
    PaletteName m_colours = PaletteName::Day;
    bool m_any = false;
};

}  // namespace sagara::ui::editor
