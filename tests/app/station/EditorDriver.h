#pragma once

#include <QTest>
#include <QWidget>

#include "ui/editor/EditorPage.h"
#include "ui/editor/FieldSpec.h"

namespace sagara::test {

/// Hands on the editor: types, chooses, clicks, as a person would. What cannot be found fails the test.
class EditorDriver {
public:
    explicit EditorDriver(ui::editor::EditorPage& page) : m_page(page) {}

    template <typename Widget>
    Widget* find(const std::string& name) const {
        auto* const widget = m_page.findChild<Widget*>(QString::fromStdString(name));
        if (!widget) fail("there is no " + name);
        return widget;
    }
    void click(const std::string& button) const;
    void type(const std::string& line, const QString& text) const;
    void choose(const std::string& combo, const QString& value) const;
    void typeCell(const std::string& table, int row, int column, const QString& text) const;
    void openSection(const std::string& id) const;
    /// "traffic", "" or a kind: a row more, which is then the chosen one.
    void addRow(const std::string& list, const std::string& kind) const;

    /// Makes a field say `value`, null: nothing.
    void enter(const ui::editor::Field& field, const std::string& path, const ui::editor::Json& value) const;
    void enterRow(const ui::editor::ListSpec& spec, const std::string& path, std::size_t row,
                  const ui::editor::Json& value) const;

private:
    static void fail(const std::string& what);
    void enterList(const ui::editor::Field& field, const std::string& path,
                   const ui::editor::Json& value) const;
    void enterPlace(const std::string& path, const ui::editor::Json& value) const;
    void enterReferences(const std::string& path, const ui::editor::Json& value) const;

    ui::editor::EditorPage& m_page;
};

}  // namespace sagara::test
