#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/theme/Page.h"
#include "ui/vessels/ShipView.h"
#include "ui/vessels/VesselLibrary.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace sagara::ui {

class DocumentTree;
class SectionsView;
class TrialsPanel;

/// The admin's page of vessels: list, what is known of each, and what may be done with her.
class VesselsPage final : public Page {
    Q_OBJECT

public:
    using Today = std::function<std::string()>;  ///< for the date on a pilot card

    VesselsPage(VesselLibrary& library, StageFor stageFor, Today today, QWidget* parent = nullptr);
    ~VesselsPage() override;

    void setColours(PaletteName name) override;
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("vessels"); }

    bool choose(const std::string& id);
    std::string chosen() const;

    // What the buttons do; dialogs are opened by `new...`, `edit...`, the rest asks nothing but a file name.
    void openNew();
    void openEditor();
    void openModel();
    void duplicate();
    void retireOrRestore();
    void backToShipped();
    /// The error is for the person.
    Trouble exportTo(const std::filesystem::path& file) const;
    Trouble importFrom(const std::filesystem::path& file);
    void writePilotCard(const QString& file);

Q_SIGNALS:
    void pilotCardWritten(const QString& file);

private:
    QWidget* listSide();
    QWidget* detailSide();
    QPushButton* button(const QString& text, const char* name, const char* icon, const QString& tip);
    void fillList();
    void showChosen();
    void showFacts(const core::Vessel& vessel);
    void showActions();
    void tell(const Trouble& trouble);
    /// Asks before a shipped vessel becomes the school's own.
    bool mayOverwrite(const std::string& id);
    Trouble save(const std::string& id, const std::string& name, const std::string& text);
    std::string freeId(const std::string& wanted) const;

    VesselLibrary& m_library;
    StageFor m_stageFor;
    Today m_today;
    PaletteName m_colours = PaletteName::Day;
    std::vector<VesselEntry> m_entries;
    std::optional<core::Vessel> m_vessel;
    std::string m_text;
    QLineEdit* m_search;
    QCheckBox* m_showRetired;
    QListWidget* m_list;
    QLabel *m_empty, *m_title, *m_subtitle, *m_message;
    QTabWidget* m_tabs;
    QTableWidget* m_facts;
    ShipView* m_view;
    SectionsView* m_sections;
    DocumentTree* m_tree;
    TrialsPanel* m_trials;
    QPushButton *m_new, *m_import, *m_edit, *m_copy, *m_model, *m_export, *m_card, *m_retire, *m_back;
    std::vector<std::pair<QPushButton*, QString>> m_icons;
    QString m_cardWanted;  ///< the file to write once the trials are done
};

}  // namespace sagara::ui
