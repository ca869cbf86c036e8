#pragma once

#include <QDialog>

#include "core/exercise/TargetOrders.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;

namespace sagara::ui {

/// What a ship that is added is like. Her size follows from her kind until somebody changes it.
class AddTargetDialog final : public QDialog {
    Q_OBJECT

public:
    /// `place`: what is said of it; `number`: for her name.
    AddTargetDialog(const QString& place, std::size_t number, QWidget* parent = nullptr);
    /// With the position left as it is. `trueToGrid_rad` is added to the true heading.
    core::AddTargetOrder order(core::NorthEast position, double trueToGrid_rad) const;

private:
    void takeSizes();
    void check();

    QLineEdit* m_name;
    QComboBox* m_type;
    QComboBox* m_activity;
    QCheckBox* m_hostile;
    QDoubleSpinBox *m_heading, *m_speed, *m_length, *m_beam, *m_draught;
    QPushButton* m_ok;
};

}  // namespace sagara::ui
