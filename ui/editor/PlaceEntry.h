#pragma once

#include "ui/editor/FieldEntries.h"

namespace sagara::ui::editor {

/// A place: one of the area by its name, or a position. Both widgets have the path as their name.
class PlaceEntry final : public FieldEditor {
    Q_OBJECT
public:
    PlaceEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    void take(int index);
    core::GeoPoint here() const;
    QComboBox* m_combo;
    LineEntry* m_position;
};

/// So many places.
class PlacesEntry final : public FieldEditor {
    Q_OBJECT
public:
    PlacesEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void showProblems(const std::vector<core::config::Problem>& problems) override;
    FieldEditor* reveal(const std::string& path) override;
    void focusEntry() override;

private:
    std::vector<PlaceEntry*> m_places;
};

}  // namespace sagara::ui::editor
