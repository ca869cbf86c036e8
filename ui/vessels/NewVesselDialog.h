#pragma once

#include <QDialog>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/vessel/Particulars.h"
#include "ui/theme/PaletteName.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTimer;

namespace sagara::ui {

/// A new vessel from her main particulars; everything else is estimated. Each field says what is wrong with
/// it as it is typed.
class NewVesselDialog final : public QDialog {
    Q_OBJECT

public:
    /// Saves; the error is for the person.
    using Save = std::function<std::optional<std::string>(const std::string& id, const std::string& name,
                                                          const std::string& text)>;
    using Taken = std::function<bool(const std::string& id)>;

    NewVesselDialog(PaletteName colours, Taken taken, Save save, QWidget* parent = nullptr);

    core::Particulars particulars() const;
    const std::string& text() const { return m_text; }  ///< the document; empty while something is wrong
    void accept() override;

private:
    QDoubleSpinBox* number(QFormLayout* form, const char* field, const QString& label, double low,
                           double high, double value, int decimals, const QString& unit, const QString& tip);
    void addRow(QFormLayout* form, const char* field, const QString& label, QWidget* widget);
    void check();
    QString summary() const;

    PaletteName m_colours;
    Taken m_taken;
    Save m_save;
    QLineEdit *m_id, *m_name;
    QComboBox *m_kind, *m_fullness;
    QDoubleSpinBox *m_loa, *m_lpp, *m_beam, *m_draught, *m_depth, *m_stability, *m_rudderArea, *m_volume,
        *m_block, *m_speed, *m_power, *m_propeller, *m_thruster;
    QSpinBox *m_shafts, *m_rudders;
    QLabel* m_summary;
    QPushButton* m_ok;
    QTimer* m_timer;
    std::map<std::string, QLabel*> m_notes;
    std::string m_text;
    bool m_idTyped = false;
};

}  // namespace sagara::ui
