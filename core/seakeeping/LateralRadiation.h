#pragma once

#include <vector>

#include "core/seakeeping/StripTheory.h"

namespace sagara::core {

/// What the length of a hull takes from strip theory's radiation in sway, roll and yaw. The sections of strip
/// theory send their waves abeam, each by itself; a hull no longer than the waves sends less, in all
/// directions. Damping is that of the energy sent out when the sections' waves are put together in phase:
/// B_ij = k / 4 pi times the integral of K_i K_j* over all directions, K = sin(beta) times the integral of
/// the section's amplitude times exp(i k x cos(beta)); Newman (1962, J. Ship Research 6, 10-17) with strip
/// theory's amplitudes. Added mass follows by Kramers and Kronig's relations from that of the strips at low
/// frequency, which their wave forces belong to. In waves shorter than a third of the length the sections are
/// alone again.
class LateralRadiation {
public:
    /// `flows` of rising frequency, as far as they are at hand.
    LateralRadiation(const StripHull& hull, const std::vector<HullFlow>& flows);
    /// Makes the flows it needs: half a second.
    explicit LateralRadiation(const StripHull& hull);

    /// Strip theory's radiation at a frequency > 0, with what the length changes.
    Radiation of(const StripHull& hull, const HullFlow& flow) const;
    /// What it adds to the added mass at infinite frequency.
    const Matrix6& atInfinity() const { return m_atInfinity; }

private:
    void learn(const StripHull& hull, const HullFlow& flow);
    void finish(const StripHull& hull);
    Matrix6 dampingAt(double omega_radps) const;
    Matrix6 addedMassAt(double omega_radps) const;

    std::vector<double> m_omega_radps;
    std::vector<Matrix6> m_damping;  ///< less that of the strips; nothing at 0 and at the end
    Matrix6 m_atInfinity;
};

}  // namespace sagara::core
