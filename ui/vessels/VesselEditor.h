#pragma once

#include <QDialog>
#include <functional>
#include <string>
#include <vector>

#include "ui/theme/PaletteName.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace sagara::ui {

class DocumentTree;

/// Every number of a vessel document in fields, checked by the loader as it is typed. A document with
/// problems cannot be saved.
class VesselEditor final : public QDialog {
    Q_OBJECT

public:
    /// Saves a text under its id; the error is shown and the editor stays.
    using Save = std::function<std::optional<std::string>(const std::string& id, const std::string& name,
                                                          const std::string& text)>;

    VesselEditor(const std::string& text, PaletteName colours, Save save, QWidget* parent = nullptr);

    std::string text() const;
    std::size_t problemCount() const { return m_problemCount; }
    void accept() override;
    void reject() override;

private:
    void check();
    void note();
    void go(std::ptrdiff_t steps);
    void showHint();

    Save m_save;
    DocumentTree* m_tree;
    QLineEdit* m_filter;
    QListWidget* m_problems;
    QLabel* m_state;
    QLabel* m_hint;
    QPushButton *m_add, *m_remove, *m_undo, *m_redo, *m_ok;
    std::vector<std::string> m_history;
    std::size_t m_at = 0;
    std::size_t m_problemCount = 0;
};

/// What the loader accepts at a path of a vessel document: "0.1 to 15 m". Empty where it does not say.
std::string acceptedAt(const std::string& text, const std::string& path);

}  // namespace sagara::ui
