#include "EditorDriver.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "core/base/Config.h"
#include "ui/editor/ScenarioFields.h"

namespace sagara::test {
namespace {

using namespace ui::editor;

QString plain(const Json& value) {
    if (value.is_string()) return QString::fromStdString(value.get<std::string>());
    if (value.is_number_float())
        return QString::fromStdString(core::config::formatNumber(value.get<double>()));
    if (value.is_object() && value.contains("lat"))
        return plain(value["lat"]) + QStringLiteral(", ") + plain(value["lon"]);
    return QString::fromStdString(value.dump());
}

}  // namespace

void EditorDriver::fail(const std::string& what) { ADD_FAILURE() << what; }

void EditorDriver::click(const std::string& button) const {
    if (auto* const b = find<QAbstractButton>(button)) {
        EXPECT_TRUE(b->isEnabled()) << button;
        b->click();
    }
}

void EditorDriver::type(const std::string& line, const QString& text) const {
    auto* const edit = find<QLineEdit>(line);
    if (!edit) return;
    edit->setFocus();
    edit->selectAll();
    if (text.isEmpty())
        QTest::keyClick(edit, Qt::Key_Delete);
    else
        QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

void EditorDriver::choose(const std::string& name, const QString& value) const {
    auto* const combo = find<QComboBox>(name);
    if (!combo) return;
    const int index = combo->findData(value);
    EXPECT_GE(index, 0) << name << " does not offer " << value.toStdString();
    combo->setCurrentIndex(index);
}

void EditorDriver::typeCell(const std::string& name, int row, int column, const QString& text) const {
    auto* const table = find<QTableView>(name);
    if (!table) return;
    table->setCurrentIndex(table->model()->index(row, column));
    auto* edit = table->viewport()->findChild<QLineEdit*>();
    if (!edit) table->edit(table->currentIndex());
    if (!edit) edit = table->viewport()->findChild<QLineEdit*>();
    if (!edit) return fail("cell of " + name + " cannot be typed in");
    edit->selectAll();
    if (text.isEmpty())
        QTest::keyClick(edit, Qt::Key_Delete);
    else
        QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    QTest::qWait(0);  // the cell's line is taken away
    delete table->viewport()->findChild<QLineEdit*>();
}

void EditorDriver::openSection(const std::string& id) const {
    const std::vector<Section> sections = scenarioSections();
    auto* const list = find<QListWidget>("sections");
    for (std::size_t i = 0; i < sections.size(); ++i)
        if (sections[i].id == id) return list->setCurrentRow(static_cast<int>(i));
    list->setCurrentRow(list->count() - 1);
}

void EditorDriver::addRow(const std::string& list, const std::string& kind) const {
    if (kind.empty()) return click(list + ".add");
    if (auto* const action = find<QAction>(list + ".add." + kind)) action->trigger();
}

void EditorDriver::enter(const Field& field, const std::string& path, const Json& value) const {
    switch (field.kind) {
        case FieldKind::Text:
        case FieldKind::Id:
        case FieldKind::Number:
        case FieldKind::Integer:
        case FieldKind::Position:
            return type(path, value.is_null() ? QString() : plain(value));
        case FieldKind::LongText: {
            auto* const text = find<QPlainTextEdit>(path);
            text->selectAll();
            QTest::keyClicks(text, plain(value));
            return;
        }
        case FieldKind::Flag: {
            auto* const box = find<QCheckBox>(path);
            if (box && box->isChecked() != (value.is_boolean() && value.get<bool>())) box->click();
            return;
        }
        case FieldKind::Choice:
        case FieldKind::Reference:
            return choose(path, value.is_null() ? QString() : plain(value));
        case FieldKind::Place:
            return enterPlace(path, value);
        case FieldKind::Places:
            for (std::size_t i = 0; i < value.size(); ++i) enterPlace(join(path, i), value[i]);
            return;
        case FieldKind::References:
            return enterReferences(path, value);
        case FieldKind::Numbers:
            for (std::size_t i = 0; i < value.size(); ++i) type(join(path, i), plain(value[i]));
            return;
        case FieldKind::Utc:
            find<QDateTimeEdit>(path)->setDateTime(QDateTime::fromString(plain(value), Qt::ISODate));
            return;
        case FieldKind::List:
            return enterList(field, path, value);
    }
}

void EditorDriver::enterPlace(const std::string& path, const Json& value) const {
    if (!value.is_object()) return choose(path, value.is_null() ? QString() : plain(value));
    choose(path, QStringLiteral("#position"));
    type(path, plain(value));
}

void EditorDriver::enterReferences(const std::string& path, const Json& value) const {
    for (const Json& item : value) {
        auto* const box = find<QCheckBox>(path + "/" + item.get<std::string>());
        if (box && !box->isChecked()) box->click();
    }
}

void EditorDriver::enterList(const Field& field, const std::string& path, const Json& value) const {
    const ListSpec& spec = *field.list;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (sizeAt(m_page.draft().document(), path) <= i) {
            const Variant* variant = spec.variantOf(value[i]);
            addRow(path, variant && spec.variants.size() > 1 ? variant->value : std::string());
        }
        enterRow(spec, path, i, value[i]);
    }
}

void EditorDriver::enterRow(const ListSpec& spec, const std::string& path, std::size_t row,
                            const Json& value) const {
    const std::string at = join(path, row);
    if (!spec.form) {
        for (std::size_t c = 0; c < spec.columns.size(); ++c) {
            const Json* cell = ui::editor::find(value, spec.columns[c]);
            typeCell(path, static_cast<int>(row), static_cast<int>(c), cell ? plain(*cell) : QString());
        }
        return;
    }
    auto* const table = find<QTableView>(path);
    if (!table) return;
    table->selectRow(static_cast<int>(row));
    if (const Variant* variant = spec.variantOf(value); variant && spec.variants.size() > 1)
        choose(at + "#kind", QString::fromStdString(variant->value));
    for (const Field& f : spec.fieldsOf(value)) {
        const Json* member = ui::editor::find(value, f.key);
        if (member) enter(f, join(at, f.key), *member);
    }
}

}  // namespace sagara::test
