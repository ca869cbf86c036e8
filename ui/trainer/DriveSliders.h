#pragma once

#include <QObject>
#include <vector>

#include "ui/run/ExerciseRun.h"

class QFormLayout;
class QLabel;
class QSlider;

namespace sagara::ui {

/// Pitch of every propeller whose blades turn and direction of every azimuth drive of one own ship: rows of
/// the helm panel, none where she has none.
class DriveSliders final : public QObject {
    Q_OBJECT

public:
    DriveSliders(ExerciseRun& run, std::uint8_t ship, QFormLayout& form);
    /// Without `follows` an order on its way stays as it was given.
    void refresh(const core::OwnShipView& ship, bool follows);

private:
    struct Row {
        std::size_t shaft;
        QLabel* name;
        QSlider* slider;
    };
    /// `text` is as long as its name will be.
    Row addRow(QFormLayout& form, std::size_t shaft, const QString& id, const QString& text);
    QString nameOf(std::size_t shaft) const;
    QString pitchText(std::size_t shaft, int percent) const;
    QString azimuthText(std::size_t shaft, int degrees) const;
    void addPitch(QFormLayout& form, std::size_t shaft);
    void addAzimuth(QFormLayout& form, std::size_t shaft);

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    std::vector<Row> m_pitches;   ///< twentieths of the design pitch
    std::vector<Row> m_azimuths;  ///< fives of degrees from ahead, starboard to the right
};

}  // namespace sagara::ui
