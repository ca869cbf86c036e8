#include "ui/trainee/DriveControls.h"

#include <QHBoxLayout>
#include <algorithm>

#include "ui/trainee/AzimuthDial.h"
#include "ui/trainee/LinePanel.h"
#include "ui/trainee/PitchLever.h"
#include "ui/trainee/ShaftTelegraph.h"

namespace sagara::ui::console {

DriveControls::DriveControls(const core::Propulsion& propulsion, std::size_t shaft, QWidget* parent)
    : QWidget(parent), m_unit(propulsion.units[shaft]), m_shaft(shaft) {
    const QString name = spokenName(m_unit.id);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3);
    m_telegraph = new ShaftTelegraph(name, propulsion.telegraph_rps, this);
    m_telegraph->setObjectName(QStringLiteral("telegraph-%1").arg(shaft));
    row->addWidget(m_telegraph);
    if (m_unit.pitch) {
        row->addWidget(m_pitch = new PitchLever(name, *m_unit.pitch, this));
        m_pitch->setObjectName(QStringLiteral("pitch-%1").arg(shaft));
        m_telegraph->setToolTip(tr("%1. It sets revolutions and pitch together, and the bar is what both do")
                                    .arg(m_telegraph->toolTip()));
    }
    if (m_unit.azimuth) {
        row->addWidget(m_azimuth = new AzimuthDial(name, this));
        m_azimuth->setObjectName(QStringLiteral("azimuth-%1").arg(shaft));
    }
}

void DriveControls::setUnit(double unit) {
    // Letters do not shrink below those of unit 1: name and rpm have to fit.
    m_telegraph->setFixedWidth(static_cast<int>(124.0 * std::max(1.0, unit)));
    if (m_pitch != nullptr) m_pitch->setFixedWidth(static_cast<int>(64.0 * unit));
    if (m_azimuth != nullptr) m_azimuth->setFixedWidth(static_cast<int>(116.0 * unit));
}

void DriveControls::show(const core::OwnShipView& own, bool settled) {
    if (m_shaft >= own.shafts_rps.size() || m_shaft >= own.drives.size()) return;
    const core::DriveView& drive = own.drives[m_shaft];
    const double speed_rps = own.shafts_rps[m_shaft];
    m_telegraph->setShaft(speed_rps, m_pitch != nullptr ? speed_rps * drive.pitch : speed_rps);
    if (settled) m_telegraph->setOrder(own.shaftOrders_rps[m_shaft]);
    m_telegraph->setNote(drive.startsLeft ? tr("air %1").arg(static_cast<int>(*drive.startsLeft))
                                          : QString());
    if (m_pitch != nullptr) {
        m_pitch->setPitch(drive.pitch);
        if (settled) m_pitch->setOrder(drive.pitchOrder, drive.pitchByHand);
    }
    if (m_azimuth != nullptr) {
        m_azimuth->setAngle(drive.azimuth_rad);
        if (settled) m_azimuth->setOrder(drive.azimuthOrder_rad);
    }
}

}  // namespace sagara::ui::console
