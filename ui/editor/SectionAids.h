#pragma once

#include <QWidget>

#include "ui/editor/EditorContext.h"

class QButtonGroup;
class QComboBox;
class QLabel;

namespace sagara::ui::editor {

/// VIEW above the weather's fields: the Beaufort scale, the sea that belongs to the wind, the tide at the
/// start.
class WeatherAid final : public QWidget {
    Q_OBJECT
public:
    WeatherAid(EditorContext& context, QWidget* parent);

private:
    void load();
    void take(int number);
    EditorContext& m_context;
    QComboBox* m_beaufort;
    QLabel* m_says;
};

/// VIEW above the factors: what each level comes to.
class LevelsAid final : public QWidget {
    Q_OBJECT
public:
    LevelsAid(EditorContext& context, QWidget* parent);

private:
    void load();
    EditorContext& m_context;
    QLabel* m_says;
};

/// VIEW above the marks: what the next click on the chart puts there.
class MarksAid final : public QWidget {
    Q_OBJECT
public:
    MarksAid(EditorContext& context, QWidget* parent);

    const std::string& kind() const { return m_kind; }
    /// Whether clicks on the chart put marks there: only then one is shown as chosen.
    void setAdding(bool on);

Q_SIGNALS:
    void kindChosen();

private:
    void paintIcons();
    EditorContext& m_context;
    QButtonGroup* m_buttons;
    std::string m_kind;
};

}  // namespace sagara::ui::editor
