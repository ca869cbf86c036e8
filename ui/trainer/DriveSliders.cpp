#include "ui/trainer/DriveSliders.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::ui {
namespace {

constexpr double kPitchStep = 0.05;
constexpr double kAzimuthStep_rad = 5.0 * core::kDegree_rad;

/// Left alone while somebody moves it.
void put(QSlider& slider, double value) {
    if (slider.isSliderDown()) return;
    const QSignalBlocker quiet(&slider);
    slider.setValue(static_cast<int>(std::lround(value)));
}

}  // namespace

DriveSliders::DriveSliders(ExerciseRun& run, std::uint8_t ship, QFormLayout& form)
    : QObject(form.parentWidget()), m_run(run), m_ship(ship) {
    const auto& units = run.world()->ships[ship]->vessel.propulsion.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (units[i].pitch) addPitch(form, i);
        if (units[i].azimuth) addAzimuth(form, i);
    }
}

DriveSliders::Row DriveSliders::addRow(QFormLayout& form, std::size_t shaft, const QString& id,
                                       const QString& text) {
    auto* const slider = new QSlider(Qt::Horizontal, form.parentWidget());
    slider->setObjectName(QStringLiteral("%1-%2").arg(id).arg(shaft));
    slider->setTickPosition(QSlider::TicksBelow);
    auto* const name = new QLabel(text, form.parentWidget());
    name->setMinimumWidth(name->sizeHint().width());  // its column stays when the number changes
    form.addRow(name, slider);
    return {shaft, name, slider};
}

QString DriveSliders::nameOf(std::size_t shaft) const {
    return QString::fromStdString(m_run.world()->ships[m_ship]->vessel.propulsion.units[shaft].id);
}

QString DriveSliders::pitchText(std::size_t shaft, int percent) const {
    return tr("Pitch, %1: %2 %").arg(nameOf(shaft)).arg(percent);
}

QString DriveSliders::azimuthText(std::size_t shaft, int degrees) const {
    return tr("Drive, %1: %2°").arg(nameOf(shaft)).arg((degrees + 360) % 360, 3, 10, QLatin1Char('0'));
}

void DriveSliders::addPitch(QFormLayout& form, std::size_t shaft) {
    const Row row = addRow(form, shaft, QStringLiteral("pitch"), pitchText(shaft, -100));
    const core::PitchControl& limits = *m_run.world()->ships[m_ship]->vessel.propulsion.units[shaft].pitch;
    row.slider->setRange(static_cast<int>(std::ceil(limits.least / kPitchStep - 0.01)),
                         static_cast<int>(std::floor(limits.most / kPitchStep + 0.01)));
    row.slider->setTickInterval(10);
    row.slider->setPageStep(2);
    row.slider->setToolTip(
        tr("Pitch over the design pitch, ahead to the right; until the next order of the "
           "telegraph"));
    connect(row.slider, &QSlider::valueChanged, this, [this, shaft](int steps) {
        m_run.give(m_ship, core::PitchOrder{static_cast<std::uint8_t>(shaft), kPitchStep * steps});
    });
    m_pitches.push_back(row);
}

void DriveSliders::addAzimuth(QFormLayout& form, std::size_t shaft) {
    const Row row = addRow(form, shaft, QStringLiteral("azimuth"), azimuthText(shaft, 0));
    row.slider->setRange(-36, 36);
    row.slider->setTickInterval(18);
    row.slider->setPageStep(3);
    row.slider->setToolTip(
        tr("Where the drive pushes the ship, ahead in the middle, to starboard to the "
           "right, astern at both ends; the wheel turns it on top of this"));
    connect(row.slider, &QSlider::valueChanged, this, [this, shaft](int steps) {
        m_run.give(m_ship, core::AzimuthOrder{static_cast<std::uint8_t>(shaft), kAzimuthStep_rad * steps});
    });
    m_azimuths.push_back(row);
}

void DriveSliders::refresh(const core::OwnShipView& ship, bool follows) {
    for (const Row& row : m_pitches) {
        if (follows) put(*row.slider, ship.drives[row.shaft].pitchOrder / kPitchStep);
        row.name->setText(pitchText(row.shaft, 5 * row.slider->value()));
    }
    for (const Row& row : m_azimuths) {
        if (follows)
            put(*row.slider, core::wrapPi(ship.drives[row.shaft].azimuthOrder_rad) / kAzimuthStep_rad);
        row.name->setText(azimuthText(row.shaft, 5 * row.slider->value()));
    }
}

}  // namespace sagara::ui
