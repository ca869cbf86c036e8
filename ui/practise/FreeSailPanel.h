#pragma once

#include <QWidget>

#include "ui/practise/FreeSail.h"
#include "ui/practise/PractisePorts.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace sagara::ui {

/// Ship, place and traffic of a free sail. Areas are read aside: until they are there no place is offered.
class FreeSailPanel final : public QWidget {
    Q_OBJECT

public:
    explicit FreeSailPanel(const PractisePorts& ports, QWidget* parent = nullptr);

    /// Without the weather; nothing while there is no ship or no place for her.
    std::optional<FreeSail> sail() const;
    /// What is chosen, in words.
    QString words() const;
    /// Of the area chosen; null while it is being read.
    const core::Area* area() const { return m_area.get(); }

Q_SIGNALS:
    void changed();

private:
    void readArea();
    void readVessel();
    void listPlaces();
    void showPlace();
    const SailPlace* place() const;

    const PractisePorts& m_ports;
    std::shared_ptr<const core::Area> m_area;
    std::optional<core::Vessel> m_vessel;
    std::vector<SailPlace> m_places;
    QString m_problem;
    QComboBox* m_ship;
    QComboBox* m_areas;
    QComboBox* m_placeBox;
    QSpinBox* m_heading;
    QSpinBox* m_speed;
    QComboBox* m_traffic;
    QLabel* m_note;
};

}  // namespace sagara::ui
